//! Poses of a scene: where its nodes, skins and morph targets put each vertex at a time of an animation.
//!
//! [`Poser`] reads skins and animations once; [`Poser::pose`] evaluates an animation at a time, and
//! [`Poser::positions`] returns the deformed positions of a mesh. Rotations are interpolated by halving
//! arcs, which needs only square roots, so all machines agree.

mod animation;
mod interpolation;
mod numbers;
mod skin;

use std::sync::Arc;

use glam::{DMat4, DQuat, DVec3};
use serde_json::Value;
use striata::mesh::{IndexedMesh, Semantic};
use striata_io::{Scene, SceneError, SceneInstance};

use self::animation::{Animation, ChannelProperty};
use self::numbers::{AccessorNumbers, index, transformed};
use self::skin::Skin;
pub(crate) use self::skin::VertexJoints;
use crate::document::entries;

/// Reads the poses of a scene.
#[derive(Clone, Debug)]
pub struct Poser {
    nodes: Vec<PoseNode>,
    /// Nodes with each parent before its children.
    order: Vec<usize>,
    skins: Vec<Skin>,
    animations: Vec<Animation>,
}

/// A node in its own pose, relative to its parent.
#[derive(Clone, Debug)]
struct PoseNode {
    parent: Option<usize>,
    local: Local,
    /// Shared by all nodes that show a mesh and have no weights of their own.
    morph_weights: Arc<[f32]>,
    /// Number of morph targets of its mesh.
    target_count: usize,
}

/// Transform of a node relative to its parent.
#[derive(Clone, Copy, Debug)]
enum Local {
    Matrix(DMat4),
    Parts { translation: DVec3, rotation: DQuat, scale: DVec3 },
}

/// The transforms of all nodes and the weights of their morph targets at one time.
///
/// Clones share their data.
#[derive(Clone, Debug)]
pub struct Pose {
    matrices: Arc<[DMat4]>,
    morph_weights: Arc<[Arc<[f32]>]>,
    /// A node whose weights differ from those above.
    replaced: Option<(usize, Vec<f32>)>,
}

impl Poser {
    /// Reads the nodes, skins and animations of a scene.
    ///
    /// # Errors
    /// [`SceneError`] if they refer to something that does not exist, or their data are malformed.
    pub fn new(scene: &Scene) -> Result<Self, SceneError> {
        let document = scene.document();
        let meshes: Vec<MeshTargets> = entries(document, "meshes").iter().map(MeshTargets::read).collect();
        let mut nodes: Vec<PoseNode> =
            entries(document, "nodes").iter().map(|node| PoseNode::read(node, &meshes)).collect();
        for (parent, node) in entries(document, "nodes").iter().enumerate() {
            for child in entries(node, "children").iter().filter_map(index) {
                if let Some(child) = nodes.get_mut(child) {
                    child.parent = Some(parent);
                }
            }
        }
        let order = parents_first(&nodes);
        let mut numbers = AccessorNumbers::of(scene);
        let skins = entries(document, "skins").iter().map(|skin| Skin::read(skin, &mut numbers));
        let skins = skins.collect::<Result<_, _>>()?;
        let target_counts: Vec<usize> = nodes.iter().map(|node| node.target_count).collect();
        let animations = entries(document, "animations").iter();
        let animations = animations.map(|at| Animation::read(at, &mut numbers, &target_counts));
        Ok(Self { skins, animations: animations.collect::<Result<_, _>>()?, nodes, order })
    }

    /// Number of animations.
    pub fn animation_count(&self) -> usize {
        self.animations.len()
    }

    /// Name of an animation; empty if it has none.
    pub fn animation_name(&self, animation: usize) -> &str {
        self.animations.get(animation).map_or("", |animation| &animation.name)
    }

    /// Time of the last key of an animation, in seconds.
    pub fn duration(&self, animation: usize) -> f32 {
        self.animations.get(animation).map_or(0.0, Animation::duration)
    }

    /// Returns the pose of the nodes as they are in the document.
    pub fn rest_pose(&self) -> Pose {
        self.pose_of(self.locals())
    }

    /// Returns the pose at a time of an animation, in seconds; the first or last one outside its keys.
    pub fn pose(&self, animation: usize, time: f32) -> Pose {
        let mut locals = self.locals();
        for channel in self.animations.get(animation).into_iter().flat_map(|animation| &animation.channels) {
            let (local, weights) = &mut locals[channel.node];
            let value = channel.value(time);
            match (channel.property, local, &value[..]) {
                (ChannelProperty::Translation, Local::Parts { translation, .. }, &[x, y, z]) => {
                    *translation = DVec3::new(x, y, z);
                }
                (ChannelProperty::Rotation, Local::Parts { rotation, .. }, &[x, y, z, w]) => {
                    *rotation = DQuat::from_xyzw(x, y, z, w).normalize();
                }
                (ChannelProperty::Scale, Local::Parts { scale, .. }, &[x, y, z]) => {
                    *scale = DVec3::new(x, y, z)
                }
                (ChannelProperty::MorphWeights, _, value) => {
                    *weights = value.iter().map(|&w| w as f32).collect();
                }
                _ => {}
            }
        }
        self.pose_of(locals)
    }

    fn locals(&self) -> Vec<(Local, Arc<[f32]>)> {
        self.nodes.iter().map(|node| (node.local, Arc::clone(&node.morph_weights))).collect()
    }

    fn pose_of(&self, locals: Vec<(Local, Arc<[f32]>)>) -> Pose {
        let mut matrices = vec![DMat4::IDENTITY; self.nodes.len()];
        for &node in &self.order {
            let parent = self.nodes[node].parent.map_or(DMat4::IDENTITY, |parent| matrices[parent]);
            matrices[node] = parent * locals[node].0.matrix();
        }
        let morph_weights = locals.into_iter().map(|(_, weights)| weights).collect();
        Pose { matrices: matrices.into(), morph_weights, replaced: None }
    }

    /// Returns the positions of a mesh in a pose, in the units of the scene.
    ///
    /// The order is that of the mesh's vertices, so that the positions of a level can be compared with those
    /// of the full mesh.
    pub fn positions(&self, pose: &Pose, instance: &SceneInstance, mesh: &IndexedMesh) -> Vec<[f32; 3]> {
        let mut positions = self.deformed(pose, instance, mesh);
        if self.skin_of(instance).is_none() {
            let matrix = pose.matrix_of(instance);
            for position in &mut positions {
                *position = transformed(&matrix, *position);
            }
        }
        positions
    }

    /// Returns the positions of a mesh after its morph targets and its skin have moved them, without the
    /// transform of a node that has no skin: in units of the scene with a skin, of the mesh without one.
    pub(crate) fn deformed(
        &self,
        pose: &Pose,
        instance: &SceneInstance,
        mesh: &IndexedMesh,
    ) -> Vec<[f32; 3]> {
        let mut positions = mesh.positions.clone();
        let weights = pose.weights_of(instance);
        for (target, &weight) in weights.iter().enumerate().filter(|&(_, &w)| w != 0.0) {
            let semantic = u16::try_from(target).map(Semantic::MorphPosition);
            let Some(layer) = semantic.ok().and_then(|semantic| mesh.layer(&semantic)) else { continue };
            for (vertex, position) in positions.iter_mut().enumerate() {
                for (axis, x) in position.iter_mut().enumerate() {
                    *x += weight * layer.get(vertex, axis);
                }
            }
        }
        if let Some(skin) = self.skin_of(instance) {
            skin.deform(&pose.matrices, mesh, &mut positions);
        }
        positions
    }

    /// Returns the matrix of each joint of an instance's skin, from the mesh to the scene; [`None`] without a
    /// skin.
    pub(crate) fn joint_matrices(&self, pose: &Pose, instance: &SceneInstance) -> Option<Vec<DMat4>> {
        Some(self.skin_of(instance)?.joint_matrices(&pose.matrices))
    }

    fn skin_of(&self, instance: &SceneInstance) -> Option<&Skin> {
        self.skins.get(instance.skin?)
    }

    /// Number of nodes.
    pub(crate) fn node_count(&self) -> usize {
        self.nodes.len()
    }
}

impl Pose {
    /// Returns the pose with other weights of the morph targets of an instance; [`None`] if the instance has
    /// no node.
    #[must_use]
    pub fn with_morph_weights(self, instance: &SceneInstance, weights: Vec<f32>) -> Option<Self> {
        let node = instance.node.filter(|&node| node < self.morph_weights.len())?;
        Some(Self { replaced: Some((node, weights)), ..self })
    }

    /// Returns the transform from a node to the scene; [`None`] if there is no such node.
    pub(crate) fn node_matrix(&self, node: usize) -> Option<DMat4> {
        self.matrices.get(node).copied()
    }

    /// Returns the transform from the mesh of an instance without a skin to the scene.
    pub(crate) fn matrix_of(&self, instance: &SceneInstance) -> DMat4 {
        let node = instance.node.and_then(|node| self.node_matrix(node));
        let in_node = instance.in_node.as_ref().map(|columns| DMat4::from_cols_array(columns));
        node.unwrap_or(DMat4::IDENTITY) * in_node.unwrap_or(DMat4::IDENTITY)
    }

    /// Returns the weights of the morph targets of an instance; those beyond the end of the list are 0.
    pub(crate) fn weights_of(&self, instance: &SceneInstance) -> &[f32] {
        instance.node.map_or(&[], |node| self.morph_weights_of(node))
    }

    /// Weights of the morph targets of a node; those beyond the end of the list are 0.
    fn morph_weights_of(&self, node: usize) -> &[f32] {
        match &self.replaced {
            Some((replaced, weights)) if *replaced == node => weights,
            _ => self.morph_weights.get(node).map_or(&[], |weights| weights),
        }
    }
}

impl PoseNode {
    fn read(node: &Value, meshes: &[MeshTargets]) -> Self {
        let mesh = node.get("mesh").and_then(index).and_then(|mesh| meshes.get(mesh));
        let of_mesh = || mesh.map_or_else(|| Arc::from([]), |mesh| Arc::clone(&mesh.weights));
        Self {
            parent: None,
            local: Local::read(node),
            morph_weights: node.get("weights").map_or_else(of_mesh, weights),
            target_count: mesh.map_or(0, |mesh| mesh.count),
        }
    }
}

/// Morph targets of a mesh of the document.
struct MeshTargets {
    /// Largest number of targets of its primitives.
    count: usize,
    weights: Arc<[f32]>,
}

impl MeshTargets {
    fn read(mesh: &Value) -> Self {
        let primitives = entries(mesh, "primitives").iter();
        let count = primitives.map(|primitive| entries(primitive, "targets").len()).max().unwrap_or(0);
        Self { count, weights: weights(mesh.get("weights").unwrap_or(&Value::Null)) }
    }
}

fn weights(value: &Value) -> Arc<[f32]> {
    numbers(Some(value)).into_iter().map(|x| x as f32).collect()
}

impl Local {
    fn read(node: &Value) -> Self {
        if let Ok(columns) = <[f64; 16]>::try_from(numbers(node.get("matrix"))) {
            return Self::Matrix(DMat4::from_cols_array(&columns));
        }
        let vector = |key, default| numbers(node.get(key)).try_into().map_or(default, DVec3::from_array);
        let rotation = <[f64; 4]>::try_from(numbers(node.get("rotation")));
        Self::Parts {
            translation: vector("translation", DVec3::ZERO),
            rotation: rotation.map_or(DQuat::IDENTITY, |q| DQuat::from_array(q).normalize()),
            scale: vector("scale", DVec3::ONE),
        }
    }

    fn matrix(&self) -> DMat4 {
        match *self {
            Self::Matrix(matrix) => matrix,
            Self::Parts { translation, rotation, scale } => {
                DMat4::from_scale_rotation_translation(scale, rotation, translation)
            }
        }
    }
}

/// Returns the nodes with each parent before its children; the scene has checked that they form a tree, but
/// nodes outside the default scene may not, and are left out if they do not.
fn parents_first(nodes: &[PoseNode]) -> Vec<usize> {
    let mut children: Vec<Vec<usize>> = vec![Vec::new(); nodes.len()];
    let mut order = Vec::with_capacity(nodes.len());
    for (node, PoseNode { parent, .. }) in nodes.iter().enumerate() {
        match parent {
            Some(parent) => children[*parent].push(node),
            None => order.push(node),
        }
    }
    let mut next = 0;
    while next < order.len() {
        order.extend_from_slice(&children[order[next]]);
        next += 1;
    }
    order
}

fn numbers(value: Option<&Value>) -> Vec<f64> {
    value.and_then(Value::as_array).into_iter().flatten().filter_map(Value::as_f64).collect()
}
