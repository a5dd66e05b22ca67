//! Adjacency of arbitrary triangles: every edge with all its sides, every position with all its corners.
//!
//! A half-edge structure requires a manifold. Here, an edge simply lists every triangle side that lies on
//! it, whether one or fifty, and a position lists all its corners. Everything is stored in flat arrays that
//! are filled by counting sorts. Indices refer to positions, so a seam, where only vertices differ, does
//! not count as a boundary.
//!
//! ```text
//!        c           corner 3t + 0 is at a; the same index names the side a -> b
//!       / \          corner 3t + 1 is at b, side b -> c
//!      / t \         corner 3t + 2 is at c, side c -> a
//!     a --- b
//! ```
//!
//! Triangles with two corners at one position are ignored: they have no area, hence no neighbors. Cost:
//! O(n) on meshes of bounded valence, O(n log n) in the worst case; about 60 bytes per triangle.

use super::disjoint_sets::DisjointSets;
use super::{IndexedMesh, PositionIndex};

/// The corners and edges of a triangle list, indexed by position.
#[derive(Clone, Debug)]
pub struct Adjacency {
    /// The triangles, with positions as corners.
    triangles: Vec<[u32; 3]>,
    /// Start of each position's corners in `corners`, followed by the number of corners.
    first_corner: Vec<u32>,
    /// Corners sorted by position, each list in increasing order.
    corners: Vec<u32>,
    /// Start of the edges with each lower end in `edges`, followed by the number of edges.
    first_edge: Vec<u32>,
    edges: Vec<EdgeRecord>,
    /// Sides sorted by edge: first those from the lower to the higher end, then the others, each list in
    /// increasing order.
    sides: Vec<u32>,
}

#[derive(Clone, Copy, Debug)]
struct EdgeRecord {
    high: u32,
    /// Start of the edge's sides in `sides`.
    first: u32,
    /// Number of sides that run from the lower to the higher end.
    forward_count: u32,
}

/// An undirected edge between two positions, with all triangle sides that lie on it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Edge<'a> {
    /// The two positions, the smaller index first.
    pub ends: [u32; 2],
    /// Sides that run from `ends[0]` to `ends[1]`; side `3 * triangle + k` starts at corner `k` of its
    /// triangle.
    pub forward: &'a [u32],
    /// Sides that run from `ends[1]` to `ends[0]`.
    pub backward: &'a [u32],
}

impl Edge<'_> {
    /// Number of triangle sides on the edge.
    pub fn side_count(&self) -> usize {
        self.forward.len() + self.backward.len()
    }

    /// All sides of the edge, forward ones first.
    pub fn sides(&self) -> impl Iterator<Item = u32> + '_ {
        self.forward.iter().chain(self.backward).copied()
    }

    /// Whether only one triangle uses the edge.
    pub fn is_boundary(&self) -> bool {
        self.side_count() == 1
    }

    /// Whether more than two triangles use the edge.
    pub fn is_non_manifold(&self) -> bool {
        self.side_count() > 2
    }

    /// Whether two triangles use the edge in the same direction, so that one of them faces the wrong way.
    pub fn is_inconsistent(&self) -> bool {
        self.forward.len() == 2 && self.backward.is_empty()
            || self.backward.len() == 2 && self.forward.is_empty()
    }
}

impl Adjacency {
    /// Builds the adjacency by position: surfaces are connected across seams.
    ///
    /// # Panics
    /// If a triangle uses a vertex that is not in `positions`.
    pub fn of_positions(mesh: &IndexedMesh, positions: &PositionIndex) -> Self {
        let triangles = mesh.triangles.iter().map(|t| t.map(|v| positions.position_of(v))).collect();
        Self::of_triangles(triangles, positions.position_count())
    }

    /// Builds the adjacency by vertex: surfaces end at seams.
    ///
    /// # Panics
    /// If a triangle uses a vertex that does not exist.
    pub fn of_vertices(mesh: &IndexedMesh) -> Self {
        Self::of_triangles(mesh.triangles.clone(), mesh.vertex_count())
    }

    /// Builds the adjacency of triangles whose corners are indices below `position_count`.
    ///
    /// # Panics
    /// If a corner is not below `position_count`.
    pub fn of_triangles(triangles: Vec<[u32; 3]>, position_count: usize) -> Self {
        let mut first_corner = vec![0; position_count + 1];
        let mut first_side = vec![0; position_count + 1];
        for corners in triangles.iter().filter(|t| is_proper(t)) {
            for k in 0..3 {
                let (from, to) = (corners[k], corners[(k + 1) % 3]);
                first_corner[from as usize + 1] += 1;
                first_side[from.min(to) as usize + 1] += 1;
            }
        }
        accumulate(&mut first_corner);
        accumulate(&mut first_side);
        let mut corners = vec![0; first_corner[position_count] as usize];
        let mut sides_by_low = vec![TriangleSide::default(); corners.len()];
        let (mut corner_slot, mut side_slot) = (first_corner.clone(), first_side.clone());
        for (t, triangle) in triangles.iter().enumerate().filter(|(_, t)| is_proper(t)) {
            for k in 0..3 {
                let (from, to) = (triangle[k], triangle[(k + 1) % 3]);
                let corner = (3 * t + k) as u32;
                corners[next_slot(&mut corner_slot[from as usize])] = corner;
                sides_by_low[next_slot(&mut side_slot[from.min(to) as usize])] =
                    TriangleSide { high: from.max(to), is_backward: from > to, corner };
            }
        }
        let (first_edge, edges) = gather_edges(&first_side, &mut sides_by_low);
        let sides = sides_by_low.iter().map(|side| side.corner).collect();
        Self { triangles, first_corner, corners, first_edge, edges, sides }
    }

    /// Number of positions, whether used or not.
    pub fn position_count(&self) -> usize {
        self.first_corner.len() - 1
    }

    /// The triangles with positions as corners, including degenerate ones.
    pub fn triangles(&self) -> &[[u32; 3]] {
        &self.triangles
    }

    /// Number of edges.
    pub fn edge_count(&self) -> usize {
        self.edges.len()
    }

    /// Corners at a position, as `3 * triangle + k`, in increasing order.
    pub fn corners(&self, position: u32) -> &[u32] {
        let p = position as usize;
        &self.corners[self.first_corner[p] as usize..self.first_corner[p + 1] as usize]
    }

    /// Triangles around a position, in increasing order.
    pub fn triangles_around(&self, position: u32) -> impl ExactSizeIterator<Item = u32> + '_ {
        self.corners(position).iter().map(|corner| corner / 3)
    }

    /// All edges, sorted by their ends.
    pub fn edges(&self) -> impl Iterator<Item = Edge<'_>> + '_ {
        (0..self.position_count() as u32).flat_map(|low| self.edges_from(low))
    }

    /// Edges whose lower end is `low`, sorted by their higher end.
    pub fn edges_from(&self, low: u32) -> impl ExactSizeIterator<Item = Edge<'_>> + '_ {
        self.edge_range(low).map(move |index| self.edge(low, index))
    }

    /// The edge between two positions, if any triangle uses it.
    pub fn edge_between(&self, a: u32, b: u32) -> Option<Edge<'_>> {
        let (low, high) = (a.min(b), a.max(b));
        let range = self.edge_range(low);
        let index = self.edges[range.clone()].binary_search_by_key(&high, |edge| edge.high).ok()?;
        Some(self.edge(low, range.start + index))
    }

    fn edge_range(&self, low: u32) -> std::ops::Range<usize> {
        self.first_edge[low as usize] as usize..self.first_edge[low as usize + 1] as usize
    }

    fn edge(&self, low: u32, index: usize) -> Edge<'_> {
        let EdgeRecord { high, first, forward_count } = self.edges[index];
        let end = self.edges.get(index + 1).map_or(self.sides.len(), |next| next.first as usize);
        let (forward, backward) = self.sides[first as usize..end].split_at(forward_count as usize);
        Edge { ends: [low, high], forward, backward }
    }

    /// The two other positions of a corner's triangle, in winding order.
    pub fn opposite_side(&self, corner: u32) -> [u32; 2] {
        let triangle = self.triangles[corner as usize / 3];
        let k = corner as usize % 3;
        [triangle[(k + 1) % 3], triangle[(k + 2) % 3]]
    }

    /// Smallest corner of each piece of surface that meets the others only at this position, in increasing
    /// order.
    ///
    /// The pieces correspond to the components of the position's link: one for a manifold vertex, two for a
    /// bow-tie.
    pub fn link_components(&self, position: u32) -> Vec<u32> {
        let mut scratch = LinkScratch::default();
        self.find_link_components(position, &mut scratch);
        scratch.roots.iter().map(|&root| self.corners(position)[root as usize]).collect()
    }

    /// Positions at which several pieces of surface meet, in increasing order.
    pub fn bow_ties(&self) -> Vec<u32> {
        let mut scratch = LinkScratch::default();
        let mut found = Vec::new();
        for position in 0..self.position_count() as u32 {
            self.find_link_components(position, &mut scratch);
            if scratch.roots.len() > 1 {
                found.push(position);
            }
        }
        found
    }

    fn find_link_components(&self, position: u32, scratch: &mut LinkScratch) {
        let corners = self.corners(position);
        scratch.ends.clear();
        for (index, &corner) in corners.iter().enumerate() {
            scratch.ends.extend(self.opposite_side(corner).map(|end| (end, index as u32)));
        }
        scratch.ends.sort_unstable();
        scratch.sets.reset(corners.len());
        for pair in scratch.ends.windows(2).filter(|pair| pair[0].0 == pair[1].0) {
            scratch.sets.join(pair[0].1, pair[1].1);
        }
        scratch.roots.clear();
        scratch.roots.extend((0..corners.len() as u32).filter(|&i| scratch.sets.root(i) == i));
    }

    /// Number of connected components; triangles that share a position are connected.
    pub fn component_count(&self) -> usize {
        let mut sets = DisjointSets::new(self.position_count());
        let used = (0..self.position_count() as u32).filter(|&p| !self.corners(p).is_empty()).count();
        let joined: usize = self.edges().map(|edge| usize::from(sets.join(edge.ends[0], edge.ends[1]))).sum();
        used - joined
    }

    /// Number of loops of boundary edges; two loops that touch at a position count as one.
    pub fn boundary_loop_count(&self) -> usize {
        let mut sets = DisjointSets::new(self.position_count());
        let mut is_boundary = vec![false; self.position_count()];
        let mut joined = 0;
        for edge in self.edges().filter(Edge::is_boundary) {
            edge.ends.iter().for_each(|&end| is_boundary[end as usize] = true);
            joined += usize::from(sets.join(edge.ends[0], edge.ends[1]));
        }
        is_boundary.iter().filter(|&&is| is).count() - joined
    }
}

/// Scratch memory for the link of a position, reused between positions.
#[derive(Default)]
struct LinkScratch {
    /// Pairs (neighbor, index into the list of corners), sorted.
    ends: Vec<(u32, u32)>,
    sets: DisjointSets,
    /// First corner of each component, as an index into the list of corners.
    roots: Vec<u32>,
}

/// A triangle side while edges are gathered; its fields are in sort order.
#[derive(Clone, Copy, Default, PartialEq, Eq, PartialOrd, Ord)]
struct TriangleSide {
    high: u32,
    is_backward: bool,
    corner: u32,
}

/// Sorts the sides of each lower end and creates an edge for each run with the same higher end.
fn gather_edges(first_side: &[u32], sides: &mut [TriangleSide]) -> (Vec<u32>, Vec<EdgeRecord>) {
    let mut first_edge = Vec::with_capacity(first_side.len());
    let mut edges = Vec::with_capacity(sides.len() / 2);
    for range in first_side.windows(2) {
        first_edge.push(edges.len() as u32);
        let star = &mut sides[range[0] as usize..range[1] as usize];
        star.sort_unstable();
        let mut first = range[0];
        for run in star.chunk_by(|a, b| a.high == b.high) {
            let forward_count = run.iter().filter(|side| !side.is_backward).count() as u32;
            edges.push(EdgeRecord { high: run[0].high, first, forward_count });
            first += run.len() as u32;
        }
    }
    first_edge.push(edges.len() as u32);
    (first_edge, edges)
}

/// Whether a triangle has three different corners. Others have no area and no neighbors, and belong to no
/// strip.
#[inline]
pub fn is_proper(&[a, b, c]: &[u32; 3]) -> bool {
    a != b && b != c && c != a
}

fn accumulate(counts: &mut [u32]) {
    let mut sum = 0;
    for count in counts {
        sum += *count;
        *count = sum;
    }
}

fn next_slot(slot: &mut u32) -> usize {
    *slot += 1;
    *slot as usize - 1
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{shapes, weld};

    fn of(triangles: &[[u32; 3]]) -> Adjacency {
        let position_count = triangles.iter().flatten().max().map_or(0, |&p| p as usize + 1);
        Adjacency::of_triangles(triangles.to_vec(), position_count)
    }

    #[test]
    fn two_triangles_share_one_edge() {
        let adjacency = of(&[[0, 1, 2], [0, 2, 3]]);
        let ends: Vec<_> = adjacency.edges().map(|edge| edge.ends).collect();
        assert_eq!(ends, vec![[0, 1], [0, 2], [0, 3], [1, 2], [2, 3]]);
        let shared = adjacency.edge_between(2, 0).unwrap();
        assert_eq!((shared.forward, shared.backward), (&[3][..], &[2][..]));
        assert!(!shared.is_boundary() && !shared.is_non_manifold() && !shared.is_inconsistent());
        assert_eq!(adjacency.edges().filter(Edge::is_boundary).count(), 4);
        assert_eq!(adjacency.edge_between(1, 3), None);
        assert_eq!(adjacency.corners(2), &[2, 4]);
        assert_eq!(adjacency.opposite_side(4), [3, 0]);
        assert_eq!((adjacency.component_count(), adjacency.boundary_loop_count()), (1, 1));
    }

    #[test]
    fn an_edge_lists_all_triangles_of_a_book() {
        let adjacency = of(&[[0, 1, 2], [1, 0, 3], [0, 1, 4], [0, 1, 0]]);
        let spine = adjacency.edge_between(0, 1).unwrap();
        assert_eq!((spine.forward, spine.backward), (&[0, 6][..], &[3][..]));
        assert!(spine.is_non_manifold() && !spine.is_inconsistent());
        assert_eq!(spine.sides().map(|side| side / 3).collect::<Vec<_>>(), vec![0, 2, 1]);
        assert_eq!(adjacency.link_components(0), vec![0]);
        assert_eq!(adjacency.triangles_around(0).collect::<Vec<_>>(), vec![0, 1, 2]);
    }

    #[test]
    fn a_reversed_neighbor_is_inconsistent() {
        let adjacency = of(&[[0, 1, 2], [2, 0, 3]]);
        assert!(adjacency.edge_between(0, 2).unwrap().is_inconsistent());
        let twisted = Adjacency::of_vertices(&shapes::moebius_strip(5));
        assert_eq!(twisted.edges().filter(Edge::is_inconsistent).count(), 1);
        assert_eq!((twisted.component_count(), twisted.boundary_loop_count()), (1, 1));
    }

    #[test]
    fn a_bow_tie_has_two_link_components() {
        let adjacency = Adjacency::of_vertices(&shapes::bow_tie());
        assert_eq!(adjacency.bow_ties(), vec![0]);
        assert_eq!(adjacency.link_components(0), vec![0, 3]);
        assert_eq!(adjacency.component_count(), 1);
        // A closed fan is a single piece even if its corners are listed out of order.
        let fan = of(&[[0, 1, 2], [0, 3, 4], [0, 2, 3], [0, 4, 1]]);
        assert_eq!(fan.bow_ties(), Vec::<u32>::new());
        assert_eq!(fan.link_components(0), vec![0]);
    }

    #[test]
    fn seams_are_closed_by_position() {
        let welded = weld(&shapes::uv_cylinder(6, 2)).unwrap();
        let by_vertex = Adjacency::of_vertices(&welded.mesh);
        let by_position = Adjacency::of_positions(&welded.mesh, &welded.positions);
        let boundary = |a: &Adjacency| a.edges().filter(Edge::is_boundary).count();
        assert_eq!((boundary(&by_vertex), by_vertex.boundary_loop_count()), (16, 1));
        assert_eq!((boundary(&by_position), by_position.boundary_loop_count()), (12, 2));
    }

    #[test]
    fn empty_and_degenerate_meshes_have_no_edges() {
        let adjacency = of(&[]);
        assert_eq!((adjacency.edge_count(), adjacency.component_count()), (0, 0));
        assert_eq!(of(&[[0, 0, 1], [2, 2, 2]]).component_count(), 0);
    }
}
