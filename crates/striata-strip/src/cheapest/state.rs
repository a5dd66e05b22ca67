//! The strips under annealing: links, ends, and what they cost, all changed by one join or cut at a time.
//!
//! Everything here is local. A link saves three indices (two and a restart); it costs one if the strip swaps across
//! it, which the two triangles decide by their turns. Where a strip ends only the last triangle's
//! free corner matters, its **apex**: two strips whose ends meet at one apex on the right windings go on from one into
//! the other without a restart, which saves an index. An end on the wrong winding may cost one.

use striata::mesh::NO_TWIN;
use striata::strip::StripLinks;

/// Cost of one index: costs are whole numbers of quarters.
pub(super) const INDEX: i32 = 4;
/// What an end of the wrong winding costs that meets no other: a strip pays an index if both of its ends are such.
const ILL_END: i32 = 1;

/// A side as `4 * triangle + k`: shifts are cheaper than divisions by three.
type Side = u32;

/// The side after a side, and the one before it.
const NEXT: [u32; 3] = [1, 2, 0];
const PREV: [u32; 3] = [2, 0, 1];

/// A strip goes on from a solid side by the next side around the triangle.
const BY_NEXT: u8 = 1;

/// How a strip goes on, by solid bits and side: 0 it ends, 1 by the next side, 2 by the one before.
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

/// A triangle: the sides across its three sides, and its solid bits.
#[derive(Clone, Copy, Debug)]
struct Node {
    twins: [Side; 3],
    solid: u32,
}

/// Strips as solid links, with the ends that meet at each vertex.
///
/// Triangles are numbered along strips, so that a sweep over them stays in cache.
#[derive(Debug)]
pub(super) struct State {
    /// The mesh's number of each triangle.
    order: Vec<u32>,
    corners: Vec<[u32; 3]>,
    nodes: Vec<Node>,
    /// Ends at each vertex that begin well, and that begin ill, at an even place.
    ends: Vec<[u8; 2]>,
}

impl State {
    /// Takes over the links of triangles, in an order that keeps neighbors near each other.
    pub(super) fn new(order: Vec<u32>, triangles: &[[u32; 3]], links: &StripLinks<'_>) -> Self {
        let mut place = vec![NO_TWIN; triangles.len()];
        for (&triangle, i) in order.iter().zip(0..) {
            place[triangle as usize] = i;
        }
        let packed = |side: u32| match links.twins()[side as usize] {
            NO_TWIN => NO_TWIN,
            twin => (place[twin as usize / 3] << 2) | (twin % 3),
        };
        let node = |&triangle: &u32| Node {
            twins: [0, 1, 2].map(|k| packed(3 * triangle + k)),
            solid: u32::from(links.solid_bits(triangle)),
        };
        let nodes = order.iter().map(node).collect();
        let corners: Vec<_> = order.iter().map(|&triangle| triangles[triangle as usize]).collect();
        let vertex_count = corners.as_flattened().iter().max().map_or(0, |&v| v as usize + 1);
        let mut state = Self { order, corners, nodes, ends: vec![[0; 2]; vertex_count] };
        for triangle in 0..state.triangle_count() {
            state.change_end(triangle, true);
        }
        state
    }

    /// Gives the links back, in the mesh's numbers.
    pub(super) fn write_links(&self, links: &mut StripLinks<'_>) {
        links.clear();
        for (i, node) in self.nodes.iter().enumerate() {
            for k in (0..3).filter(|k| node.solid & 1 << k != 0) {
                let side = 3 * self.order[i] + k;
                if !links.is_solid(side) {
                    links.join(side);
                }
            }
        }
    }

    /// The mesh's number of each triangle.
    pub(super) fn into_order(self) -> Vec<u32> {
        self.order
    }

    /// Triangles.
    pub(super) fn triangle_count(&self) -> u32 {
        self.nodes.len() as u32
    }

    /// Whether there is a link at all.
    pub(super) fn can_move(&self) -> bool {
        self.nodes.iter().any(|node| node.twins != [NO_TWIN; 3])
    }

    /// The side on the other side of this one.
    #[inline]
    pub(super) fn twin(&self, side: Side) -> Side {
        self.nodes[side as usize >> 2].twins[side as usize & 3]
    }

    /// Whether the link across this side is solid.
    #[inline]
    pub(super) fn is_solid(&self, side: Side) -> bool {
        self.nodes[side as usize >> 2].solid & 1 << (side & 3) != 0
    }

    /// Solid bits of the triangle of a side.
    #[inline]
    pub(super) fn solid(&self, side: Side) -> u32 {
        self.nodes[side as usize >> 2].solid
    }

    #[inline]
    fn turn(&self, side: Side) -> u8 {
        TURNS[self.nodes[side as usize >> 2].solid as usize & 7][side as usize & 3]
    }

    /// The other solid side of a triangle that has one.
    #[inline]
    fn other(&self, side: Side) -> Option<Side> {
        let k = side & 3;
        let others = self.nodes[side as usize >> 2].solid & !(1 << k);
        (others != 0).then(|| (side & !3) | others.trailing_zeros())
    }

    /// 1 where the strip swaps across a solid link.
    #[inline]
    fn swap(&self, side: Side) -> i32 {
        let turns = (self.turn(side), self.turn(self.twin(side)));
        i32::from(turns == (1, 2) || turns == (2, 1))
    }

    /// Counts the end of a strip in this triangle in or out, if there is one: the change of cost.
    #[inline]
    fn change_end(&mut self, triangle: u32, comes: bool) -> i32 {
        let node = self.nodes[triangle as usize];
        if node.solid.count_ones() != 1 {
            return 0;
        }
        let k = node.solid.trailing_zeros() as usize;
        let class = usize::from(self.turn(node.twins[k]) == BY_NEXT);
        let apex = self.corners[triangle as usize][PREV[k] as usize];
        let ends = &mut self.ends[apex as usize];
        let before = ends_cost(*ends);
        ends[class] = if comes { ends[class].saturating_add(1) } else { ends[class].saturating_sub(1) };
        ends_cost(*ends) - before
    }

    /// The neighbor along the other solid side, if there is one.
    #[inline]
    fn beyond(&self, side: Side) -> Option<u32> {
        self.other(side).map(|other| self.twin(other) >> 2)
    }

    /// Makes a dashed link solid: the change of cost.
    pub(super) fn join(&mut self, side: Side) -> i32 {
        let twin = self.twin(side);
        let mut change = -3 * INDEX + self.ends_around(side, twin, false);
        self.nodes[side as usize >> 2].solid |= 1 << (side & 3);
        self.nodes[twin as usize >> 2].solid |= 1 << (twin & 3);
        change += INDEX * self.swaps_around(side, twin);
        change + self.ends_around(side, twin, true)
    }

    /// Makes a solid link dashed: the change of cost.
    pub(super) fn cut(&mut self, side: Side) -> i32 {
        let twin = self.twin(side);
        let mut change = 3 * INDEX + self.ends_around(side, twin, false);
        change -= INDEX * self.swaps_around(side, twin);
        self.nodes[side as usize >> 2].solid &= !(1 << (side & 3));
        self.nodes[twin as usize >> 2].solid &= !(1 << (twin & 3));
        change + self.ends_around(side, twin, true)
    }

    /// Swaps across a solid link and across its neighbors along the strip: those that it has a part in.
    #[inline]
    pub(super) fn swaps_at(&self, side: Side) -> i32 {
        self.swaps_around(side, self.twin(side))
    }

    #[inline]
    fn swaps_around(&self, side: Side, twin: Side) -> i32 {
        let beside = |side: Side| self.other(side).map_or(0, |other| self.swap(other));
        self.swap(side) + beside(side) + beside(twin)
    }

    /// Counts in or out the ends that a link has a part in: of its two triangles and of their neighbors.
    #[inline]
    fn ends_around(&mut self, side: Side, twin: Side, come: bool) -> i32 {
        let mut change = self.change_end(side >> 2, come) + self.change_end(twin >> 2, come);
        for side in [side, twin] {
            if let Some(neighbor) = self.beyond(side) {
                change += self.change_end(neighbor, come);
            }
        }
        change
    }

    /// Whether a dashed link would close a loop: both of its triangles lie in one strip.
    ///
    /// Follows the strip from both at once, so that the shorter way decides.
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

    /// The next side around the triangle of a side.
    #[inline]
    pub(super) fn next(side: Side) -> Side {
        (side & !3) | NEXT[side as usize & 3]
    }

    /// The side before this one around its triangle.
    #[inline]
    pub(super) fn prev(side: Side) -> Side {
        (side & !3) | PREV[side as usize & 3]
    }
}

/// What the ends at one vertex cost: pairs of a kind save a restart.
#[inline]
fn ends_cost([well, ill]: [u8; 2]) -> i32 {
    let pairs = i32::from(well >> 1) + i32::from(ill >> 1);
    ILL_END * i32::from(ill & 1) - INDEX * pairs
}
