//! Distances of the simplified surface from the original mesh.
//!
//! Witnesses measure original vertices only. A triangle that bridges a valley or leaves a sheet may lie far
//! from the original although every original vertex is near it. Each position therefore has an upper bound
//! for the triangles around it. A collapse adds to it how far its new edges stick out of the star that they
//! replace, and the triangles themselves are measured only if the bound exceeds the largest error so far.

use wide::f32x8;

use crate::mesh::lanes::lane_max;
use crate::mesh::{PACKET, PointPacket, Welded};

use super::fan::point;
use super::links::LinkEdge;
use super::surface_snapshot::{SnapshotTriangle, SurfaceSnapshot};

/// Distances below this share of the largest error so far are not distinguished: a smaller share takes
/// longer, and measured triangles are measured again later.
const MEASURED_SHARE: f32 = 0.5;

/// Barycentric coordinates of the sample points on each triangle, the first of which is the center of the fan. The other
/// end of an edge of the fan is that of the next triangle.
const SAMPLES: [[f32; 3]; PACKET] = [
    [0.5, 0.5, 0.0],
    [0.75, 0.25, 0.0],
    [0.25, 0.75, 0.0],
    [0.34, 0.33, 0.33],
    [0.6, 0.2, 0.2],
    [0.2, 0.6, 0.2],
    [0.2, 0.2, 0.6],
    [0.1, 0.45, 0.45],
];

/// Bounds of all positions, and the original mesh once it is needed.
#[derive(Default)]
pub(in crate::simplify) struct OutwardBounds {
    original: Option<SurfaceSnapshot>,
    /// Largest distance of the triangles around each position from the original; empty until first queried.
    bounds: Vec<f32>,
}

impl OutwardBounds {
    /// Returns a bound for the triangles that replace those around `v` and stick out of them by
    /// `protrusion_squared`; `worst` is the largest squared error so far.
    pub(in crate::simplify) fn bound_after(
        &mut self,
        v: u32,
        protrusion_squared: f32,
        worst: f32,
        position_count: usize,
    ) -> f32 {
        if self.bounds.is_empty() {
            // All earlier collapses stayed within the error so far.
            self.bounds.resize(position_count, worst.sqrt());
        }
        self.bounds[v as usize] + protrusion_squared.sqrt()
    }

    /// Raises the bounds of `u` and its `ring` to at least `bound`.
    pub(in crate::simplify) fn note(&mut self, u: u32, ring: &[u32], bound: f32) {
        for &p in ring.iter().chain([&u]) {
            if let Some(bound_of_position) = self.bounds.get_mut(p as usize) {
                *bound_of_position = bound_of_position.max(bound);
            }
        }
    }

    /// Measures the largest distance from the original mesh of the triangles of `u` with the opposite
    /// `edges`. Returns at least [`MEASURED_SHARE`] of the largest error so far; `worst` is the square
    /// of that error.
    pub(in crate::simplify) fn measure(
        &mut self,
        (welded, positions): (&Welded, &[[f32; 4]]),
        (u, edges): (u32, &[LinkEdge]),
        worst: f32,
    ) -> f32 {
        let original = self.original.get_or_insert_with(|| snapshot_of(welded, positions));
        // Triangles next to each other are near the same one, and one that is near enough ends the search.
        let mut near: Option<SnapshotTriangle> = None;
        let mut farthest = MEASURED_SHARE * MEASURED_SHARE * worst;
        let corners_of = |triangle: &SnapshotTriangle| triangle.positions.map(|p| point(positions, p));
        for e in edges {
            let corners = [u, e.a, e.b].map(|p| point(positions, p));
            let samples =
                PointPacket::new(SAMPLES.map(|[a, b, c]| corners[0] * a + corners[1] * b + corners[2] * c));
            // Corners are vertices of the original, so the nearest corner bounds the distance.
            let from_corners = corners.map(|corner| samples.squared_distances_from(corner));
            let mut least = from_corners[0].fast_min(from_corners[1]).fast_min(from_corners[2]);
            if lane_max(least) <= farthest {
                continue;
            }
            if let Some(near) = &near {
                least = least.fast_min(samples.squared_distances(corners_of(near)));
            }
            let enough = f32x8::splat(farthest);
            let open = |least: f32x8| least.simd_gt(enough).bitselect(least, f32x8::ZERO);
            if lane_max(least) > farthest {
                original.visit_near_any(positions, samples, open(least), |triangle| {
                    let found = samples.squared_distances(corners_of(triangle));
                    if found.simd_lt(least).any() {
                        near = Some(*triangle);
                    }
                    least = least.fast_min(found);
                    open(least)
                });
                farthest = farthest.max(lane_max(least));
            }
        }
        farthest.sqrt()
    }
}

fn snapshot_of(welded: &Welded, positions: &[[f32; 4]]) -> SurfaceSnapshot {
    let of = |&vertices: &[u32; 3]| SnapshotTriangle {
        positions: vertices.map(|v| welded.positions.position_of(v)),
        vertices,
    };
    SurfaceSnapshot::of_triangles(welded.mesh.triangles.iter().map(of).collect(), positions)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{IndexedMesh, weld};

    /// A valley with two slopes along y, 1 deep and 2 wide.
    fn valley() -> (Welded, Vec<[f32; 4]>) {
        let corners = [[0., 0., 1.], [1., 0., 0.], [2., 0., 1.], [0., 4., 1.], [1., 4., 0.], [2., 4., 1.]];
        let triangles = vec![[0, 1, 4], [0, 4, 3], [1, 2, 5], [1, 5, 4]];
        let welded = weld(&IndexedMesh::new(corners.to_vec(), triangles)).expect("the mesh is valid");
        let positions = welded.mesh.positions.iter().map(|&[x, y, z]| [x, y, z, 0.0]).collect();
        (welded, positions)
    }

    fn corner(positions: &[[f32; 4]], at: [f32; 3]) -> u32 {
        positions.iter().position(|p| p[..3] == at).expect("there is such a corner") as u32
    }

    #[test]
    fn a_bridge_is_as_far_from_the_valley_as_its_slopes_are() {
        let (welded, positions) = valley();
        // The triangle 0 2 5 bridges the valley: the midpoint of its edge 0 2 is 1 above the ground,
        // but nearer to the slopes.
        let [p, a, b] = [[0., 0., 1.], [2., 0., 1.], [2., 4., 1.]].map(|at| corner(&positions, at));
        let edges = [LinkEdge { a, b, triangle: 0 }];
        let found = OutwardBounds::default().measure((&welded, &positions), (p, &edges), 0.0);
        assert!((found - 0.5f32.sqrt()).abs() < 1e-5, "{found}");
    }

    #[test]
    fn small_distances_are_rounded_up_to_a_share_of_the_error() {
        let (welded, positions) = valley();
        let [p, a, b] = [[0., 0., 1.], [1., 0., 0.], [1., 4., 0.]].map(|at| corner(&positions, at));
        let edges = [LinkEdge { a, b, triangle: 0 }];
        let found = OutwardBounds::default().measure((&welded, &positions), (p, &edges), 4.0);
        assert_eq!(found, 1.0, "half the error, although the triangle is part of the valley");
    }

    #[test]
    fn bounds_add_up_until_they_are_measured() {
        let mut outward = OutwardBounds::default();
        assert_eq!(outward.bound_after(1, 4.0, 0.0, 3), 2.0);
        outward.note(1, &[2], 2.0);
        assert_eq!(outward.bound_after(2, 1.0, 0.0, 3), 3.0);
        assert_eq!(outward.bound_after(0, 1.0, 0.0, 3), 1.0);
    }
}
