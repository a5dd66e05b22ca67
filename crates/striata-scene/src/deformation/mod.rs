//! Deformed meshes: simplification that respects the poses of skins, morph targets and animations.
//!
//! A simplifier sees a mesh in its bind pose, in which vertices of different joints may be close together
//! and far apart a moment later. Two things make levels hold in all poses:
//!
//! * Before simplification, [`Deformation::add_layers`] adds the displacements of some poses as morph target
//!   layers. The simplifier counts them like distances, so a collapse that is cheap in the bind pose but tears
//!   a pose is expensive. The poses are chosen one after another, each as different as possible from those
//!   before it.
//! * Afterward, [`Deformation::finish`] removes these layers, measures the levels in the poses, and raises
//!   the errors of the levels to the largest distance found.
//!
//! Measured on an animated fox of 576 triangles at half of them, over fifteen times of its animations: the
//! RMS distance falls from 0.56 to 0.40, the largest from 8.8 to 3.2 units, and no level exceeds its error.

mod poses;
mod raised_errors;

use striata::mesh::{AttributeLayer, IndexedMesh, RefinableMesh, Semantic};
use striata_io::{Scene, SceneInstance};

use self::poses::chosen_poses;
use self::raised_errors::with_raised_errors;
use crate::pose::{Pose, Poser};

/// The poses that a mesh of a scene is simplified for.
#[derive(Debug)]
pub struct Deformation<'s> {
    poser: &'s Poser,
    poses: Vec<(Pose, &'s SceneInstance)>,
    /// Layers of the mesh before any were added.
    layer_count: usize,
}

impl<'s> Deformation<'s> {
    /// Chooses poses of a mesh; [`None`] if nothing deforms it.
    pub fn of(scene: &'s Scene, poser: &'s Poser, mesh_index: usize) -> Option<Self> {
        let mesh = scene.meshes().get(mesh_index)?.as_ref()?;
        let instances: Vec<&SceneInstance> =
            scene.instances().iter().filter(|instance| instance.mesh == mesh_index).collect();
        let has_targets =
            mesh.layers.iter().any(|layer| matches!(layer.semantic, Semantic::MorphPosition(_)));
        if !has_targets && instances.iter().all(|instance| instance.skin.is_none()) {
            return None;
        }
        let poses = chosen_poses(poser, &instances, mesh);
        (!poses.is_empty()).then_some(Self { poser, poses, layer_count: mesh.layers.len() })
    }

    /// Adds the displacements of the poses to the mesh, in its own units.
    pub fn add_layers(&self, mesh: &mut IndexedMesh) {
        let rest = self.poser.rest_pose();
        let used = mesh.layers.iter().filter_map(|layer| match layer.semantic {
            Semantic::MorphPosition(target) => Some(target),
            _ => None,
        });
        let first = used.max().map_or(0, |target| target.saturating_add(1));
        let mut layers = Vec::new();
        for (number, (pose, instance)) in self.poses.iter().enumerate() {
            let Some(target) = first.checked_add(number as u16) else { break };
            let at_rest = self.poser.positions(&rest, instance, mesh);
            let posed = self.poser.positions(pose, instance, mesh);
            let scale = if instance.scale > 0.0 { instance.scale as f32 } else { 1.0 };
            let displacements = at_rest.as_flattened().iter().zip(posed.as_flattened());
            let displacements: Vec<f32> = displacements.map(|(from, to)| (to - from) / scale).collect();
            layers.push(AttributeLayer::from_f32(Semantic::MorphPosition(target), 3, displacements));
        }
        mesh.layers.extend(layers);
    }

    /// Removes the layers that were added, and raises the errors of levels that are worse in a pose.
    pub fn finish(&self, mut refinable: RefinableMesh) -> RefinableMesh {
        refinable.mesh.layers.truncate(self.layer_count);
        with_raised_errors(refinable, self.poser, &self.poses)
    }
}
