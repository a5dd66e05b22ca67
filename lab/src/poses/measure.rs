//! Distances of the posed full mesh from posed levels.

use serde::Serialize;
use striata::mesh::{IndexedMesh, RefinableMesh, TriangleTree, replay_into};
use striata_io::Scene;
use striata_scene::Poser;

/// Fractional part of the golden ratio: its multiples are spread evenly, and never repeat.
const GOLDEN: f64 = 0.618_033_988_749_895;

/// A mesh in a pose of an instance.
pub(super) struct MeasuredPose {
    positions: Vec<[f32; 3]>,
    /// Scene units per mesh unit.
    scale: f64,
}

impl MeasuredPose {
    /// Poses all instances of a mesh at scattered times of all animations, or at rest if there are none.
    pub(super) fn all(
        scene: &Scene,
        poser: &Poser,
        index: usize,
        mesh: &IndexedMesh,
        times: u32,
    ) -> Vec<Self> {
        let mut poses = Vec::new();
        for animation in 0..poser.animation_count() {
            let duration = f64::from(poser.duration(animation));
            let time = |step: u32| (f64::from(step + 1) * GOLDEN).fract() * duration;
            poses.extend((0..times).map(|step| poser.pose(animation, time(step) as f32)));
        }
        if poses.is_empty() {
            poses.push(poser.rest_pose());
        }
        let shown = scene.instances().iter().filter(|at| at.mesh == index && at.scale > 0.0);
        let posed = shown.flat_map(|instance| {
            poses
                .iter()
                .map(|pose| Self { positions: poser.positions(pose, instance, mesh), scale: instance.scale })
        });
        posed.collect()
    }
}

/// Distances over all vertices and poses, mesh units.
#[derive(Clone, Copy, Debug, Default, Serialize)]
pub(super) struct PoseDistances {
    pub rms: f64,
    pub max: f64,
}

/// Measures the distance of each vertex of the full mesh from a level in the same pose.
pub(super) fn distances(
    refinable: &RefinableMesh,
    split_count: usize,
    posed: &[MeasuredPose],
) -> PoseDistances {
    let mut triangles = Vec::new();
    replay_into(&refinable.sequence, split_count, &refinable.mesh.triangles, &mut triangles);
    let (mut sum, mut count, mut max) = (0.0, 0usize, 0.0f64);
    for MeasuredPose { positions, scale } in posed {
        let level = IndexedMesh::new(positions.clone(), triangles.clone());
        let Ok(tree) = TriangleTree::new(&level) else { continue };
        let mut triangle = usize::MAX;
        for position in positions {
            let distance = tree.distance_from_hint(position.map(f64::from), &mut triangle) / scale;
            if distance.is_finite() {
                sum += distance * distance;
                count += 1;
                max = max.max(distance);
            }
        }
    }
    PoseDistances { rms: (sum / count.max(1) as f64).sqrt(), max }
}
