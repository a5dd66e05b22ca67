//! Statistics of a mesh: counts, topology, size.
//!
//! Everything is counted by position (vertices with bit-equal coordinates, -0 being 0), so the numbers do
//! not depend on how a file splits vertices at seams. Topology comes from [`Adjacency`]; the genus follows
//! from Euler's formula and is reported only if the surface is an oriented manifold.
//!
//! Cost: O(n) expected time, about 150 bytes per triangle while counting.

use std::borrow::Cow;
use std::collections::HashSet;

use glam::DVec3;

use super::disjoint_sets::DisjointSets;
use super::weld::index_positions;
use super::{Adjacency, Bounds, IndexedMesh, MeshError};

/// Counts, topology and size of a mesh.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct Statistics {
    /// Number of vertices, whether used or not.
    pub vertex_count: usize,
    /// Number of triangles, whether degenerate or not.
    pub triangle_count: usize,
    /// Number of distinct vertex positions, whether used or not.
    pub position_count: usize,
    /// Number of vertices that no triangle uses.
    pub unused_vertex_count: usize,
    /// Number of triangles without area: two corners at one position, or three on a line.
    pub degenerate_triangle_count: usize,
    /// Number of triangles with the same positions as an earlier one, in either direction.
    pub duplicate_triangle_count: usize,
    /// Number of edges between positions.
    pub edge_count: usize,
    /// Number of connected components; triangles that share a position are connected.
    pub component_count: usize,
    /// Number of edges with one triangle.
    pub boundary_edge_count: usize,
    /// Number of loops of boundary edges; loops that touch count as one.
    pub boundary_loop_count: usize,
    /// Number of edges with more than two triangles.
    pub non_manifold_edge_count: usize,
    /// Number of bow-ties: positions where pieces of surface meet that share no edge there.
    pub non_manifold_vertex_count: usize,
    /// Number of edges whose two triangles face opposite ways.
    pub inconsistent_edge_count: usize,
    /// Vertices minus edges plus triangles, counting only used positions and non-degenerate triangles.
    pub euler_characteristic: i64,
    /// Number of handles, summed over components; `None` unless the mesh is an oriented manifold.
    pub genus: Option<usize>,
    /// Whether the mesh has triangles and no boundary edges.
    pub is_closed: bool,
    /// Sum of the areas of all triangles, in square mesh units.
    pub area: f64,
    /// Bounds of all vertices; `None` if there are none.
    pub bounds: Option<Bounds>,
}

impl Statistics {
    /// Computes the statistics of a mesh.
    ///
    /// # Errors
    /// [`MeshError`] if the mesh is inconsistent; [`validate`](super::validate) then reports all defects.
    pub fn of(mesh: &IndexedMesh) -> Result<Self, MeshError> {
        mesh.check()?;
        let (triangles, position_count) = triangles_by_position(mesh);
        let areas = || (0..mesh.triangles.len()).map(|t| area_of(mesh, t));
        let mut statistics = Self {
            vertex_count: mesh.vertex_count(),
            triangle_count: mesh.triangle_count(),
            position_count,
            unused_vertex_count: unused_vertices(mesh).count(),
            degenerate_triangle_count: areas().filter(|&area| area == 0.0).count(),
            duplicate_triangle_count: duplicate_triangles(&triangles).len(),
            area: areas().sum(),
            bounds: mesh.bounds(),
            ..Self::default()
        };
        statistics.count_topology(&Adjacency::of_triangles(triangles, position_count));
        Ok(statistics)
    }

    fn count_topology(&mut self, adjacency: &Adjacency) {
        self.edge_count = adjacency.edge_count();
        for edge in adjacency.edges() {
            self.boundary_edge_count += usize::from(edge.is_boundary());
            self.non_manifold_edge_count += usize::from(edge.is_non_manifold());
            self.inconsistent_edge_count += usize::from(edge.is_inconsistent());
        }
        self.component_count = adjacency.component_count();
        self.boundary_loop_count = adjacency.boundary_loop_count();
        self.non_manifold_vertex_count = adjacency.bow_ties().len();
        let positions = 0..adjacency.position_count() as u32;
        let used_count = positions.filter(|&p| !adjacency.corners(p).is_empty()).count();
        let side_count: usize = adjacency.edges().map(|edge| edge.side_count()).sum();
        self.euler_characteristic = used_count as i64 - self.edge_count as i64 + (side_count / 3) as i64;
        self.is_closed = self.edge_count > 0 && self.boundary_edge_count == 0;
        self.genus = self.genus_of_manifold();
    }

    /// Genus from V - E + F = 2 - 2 * genus - loops, which holds for each component.
    fn genus_of_manifold(&self) -> Option<usize> {
        let defects =
            self.non_manifold_edge_count + self.non_manifold_vertex_count + self.inconsistent_edge_count;
        if defects > 0 {
            return None;
        }
        let spheres = 2 * self.component_count as i64 - self.boundary_loop_count as i64;
        usize::try_from((spheres - self.euler_characteristic) / 2).ok()
    }

    /// Whether all edges and vertices are manifold and all triangles face consistently; boundaries are
    /// allowed.
    pub fn is_oriented_manifold(&self) -> bool {
        self.genus.is_some()
    }
}

/// The triangles with positions as corners, and the number of positions; indices must be in range.
pub(super) fn triangles_by_position(mesh: &IndexedMesh) -> (Vec<[u32; 3]>, usize) {
    let position_of = index_positions(&mesh.positions);
    let position_count = position_of.iter().max().map_or(0, |&p| p as usize + 1);
    (mesh.triangles.iter().map(|t| t.map(|v| position_of[v as usize])).collect(), position_count)
}

impl IndexedMesh {
    /// Number of connected components, as in [`Statistics::component_count`] but without computing anything
    /// else; linear time.
    ///
    /// # Errors
    /// [`MeshError`] if the mesh is inconsistent.
    pub fn component_count(&self) -> Result<usize, MeshError> {
        self.check()?;
        let (triangles, position_count) = triangles_by_position(self);
        let mut sets = DisjointSets::new(position_count);
        let mut is_used = vec![false; position_count];
        let mut joined = 0;
        for [a, b, c] in triangles {
            if a != b && b != c && c != a {
                [a, b, c].iter().for_each(|&p| is_used[p as usize] = true);
                joined += usize::from(sets.join(a, b)) + usize::from(sets.join(b, c));
            }
        }
        Ok(is_used.iter().filter(|&&is| is).count() - joined)
    }
}

/// Area of a triangle, in square mesh units; exactly 0 if two corners have the same position.
pub(super) fn area_of(mesh: &IndexedMesh, triangle: usize) -> f64 {
    let corner = |v: u32| DVec3::from_array(mesh.positions[v as usize].map(f64::from));
    let [a, b, c] = mesh.triangles[triangle].map(corner);
    0.5 * (b - a).cross(c - a).length()
}

/// Vertices that no triangle uses, in increasing order; indices out of range are ignored.
pub(super) fn unused_vertices(mesh: &IndexedMesh) -> impl Iterator<Item = usize> {
    let mut used = vec![false; mesh.positions.len()];
    for &v in mesh.triangles.iter().flatten() {
        if let Some(slot) = used.get_mut(v as usize) {
            *slot = true;
        }
    }
    used.into_iter().enumerate().filter(|(_, used)| !used).map(|(v, _)| v)
}

/// A triangle with the same three corners as an earlier one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Duplicate {
    pub triangle: u32,
    /// The first triangle with these corners.
    pub first: u32,
    pub is_opposite: bool,
}

/// All triangles with the same corners as an earlier one, in increasing order; degenerate triangles are
/// never duplicates.
pub(super) fn duplicate_triangles(triangles: &[[u32; 3]]) -> Vec<Duplicate> {
    // Around an even permutation of sorted corners, two of the three steps go up; around an odd one, only
    // one does.
    let is_even = |[a, b, c]: [u32; 3]| [a < b, b < c, c < a].into_iter().filter(|&rises| rises).count() == 2;
    let mut sorted: Vec<([u32; 3], u32)> = Vec::with_capacity(triangles.len());
    for (t, &corners) in triangles.iter().enumerate() {
        let mut key = corners;
        key.sort_unstable();
        if key[0] < key[1] && key[1] < key[2] {
            sorted.push((key, t as u32));
        }
    }
    sorted.sort_unstable();
    let mut duplicates = Vec::new();
    for run in sorted.chunk_by(|a, b| a.0 == b.0) {
        let first = run[0].1;
        duplicates.extend(run[1..].iter().map(|&(_, triangle)| {
            let is_opposite = is_even(triangles[triangle as usize]) != is_even(triangles[first as usize]);
            Duplicate { triangle, first, is_opposite }
        }));
    }
    duplicates.sort_unstable_by_key(|duplicate| duplicate.triangle);
    duplicates
}

/// Leaves out the triangles with the positions, the direction and the group of an earlier one, which a picture of an
/// opaque surface does not show. O(n log n).
///
/// # Panics
/// If the mesh is inconsistent.
pub fn without_copies(mesh: &IndexedMesh) -> Cow<'_, IndexedMesh> {
    let position_of = index_positions(&mesh.positions);
    let groups = mesh.groups_or_whole();
    let mut is_copy = vec![false; mesh.triangles.len()];
    for group in &groups {
        let triangles: Vec<[u32; 3]> =
            mesh.triangles[group.range()].iter().map(|t| t.map(|v| position_of[v as usize])).collect();
        // The first one of each direction stays.
        let mut opposite_of = HashSet::new();
        for copy in duplicate_triangles(&triangles) {
            is_copy[group.first as usize + copy.triangle as usize] =
                !copy.is_opposite || !opposite_of.insert(copy.first);
        }
    }
    match is_copy.contains(&true) {
        true => Cow::Owned(mesh.with_triangles(|t| !is_copy[t])),
        false => Cow::Borrowed(mesh),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::shapes;

    fn of(mesh: &IndexedMesh) -> Statistics {
        Statistics::of(mesh).unwrap()
    }

    #[test]
    fn counts_degenerate_duplicate_and_unused_elements() {
        let positions =
            vec![[0., 0., 0.], [2., 0., 0.], [2., 3., 0.], [0., 3., 0.], [1., 0., 0.], [-0., 0., 0.]];
        let triangles = vec![[0, 1, 2], [5, 2, 3], [2, 0, 1], [3, 2, 0], [0, 4, 1], [0, 5, 3]];
        let found = of(&IndexedMesh::new(positions.clone(), triangles));
        assert_eq!((found.vertex_count, found.position_count, found.unused_vertex_count), (6, 5, 0));
        assert_eq!((found.degenerate_triangle_count, found.duplicate_triangle_count), (2, 2));
        assert_eq!(found.area, 12.0);
        assert_eq!(found.bounds.unwrap().max, [2., 3., 0.]);
        let plain = of(&IndexedMesh::new(positions, vec![[0, 1, 2], [5, 2, 3]]));
        assert_eq!((plain.unused_vertex_count, plain.boundary_edge_count, plain.genus), (1, 4, Some(0)));
        assert!(!plain.is_closed);
    }

    #[test]
    fn duplicates_report_their_direction() {
        let found = duplicate_triangles(&[[3, 1, 2], [1, 2, 3], [4, 4, 4], [2, 1, 3], [4, 4, 4], [1, 2, 4]]);
        let duplicate = |triangle, is_opposite| Duplicate { triangle, first: 0, is_opposite };
        assert_eq!(found, vec![duplicate(1, false), duplicate(3, true)]);
    }

    #[test]
    fn topology_of_known_surfaces() {
        let numbers = |mesh: &IndexedMesh| {
            let s = of(mesh);
            (s.euler_characteristic, s.boundary_loop_count, s.genus, s.is_closed)
        };
        assert_eq!(numbers(&shapes::icosphere(1, 1.0)), (2, 0, Some(0), true));
        assert_eq!(numbers(&shapes::torus(5, 6, 2.0, 1.0)), (0, 0, Some(1), true));
        assert_eq!(numbers(&shapes::hard_cube()), (2, 0, Some(0), true));
        assert_eq!(numbers(&shapes::uv_cylinder(5, 2)), (0, 2, Some(0), false));
        assert_eq!(numbers(&shapes::moebius_strip(5)), (0, 1, None, false));
        assert_eq!(numbers(&shapes::klein_bottle(5, 6)), (0, 0, None, true));
        assert_eq!(numbers(&IndexedMesh::default()), (0, 0, Some(0), false));
    }

    #[test]
    fn non_manifold_edges_and_vertices_are_counted() {
        let book = of(&shapes::book(4));
        assert_eq!((book.non_manifold_edge_count, book.boundary_edge_count, book.genus), (1, 8, None));
        let tie = of(&shapes::bow_tie());
        assert_eq!((tie.non_manifold_vertex_count, tie.component_count, tie.genus), (1, 1, None));
        assert_eq!(of(&shapes::many_components(7)).component_count, 7);
    }

    #[test]
    fn copies_are_left_out_of_pictures() {
        let corners = vec![[0., 0., 0.], [1., 0., 0.], [0., 1., 0.], [1., 0., 0.]];
        let triangles = vec![[0, 1, 2], [3, 2, 0], [2, 1, 0], [1, 0, 2], [2, 0, 3]];
        let mut mesh = IndexedMesh::new(corners, triangles);
        assert_eq!(without_copies(&mesh).triangles, [[0, 1, 2], [2, 1, 0]]);
        let group =
            |first, count| crate::mesh::TriangleGroup { name: String::new(), material: None, first, count };
        mesh.groups = vec![group(0, 1), group(1, 0), group(1, 4)];
        let left = without_copies(&mesh);
        assert_eq!(left.triangles, [[0, 1, 2], [3, 2, 0], [2, 1, 0]]);
        assert_eq!(left.groups.iter().map(|g| g.count).collect::<Vec<_>>(), [1, 0, 2]);
        mesh.triangles.truncate(1);
        mesh.groups.clear();
        assert!(matches!(without_copies(&mesh), Cow::Borrowed(_)));
    }
}
