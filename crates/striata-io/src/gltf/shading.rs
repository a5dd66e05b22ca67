//! Normals and a material for meshes that come without, so that they look well in viewers.
//!
//! Without normals, a glTF mesh has flat facets, and without a material, it is a white metal. Normals are smooth
//! up to creases ([`PositionEdges::with_smooth_normals`]).

use std::borrow::Cow;

use serde_json::{Value, json};
use striata::mesh::{IndexedMesh, Material, PositionEdges, Semantic, TriangleGroup};

/// Returns the mesh with smooth normals up to creases of 50 degrees, if it has none, and with a matte material, if it
/// has none: what [`WriteOptions::shading`](crate::WriteOptions::shading) writes. Vertices at creases are divided.
pub fn shaded(mesh: &IndexedMesh) -> Cow<'_, IndexedMesh> {
    let has_normals = mesh.layers.iter().any(|layer| layer.semantic == Semantic::Normal);
    let has_materials = !mesh.appearance.materials.is_empty();
    if mesh.triangles.is_empty() || has_normals && has_materials {
        return Cow::Borrowed(mesh);
    }
    let mut is_solid = false;
    // The writer reports a mesh that is inconsistent.
    let mut out = match PositionEdges::of(mesh) {
        Ok(edges) => {
            is_solid = edges.is_solid();
            if has_normals { mesh.clone() } else { edges.with_smooth_normals() }
        }
        Err(_) => mesh.clone(),
    };
    if !has_materials {
        add_material(&mut out, is_solid);
    }
    Cow::Owned(out)
}

/// Light that a mesh without colors reflects: a white one loses its shading under the lights of most viewers.
const GRAY: f64 = 0.5;

/// Gives all triangles a matte material.
fn add_material(mesh: &mut IndexedMesh, is_solid: bool) {
    let material = matte(mesh.layer(&Semantic::Color(0)).is_none(), is_solid);
    mesh.appearance.materials = vec![Material { name: String::new(), gltf_json: material.to_string() }];
    if mesh.groups.is_empty() {
        let (first, count) = (0, mesh.triangles.len() as u32);
        mesh.groups = vec![TriangleGroup { name: String::new(), material: None, first, count }];
    }
    mesh.groups.iter_mut().for_each(|group| group.material = Some(0));
}

/// A matte material; the backs of triangles are shown if they can be seen.
fn matte(is_gray: bool, is_solid: bool) -> Value {
    let mut material = json!({ "pbrMetallicRoughness": { "metallicFactor": 0.0, "roughnessFactor": 0.9 } });
    if is_gray {
        material["pbrMetallicRoughness"]["baseColorFactor"] = json!([GRAY, GRAY, GRAY, 1.0]);
    }
    if !is_solid {
        material["doubleSided"] = json!(true);
    }
    material
}

/// Whether a material is one that [`shaded`] adds, which is no loss to a format without materials.
pub(crate) fn is_added(material: &Material) -> bool {
    let known = [(false, false), (false, true), (true, false), (true, true)];
    let is_known = |json: Value| known.iter().any(|&(is_gray, is_solid)| json == matte(is_gray, is_solid));
    material.name.is_empty() && serde_json::from_str(&material.gltf_json).is_ok_and(is_known)
}

#[cfg(test)]
mod tests {
    use striata::mesh::shapes;

    use super::*;

    #[test]
    fn closed_meshes_show_one_side() {
        let ball = shapes::icosphere(2, 1.0);
        let shown = shaded(&ball);
        assert!(shown.layer(&Semantic::Normal).is_some());
        assert!(!shown.appearance.materials[0].gltf_json.contains("doubleSided"), "it is closed");
    }

    #[test]
    fn normals_and_materials_that_exist_stay_and_unused_vertices_too() {
        let mut mesh = shapes::grid(4, 4);
        mesh.positions.insert(3, [9.0; 3]);
        mesh.triangles.iter_mut().flatten().for_each(|v| *v += u32::from(*v >= 3));
        mesh.positions.push([8.0; 3]);
        let shown = shaded(&mesh).into_owned();
        assert_eq!(shown.positions, mesh.positions);
        assert_eq!(shown.triangles, mesh.triangles);
        assert!(shown.appearance.materials[0].gltf_json.contains("doubleSided"), "it is open");
        assert_eq!(shaded(&shown).into_owned(), shown);
        let mut material = shown.appearance.materials[0].clone();
        assert!(is_added(&material));
        material.name = "steel".to_owned();
        assert!(!is_added(&material), "it is the file's own");
    }
}
