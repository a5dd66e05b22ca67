//! A surface, and the point of it that is nearest to another point.

use glam::DVec3;

use crate::mesh::{Adjacency, IndexedMesh, MeshError, TriangleSearch, TriangleTree};

/// Cosine between the normals of two triangles above which they face the same side.
const SAME_SIDE: f64 = 0.2;
/// Multiple of the distance to the nearest triangle within which one that faces the same side is looked for,
/// with a share of the diagonal added.
const REACH: f64 = 3.0;
const REACH_SHARE: f64 = 0.005;
/// Largest number of steps from a triangle to a neighbor, after a small move.
const MAX_STEPS: usize = 8;
const NONE: u32 = u32::MAX;

/// A point of a triangle, by the shares of its corners.
#[derive(Clone, Copy, Debug)]
pub(super) struct FitPoint {
    pub triangle: u32,
    pub shares: [f64; 3],
}

/// The triangles of a mesh, or its edges as triangles without area.
pub(super) struct FitSurface {
    pub tree: TriangleTree,
    pub corners: Vec<[DVec3; 3]>,
    pub triangles: Vec<[u32; 3]>,
    pub vertex_count: usize,
    /// Normals of the triangles, as long as twice their area.
    pub normals: Vec<DVec3>,
    reach: f64,
    /// For each side of each triangle, the triangle across it or [`NONE`]; empty if searches do not need it.
    neighbors: Vec<[u32; 3]>,
}

impl FitSurface {
    /// # Errors
    /// [`MeshError`] if the mesh is inconsistent.
    pub(super) fn new(mesh: &IndexedMesh) -> Result<Self, MeshError> {
        let at = |v: u32| DVec3::from(mesh.positions[v as usize].map(f64::from));
        let corners: Vec<[DVec3; 3]> = mesh.triangles.iter().map(|t| t.map(at)).collect();
        let normals = corners.iter().map(doubled_normal).collect();
        let tree = TriangleTree::new(mesh)?;
        let (triangles, vertex_count) = (mesh.triangles.clone(), mesh.vertex_count());
        let (reach, neighbors) = (REACH_SHARE * mesh.diagonal(), Vec::new());
        Ok(Self { tree, corners, triangles, vertex_count, normals, reach, neighbors })
    }

    /// Lets searches after small moves walk from triangle to triangle.
    pub(super) fn with_neighbors(mut self, adjacency: &Adjacency) -> Self {
        self.neighbors = vec![[NONE; 3]; self.triangles.len()];
        for edge in adjacency.edges().filter(|edge| edge.side_count() == 2) {
            let mut sides = edge.sides();
            if let (Some(a), Some(b)) = (sides.next(), sides.next()) {
                self.neighbors[a as usize / 3][a as usize % 3] = b / 3;
                self.neighbors[b as usize / 3][b as usize % 3] = a / 3;
            }
        }
        self
    }

    /// Follows vertices that have moved a little; returns which triangles have.
    pub(super) fn move_vertices(&mut self, positions: &[[f32; 3]]) -> Vec<bool> {
        let mut has_moved = vec![false; self.triangles.len()];
        let at = |v: u32| DVec3::from(positions[v as usize].map(f64::from));
        for (t, triangle) in self.triangles.iter().enumerate() {
            let corners = triangle.map(at);
            has_moved[t] = corners != self.corners[t];
            self.corners[t] = corners;
            self.normals[t] = doubled_normal(&corners);
        }
        if has_moved.contains(&true) {
            self.tree.move_corners(self.triangles.iter().map(|t| t.map(|v| positions[v as usize])));
        }
        has_moved
    }

    pub(super) fn at(&self, point: FitPoint) -> DVec3 {
        let [a, b, c] = self.corners[point.triangle as usize];
        let [u, v, w] = point.shares;
        u * a + v * b + w * c
    }

    fn on(&self, triangle: u32, point: DVec3) -> FitPoint {
        FitPoint { triangle, shares: nearest_shares(point, self.corners[triangle as usize]) }
    }

    /// Whether a triangle faces the same side as `normal`.
    fn faces_side(&self, triangle: usize, normal: DVec3) -> bool {
        let other = self.normals[triangle];
        normal.dot(other) > SAME_SIDE * (normal.length_squared() * other.length_squared()).sqrt()
    }

    /// Walks from a triangle to nearer neighbors that face the same side as `normal`.
    fn walk(&self, point: DVec3, normal: DVec3, start: FitPoint) -> FitPoint {
        let away = |found: FitPoint| self.at(found).distance_squared(point);
        let (mut found, mut least) = (start, away(start));
        for _ in 0..MAX_STEPS {
            let from = found;
            // Only across a side on which the nearest point lies can another triangle be nearer.
            for corner in (0..3).filter(|&corner| from.shares[corner] == 0.0) {
                let neighbor = self.neighbors[from.triangle as usize][(corner + 1) % 3];
                if neighbor != NONE && self.faces_side(neighbor as usize, normal) {
                    let candidate = self.on(neighbor, point);
                    let distance = away(candidate);
                    if distance < least {
                        (found, least) = (candidate, distance);
                    }
                }
            }
            if found.triangle == from.triangle {
                break;
            }
        }
        found
    }

    /// Finds the nearest point on a triangle that faces the same side as `normal`; `None` if there is none
    /// within reach. `last` is the point that was found before the surfaces moved a little.
    pub(super) fn nearest(
        &self,
        point: DVec3,
        normal: DVec3,
        search: &mut TriangleSearch,
        last: Option<FitPoint>,
    ) -> Option<FitPoint> {
        if let Some(last) = last {
            let found = self.on(last.triangle, point);
            // Above the inside of a triangle, no neighbor is nearer after a small move.
            if found.shares.iter().all(|&share| share > 0.0) {
                return Some(found);
            }
            if !self.neighbors.is_empty() {
                return Some(self.walk(point, normal, found));
            }
            search.triangle = last.triangle as usize;
        }
        let distance = self.tree.searched_distance(point.to_array(), search);
        let mut found = search.triangle;
        if found < self.corners.len() && !self.faces_side(found, normal) {
            let mut least = REACH * distance + self.reach;
            found = usize::MAX;
            self.tree.visit_searched(point.to_array(), least, search, |candidate, away| {
                if away < least && self.faces_side(candidate, normal) {
                    (found, least) = (candidate, away);
                }
                least
            });
        }
        (found < self.corners.len()).then(|| self.on(found as u32, point))
    }
}

fn doubled_normal(&[a, b, c]: &[DVec3; 3]) -> DVec3 {
    (b - a).cross(c - a)
}

/// Shares of the corners at the point of a triangle that is nearest to `point`.
pub(super) fn nearest_shares(point: DVec3, [a, b, c]: [DVec3; 3]) -> [f64; 3] {
    let normal = (b - a).cross(c - a);
    let squared = normal.length_squared();
    if squared > 0.0 {
        let parts = [(c - b).cross(point - b), (a - c).cross(point - c), (b - a).cross(point - a)];
        let shares = parts.map(|part| part.dot(normal) / squared);
        if shares.iter().all(|&share| share >= 0.0) {
            return shares;
        }
    }
    let mut best = (f64::INFINITY, [1.0, 0.0, 0.0]);
    for (corner, (start, end)) in [(a, b), (b, c), (c, a)].into_iter().enumerate() {
        let along = share_along(point, start, end);
        let away = (start.lerp(end, along) - point).length_squared();
        if away < best.0 {
            let mut shares = [0.0; 3];
            (shares[corner], shares[(corner + 1) % 3]) = (1.0 - along, along);
            best = (away, shares);
        }
    }
    best.1
}

/// Share of the end at the point of a segment that is nearest to `point`.
pub(super) fn share_along(point: DVec3, start: DVec3, end: DVec3) -> f64 {
    let side = end - start;
    let squared = side.length_squared();
    if squared > 0.0 { ((point - start).dot(side) / squared).clamp(0.0, 1.0) } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shares_lead_to_the_nearest_point() {
        let triangle = [DVec3::ZERO, DVec3::new(4.0, 0.0, 0.0), DVec3::new(0.0, 2.0, 0.0)];
        let cases = [
            ([1.0, 0.5, 3.0], [1.0, 0.5, 0.0]),
            ([-1.0, 1.0, 1.0], [0.0, 1.0, 0.0]),
            ([5.0, -3.0, 0.0], [4.0, 0.0, 0.0]),
            ([3.0, 3.0, 0.0], [2.0, 1.0, 0.0]),
        ];
        for (point, expected) in cases {
            let [u, v, w] = nearest_shares(DVec3::from(point), triangle);
            let found = u * triangle[0] + v * triangle[1] + w * triangle[2];
            assert!((found - DVec3::from(expected)).length() < 1e-12, "{point:?}: {found}");
        }
        let flat = [DVec3::ZERO, DVec3::X, DVec3::X];
        assert_eq!(nearest_shares(DVec3::new(0.25, 1.0, 0.0), flat)[1], 0.25);
    }

    #[test]
    fn the_other_side_of_a_sheet_is_not_found() {
        let at = |x: f32, y: f32, z: f32| [x, y, z];
        let positions = vec![
            at(0.0, 0.0, 0.0),
            at(1.0, 0.0, 0.0),
            at(0.0, 1.0, 0.0),
            at(0.0, 0.0, -0.005),
            at(1.0, 0.0, -0.005),
            at(0.0, 1.0, -0.005),
        ];
        let sheet = IndexedMesh::new(positions, vec![[0, 1, 2], [3, 5, 4]]);
        let surface = FitSurface::new(&sheet).expect("a valid mesh");
        for (normal, expected) in [(DVec3::Z, 0), (DVec3::NEG_Z, 1)] {
            let mut search = TriangleSearch::new();
            let found = surface.nearest(DVec3::new(0.2, 0.2, 0.001), normal, &mut search, None);
            assert_eq!(found.map(|point| point.triangle), Some(expected));
        }
        assert!(
            surface
                .nearest(DVec3::new(0.2, 0.2, 0.001), DVec3::X, &mut TriangleSearch::new(), None)
                .is_none()
        );
    }
}
