//! Scene of a single mesh.

use serde_json::{Value, json};
use striata::Lod;
use striata::mesh::IndexedMesh;
use striata_io::{Scene, SceneError};

use crate::LodScene;

impl LodScene {
    /// Creates a scene with one node that shows a mesh; each group of the mesh becomes a primitive.
    ///
    /// # Errors
    /// [`SceneError`] if the JSON of the mesh's materials is broken.
    pub fn from_lod(lod: Lod) -> Result<Self, SceneError> {
        let scene = scene_around(lod.mesh())?;
        let lods = scene.meshes().iter().map(|_| Some(lod.clone())).collect();
        Ok(Self::of_parts(scene, lods))
    }
}

/// Returns the scene without triangles whose only node shows a mesh; each group of the mesh becomes a primitive.
///
/// # Errors
/// [`SceneError`] if the JSON of the mesh's materials is broken.
pub fn scene_around(mesh: &IndexedMesh) -> Result<Scene, SceneError> {
    let mut parts = Scene::from_mesh(sample_of(mesh))?.into_parts();
    if !parts.meshes.is_empty() {
        // The sample has one primitive; all groups have its attributes.
        let primitive = parts.document["meshes"][0]["primitives"][0].clone();
        let of_group = |material: Option<u32>| {
            let mut primitive = primitive.clone();
            if let Some(material) = material {
                primitive["material"] = json!(material);
            }
            primitive
        };
        let primitives: Vec<Value> = mesh.groups_or_whole().iter().map(|g| of_group(g.material)).collect();
        parts.document["meshes"][0]["primitives"] = Value::Array(primitives);
        parts.meshes = vec![None];
    }
    Scene::from_parts(parts)
}

/// Returns the first triangle of a mesh, with all attributes and the appearance of the whole mesh.
pub(crate) fn sample_of(mesh: &IndexedMesh) -> IndexedMesh {
    let corners = mesh.triangles.first().map_or(&[][..], |triangle| &triangle[..]);
    IndexedMesh {
        positions: corners.iter().map(|&vertex| mesh.positions[vertex as usize]).collect(),
        origin: mesh.origin,
        exact_positions: Vec::new(),
        triangles: mesh.triangles.first().map(|_| [0, 1, 2]).into_iter().collect(),
        layers: mesh.layers.iter().map(|layer| layer.gather(corners)).collect(),
        triangle_layers: Vec::new(),
        groups: Vec::new(),
        appearance: mesh.appearance.clone(),
    }
}
