//! Meshes that nodes show, and checks that the parts of a scene match.

use serde_json::Value;
use striata::mesh::{Bounds, IndexedMesh};

use super::SceneError;
use crate::gltf::{has_triangles, usable_importance};

/// A mesh that a node shows.
#[derive(Clone, Debug, PartialEq)]
pub struct SceneInstance {
    /// Index of the node; [`None`] if the document has no nodes, and shows each mesh once.
    pub node: Option<usize>,
    /// Index of the mesh.
    pub mesh: usize,
    /// Index of the skin, if the mesh is skinned.
    pub skin: Option<usize>,
    /// Transform from the mesh to the node, a matrix in column order, if the node shows the mesh several
    /// times (`EXT_mesh_gpu_instancing`).
    pub in_node: Option<Box<[f64; 16]>>,
    /// Transform from the mesh to the scene, a matrix in column order. For a skinned mesh, that of the joint
    /// that enlarges it most, in the pose of the nodes.
    pub transform: [f64; 16],
    /// Largest factor by which the transform enlarges a length.
    pub scale: f64,
    /// How much its errors count: the products of the numbers `importance` in the `extras` of its mesh, its node and
    /// all nodes above, each 1 if there is none, within 1e-6 and 1e6.
    pub importance: f64,
}

impl SceneInstance {
    /// Returns an importance within the limits of [`importance`](Self::importance); [`None`] for what is no positive
    /// number.
    pub fn usable_importance(importance: f64) -> Option<f64> {
        usable_importance(importance)
    }
}

/// Gives the georeference of a scene to the meshes whose z axis points up in it, so that they stay height fields.
pub(super) fn mark_terrains(
    meshes: &mut [Option<IndexedMesh>],
    instances: &[SceneInstance],
    georeference: &str,
) {
    let mut stands = vec![true; meshes.len()];
    for SceneInstance { mesh, transform: [_, x_up, _, _, _, y_up, _, _, z_x, z_up, z_z, ..], .. } in instances
    {
        stands[*mesh] &= *z_up > 0.0 && [x_up, y_up, z_x, z_z].iter().all(|&&part| part == 0.0);
    }
    for (mesh, _) in meshes.iter_mut().zip(stands).filter(|(_, stands)| *stands) {
        if let Some(mesh) = mesh {
            georeference.clone_into(&mut mesh.appearance.georeference);
        }
    }
}

/// Checks everything that code relies on later.
pub(super) fn check_parts(
    document: &Value,
    buffer_bytes: usize,
    image_count: usize,
    meshes: &[Option<IndexedMesh>],
) -> Result<(), SceneError> {
    if !document.is_object() {
        return Err(SceneError::at("", "the document is not an object"));
    }
    let entries = list(document, "images").len();
    if entries != image_count {
        return Err(SceneError::at("images", format!("{image_count} images for {entries} entries")));
    }
    for (index, view) in list(document, "bufferViews").iter().enumerate().filter(|(_, v)| !v.is_null()) {
        let number = |key: &str| view.get(key).map_or(Some(0), Value::as_u64);
        let end = number("byteOffset").zip(number("byteLength")).and_then(|(o, l)| o.checked_add(l));
        if number("buffer") != Some(0) || end.is_none_or(|end| end > buffer_bytes as u64) {
            let reason = format!("lies outside the buffer of {buffer_bytes} bytes");
            return Err(SceneError::at(format!("bufferViews[{index}]"), reason));
        }
    }
    check_meshes(document, meshes)
}

/// Checks that there is a mesh for each entry of the document, and a group for each triangle primitive.
pub(super) fn check_meshes(document: &Value, meshes: &[Option<IndexedMesh>]) -> Result<(), SceneError> {
    let entries = list(document, "meshes");
    if entries.len() != meshes.len() {
        let reason = format!("{} meshes for {} entries", meshes.len(), entries.len());
        return Err(SceneError::at("meshes", reason));
    }
    for (index, (entry, mesh)) in entries.iter().zip(meshes).enumerate() {
        let Some(mesh) = mesh else { continue };
        let fail = |reason: String| Err(SceneError::at(format!("meshes[{index}]"), reason));
        if let Err(error) = mesh.check() {
            return fail(error.to_string());
        }
        let primitives = list(entry, "primitives").iter().filter(|p| has_triangles(p)).count();
        let groups = mesh.groups_or_whole().len();
        if groups != primitives {
            return fail(format!("{groups} groups for {primitives} triangle primitives"));
        }
    }
    Ok(())
}

fn list<'v>(value: &'v Value, key: &str) -> &'v [Value] {
    value.get(key).and_then(Value::as_array).map_or(&[], Vec::as_slice)
}

/// Returns the bounding box of all instances.
pub(super) fn bounds_of(meshes: &[Option<IndexedMesh>], instances: &[SceneInstance]) -> Option<Bounds> {
    let boxes: Vec<Option<Bounds>> = meshes.iter().map(|mesh| mesh.as_ref()?.bounds()).collect();
    let mut corners = Vec::new();
    for instance in instances {
        let Some(Bounds { min, max }) = boxes[instance.mesh] else { continue };
        let m = &instance.transform;
        corners.extend((0..8).map(|corner| {
            let p =
                [0, 1, 2].map(|axis| f64::from(if corner >> axis & 1 == 0 { min[axis] } else { max[axis] }));
            [0, 1, 2].map(|row| (m[row] * p[0] + m[4 + row] * p[1] + m[8 + row] * p[2] + m[12 + row]) as f32)
        }));
    }
    Bounds::of(&corners)
}
