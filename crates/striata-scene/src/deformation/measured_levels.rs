//! Measures some levels of a mesh in its poses: for each level, the largest distance of a vertex of the full
//! mesh from the surface of the level.
//!
//! The distance from the triangle that a vertex has most likely collapsed into is never less than that from
//! the surface, nor is the distance from the point of it that was nearest in the pose before. If it is no more
//! than the largest distance so far, nothing else is computed, and in most poses no level needs a search tree.

use striata::mesh::{RefinableMesh, TriangleTree};
use striata::{Cancelled, Progress, ProgressFn};

use super::pose_choice::PosedInstance;
use crate::level_walk::LevelWalk;
use crate::pose::Poser;

/// Ratio of the steps of one measured level to those of the next finer one.
const LEVEL_RATIO: f64 = 0.7;
/// Ratio for small meshes, and the number of vertices, summed over the poses, up to which a mesh is small.
const DENSE_LEVEL_RATIO: f64 = 0.9;
const SMALL_WORK: usize = 1 << 18;
/// Factor on the largest distances. Between two of 32 evenly spread times, a distance that rises and falls
/// twice within an animation may be larger by 1 - cos(2 pi / 31), or 2 %.
const TIME_MARGIN: f64 = 1.02;
/// Number of vertices that are examined, summed over the poses.
const EXAMINED_VERTICES: usize = 1 << 19;
/// Least number of poses in which a large mesh is measured, as long as the vertices of all poses do not
/// exceed the limit below, which bounds memory: 12 bytes each.
const MIN_POSES: usize = 16;
const MAX_EXAMINED_VERTICES: usize = 1 << 26;

/// A level and the largest distance found in any pose.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct MeasuredLevel {
    pub split_count: usize,
    /// Mesh units; at least the error that the level had before.
    pub distance: f64,
}

/// Positions of all vertices in a pose.
struct PosedPositions {
    positions: Vec<[f32; 3]>,
    /// Units of the positions per mesh unit.
    scale: f64,
    /// Distance at the last level if it exceeded that of all poses before, otherwise 0.
    rank: f64,
}

/// Measures levels, from fine to coarse, in the first of the poses: all of them if the mesh is small.
pub(super) fn measured_levels(
    refinable: &RefinableMesh,
    poser: &Poser,
    poses: &[PosedInstance<'_>],
    progress: &mut ProgressFn<'_>,
) -> Result<Vec<MeasuredLevel>, Cancelled> {
    let vertices = refinable.mesh.vertex_count().max(1);
    let count = (EXAMINED_VERTICES / vertices).max(MIN_POSES).min(MAX_EXAMINED_VERTICES / vertices);
    let posed = poses.iter().take(count).map(|posed| PosedPositions {
        positions: posed.positions(poser, &refinable.mesh),
        scale: posed.scale(),
        rank: 0.0,
    });
    let finer = refinable.mesh.triangles.clone();
    let mut meter = LevelMeter { refinable, posed: posed.collect(), finer, walk: LevelWalk::default() };
    let is_small = meter.posed.len() * vertices <= SMALL_WORK;
    let ratio = if is_small { DENSE_LEVEL_RATIO } else { LEVEL_RATIO };
    let step_count = refinable.sequence.step_count();
    let mut measured = Vec::new();
    let mut split_count = step_count;
    while split_count > 0 {
        let (done, total) = ((step_count - split_count) as u64, step_count as u64);
        Progress { phase: "poses", done, total }.report(progress)?;
        split_count = ((split_count as f64 * ratio) as usize).min(split_count - 1);
        measured.push(MeasuredLevel { split_count, distance: meter.measure(split_count) });
    }
    Ok(measured)
}

struct LevelMeter<'r> {
    refinable: &'r RefinableMesh,
    posed: Vec<PosedPositions>,
    /// Triangles of the last level.
    finer: Vec<[u32; 3]>,
    walk: LevelWalk,
}

impl LevelMeter<'_> {
    /// Returns the largest distance in any pose.
    fn measure(&mut self, split_count: usize) -> f64 {
        let Self { refinable: RefinableMesh { sequence, .. }, posed, finer, walk } = self;
        walk.move_to(finer, sequence, split_count);
        finer.clone_from(&walk.triangles);
        let mut tree = None;
        let mut worst = f64::from(sequence.error_at(split_count));
        for posed in posed.iter_mut() {
            let distance =
                worst_distance(&posed.positions, walk, &mut tree, worst * posed.scale) / posed.scale;
            posed.rank = if distance > worst { distance } else { 0.0 };
            worst = worst.max(distance);
        }
        // Next time, the worst poses come first, which saves searches in the others.
        posed.sort_by(|a, b| b.rank.total_cmp(&a.rank));
        TIME_MARGIN * worst
    }
}

/// Returns the largest distance of a vertex from the triangles of a level; `enough` if it is less. `tree` keeps the tree
/// of the level's triangles from pose to pose.
fn worst_distance(
    positions: &[[f32; 3]],
    walk: &mut LevelWalk,
    tree: &mut Option<TriangleTree>,
    enough: f64,
) -> f64 {
    let mut worst = enough;
    let mut is_in_pose = false;
    for (vertex, position) in (0..).zip(positions) {
        let near = walk.nearest(positions, vertex, worst * worst);
        if near.is_some_and(|squared| squared <= worst * worst) {
            continue;
        }
        if !is_in_pose {
            move_to_pose(tree, positions, &walk.triangles);
            is_in_pose = true;
        }
        let Some(tree) = tree else { break };
        let point = position.map(f64::from);
        if point.iter().any(|x| !x.is_finite()) {
            continue;
        }
        let triangle = walk.triangle_of(vertex);
        let mut nearest = *triangle as usize;
        let distance = tree.distance_within(point, worst, &mut nearest);
        *triangle = nearest as u32;
        if distance.is_finite() {
            worst = worst.max(distance);
        }
    }
    worst
}

/// Moves the tree of some triangles to a pose, or creates it. A pose with positions that are not finite has no tree.
fn move_to_pose(tree: &mut Option<TriangleTree>, positions: &[[f32; 3]], triangles: &[[u32; 3]]) {
    let corners = || triangles.iter().map(|triangle| triangle.map(|vertex| positions[vertex as usize]));
    if !corners().flatten().flatten().all(f32::is_finite) {
        *tree = None;
    } else if let Some(tree) = tree {
        tree.move_corners(corners());
    } else {
        *tree = Some(TriangleTree::of_triangles(corners().collect()));
    }
}
