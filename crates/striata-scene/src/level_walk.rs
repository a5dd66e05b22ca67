//! Points of a level that are near the vertices of the full mesh.
//!
//! The search for a vertex starts at the vertex that it has collapsed to, and walks from triangle to nearer and nearer
//! neighbors. It finds a point of the level, so its distance is never less than that from the level, and most often
//! the same.

use glam::DVec3;
use striata::mesh::{CollapseSequence, replay_into};

/// Largest number of steps from a triangle to a neighbor.
const MAX_WALK: usize = 32;
/// Number of triangles that are looked at around a corner, so that hubs do not take quadratic time.
const MAX_RING: usize = 64;

/// A point of a triangle of the level.
#[derive(Clone, Copy, Debug)]
struct Hint {
    triangle: u32,
    /// Shares of the second and third corner.
    shares: [f32; 2],
}

const NO_HINT: Hint = Hint { triangle: u32::MAX, shares: [0.0; 2] };

/// Triangles of a level, and for each vertex of the full mesh the point of the level that its last search found.
#[derive(Debug, Default)]
pub(crate) struct LevelWalk {
    /// Triangles of the level.
    pub triangles: Vec<[u32; 3]>,
    hints: Vec<Hint>,
    rings: VertexRings,
}

impl LevelWalk {
    /// Moves to a level, given the triangles of the full mesh or of a finer level; all points lie at the vertices that
    /// their vertices have collapsed to.
    pub(crate) fn move_to(&mut self, finer: &[[u32; 3]], sequence: &CollapseSequence, split_count: usize) {
        self.triangles.clear();
        replay_into(sequence, split_count, finer, &mut self.triangles);
        nearby_triangles(sequence, split_count, &self.triangles, &mut self.hints);
        self.rings.rebuild(&self.triangles, self.hints.len());
    }

    /// Walks to the point nearest to a vertex, and returns its squared distance; stops at any that is no farther than
    /// the squared distance `enough`. [`None`] if nothing of the level is known to be near.
    pub(crate) fn nearest(&mut self, positions: &[[f32; 3]], vertex: u32, enough: f64) -> Option<f64> {
        let Self { triangles, hints, rings } = self;
        let at = |vertex: u32| DVec3::from_array(positions[vertex as usize].map(f64::from));
        let hint = &mut hints[vertex as usize];
        let &start = triangles.get(hint.triangle as usize)?;
        if start.contains(&vertex) {
            return Some(0.0);
        }
        let point = at(vertex);
        let squared_at =
            |corners: [u32; 3], shares: [f64; 2]| point.distance_squared(point_at(corners.map(at), shares));
        let last = squared_at(start, hint.shares.map(f64::from));
        if last <= enough {
            return Some(last);
        }
        let nearest_of = |corners: [u32; 3]| {
            let shares = nearest_shares(point, corners.map(at));
            (squared_at(corners, shares), shares.map(|share| share as f32))
        };
        let (mut nearest, shares) = nearest_of(start);
        hint.shares = shares;
        for _ in 0..MAX_WALK {
            if nearest <= enough {
                break;
            }
            let from = hint.triangle;
            let corners = triangles[from as usize];
            for (done, &corner) in corners.iter().enumerate() {
                for &neighbor in rings.of(corner).iter().take(MAX_RING) {
                    let others = triangles[neighbor as usize];
                    if corners[..done].iter().any(|corner| others.contains(corner)) {
                        // It has been compared at that corner, or is one of too many there.
                        continue;
                    }
                    let (other, shares) = nearest_of(others);
                    if other < nearest {
                        nearest = other;
                        *hint = Hint { triangle: neighbor, shares };
                    }
                }
            }
            if hint.triangle == from {
                break;
            }
        }
        Some(nearest)
    }

    /// Triangle in which the point of a vertex lies; may not exist.
    pub(crate) fn triangle_of(&mut self, vertex: u32) -> &mut u32 {
        &mut self.hints[vertex as usize].triangle
    }
}

/// The triangles of each vertex.
#[derive(Debug, Default)]
struct VertexRings {
    /// Index of the first triangle of each vertex, and the number of all at the end.
    first: Vec<u32>,
    triangles: Vec<u32>,
}

impl VertexRings {
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

/// Finds for each vertex a corner of the level: the vertex that it has collapsed to.
fn nearby_triangles(
    sequence: &CollapseSequence,
    split_count: usize,
    triangles: &[[u32; 3]],
    hints: &mut Vec<Hint>,
) {
    hints.clear();
    hints.resize(sequence.positions().vertex_count(), NO_HINT);
    for (index, triangle) in (0..).zip(triangles) {
        for (&vertex, shares) in triangle.iter().zip([[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]) {
            hints[vertex as usize] = Hint { triangle: index, shares };
        }
    }
    for vertex in sequence.vertex_count_at(split_count)..hints.len() {
        hints[vertex] = hints[sequence.target(vertex as u32) as usize];
    }
}

/// Returns the nearest point of a triangle as shares of its second and third corner: the point is
/// `a + x (b - a) + y (c - a)`. Of a triangle without area, some point of a side.
///
/// The regions of the triangle are distinguished as in Ericson 2004, Real-Time Collision Detection, 5.1.5.
pub(crate) fn nearest_shares(point: DVec3, [a, b, c]: [DVec3; 3]) -> [f64; 2] {
    let ratio = |part: f64, whole: f64| (part / whole.max(f64::MIN_POSITIVE)).clamp(0.0, 1.0);
    let (ab, ac, ap) = (b - a, c - a, point - a);
    let (d1, d2) = (ab.dot(ap), ac.dot(ap));
    if d1 <= 0.0 && d2 <= 0.0 {
        return [0.0, 0.0];
    }
    let bp = point - b;
    let (d3, d4) = (ab.dot(bp), ac.dot(bp));
    if d3 >= 0.0 && d4 <= d3 {
        return [1.0, 0.0];
    }
    let vc = d1 * d4 - d3 * d2;
    if vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0 {
        return [ratio(d1, d1 - d3), 0.0];
    }
    let cp = point - c;
    let (d5, d6) = (ab.dot(cp), ac.dot(cp));
    if d6 >= 0.0 && d5 <= d6 {
        return [0.0, 1.0];
    }
    let vb = d5 * d2 - d1 * d6;
    if vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0 {
        return [0.0, ratio(d2, d2 - d6)];
    }
    let va = d3 * d6 - d5 * d4;
    if va <= 0.0 && d4 >= d3 && d5 >= d6 {
        let share = ratio(d4 - d3, (d4 - d3) + (d5 - d6));
        return [1.0 - share, share];
    }
    [ratio(vb, va + vb + vc), ratio(vc, va + vb + vc)]
}

/// Returns the point of a triangle with these shares.
pub(crate) fn point_at([a, b, c]: [DVec3; 3], [x, y]: [f64; 2]) -> DVec3 {
    a + x * (b - a) + y * (c - a)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nearest_points_of_a_triangle() {
        let triangle = [DVec3::ZERO, DVec3::X, DVec3::Y];
        for (from, expected) in [
            ([0.25, 0.25, 3.0], [0.25, 0.25]),
            ([-1.0, -1.0, 0.0], [0.0, 0.0]),
            ([3.0, 0.0, 1.0], [1.0, 0.0]),
            ([0.0, 3.0, 1.0], [0.0, 1.0]),
            ([0.5, -2.0, 0.0], [0.5, 0.0]),
            ([-2.0, 0.5, 0.0], [0.0, 0.5]),
            ([1.0, 1.0, 0.0], [0.5, 0.5]),
        ] {
            assert_eq!(nearest_shares(DVec3::from(from), triangle), expected, "{from:?}");
        }
    }

    #[test]
    fn triangles_without_area_have_a_point_too() {
        for triangle in
            [[DVec3::ONE; 3], [DVec3::ZERO, DVec3::X, 2.0 * DVec3::X], [DVec3::X, DVec3::X, DVec3::ZERO]]
        {
            for from in [DVec3::ZERO, DVec3::X, DVec3::new(1.5, 1.0, -1.0), -DVec3::ONE] {
                let [x, y] = nearest_shares(from, triangle);
                assert!(x >= 0.0 && y >= 0.0 && x + y <= 1.0 + 1e-12, "{from} {triangle:?}: {x} {y}");
            }
        }
    }
}
