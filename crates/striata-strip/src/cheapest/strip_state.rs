//! Strips during annealing: solid links, strip ends and their cost, updated by one join or cut at a time.
//!
//! All costs are local. A link saves three indices (two and a restart), and costs one if the strip swaps
//! across it, which the turns in its two triangles decide. At the end of a strip only the free corner of
//! the last triangle matters, its **apex**: two strips whose ends meet at one apex with matching windings
//! continue from one into the other without a restart, which saves an index. An end with the wrong winding
//! may cost one.

use striata::mesh::NO_TWIN;
use striata::strip::StripLinks;

/// Cost of one index; costs are integers in quarters of an index.
pub(super) const INDEX: i32 = 4;
/// Cost of an unmatched end with the wrong winding: a strip pays an index if both of its ends are like that.
const UNMATCHED_END: i32 = 1;

/// Side of a triangle as `4 * triangle + k`: shifts are cheaper than divisions by three.
type Side = u32;

/// The side after and the side before each side of a triangle.
const NEXT: [u32; 3] = [1, 2, 0];
const PREV: [u32; 3] = [2, 0, 1];

/// Turn of a strip that leaves by the side after the one it entered by.
const BY_NEXT: u8 = 1;

/// Turn of a strip by solid bits and entered side: 0 if it ends, 1 for the next side, 2 for the previous one.
const TURNS: [[u8; 4]; 8] = [
    [0, 0, 0, 0],
    [0, 0, 0, 0],
    [0, 0, 0, 0],
    [1, 2, 0, 0],
    [0, 0, 0, 0],
    [2, 0, 1, 0],
    [0, 1, 2, 0],
    [0, 0, 0, 0],
];

/// Links of a triangle: the twins of its three sides, and its solid bits.
#[derive(Clone, Copy, Debug)]
struct TriangleLinks {
    twins: [Side; 3],
    solid: u32,
}

/// Numbers that a part of the mesh gives its triangles and vertices.
#[derive(Debug)]
pub(super) struct StateNumbers {
    of_triangles: Vec<u32>,
    of_vertices: Vec<u32>,
}

impl StateNumbers {
    pub(super) fn new(triangles: &[[u32; 3]]) -> Self {
        let vertex_count = triangles.as_flattened().iter().max().map_or(0, |&v| v as usize + 1);
        Self { of_triangles: vec![NO_TWIN; triangles.len()], of_vertices: vec![NO_TWIN; vertex_count] }
    }
}

/// Strips as solid links, with counts of the strip ends at each vertex.
///
/// Triangles are numbered along strips, so that a sweep over them stays in the CPU cache.
#[derive(Debug)]
pub(super) struct StripState {
    /// Mesh index of each triangle.
    order: Vec<u32>,
    corners: Vec<[u32; 3]>,
    nodes: Vec<TriangleLinks>,
    /// Number of strip ends at each vertex: those with the right winding at an even position, and the others.
    ends: Vec<[u8; 2]>,
}

impl StripState {
    /// Copies the links between some triangles, in an order that keeps neighbors close to each other in memory.
    /// Links to other triangles are left out.
    ///
    /// `numbers` has room for each triangle and vertex of the mesh, [`NO_TWIN`] before and after.
    pub(super) fn new(
        order: &[u32],
        triangles: &[[u32; 3]],
        links: &StripLinks<'_>,
        numbers: &mut StateNumbers,
    ) -> Self {
        let StateNumbers { of_triangles, of_vertices } = numbers;
        for (&triangle, i) in order.iter().zip(0..) {
            of_triangles[triangle as usize] = i;
        }
        let packed = |side: u32| match links.twins()[side as usize] {
            NO_TWIN => NO_TWIN,
            twin if of_triangles[twin as usize / 3] == NO_TWIN => NO_TWIN,
            twin => (of_triangles[twin as usize / 3] << 2) | (twin % 3),
        };
        let node = |&triangle: &u32| {
            let twins = [0, 1, 2].map(|k| packed(3 * triangle + k));
            let inside = (0..3).fold(0, |bits, k| bits | u32::from(twins[k] != NO_TWIN) << k);
            TriangleLinks { twins, solid: u32::from(links.solid_bits(triangle)) & inside }
        };
        let nodes = order.iter().map(node).collect();
        let mut vertex_count = 0;
        let mut number = |v: u32| {
            let number = &mut of_vertices[v as usize];
            if *number == NO_TWIN {
                (*number, vertex_count) = (vertex_count, vertex_count + 1);
            }
            *number
        };
        let corners = order.iter().map(|&triangle| triangles[triangle as usize].map(&mut number)).collect();
        let mut state =
            Self { order: order.to_vec(), corners, nodes, ends: vec![[0; 2]; vertex_count as usize] };
        for &triangle in order {
            of_triangles[triangle as usize] = NO_TWIN;
            triangles[triangle as usize].iter().for_each(|&v| of_vertices[v as usize] = NO_TWIN);
        }
        for triangle in 0..state.triangle_count() {
            state.change_end(triangle, true);
        }
        state
    }

    /// Joins the solid links, with the triangle indices of the mesh.
    pub(super) fn write_links(&self, links: &mut StripLinks<'_>) {
        for (i, node) in self.nodes.iter().enumerate() {
            for k in (0..3).filter(|k| node.solid & 1 << k != 0) {
                let side = 3 * self.order[i] + k;
                if !links.is_solid(side) {
                    links.join(side);
                }
            }
        }
    }

    /// Mesh index of each triangle.
    pub(super) fn order(&self) -> &[u32] {
        &self.order
    }

    /// Number of triangles.
    pub(super) fn triangle_count(&self) -> u32 {
        self.nodes.len() as u32
    }

    /// Whether the mesh has any link.
    pub(super) fn can_move(&self) -> bool {
        self.nodes.iter().any(|node| node.twins != [NO_TWIN; 3])
    }

    /// Returns the same edge as a side of the neighboring triangle, or [`NO_TWIN`].
    #[inline]
    pub(super) fn twin(&self, side: Side) -> Side {
        self.nodes[side as usize >> 2].twins[side as usize & 3]
    }

    /// Whether the link across this side is solid.
    #[inline]
    pub(super) fn is_solid(&self, side: Side) -> bool {
        self.nodes[side as usize >> 2].solid & 1 << (side & 3) != 0
    }

    /// Returns the solid bits of the triangle of a side.
    #[inline]
    pub(super) fn solid(&self, side: Side) -> u32 {
        self.nodes[side as usize >> 2].solid
    }

    /// Returns how the strip that enters a triangle by this side leaves it, as in [`TURNS`].
    #[inline]
    fn turn(&self, side: Side) -> u8 {
        TURNS[self.nodes[side as usize >> 2].solid as usize & 7][side as usize & 3]
    }

    /// Returns the other solid side of a triangle, if it has one.
    #[inline]
    fn other(&self, side: Side) -> Option<Side> {
        let k = side & 3;
        let others = self.nodes[side as usize >> 2].solid & !(1 << k);
        (others != 0).then(|| (side & !3) | others.trailing_zeros())
    }

    /// Returns 1 if the strip swaps across a solid link, else 0.
    #[inline]
    fn swap(&self, side: Side) -> i32 {
        let turns = (self.turn(side), self.turn(self.twin(side)));
        i32::from(turns == (1, 2) || turns == (2, 1))
    }

    /// Adds or removes the strip end in this triangle, if there is one, and returns the change of cost.
    #[inline]
    fn change_end(&mut self, triangle: u32, is_added: bool) -> i32 {
        let node = self.nodes[triangle as usize];
        if node.solid.count_ones() != 1 {
            return 0;
        }
        let k = node.solid.trailing_zeros() as usize;
        let class = usize::from(self.turn(node.twins[k]) == BY_NEXT);
        let apex = self.corners[triangle as usize][PREV[k] as usize];
        let ends = &mut self.ends[apex as usize];
        let before = ends_cost(*ends);
        ends[class] = if is_added { ends[class].saturating_add(1) } else { ends[class].saturating_sub(1) };
        ends_cost(*ends) - before
    }

    /// Returns the neighbor along the other solid side, if there is one.
    #[inline]
    fn beyond(&self, side: Side) -> Option<u32> {
        self.other(side).map(|other| self.twin(other) >> 2)
    }

    /// Makes a dashed link solid and returns the change of cost.
    pub(super) fn join(&mut self, side: Side) -> i32 {
        let twin = self.twin(side);
        let mut change = -3 * INDEX + self.ends_around(side, twin, false);
        self.nodes[side as usize >> 2].solid |= 1 << (side & 3);
        self.nodes[twin as usize >> 2].solid |= 1 << (twin & 3);
        change += INDEX * self.swaps_around(side, twin);
        change + self.ends_around(side, twin, true)
    }

    /// Makes a solid link dashed and returns the change of cost.
    pub(super) fn cut(&mut self, side: Side) -> i32 {
        let twin = self.twin(side);
        let mut change = 3 * INDEX + self.ends_around(side, twin, false);
        change -= INDEX * self.swaps_around(side, twin);
        self.nodes[side as usize >> 2].solid &= !(1 << (side & 3));
        self.nodes[twin as usize >> 2].solid &= !(1 << (twin & 3));
        change + self.ends_around(side, twin, true)
    }

    /// Number of swaps that a solid link influences: across itself and across its neighbors along the strip.
    #[inline]
    pub(super) fn swaps_at(&self, side: Side) -> i32 {
        self.swaps_around(side, self.twin(side))
    }

    /// Number of swaps across a solid link and the links next to it along the strip.
    #[inline]
    fn swaps_around(&self, side: Side, twin: Side) -> i32 {
        let swap_beyond = |side: Side| self.other(side).map_or(0, |other| self.swap(other));
        self.swap(side) + swap_beyond(side) + swap_beyond(twin)
    }

    /// Adds or removes the strip ends that a link influences: those in its two triangles and in their
    /// neighbors.
    #[inline]
    fn ends_around(&mut self, side: Side, twin: Side, is_added: bool) -> i32 {
        let mut change = self.change_end(side >> 2, is_added) + self.change_end(twin >> 2, is_added);
        for side in [side, twin] {
            if let Some(neighbor) = self.beyond(side) {
                change += self.change_end(neighbor, is_added);
            }
        }
        change
    }

    /// Whether joining a dashed link would close a loop because both of its triangles are in one strip.
    ///
    /// Follows the strip from both triangles in parallel, so that the shorter path decides.
    pub(super) fn closes_loop(&self, side: Side) -> bool {
        let ends = [side, self.twin(side)];
        let mut exits = ends.map(|side| {
            let solid = self.solid(side);
            (solid != 0).then(|| (side & !3) | solid.trailing_zeros())
        });
        loop {
            for i in 0..2 {
                let Some(exit) = exits[i] else { return false };
                let entered = self.twin(exit);
                if entered >> 2 == ends[1 - i] >> 2 {
                    return true;
                }
                exits[i] = self.other(entered);
            }
        }
    }

    /// Returns the next side around the triangle.
    #[inline]
    pub(super) fn next(side: Side) -> Side {
        (side & !3) | NEXT[side as usize & 3]
    }

    /// Returns the previous side around the triangle.
    #[inline]
    pub(super) fn prev(side: Side) -> Side {
        (side & !3) | PREV[side as usize & 3]
    }
}

/// Cost of the ends at one vertex: each pair of the same kind saves a restart.
#[inline]
fn ends_cost([right, wrong]: [u8; 2]) -> i32 {
    let pairs = i32::from(right >> 1) + i32::from(wrong >> 1);
    UNMATCHED_END * i32::from(wrong & 1) - INDEX * pairs
}
