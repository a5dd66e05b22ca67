//! The dual graph of a mesh: a node for each triangle, a link for each edge shared by two triangles.
//!
//! Strips and clusters are built by walking from triangle to triangle. Two triangles are linked if they
//! traverse a common edge in opposite directions, belong to the same group and agree on the vertices of the
//! edge. If an edge has more than two sides, the first forward side is linked with the first backward side,
//! and so on, so every side has at most one link and every node at most three.
//!
//! ```text
//!          c               side 3t + 1 runs b -> c, its twin
//!        /   \  \          side 3n + k runs c -> b;
//!      /   t   \  n  >     each side stores the other
//!    a --------- b
//! ```
//!
//! Linear time on meshes of bounded valence; 40 bytes per triangle during construction, 12 afterward.

use std::cmp::Ordering;

use super::{IndexedMesh, PositionIndex, is_proper};

/// Links between neighboring triangles.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct DualGraph {
    twins: Vec<[u32; 3]>,
}

/// Value in place of a twin: there is no link across this side.
pub const NO_TWIN: u32 = u32::MAX;

impl DualGraph {
    /// Links triangles of the same group that share two vertices; there are no links across seams and group
    /// boundaries, as strips require.
    ///
    /// # Panics
    /// If a triangle uses a vertex that does not exist, or if the groups do not cover the triangles.
    pub fn of_vertices(mesh: &IndexedMesh) -> Self {
        Self::of_triangles(&mesh.triangles, mesh.vertex_count(), &group_ends(mesh))
    }

    /// Links triangles that share two positions, also across seams and group boundaries.
    ///
    /// # Panics
    /// If a triangle uses a vertex that is not in `positions`.
    pub fn of_positions(mesh: &IndexedMesh, positions: &PositionIndex) -> Self {
        let triangles: Vec<_> = mesh.triangles.iter().map(|t| t.map(|v| positions.position_of(v))).collect();
        Self::of_triangles(&triangles, positions.position_count(), &[triangles.len() as u32])
    }

    /// Links triangles of the same group; `group_ends` is increasing and ends with the triangle count.
    fn of_triangles(triangles: &[[u32; 3]], vertex_count: usize, group_ends: &[u32]) -> Self {
        let (firsts, mut sides) = sides_by_low_end(triangles, vertex_count);
        let mut pairing = SidePairing {
            triangles,
            group_ends,
            twins: vec![[NO_TWIN; 3]; triangles.len()],
            edge: [vec![], vec![]],
        };
        for range in firsts.windows(2) {
            let around = &mut sides[range[0] as usize..range[1] as usize];
            around.sort_unstable();
            for edge in around.chunk_by(|a, b| a >> 32 == b >> 32) {
                pairing.pair_edge(edge);
            }
        }
        Self { twins: pairing.twins }
    }

    /// Number of nodes, one for each triangle; degenerate triangles have no links.
    pub fn triangle_count(&self) -> usize {
        self.twins.len()
    }

    /// The triangle across side `k` (from corner `k` to the next corner), if there is one.
    #[inline]
    pub fn neighbor(&self, triangle: u32, k: usize) -> Option<u32> {
        self.twin(3 * triangle + k as u32).map(|side| side / 3)
    }

    /// The triangles across the three sides; [`NO_TWIN`] for sides without a link.
    ///
    /// A triangle can appear twice, since two triangles can share two edges.
    #[inline]
    pub fn neighbors(&self, triangle: u32) -> [u32; 3] {
        self.twins[triangle as usize].map(|side| if side == NO_TWIN { NO_TWIN } else { side / 3 })
    }

    /// The twin of every side; [`NO_TWIN`] for sides without a link.
    pub fn twins(&self) -> &[u32] {
        self.twins.as_flattened()
    }

    /// The side of the neighboring triangle that is linked with this side, `3 * triangle + k`.
    #[inline]
    pub fn twin(&self, side: u32) -> Option<u32> {
        let twin = self.twins[side as usize / 3][side as usize % 3];
        (twin != NO_TWIN).then_some(twin)
    }

    /// Number of links of a triangle, 0 to 3.
    #[inline]
    pub fn degree(&self, triangle: u32) -> usize {
        self.twins[triangle as usize].iter().filter(|&&side| side != NO_TWIN).count()
    }

    /// Number of links in the graph.
    pub fn link_count(&self) -> usize {
        self.twins.iter().flatten().filter(|&&side| side != NO_TWIN).count() / 2
    }
}

/// The sides of all non-degenerate triangles, sorted by the lower vertex of each: the start of each
/// vertex's list, and for each side its higher vertex (high 32 bits) and its index (low 32 bits).
fn sides_by_low_end(triangles: &[[u32; 3]], vertex_count: usize) -> (Vec<u32>, Vec<u64>) {
    let ends = |[a, b, c]: [u32; 3]| [(a, b), (b, c), (c, a)].map(|(a, b)| (a.min(b), a.max(b)));
    let proper =
        || (0..).zip(triangles.iter().copied()).filter(|(_, corners): &(u32, [u32; 3])| is_proper(corners));
    let mut firsts = vec![0; vertex_count + 2];
    for (low, _) in proper().flat_map(|(_, corners)| ends(corners)) {
        firsts[low as usize + 2] += 1;
    }
    for i in 2..firsts.len() {
        firsts[i] += firsts[i - 1];
    }
    let mut sides = vec![0; firsts[vertex_count + 1] as usize];
    for (triangle, corners) in proper() {
        for (side, (low, high)) in (3 * triangle..).zip(ends(corners)) {
            let slot = &mut firsts[low as usize + 1];
            sides[*slot as usize] = u64::from(high) << 32 | u64::from(side);
            *slot += 1;
        }
    }
    firsts.pop();
    (firsts, sides)
}

/// Pairs up the sides of one edge at a time.
struct SidePairing<'a> {
    triangles: &'a [[u32; 3]],
    group_ends: &'a [u32],
    twins: Vec<[u32; 3]>,
    /// Sides of the current edge that run toward its higher vertex, and those that run toward its lower one.
    edge: [Vec<u32>; 2],
}

impl SidePairing<'_> {
    /// Pairs up the sides of an edge; their indices, in the low 32 bits, are increasing.
    fn pair_edge(&mut self, sides: &[u64]) {
        for side in sides.iter().map(|&side| side as u32) {
            let [a, b, c] = self.triangles[side as usize / 3];
            let runs_down = [a > b, b > c, c > a][side as usize % 3];
            self.edge[usize::from(runs_down)].push(side);
        }
        let group_of = |side: u32| self.group_ends.partition_point(|&end| end <= side / 3);
        let [mut up, mut down] = [0, 0];
        // The lists are sorted by triangle and thus by group, so a single pass pairs up group after group.
        while let (Some(&a), Some(&b)) = (self.edge[0].get(up), self.edge[1].get(down)) {
            let order =
                if self.group_ends.len() == 1 { Ordering::Equal } else { group_of(a).cmp(&group_of(b)) };
            if order.is_eq() {
                self.twins[a as usize / 3][a as usize % 3] = b;
                self.twins[b as usize / 3][b as usize % 3] = a;
            }
            up += usize::from(order.is_le());
            down += usize::from(order.is_ge());
        }
        self.edge.iter_mut().for_each(Vec::clear);
    }
}

/// End of each non-empty group: one past its last triangle.
fn group_ends(mesh: &IndexedMesh) -> Vec<u32> {
    mesh.groups_or_whole()
        .iter()
        .filter(|group| group.count > 0)
        .map(|group| group.first + group.count)
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{TriangleGroup, shapes, weld};

    fn plain(triangles: &[[u32; 3]]) -> IndexedMesh {
        let vertex_count = triangles.iter().flatten().max().map_or(0, |&v| v as usize + 1);
        IndexedMesh::new(vec![[0.0; 3]; vertex_count], triangles.to_vec())
    }

    #[test]
    fn both_sides_of_a_link_store_each_other() {
        let graph = DualGraph::of_vertices(&plain(&[[0, 1, 2], [0, 2, 3], [2, 1, 4]]));
        assert_eq!(graph.neighbors(0), [NO_TWIN, 2, 1]);
        assert_eq!(graph.neighbors(1), [0, NO_TWIN, NO_TWIN]);
        assert_eq!((graph.twin(2), graph.twin(3), graph.twin(0)), (Some(3), Some(2), None));
        assert_eq!(graph.neighbor(2, 0), Some(0));
        assert_eq!((graph.degree(0), graph.degree(2), graph.link_count()), (2, 1, 2));
    }

    #[test]
    fn only_opposite_sides_are_linked() {
        let graph = DualGraph::of_vertices(&plain(&[[0, 1, 2], [0, 1, 3]]));
        assert_eq!(graph.link_count(), 0);
        let moebius = DualGraph::of_vertices(&shapes::moebius_strip(5));
        assert_eq!(moebius.link_count(), 9);
    }

    #[test]
    fn many_triangles_on_an_edge_are_paired_in_order() {
        let graph = DualGraph::of_vertices(&plain(&[
            [0, 1, 2],
            [0, 1, 3],
            [1, 0, 4],
            [0, 1, 5],
            [6, 1, 0],
            [0, 0, 1],
        ]));
        assert_eq!([0, 1, 2, 3, 4, 5].map(|t| graph.degree(t)), [1, 1, 1, 0, 1, 0]);
        assert_eq!(graph.neighbors(0), [2, NO_TWIN, NO_TWIN]);
        assert_eq!(graph.neighbors(4), [NO_TWIN, 1, NO_TWIN]);
    }

    #[test]
    fn links_do_not_cross_groups_and_seams() {
        let mut mesh = plain(&[[0, 1, 2], [1, 0, 3], [0, 1, 4], [1, 0, 5]]);
        let group = |first, count| TriangleGroup { first, count, ..TriangleGroup::default() };
        mesh.groups = vec![group(0, 1), group(1, 0), group(1, 3)];
        let graph = DualGraph::of_vertices(&mesh);
        assert_eq!([0, 1, 2, 3].map(|t| graph.neighbors(t)[0]), [NO_TWIN, 2, 1, NO_TWIN]);

        let welded = weld(&shapes::hard_cube()).unwrap();
        assert_eq!(DualGraph::of_vertices(&welded.mesh).link_count(), 6);
        assert_eq!(DualGraph::of_positions(&welded.mesh, &welded.positions).link_count(), 18);
    }

    #[test]
    fn two_opposite_triangles_share_three_links() {
        let graph = DualGraph::of_vertices(&plain(&[[0, 1, 2], [0, 2, 1]]));
        assert_eq!((graph.neighbors(0), graph.link_count()), ([1, 1, 1], 3));
    }
}
