//! Choice of poses: each as different as possible from those chosen before.

use std::collections::BTreeSet;

use striata::mesh::{IndexedMesh, Semantic};
use striata_io::SceneInstance;

use super::ScenePoses;
use crate::pose::{Pose, Poser};

/// Number of poses that are compared, of all animations and instances.
const MAX_CANDIDATES: usize = 256;
/// Number of morph targets that are also shown alone.
const MAX_TARGETS: usize = 64;
/// Number of vertices by which poses are compared.
const COMPARED_VERTICES: usize = 512;
/// Mean square displacement, relative to the square of the mesh's size, below which a pose shows nothing new.
const LEAST_DIFFERENCE: f64 = 1e-8;

/// An instance of a mesh in a pose.
#[derive(Clone, Debug)]
pub(super) struct PosedInstance<'s> {
    instance: &'s SceneInstance,
    pose: Pose,
}

impl PosedInstance<'_> {
    /// Positions of all vertices of the mesh, in units of [`scale`](Self::scale).
    pub(super) fn positions(&self, poser: &Poser, mesh: &IndexedMesh) -> Vec<[f32; 3]> {
        poser.deformed(&self.pose, self.instance, mesh)
    }

    /// Units of the positions per unit of the mesh.
    pub(super) fn scale(&self) -> f64 {
        let scale = self.instance.scale;
        let is_used = self.instance.skin.is_some() && scale.is_finite() && scale > 0.0;
        if is_used { scale } else { 1.0 }
    }

    /// Differences from the pose of the document, in mesh units; 0 for numbers that are not finite.
    pub(super) fn displacements(&self, poser: &Poser, mesh: &IndexedMesh) -> Vec<f32> {
        let at_rest = poser.deformed(&poser.rest_pose(), self.instance, mesh);
        let posed = self.positions(poser, mesh);
        let pairs = at_rest.as_flattened().iter().zip(posed.as_flattened());
        let scale = self.scale() as f32;
        pairs.map(|(from, to)| (to - from) / scale).map(|x| if x.is_finite() { x } else { 0.0 }).collect()
    }
}

/// Returns poses of the instances of a mesh, each as different as possible from those before it; none if
/// nothing deforms the mesh.
pub(super) fn distinct_poses<'s>(
    poses: &ScenePoses,
    instances: impl Iterator<Item = &'s SceneInstance>,
    mesh: &IndexedMesh,
) -> Vec<PosedInstance<'s>> {
    let targets: Vec<u16> = mesh.layers.iter().filter_map(|layer| morph_target(&layer.semantic)).collect();
    // Instances with the same skin look alike, unless they have weights of their own.
    let mut skins = BTreeSet::new();
    let is_new = |instance: &&SceneInstance| match instance.skin {
        None => !targets.is_empty(),
        Some(skin) => !targets.is_empty() || skins.insert(skin),
    };
    let instances: Vec<&SceneInstance> = instances.filter(is_new).collect();
    let sample = sampled(mesh);
    let with_displacement = |posed: PosedInstance<'s>| {
        let displacement = posed.displacements(poses.poser(), &sample);
        CandidatePose { posed, displacement, difference: f64::INFINITY }
    };
    let candidates = candidates(poses, &instances, &targets).into_iter().map(with_displacement).collect();
    let diagonal = mesh.diagonal();
    farthest_first(candidates, LEAST_DIFFERENCE * diagonal * diagonal * sample.positions.len() as f64)
}

fn morph_target(semantic: &Semantic) -> Option<u16> {
    match semantic {
        Semantic::MorphPosition(target) => Some(*target),
        _ => None,
    }
}

/// Returns poses of all instances: the animations, and each morph target alone.
fn candidates<'s>(
    poses: &ScenePoses,
    instances: &[&'s SceneInstance],
    targets: &[u16],
) -> Vec<PosedInstance<'s>> {
    let rest = poses.poser().rest_pose();
    let mut found = Vec::new();
    // The morph targets of all instances are equal.
    let with_weights = instances.iter().find(|instance| instance.node.is_some());
    for (instance, &target) in with_weights.into_iter().flat_map(|at| targets.iter().map(move |t| (at, t))) {
        let mut weights = vec![0.0; usize::from(target) + 1];
        weights[usize::from(target)] = 1.0;
        let pose = rest.clone().with_morph_weights(instance, weights);
        found.extend(pose.map(|pose| PosedInstance { instance, pose }));
        if found.len() == MAX_TARGETS {
            break;
        }
    }
    let count = instances.len() * poses.poses().len();
    // Evenly spread over all instances and times if there are too many.
    let stride = count.div_ceil(MAX_CANDIDATES - found.len()).max(1);
    for index in (0..count).step_by(stride) {
        let (instance, pose) = (index / poses.poses().len(), index % poses.poses().len());
        found.push(PosedInstance { instance: instances[instance], pose: poses.poses()[pose].clone() });
    }
    found
}

struct CandidatePose<'s> {
    posed: PosedInstance<'s>,
    displacement: Vec<f32>,
    /// Squared difference from the most similar pose chosen so far.
    difference: f64,
}

fn farthest_first(mut candidates: Vec<CandidatePose<'_>>, least: f64) -> Vec<PosedInstance<'_>> {
    let mut chosen = Vec::new();
    // The pose of the document counts as chosen already.
    let mut latest = candidates.first().map_or(Vec::new(), |c| vec![0.0; c.displacement.len()]);
    while !candidates.is_empty() {
        let mut farthest = 0;
        for index in 0..candidates.len() {
            let pairs = candidates[index].displacement.iter().zip(&latest);
            let squared: f64 = pairs.map(|(a, b)| f64::from(a - b).powi(2)).sum();
            candidates[index].difference = squared.min(candidates[index].difference);
            if candidates[index].difference > candidates[farthest].difference {
                farthest = index;
            }
        }
        let CandidatePose { posed, displacement, difference } = candidates.swap_remove(farthest);
        if difference <= least {
            break;
        }
        latest = displacement;
        chosen.push(posed);
    }
    chosen
}

/// Returns some of the vertices of a mesh, evenly spread over its vertices, with all their layers.
fn sampled(mesh: &IndexedMesh) -> IndexedMesh {
    let stride = mesh.vertex_count().div_ceil(COMPARED_VERTICES).max(1);
    let kept: Vec<u32> = (0..mesh.vertex_count() as u32).step_by(stride).collect();
    let positions = kept.iter().map(|&vertex| mesh.positions[vertex as usize]).collect();
    let mut sample = IndexedMesh::new(positions, Vec::new());
    sample.layers = mesh.layers.iter().map(|layer| layer.gather(&kept)).collect();
    sample
}
