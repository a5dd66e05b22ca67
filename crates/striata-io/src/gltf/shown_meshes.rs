//! Meshes that the default scene of a document shows, with their transforms; skins are posed by their nodes.

use glam::{DMat3, DMat4, DVec3};
use serde_json::Value;

use super::document::GltfDocument;
use super::gpu_instancing::{BYTES_PER_INSTANCE, GpuInstances, is_instanced};
use super::importance;
use super::json::JsonNode;
use super::node_tree::{PlacedNode, placed_nodes};
use crate::error::Fault;
use crate::scene::SceneInstance;

/// Returns the meshes that the nodes of the default scene show, in tree order; all meshes if there are no
/// nodes. `buffer` contains the data that the buffer views refer to.
pub(crate) fn shown_meshes(document: &Value, buffer: &[u8]) -> Result<Vec<SceneInstance>, Fault> {
    let root = JsonNode { value: document, path: String::new() };
    if root.values("nodes")?.is_empty() {
        let bare = |(mesh, at): (usize, JsonNode<'_>)| SceneInstance {
            node: None,
            mesh,
            skin: None,
            in_node: None,
            transform: DMat4::IDENTITY.to_cols_array(),
            scale: 1.0,
            importance: importance::below(1.0, &at),
        };
        return Ok(root.entries("meshes")?.into_iter().enumerate().map(bare).collect());
    }
    let nodes = placed_nodes(&root)?;
    let mut matrix_of = vec![None; root.values("nodes")?.len()];
    for PlacedNode { index, matrix, .. } in &nodes {
        matrix_of[*index] = Some(*matrix);
    }
    let mut poses = SkinPoses { root: &root, buffer, matrix_of: &matrix_of, known: Vec::new() };
    let (mut found, mut gpu_instances) = (Vec::new(), GpuInstances::new(BYTES_PER_INSTANCE));
    let mut opened = None;
    for PlacedNode { index, node, matrix, importance } in &nodes {
        let Some(at) = node.get("mesh") else { continue };
        let mesh = at.as_unsigned()?;
        let importance = importance::below(*importance, &root.item("meshes", mesh, &at)?);
        let skin = node.get("skin").map(|at| poses.number(&at)).transpose()?;
        let matrix = match skin {
            Some(skin) => poses.matrix(skin)?,
            None => *matrix,
        };
        let instance = |in_node: Option<DMat4>| {
            let matrix = in_node.map_or(matrix, |in_node| matrix * in_node);
            SceneInstance {
                node: Some(*index),
                mesh: mesh as usize,
                skin,
                in_node: in_node.map(|in_node| Box::new(in_node.to_cols_array())),
                transform: matrix.to_cols_array(),
                scale: largest_stretch(&matrix),
                importance,
            }
        };
        if is_instanced(node) {
            let document = match &mut opened {
                Some(opened) => opened,
                none => none.insert(GltfDocument::over(document, buffer)?),
            };
            found.extend(gpu_instances.of_node(document, node)?.into_iter().map(instance));
        } else {
            found.push(instance(None));
        }
    }
    Ok(found)
}

/// Matrices of skins in the pose of the nodes.
struct SkinPoses<'r, 'a> {
    root: &'r JsonNode<'a>,
    buffer: &'r [u8],
    /// Transform of each node of the scene.
    matrix_of: &'r [Option<DMat4>],
    /// Matrix of each skin, if it was computed before.
    known: Vec<Option<DMat4>>,
}

impl SkinPoses<'_, '_> {
    /// Returns the index of an existing skin.
    fn number(&mut self, at: &JsonNode<'_>) -> Result<usize, Fault> {
        let index = at.as_unsigned()?;
        self.root.item("skins", index, at)?;
        Ok(index as usize)
    }

    /// Returns the matrix of the joint that enlarges the mesh most.
    fn matrix(&mut self, skin: usize) -> Result<DMat4, Fault> {
        if let Some(&Some(matrix)) = self.known.get(skin) {
            return Ok(matrix);
        }
        let at = self.root.item("skins", skin as u64, self.root)?;
        let joints = at.entries("joints")?;
        let inverse_binds = match at.unsigned("inverseBindMatrices")? {
            Some(accessor) => self.matrices(accessor, joints.len()),
            None => Vec::new(),
        };
        let mut largest = None;
        for (joint, node) in joints.iter().enumerate() {
            let node = usize::try_from(node.as_unsigned()?).ok();
            let Some(&Some(matrix)) = node.and_then(|node| self.matrix_of.get(node)) else { continue };
            let matrix = matrix * inverse_binds.get(joint).copied().unwrap_or(DMat4::IDENTITY);
            let stretch = largest_stretch(&matrix);
            if stretch.is_finite() && largest.is_none_or(|(most, _)| stretch > most) {
                largest = Some((stretch, matrix));
            }
        }
        let matrix = largest.map_or(DMat4::IDENTITY, |(_, matrix)| matrix);
        self.known.resize(self.known.len().max(skin + 1), None);
        self.known[skin] = Some(matrix);
        Ok(matrix)
    }

    /// Returns the first matrices of an accessor of the buffer, at most `limit`; none if it is malformed.
    fn matrices(&self, accessor: u64, limit: usize) -> Vec<DMat4> {
        let bytes = || -> Option<&[u8]> {
            let at = self.root.item("accessors", accessor, self.root).ok()?;
            let is_matrices = at.text("type") == "MAT4" && at.unsigned("componentType").ok()? == Some(5126);
            let view = self.root.item("bufferViews", at.unsigned("bufferView").ok()??, &at).ok()?;
            let place = |of: &JsonNode<'_>| Some(of.unsigned("byteOffset").ok()?.unwrap_or(0));
            let start = usize::try_from(place(&view)?.checked_add(place(&at)?)?).ok()?;
            let count = usize::try_from(at.required_unsigned("count").ok()?).ok()?;
            let end = start.checked_add(count.checked_mul(64)?)?;
            self.buffer.get(start..end).filter(|_| is_matrices)
        };
        let (matrices, _) = bytes().unwrap_or_default().as_chunks::<64>();
        let number = |chunk: &[u8; 4]| f64::from(f32::from_le_bytes(*chunk));
        let matrix = |bytes: &[u8; 64]| {
            let (numbers, _) = bytes.as_chunks::<4>();
            DMat4::from_cols_array(&std::array::from_fn(|i| number(&numbers[i])))
        };
        matrices.iter().take(limit).map(matrix).collect()
    }
}

/// Returns the largest factor by which a transform enlarges a length: its largest singular value.
///
/// Powers of the symmetric matrix `MᵀM` converge to the direction of the largest stretch. Only exact
/// operations and square roots are used, so all machines agree.
fn largest_stretch(matrix: &DMat4) -> f64 {
    let linear = DMat3::from_mat4(*matrix);
    let mut power = linear.transpose() * linear;
    for _ in 0..32 {
        let size = power.to_cols_array().iter().fold(0.0, |size: f64, x| size.max(x.abs()));
        if !(size > 0.0 && size.is_finite()) {
            return 0.0;
        }
        power *= 1.0 / size;
        power *= power;
    }
    let columns = [power.x_axis, power.y_axis, power.z_axis];
    let direction = columns.into_iter().fold(DVec3::ZERO, |longest, column| {
        if column.length_squared() > longest.length_squared() { column } else { longest }
    });
    (linear * direction).length() / direction.length()
}
