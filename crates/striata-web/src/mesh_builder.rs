//! Builds a model from arrays that a page has: what another loader has read, or what a page has made.

use striata::mesh::{AttributeLayer, IndexedMesh, LayerData, Semantic, TriangleGroup};
use wasm_bindgen::prelude::wasm_bindgen;

use crate::built_model::BuiltModel;
use crate::model::Model;
use crate::progress::{self, Sink};
use crate::{Failure, limits};

/// Collects the vertices and triangles of a mesh.
#[wasm_bindgen]
#[derive(Debug, Default)]
pub struct MeshBuilder {
    mesh: IndexedMesh,
}

#[wasm_bindgen]
impl MeshBuilder {
    /// Starts with positions, three numbers per vertex.
    ///
    /// # Errors
    /// If the number of values is not a multiple of three.
    #[wasm_bindgen(constructor)]
    pub fn new(positions: &[f32]) -> Result<Self, Failure> {
        let (positions, rest) = positions.as_chunks();
        if !rest.is_empty() {
            return Err(Failure::unsupported("positions need three numbers per vertex"));
        }
        Ok(Self { mesh: IndexedMesh::new(positions.to_vec(), Vec::new()) })
    }

    /// Adds an attribute with floats. Names are those of glTF; morph targets have a number in front:
    /// `0/POSITION`.
    ///
    /// # Errors
    /// If the number of values does not fit the number of vertices.
    pub fn add_floats(&mut self, name: &str, component_count: u8, values: &[f32]) -> Result<(), Failure> {
        self.add(name, component_count, false, LayerData::F32(values.to_vec()))
    }

    /// Adds an attribute with 16-bit integers.
    ///
    /// # Errors
    /// As for [`add_floats`](Self::add_floats).
    pub fn add_shorts(&mut self, name: &str, component_count: u8, values: &[u16]) -> Result<(), Failure> {
        self.add(name, component_count, false, LayerData::U16(values.to_vec()))
    }

    /// Adds the triangles of a group, three corners each.
    ///
    /// # Errors
    /// If the number of corners is not a multiple of three, or a corner is not a vertex.
    pub fn add_group(&mut self, indices: &[u32]) -> Result<(), Failure> {
        let (triangles, rest) = indices.as_chunks::<3>();
        let vertex_count = self.mesh.vertex_count();
        if !rest.is_empty() || triangles.iter().flatten().any(|&corner| corner as usize >= vertex_count) {
            return Err(Failure::corrupt(
                "triangles need three corners each, which are vertices of the mesh",
            ));
        }
        let first = self.mesh.triangles.len() as u32;
        self.mesh.triangles.extend(triangles);
        let count = triangles.len() as u32;
        self.mesh.groups.push(TriangleGroup { name: String::new(), material: None, first, count });
        Ok(())
    }

    /// Builds the levels.
    ///
    /// # Errors
    /// If the mesh is inconsistent or too large for a page.
    pub fn build(self, sink: &Sink) -> Result<Model, Failure> {
        limits::check_to_build(self.mesh.vertex_count(), self.mesh.triangle_count())?;
        self.mesh.check().map_err(Failure::corrupt)?;
        BuiltModel::simplify(self.mesh, &mut progress::reporter(sink)).map(Model::of_built)
    }

    fn add(
        &mut self,
        name: &str,
        component_count: u8,
        normalized: bool,
        data: LayerData,
    ) -> Result<(), Failure> {
        let semantic = semantic_of(name);
        if component_count == 0 || data.len() != usize::from(component_count) * self.mesh.vertex_count() {
            return Err(Failure::unsupported(format!(
                "{name} does not have as many values as there are vertices"
            )));
        }
        self.mesh.layers.push(AttributeLayer { semantic, component_count, normalized, data });
        Ok(())
    }
}

/// The meaning of an attribute of glTF.
fn semantic_of(name: &str) -> Semantic {
    let generic = || Semantic::Generic(name.to_owned());
    if let Some((target, morphed)) = name.split_once('/') {
        let Ok(target) = target.parse() else { return generic() };
        return match morphed {
            "POSITION" => Semantic::MorphPosition(target),
            "NORMAL" => Semantic::MorphNormal(target),
            "TANGENT" => Semantic::MorphTangent(target),
            _ => generic(),
        };
    }
    let numbered = |prefix: &str| name.strip_prefix(prefix).and_then(|set| set.parse().ok());
    match name {
        "NORMAL" => Semantic::Normal,
        "TANGENT" => Semantic::Tangent,
        _ => None
            .or_else(|| numbered("TEXCOORD_").map(Semantic::TexCoord))
            .or_else(|| numbered("COLOR_").map(Semantic::Color))
            .or_else(|| numbered("JOINTS_").map(Semantic::Joints))
            .or_else(|| numbered("WEIGHTS_").map(Semantic::Weights))
            .unwrap_or_else(generic),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_of_attributes_have_their_meanings() {
        let expected = [
            ("NORMAL", Semantic::Normal),
            ("TEXCOORD_1", Semantic::TexCoord(1)),
            ("WEIGHTS_0", Semantic::Weights(0)),
            ("12/POSITION", Semantic::MorphPosition(12)),
            ("_FEATURE", Semantic::Generic("_FEATURE".to_owned())),
            ("TEXCOORD_x", Semantic::Generic("TEXCOORD_x".to_owned())),
        ];
        for (name, semantic) in expected {
            assert_eq!(semantic_of(name), semantic);
        }
    }

    #[test]
    fn arrays_that_do_not_fit_are_rejected() {
        assert!(MeshBuilder::new(&[0.0; 4]).is_err());
        let mut mesh = MeshBuilder::new(&[0.0; 9]).unwrap();
        assert!(mesh.add_floats("NORMAL", 3, &[0.0; 8]).is_err());
        assert!(mesh.add_group(&[0, 1, 3]).is_err());
        assert!(mesh.add_group(&[0, 1]).is_err());
        assert!(mesh.add_group(&[0, 1, 2]).is_ok());
    }
}
