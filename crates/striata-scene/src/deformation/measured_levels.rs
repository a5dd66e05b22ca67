//! Measures some levels of a mesh in its poses: for each level, the largest distance of a vertex of the full
//! mesh from the surface of the level.
//!
//! The distance from the triangle that a vertex has most likely collapsed into is never less than that from
//! the surface. If it is no more than the largest distance so far, nothing else is computed, and in most
//! poses no level needs a search tree. Cost: about a microsecond per vertex and pose.

use glam::DVec3;
use striata::mesh::{CollapseSequence, IndexedMesh, RefinableMesh, TriangleTree, replay_into};
use striata::{Cancelled, Progress, ProgressFn};

use super::pose_choice::PosedInstance;
use crate::pose::Poser;

/// Ratio of the steps of one measured level to those of the next finer one.
const LEVEL_RATIO: f64 = 0.7;
/// The same for small meshes, and the number of vertices, summed over the poses, up to which a mesh is small.
const DENSE_LEVEL_RATIO: f64 = 0.9;
const SMALL_WORK: usize = 1 << 18;
/// Factor on the largest distances. Between two of 32 evenly spread times, a distance that rises and falls
/// twice within an animation may be larger by 1 - cos(2 pi / 31), or 2 %.
const TIME_MARGIN: f64 = 1.02;
/// Largest number of steps from a triangle to a neighbor.
const MAX_WALK: usize = 32;
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
struct PosedMesh {
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
    let posed = poses.iter().take(count).map(|posed| PosedMesh {
        positions: posed.positions(poser, &refinable.mesh),
        scale: posed.scale(),
        rank: 0.0,
    });
    let mut meter = LevelMeter {
        refinable,
        posed: posed.collect(),
        triangles: Vec::new(),
        hints: Vec::new(),
        rings: Rings::default(),
    };
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
    posed: Vec<PosedMesh>,
    /// Triangles of the level.
    triangles: Vec<[u32; 3]>,
    /// For each vertex, a triangle of the level near the vertex that it has collapsed to.
    hints: Vec<u32>,
    rings: Rings,
}

impl LevelMeter<'_> {
    /// Returns the largest distance in any pose.
    fn measure(&mut self, split_count: usize) -> f64 {
        let Self { refinable, posed, triangles, hints, rings } = self;
        let sequence = &refinable.sequence;
        triangles.clear();
        replay_into(refinable, split_count, &refinable.mesh.triangles, triangles);
        nearby_triangles(sequence, split_count, triangles, hints);
        rings.rebuild(triangles, refinable.mesh.vertex_count());
        let mut worst = f64::from(sequence.error_at(split_count));
        for posed in posed.iter_mut() {
            let corners = std::mem::take(triangles);
            let mut shown = IndexedMesh::new(std::mem::take(&mut posed.positions), corners);
            let distance = worst_distance(&shown, rings, hints, worst * posed.scale) / posed.scale;
            posed.rank = if distance > worst { distance } else { 0.0 };
            worst = worst.max(distance);
            *triangles = std::mem::take(&mut shown.triangles);
            posed.positions = shown.positions;
        }
        // Next time, the worst poses come first, which saves searches in the others.
        posed.sort_by(|a, b| b.rank.total_cmp(&a.rank));
        TIME_MARGIN * worst
    }
}

/// Returns the largest distance of a vertex from the triangles of a level; `enough` if it is less.
fn worst_distance(shown: &IndexedMesh, rings: &Rings, hints: &mut [u32], enough: f64) -> f64 {
    let mut worst = enough;
    let mut tree = None;
    for (vertex, hint) in hints.iter_mut().enumerate() {
        if is_near(shown, rings, (vertex as u32, hint), worst) {
            continue;
        }
        // A pose with positions that are not finite has no surface.
        let Ok(tree) = tree.get_or_insert_with(|| TriangleTree::new(shown)) else { break };
        let point = shown.positions[vertex].map(f64::from);
        if point.iter().any(|x| !x.is_finite()) {
            continue;
        }
        let mut triangle = *hint as usize;
        let distance = tree.distance_within(point, worst, &mut triangle);
        *hint = triangle as u32;
        if distance.is_finite() {
            worst = worst.max(distance);
        }
    }
    worst
}

/// Whether a vertex is a corner of a triangle, or no farther than a distance from it or from one that is
/// found by walking to nearer and nearer neighbors; the hint becomes the last one.
fn is_near(shown: &IndexedMesh, rings: &Rings, (vertex, hint): (u32, &mut u32), distance: f64) -> bool {
    let at = |vertex: u32| DVec3::from_array(shown.positions[vertex as usize].map(f64::from));
    let Some(&start) = shown.triangles.get(*hint as usize) else { return false };
    if start.contains(&vertex) {
        return true;
    }
    let (point, limit) = (at(vertex), distance * distance);
    let squared = |triangle: [u32; 3]| point.distance_squared(nearest_point(point, triangle.map(at)));
    let mut nearest = squared(start);
    for _ in 0..MAX_WALK {
        if nearest <= limit {
            return true;
        }
        let from = *hint;
        for &corner in &shown.triangles[from as usize] {
            for &neighbor in rings.of(corner) {
                let other = squared(shown.triangles[neighbor as usize]);
                if other < nearest {
                    (nearest, *hint) = (other, neighbor);
                }
            }
        }
        if *hint == from {
            return false;
        }
    }
    nearest <= limit
}

/// The triangles of each vertex.
#[derive(Default)]
struct Rings {
    /// Index of the first triangle of each vertex, and the number of all at the end.
    first: Vec<u32>,
    triangles: Vec<u32>,
}

impl Rings {
    fn of(&self, vertex: u32) -> &[u32] {
        &self.triangles[self.first[vertex as usize] as usize..self.first[vertex as usize + 1] as usize]
    }

    fn rebuild(&mut self, triangles: &[[u32; 3]], vertex_count: usize) {
        self.first.clear();
        self.first.resize(vertex_count + 1, 0);
        for &vertex in triangles.as_flattened() {
            self.first[vertex as usize] += 1;
        }
        let mut end = 0;
        for first in &mut self.first {
            end += *first;
            *first = end;
        }
        self.triangles.clear();
        self.triangles.resize(3 * triangles.len(), 0);
        for (index, triangle) in triangles.iter().enumerate() {
            for &vertex in triangle {
                // Each ring is filled from its end.
                self.first[vertex as usize] -= 1;
                self.triangles[self.first[vertex as usize] as usize] = index as u32;
            }
        }
    }
}

/// Returns the point of a triangle that is nearest to a point, or another one if the triangle is degenerate.
fn nearest_point(point: DVec3, [a, b, c]: [DVec3; 3]) -> DVec3 {
    let (ab, ac, normal) = (b - a, c - a, (b - a).cross(c - a));
    let scale = normal.length_squared().max(f64::MIN_POSITIVE);
    let (x, y) = ((point - a).cross(ac).dot(normal) / scale, ab.cross(point - a).dot(normal) / scale);
    if x >= 0.0 && y >= 0.0 && x + y <= 1.0 {
        return a + x * ab + y * ac;
    }
    let on_side = |start: DVec3, end: DVec3| {
        let side = end - start;
        let share = (point - start).dot(side) / side.length_squared().max(f64::MIN_POSITIVE);
        start + share.clamp(0.0, 1.0) * side
    };
    let nearer =
        |p: DVec3, q: DVec3| if point.distance_squared(p) <= point.distance_squared(q) { p } else { q };
    nearer(on_side(a, b), nearer(on_side(b, c), on_side(c, a)))
}

/// Finds for each vertex a triangle of a level near the vertex that it has collapsed to.
fn nearby_triangles(
    sequence: &CollapseSequence,
    split_count: usize,
    triangles: &[[u32; 3]],
    hints: &mut Vec<u32>,
) {
    hints.clear();
    hints.resize(sequence.positions().vertex_count(), u32::MAX);
    for (index, triangle) in triangles.iter().enumerate() {
        for &vertex in triangle {
            hints[vertex as usize] = index as u32;
        }
    }
    for vertex in sequence.vertex_count_at(split_count)..hints.len() {
        hints[vertex] = hints[sequence.target(vertex as u32) as usize];
    }
}
