//! Choice of poses: each as different as possible from those chosen before.

use striata::mesh::{IndexedMesh, Semantic};
use striata_io::SceneInstance;

use crate::pose::{Pose, Poser};

/// Number of poses that a mesh is simplified for.
const MAX_POSES: usize = 8;
/// Number of times at which each animation is examined.
const TIMES: usize = 16;
/// Number of poses that are compared, of all animations and instances.
const MAX_CANDIDATES: usize = 256;
/// Number of vertices by which poses are compared.
const COMPARED_VERTICES: usize = 2048;
/// Mean square displacement, relative to the square of the mesh's size, below which a pose shows nothing new.
const LEAST_DIFFERENCE: f64 = 1e-8;

/// Returns the poses in which the instances of a mesh differ most, from the bind pose and from each other.
pub(super) fn chosen_poses<'s>(
    poser: &Poser,
    instances: &[&'s SceneInstance],
    mesh: &IndexedMesh,
) -> Vec<(Pose, &'s SceneInstance)> {
    let sample = sampled(mesh);
    let rest = poser.rest_pose();
    let mut candidates = Vec::new();
    for &instance in instances {
        let at_rest = poser.positions(&rest, instance, &sample);
        for pose in poses(poser, instance, mesh) {
            if candidates.len() == MAX_CANDIDATES {
                break;
            }
            let posed = poser.positions(&pose, instance, &sample);
            let moved = at_rest.as_flattened().iter().zip(posed.as_flattened());
            let displacement: Vec<f32> = moved.map(|(from, to)| to - from).collect();
            if displacement.iter().all(|x| x.is_finite()) {
                candidates.push(Candidate { pose, instance, displacement, difference: f64::INFINITY });
            }
        }
    }
    let diagonal = mesh.diagonal() * instances.iter().map(|instance| instance.scale).fold(0.0, f64::max);
    let least = LEAST_DIFFERENCE * diagonal * diagonal * sample.positions.len() as f64;
    farthest_first(candidates, least)
}

struct Candidate<'s> {
    pose: Pose,
    instance: &'s SceneInstance,
    displacement: Vec<f32>,
    /// Squared difference from the most similar pose chosen so far.
    difference: f64,
}

fn farthest_first(mut candidates: Vec<Candidate<'_>>, least: f64) -> Vec<(Pose, &SceneInstance)> {
    let mut chosen = Vec::new();
    // The bind pose counts as chosen already.
    let mut latest = candidates.first().map_or(Vec::new(), |c| vec![0.0; c.displacement.len()]);
    while chosen.len() < MAX_POSES && !candidates.is_empty() {
        let mut farthest = 0;
        for index in 0..candidates.len() {
            let squared =
                candidates[index].displacement.iter().zip(&latest).map(|(a, b)| f64::from(a - b).powi(2));
            let difference = squared.sum::<f64>().min(candidates[index].difference);
            candidates[index].difference = difference;
            if difference > candidates[farthest].difference {
                farthest = index;
            }
        }
        let Candidate { pose, instance, displacement, difference } = candidates.swap_remove(farthest);
        if difference <= least {
            break;
        }
        latest = displacement;
        chosen.push((pose, instance));
    }
    chosen
}

/// Returns poses at times of all animations, and with each morph target alone if there are no animations.
fn poses(poser: &Poser, instance: &SceneInstance, mesh: &IndexedMesh) -> Vec<Pose> {
    let mut poses = Vec::new();
    let animations = poser.animation_count();
    let times = TIMES.min((MAX_CANDIDATES / animations.max(1)).max(2));
    for animation in 0..animations.min(MAX_CANDIDATES / 2) {
        let duration = poser.duration(animation);
        poses.extend((0..times).map(|i| poser.pose(animation, duration * i as f32 / (times - 1) as f32)));
    }
    if animations == 0 {
        let targets = mesh.layers.iter().filter_map(|layer| match layer.semantic {
            Semantic::MorphPosition(target) => Some(target),
            _ => None,
        });
        poses.extend(targets.filter_map(|target| poser.rest_pose().with_target(instance, target)));
    }
    poses
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
