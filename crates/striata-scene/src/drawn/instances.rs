//! Transforms, joints and morph weights of the instances of a scene at a time of an animation.

use glam::DMat4;
use striata_io::Scene;

use crate::{Pose, Poser};

/// A mesh as a pose shows it.
#[derive(Clone, Debug, PartialEq)]
pub struct DrawnInstance {
    /// Index of the mesh.
    pub mesh: usize,
    /// Transform from the mesh to the scene, in column order; the identity for a skinned mesh, whose joints
    /// move its vertices to the scene.
    pub world: [f64; 16],
    /// Matrix of each joint, in column order; empty without a skin.
    pub joints: Vec<[f64; 16]>,
    /// Weights of the morph targets; those beyond the end of the list are 0.
    pub morph_weights: Vec<f32>,
}

impl Poser {
    /// Returns the meshes as a pose shows them: one entry for each of [`Scene::instances`].
    pub fn instances(&self, scene: &Scene, pose: &Pose) -> Vec<DrawnInstance> {
        let shown = scene.instances().iter().map(|instance| {
            let joints = self.joint_matrices(pose, instance);
            let world = if joints.is_some() { DMat4::IDENTITY } else { pose.matrix_of(instance) };
            DrawnInstance {
                mesh: instance.mesh,
                world: world.to_cols_array(),
                joints: joints.unwrap_or_default().iter().map(DMat4::to_cols_array).collect(),
                morph_weights: pose.weights_of(instance).to_vec(),
            }
        });
        shown.collect()
    }
}
