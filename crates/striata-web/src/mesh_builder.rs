//! Builds a model from arrays that a page has: what another loader has read, or what a page has made.

use striata::mesh::{ColorSpace, IndexedMesh, LayerData, PositionEdges, TriangleGroup};
use striata::simplify::{SequenceOptions, build_sequence_with_progress};
use wasm_bindgen::prelude::wasm_bindgen;

use crate::built_arrays::BuiltArrays;
use crate::layer_name::layer_of;
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
        let mut mesh = IndexedMesh::new(positions.to_vec(), Vec::new());
        // Colors of a page are light.
        mesh.appearance.color_space = ColorSpace::Linear;
        Ok(Self { mesh })
    }

    /// Adds an attribute with floats. Names are those of glTF; morph targets have a number in front:
    /// `0/POSITION`.
    ///
    /// # Errors
    /// If the number of values does not fit the number of vertices.
    pub fn add_floats(&mut self, name: &str, component_count: u8, values: &[f32]) -> Result<(), Failure> {
        let data = LayerData::F32(values.to_vec());
        self.mesh.layers.push(layer_of(name, component_count, data, self.mesh.vertex_count())?);
        Ok(())
    }

    /// Adds an attribute with 16-bit integers.
    ///
    /// # Errors
    /// As for [`add_floats`](Self::add_floats).
    pub fn add_shorts(&mut self, name: &str, component_count: u8, values: &[u16]) -> Result<(), Failure> {
        let data = LayerData::U16(values.to_vec());
        self.mesh.layers.push(layer_of(name, component_count, data, self.mesh.vertex_count())?);
        Ok(())
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

    /// Computes normals that are smooth up to creases of 50 degrees. Vertices at creases are divided.
    ///
    /// # Errors
    /// If the mesh is inconsistent.
    pub fn add_smooth_normals(&mut self) -> Result<(), Failure> {
        self.mesh = PositionEdges::of(&self.mesh).map_err(Failure::corrupt)?.with_smooth_normals();
        Ok(())
    }

    /// Builds the levels.
    ///
    /// # Errors
    /// If the mesh is inconsistent or too large for a page.
    pub fn build(self, sink: &Sink) -> Result<BuiltArrays, Failure> {
        limits::check_to_build(self.mesh.vertex_count(), self.mesh.triangle_count())?;
        self.mesh.check().map_err(Failure::corrupt)?;
        if self.mesh.triangles.is_empty() {
            return Err(Failure::unsupported("the mesh has no triangles"));
        }
        let options = SequenceOptions::default();
        let built = build_sequence_with_progress(&self.mesh, &options, &mut progress::reporter(sink))?;
        BuiltArrays::new(built.refinable)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn arrays_that_do_not_fit_are_rejected() {
        assert!(MeshBuilder::new(&[0.0; 4]).is_err());
        let mut mesh = MeshBuilder::new(&[0.0; 9]).unwrap();
        assert!(mesh.add_floats("NORMAL", 3, &[0.0; 8]).is_err());
        assert!(mesh.add_group(&[0, 1, 3]).is_err());
        assert!(mesh.add_group(&[0, 1]).is_err());
        assert!(mesh.add_group(&[0, 1, 2]).is_ok());
    }

    #[test]
    fn normals_are_smooth_up_to_creases() {
        // A roof of two triangles with an angle of 90 degrees, and a flat square.
        let roof = [0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 1.0, 0.0, -1.0, -1.0, 0.0, -1.0];
        let square = [0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 1.0, 0.0, 0.0, -1.0, 0.0, 0.0];
        for (positions, vertex_count) in [(roof, 6), (square, 4)] {
            let mut mesh = MeshBuilder::new(&positions).unwrap();
            mesh.add_group(&[0, 2, 1, 0, 1, 3]).unwrap();
            mesh.add_smooth_normals().unwrap();
            assert_eq!(mesh.mesh.vertex_count(), vertex_count);
            assert_eq!(mesh.mesh.groups.len(), 1);
        }
    }
}
