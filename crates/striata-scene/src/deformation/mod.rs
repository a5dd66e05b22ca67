//! Deformed meshes: simplification that respects the poses of skins, morph targets and animations.
//!
//! A simplifier sees a mesh in its bind pose, in which vertices of different joints may be close together
//! and far apart a moment later. Two things make levels hold in all poses:
//!
//! * Before simplification, [`Deformation::add_layers`] adds the displacements of some poses as morph target
//!   layers. The simplifier counts them like distances, so a collapse that is cheap in the bind pose but
//!   tears a pose is expensive. The poses are chosen one after another, each as different as possible from
//!   those before it.
//! * Afterward, [`Deformation::finish`] removes these layers, measures levels in these and further poses, and
//!   raises the errors of the levels to the largest distance found.
//!
//! Measured at times that were not examined (`docs/results/scenes.md`): half of the triangles of an animated
//! fox have an RMS distance of 0.60 instead of 0.73 and a maximum of 3.5 instead of 8.8 units; at a tenth,
//! 2.5 instead of 2.8 and 13.1 instead of 14.9. No level of three scenes exceeds its error. This is not
//! guaranteed: only vertices, some levels and some poses are measured.
//!
//! A mesh without a skin is examined in its own space, because its node moves all levels alike.

mod measured_levels;
mod pose_choice;
mod raised_errors;
mod scene_poses;

use striata::mesh::{AttributeLayer, IndexedMesh, RefinableMesh, Semantic};
use striata::{Cancelled, ProgressFn, ignore_progress};
use striata_io::Scene;

pub(crate) use self::raised_errors::with_errors;
pub use self::scene_poses::ScenePoses;

use self::measured_levels::measured_levels;
use self::pose_choice::{PosedInstance, distinct_poses};
use self::raised_errors::with_raised_errors;
use crate::pose::Poser;

/// Number of poses that a mesh is simplified for. With eight, coarse levels of an animated fox have larger
/// distances, because the poses outweigh each other.
const MAX_LAYERS: usize = 4;
/// Numbers of a layer of displacements.
const WIDTH: usize = 3;
/// Number of vertices, summed over all layers that are added to a mesh, that bounds their memory: 12 bytes
/// each.
const MAX_LAYER_VERTICES: usize = 1 << 26;

/// The poses that a mesh of a scene is simplified for.
#[derive(Clone, Debug)]
pub struct Deformation<'s> {
    poser: &'s Poser,
    /// The most different poses first.
    poses: Vec<PosedInstance<'s>>,
    /// Layers of the mesh before any were added.
    layer_count: usize,
}

impl<'s> Deformation<'s> {
    /// Chooses poses of a mesh of the scene that the poses belong to; [`None`] if nothing deforms it.
    ///
    /// The mesh is passed separately, because the scene may have been stripped of its triangles.
    pub fn of(
        scene: &'s Scene,
        poses: &'s ScenePoses,
        mesh_index: usize,
        mesh: &IndexedMesh,
    ) -> Option<Self> {
        let poser = poses.poser();
        let is_morphed = mesh.layers.iter().any(|layer| matches!(layer.semantic, Semantic::MorphPosition(_)));
        let is_skinned = mesh.layers.iter().any(|layer| matches!(layer.semantic, Semantic::Joints(_)));
        if !is_morphed && !is_skinned {
            return None;
        }
        let instances = scene.instances().iter().filter(|instance| instance.mesh == mesh_index);
        let poses = distinct_poses(poses, instances, mesh);
        (!poses.is_empty()).then_some(Self { poser, poses, layer_count: mesh.layers.len() })
    }

    /// Adds the displacements of the poses to the mesh, in its own units, as far as there are numbers left
    /// for morph targets.
    pub fn add_layers(&self, mesh: &mut IndexedMesh) {
        let used = mesh.layers.iter().filter_map(|layer| match layer.semantic {
            Semantic::MorphPosition(target) => Some(target),
            _ => None,
        });
        let free = used.max().map_or(Some(0), |target| target.checked_add(1)).map(|first| first..=u16::MAX);
        let count = MAX_LAYERS.min(MAX_LAYER_VERTICES / mesh.vertex_count().max(1));
        let layers: Vec<AttributeLayer> = free
            .into_iter()
            .flatten()
            .zip(self.poses.iter().take(count))
            .map(|(target, posed)| {
                let displacements = posed.displacements(self.poser, mesh);
                AttributeLayer::from_f32(Semantic::MorphPosition(target), WIDTH as u8, displacements)
            })
            .collect();
        mesh.layers.extend(layers);
    }

    /// Removes the layers that were added.
    pub fn remove_layers(&self, mesh: &mut IndexedMesh) {
        mesh.layers.truncate(self.layer_count);
    }

    /// Removes the layers that were added, and raises the errors of levels that are worse in a pose.
    #[must_use]
    pub fn finish(&self, refinable: RefinableMesh) -> RefinableMesh {
        match self.finish_with_progress(refinable, &mut ignore_progress) {
            Ok(refinable) => refinable,
            Err(Cancelled) => unreachable!("the callback that ignores progress never cancels"),
        }
    }

    /// Runs [`finish`](Self::finish) and reports progress; the callback can cancel.
    ///
    /// # Errors
    /// [`Cancelled`] if the callback cancels.
    pub fn finish_with_progress(
        &self,
        mut refinable: RefinableMesh,
        progress: &mut ProgressFn<'_>,
    ) -> Result<RefinableMesh, Cancelled> {
        self.remove_layers(&mut refinable.mesh);
        let measured = measured_levels(&refinable, self.poser, &self.poses, progress)?;
        Ok(with_raised_errors(refinable, &measured))
    }
}
