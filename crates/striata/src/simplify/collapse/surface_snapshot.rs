//! Box tree over the triangles of the surface at one moment, for nearest-point queries.
//!
//! The error of a vanished part is its distance from whatever part replaces it. To find that, the
//! triangles of all parts are put into a tree. Collapses do not update the tree; it is rebuilt once
//! half of its triangles are gone, so all builds together cost about two of the first. Between builds,
//! queries return triangles that may have changed since; the caller only needs the parts that they belong
//! to, which still exist. A node of the tree is split when a query reaches it first.

use std::cell::RefCell;

use glam::{Vec3, Vec3A};
use wide::f32x8;

use crate::mesh::{AxisBox, BoxTree, PointPacket};

use super::fan::nearest;
use super::fan::point;
use super::links::{LinkEdge, Links};
use super::wedges::Wedges;

/// Triangle of the tree.
#[derive(Clone, Copy, Debug)]
pub(in crate::simplify) struct SnapshotTriangle {
    pub positions: [u32; 3],
    pub vertices: [u32; 3],
}

/// Point on the tree's triangles that is nearest to a query point.
#[derive(Clone, Copy, Debug)]
pub(in crate::simplify) struct SnapshotPoint {
    pub distance_squared: f32,
    pub triangle: SnapshotTriangle,
    /// Barycentric coordinates in the triangle.
    pub weights: [f32; 3],
}

/// Box tree over all triangles that exist when it is built.
#[derive(Default)]
pub(in crate::simplify) struct SurfaceSnapshot {
    tree: RefCell<BoxTree>,
    triangles: Vec<SnapshotTriangle>,
}

impl SurfaceSnapshot {
    /// Builds the tree over the triangles in the links.
    pub(in crate::simplify) fn new(
        links: &Links,
        wedges: Option<&Wedges<'_>>,
        positions: &[[f32; 4]],
    ) -> Self {
        let mut triangles = Vec::new();
        let mut edges: Vec<LinkEdge> = Vec::new();
        for p in 0..positions.len() as u32 {
            links.edges_into(p, &mut edges);
            for e in edges.iter().filter(|e| p < e.a && p < e.b) {
                triangles.push(match wedges {
                    None => SnapshotTriangle { positions: [p, e.a, e.b], vertices: [p, e.a, e.b] },
                    Some(wedges) => {
                        let vertices = wedges.corners(e.triangle);
                        SnapshotTriangle { positions: vertices.map(|v| wedges.position_of(v)), vertices }
                    }
                });
            }
        }
        Self::of_triangles(triangles, positions)
    }

    /// Builds the tree over triangles given by their corners.
    pub(in crate::simplify) fn of_triangles(
        triangles: Vec<SnapshotTriangle>,
        positions: &[[f32; 4]],
    ) -> Self {
        let tree = BoxTree::unsplit(triangles.len(), |t| box_of(&triangles[t as usize], positions));
        Self { tree: RefCell::new(tree), triangles }
    }

    /// Visits triangles whose boxes are closer to a point than a squared limit, near ones first;
    /// `visit` returns the limit to use from then on.
    pub(in crate::simplify) fn visit_near(
        &self,
        positions: &[[f32; 4]],
        from: Vec3,
        limit: f32,
        mut visit: impl FnMut(&SnapshotTriangle) -> f32,
    ) {
        let boxes = |t: u32| box_of(&self.triangles[t as usize], positions);
        let visit = |index: usize| visit(&self.triangles[index]);
        self.tree.borrow_mut().visit_near_and_split(&boxes, Vec3A::from(from), limit, visit);
    }

    /// Visits triangles whose boxes are closer to some point of a packet than its squared limit, near ones first;
    /// `visit` returns the limits to use from then on.
    pub(in crate::simplify) fn visit_near_any(
        &self,
        positions: &[[f32; 4]],
        points: PointPacket,
        limits: f32x8,
        mut visit: impl FnMut(&SnapshotTriangle) -> f32x8,
    ) {
        let boxes = |t: u32| box_of(&self.triangles[t as usize], positions);
        let visit = |index: usize| visit(&self.triangles[index]);
        self.tree.borrow_mut().visit_near_any_and_split(&boxes, points, limits, visit);
    }

    /// Number of triangles in the tree.
    pub(in crate::simplify) fn triangle_count(&self) -> usize {
        self.triangles.len()
    }

    /// Nearest point on the triangles that `is_host` accepts, if one is within the squared distance `limit`.
    pub(in crate::simplify) fn nearest(
        &self,
        positions: &[[f32; 4]],
        from: Vec3,
        limit: f32,
        is_host: impl Fn(&SnapshotTriangle) -> bool,
    ) -> Option<SnapshotPoint> {
        let mut best: Option<SnapshotPoint> = None;
        let mut least = limit;
        self.visit_near(positions, from, limit, |&triangle| {
            if is_host(&triangle) {
                let [a, b, c] = triangle.positions.map(|p| point(positions, p) - from);
                let weights = nearest(a, b, c);
                let distance_squared = (a * weights[0] + b * weights[1] + c * weights[2]).length_squared();
                if distance_squared < least || (best.is_none() && distance_squared <= least) {
                    least = distance_squared;
                    best = Some(SnapshotPoint { distance_squared, triangle, weights });
                }
            }
            // The distance of a box may equal that of its triangle; rounding must not exclude the triangle.
            least * 1.000_01
        });
        best
    }
}

fn box_of(triangle: &SnapshotTriangle, positions: &[[f32; 4]]) -> AxisBox {
    let [a, b, c] = triangle.positions.map(|p| Vec3A::from(point(positions, p)));
    AxisBox { min: a.min(b).min(c), max: a.max(b).max(c) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_nearest_host_is_found() {
        // Two triangles at heights 0 and 1.
        let corners = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]];
        let positions: Vec<[f32; 4]> =
            [0.0, 1.0].iter().flat_map(|&z| corners.map(|[x, y]| [x, y, z, 0.0])).collect();
        let links = Links::new(6, &[[0, 1, 2], [3, 4, 5]], false);
        let snapshot = SurfaceSnapshot::new(&links, None, &positions);
        assert_eq!(snapshot.triangle_count(), 2);
        let from = Vec3::new(0.25, 0.25, 0.75);
        let nearest = snapshot.nearest(&positions, from, f32::INFINITY, |_| true).expect("there are two");
        assert_eq!((nearest.triangle.positions, nearest.distance_squared), ([3, 4, 5], 0.0625));
        let other = snapshot
            .nearest(&positions, from, f32::INFINITY, |t| t.positions[0] == 0)
            .expect("one is a host");
        assert_eq!(other.distance_squared, 0.5625);
        assert!(snapshot.nearest(&positions, from, 0.5, |t| t.positions[0] == 0).is_none(), "too far");
    }
}
