//! Flattened node tree: the meshes that the scene shows, and their transforms.

use glam::{DMat4, DVec3};

use super::document::GltfDocument;
use super::georeference::turn_of_terrain;
use super::gpu_instancing::{GpuInstances, unit};
use super::importance;
use super::json::JsonNode;
use super::rest_pose::{RestPose, RestPoses};
use crate::error::Fault;

/// One mesh as shown by one node.
pub(crate) struct Instance<'a> {
    /// Index of the mesh.
    pub mesh: u64,
    /// Name of the mesh, or of the node if the mesh has none.
    pub name: &'a str,
    /// Transform from the mesh to the scene; the identity for skinned meshes, whose node transforms glTF
    /// ignores.
    pub matrix: DMat4,
    /// Pose that its morph targets and its skin give it.
    pub pose: RestPose,
}

/// Visits the meshes of the default scene in tree order, or all meshes if there are no nodes.
///
/// Instances of `EXT_mesh_gpu_instancing` are limited to one for `bytes_per_instance` bytes of the document and its
/// buffers, unless there are few.
pub(crate) fn visit_instances<'a>(
    document: &GltfDocument<'a>,
    bytes_per_instance: u64,
    visit: &mut dyn FnMut(Instance<'a>) -> Result<(), Fault>,
) -> Result<(), Fault> {
    let root = &document.root;
    if root.values("nodes")?.is_empty() {
        for (mesh, at) in root.entries("meshes")?.iter().enumerate() {
            let (name, pose) = (at.text("name"), RestPose::default());
            visit(Instance { mesh: mesh as u64, name, matrix: DMat4::IDENTITY, pose })?;
        }
        return Ok(());
    }
    let mut gpu_instances = GpuInstances::new(bytes_per_instance);
    let mut nodes = placed_nodes(root)?;
    if let Some(turn) = turn_of_terrain(root.value) {
        nodes.iter_mut().for_each(|node| node.matrix = turn * node.matrix);
    }
    let mut poses = RestPoses::new(nodes.iter().map(|node| (node.index, node.matrix)).collect());
    for PlacedNode { node, matrix, .. } in nodes {
        if let Some(from) = node.get("mesh") {
            let index = from.as_unsigned()?;
            let mesh = root.item("meshes", index, &from)?;
            let own_name = mesh.text("name");
            let name = if own_name.is_empty() { node.text("name") } else { own_name };
            let pose = poses.of_node(document, &node, &mesh)?;
            for placement in gpu_instances.of_node(document, &node)? {
                let matrix = placement.map_or(matrix, |placement| matrix * placement);
                let matrix = if node.get("skin").is_some() { DMat4::IDENTITY } else { matrix };
                visit(Instance { mesh: index, name, matrix, pose: pose.clone() })?;
            }
        }
    }
    Ok(())
}

/// Node of the default scene.
pub(super) struct PlacedNode<'a> {
    pub index: usize,
    pub node: JsonNode<'a>,
    /// Transform from the node to the scene.
    pub matrix: DMat4,
    /// Importance, times that of all nodes above.
    pub importance: f64,
}

/// Returns the nodes of the default scene in tree order.
///
/// Fails if they do not form a tree, or a transform is malformed.
pub(super) fn placed_nodes<'a>(root: &JsonNode<'a>) -> Result<Vec<PlacedNode<'a>>, Fault> {
    let mut found = Vec::new();
    let mut is_seen = vec![false; root.values("nodes")?.len()];
    let mut stack = roots(root)?;
    stack.reverse();
    while let Some(PendingNode { index, parent, importance, from }) = stack.pop() {
        let node = root.item("nodes", index, &from)?;
        let index = index as usize;
        if std::mem::replace(&mut is_seen[index], true) {
            return Err(from.fault(format!("nodes[{index}] is reached twice: nodes must form a tree")));
        }
        let matrix = parent * local_matrix(&node)?;
        let importance = importance::below(importance, &node);
        for child in node.entries("children")?.into_iter().rev() {
            stack.push(PendingNode { index: child.as_unsigned()?, parent: matrix, importance, from: child });
        }
        found.push(PlacedNode { index, node, matrix, importance });
    }
    Ok(found)
}

/// Node that has not been visited yet.
struct PendingNode<'a> {
    index: u64,
    /// Transform of the parent.
    parent: DMat4,
    /// Importance of the parent.
    importance: f64,
    /// Value that refers to the node.
    from: JsonNode<'a>,
}

impl<'a> PendingNode<'a> {
    fn root(index: u64, from: JsonNode<'a>) -> Self {
        Self { index, parent: DMat4::IDENTITY, importance: 1.0, from }
    }
}

/// Returns the roots of the default scene, or of the first; without scenes, the nodes without a parent.
fn roots<'a>(root: &JsonNode<'a>) -> Result<Vec<PendingNode<'a>>, Fault> {
    let scene = match root.get("scene") {
        Some(at) => Some(root.item("scenes", at.as_unsigned()?, &at)?),
        None => root.entries("scenes")?.into_iter().next(),
    };
    if let Some(scene) = scene {
        let entry = |at: JsonNode<'a>| Ok(PendingNode::root(at.as_unsigned()?, at));
        return scene.entries("nodes")?.into_iter().map(entry).collect();
    }
    let nodes = root.entries("nodes")?;
    let mut is_child = vec![false; nodes.len()];
    for node in &nodes {
        for child in node.entries("children")? {
            if let Some(slot) = usize::try_from(child.as_unsigned()?).ok().and_then(|i| is_child.get_mut(i)) {
                *slot = true;
            }
        }
    }
    let is_root = |&(index, _): &(usize, &JsonNode<'a>)| !is_child[index];
    let entry = |(index, node): (usize, &JsonNode<'a>)| PendingNode::root(index as u64, node.clone());
    Ok(nodes.iter().enumerate().filter(is_root).map(entry).collect())
}

fn local_matrix(node: &JsonNode<'_>) -> Result<DMat4, Fault> {
    if let Some(columns) = node.numbers::<16>("matrix")? {
        return Ok(DMat4::from_cols_array(&columns));
    }
    let translation = node.numbers::<3>("translation")?.unwrap_or([0.0; 3]);
    let rotation = node.numbers::<4>("rotation")?.unwrap_or([0.0, 0.0, 0.0, 1.0]);
    let scale = node.numbers::<3>("scale")?.unwrap_or([1.0; 3]);
    let Some(rotation) = unit(rotation) else { return Err(node.fault("the rotation has no length")) };
    Ok(DMat4::from_scale_rotation_translation(
        DVec3::from_array(scale),
        rotation,
        DVec3::from_array(translation),
    ))
}
