//! Cuts coded as sequences of binary decisions: the length, then the rank of the run among the free runs of
//! that length, in falling order of edge lengths.

use super::split_context::SplitContext;
use crate::entropy::{AdaptiveBit, Coder, Rate};
use crate::topology::rings::Neighbor;
use crate::topology::surface::{Cut, NONE, triangle_of};

/// Number of lengths and ranks that have their own probabilities.
const MAX_CODED: usize = 16;

/// Up to this many steps, runs are summed triangle by triangle; beyond it, by prefix sums.
const MAX_STEPS: usize = 4096;

/// Model of cuts around vertices with any number of triangles.
#[derive(Clone, Debug)]
pub(super) struct ChainCuts {
    lengths: Vec<AdaptiveBit>,
    ranks: Vec<AdaptiveBit>,
    spokes: Vec<ChainSpoke>,
    /// Score and start of each candidate run; the score grows with the lengths of its edges.
    starts: Vec<(i64, u32)>,
}

/// The ring of a vertex that splits.
#[derive(Clone, Copy)]
pub(super) struct Edges<'a> {
    /// Corners around the vertex.
    pub corners: &'a [u32],
    /// Neighbors of the vertex, one at the far end of each edge.
    pub neighbors: &'a [Neighbor],
    /// Grid coordinates of the vertex.
    pub position: [i32; 3],
}

/// An edge from the split vertex, and the triangle counterclockwise of it.
#[derive(Clone, Copy, Debug)]
struct ChainSpoke {
    /// Squared length of the edge.
    square: i64,
    is_virtual: bool,
    /// Whether the triangle may move to the new vertex.
    is_free: bool,
}

impl ChainCuts {
    /// Creates an untrained model.
    pub(super) fn new() -> Self {
        let bit = AdaptiveBit::new(Rate::Steady);
        Self {
            lengths: vec![bit; MAX_CODED * MAX_CODED],
            ranks: vec![bit; MAX_CODED * MAX_CODED * MAX_CODED],
            spokes: Vec::new(),
            starts: Vec::new(),
        }
    }

    /// Codes a cut; returns its start in the ring and its length, or `None` if no run is free.
    pub(super) fn code<C: Coder>(
        &mut self,
        coder: &mut C,
        split_context: &SplitContext<'_>,
        edges: Edges<'_>,
        actual: Option<Cut>,
    ) -> Option<(usize, usize)> {
        let n = edges.corners.len();
        let max_length = (split_context.max_patch as usize).min(n - 1);
        let actual_length = actual.map_or(0, |cut| cut.length as usize);
        let mut length = 1;
        while length < max_length {
            let bit = &mut self.lengths[n.min(MAX_CODED - 1) * MAX_CODED + length.min(MAX_CODED - 1)];
            if !bit.code(coder, actual_length > length) {
                break;
            }
            length += 1;
        }
        self.find_starts(split_context, edges, length);
        let actual_first = actual.map_or(NONE, |cut| cut.first);
        let key = (n.min(MAX_CODED - 1) * MAX_CODED + length.min(MAX_CODED - 1)) * MAX_CODED;
        let mut rank = 0;
        let start = loop {
            let start = self.next_start(n * length > MAX_STEPS)?;
            let is_actual = edges.corners[start as usize] == actual_first;
            let is_last = self.starts.is_empty();
            if is_last || self.ranks[key + rank.min(MAX_CODED - 1)].code(coder, is_actual) {
                break start as usize;
            }
            rank += 1;
        };
        Some((start, length))
    }

    /// Lists where a run of free triangles can start, with its score.
    fn find_starts(&mut self, split_context: &SplitContext<'_>, edges: Edges<'_>, length: usize) {
        let Edges { corners, neighbors, position } = edges;
        let n = corners.len();
        self.spokes.clear();
        self.spokes.extend(corners.iter().zip(neighbors).map(|(&corner, neighbor)| {
            let is_virtual = split_context.surface.is_virtual(neighbor.vertex);
            let end = neighbor.grid_point;
            let square = (0..3).map(|a| (i64::from(end[a]) - i64::from(position[a])).pow(2)).sum::<i64>();
            ChainSpoke {
                square: if is_virtual { 0 } else { square },
                is_virtual,
                is_free: !split_context.is_claimed(triangle_of(corner)),
            }
        }));
        self.starts.clear();
        if n * length > MAX_STEPS {
            self.find_starts_by_prefix_sums(n, length);
            return;
        }
        'starts: for start in 0..n {
            let mut at = start;
            let mut sum = self.spokes[start].square;
            for left in (0..length).rev() {
                let is_free = self.spokes[at].is_free;
                at = if at + 1 == n { 0 } else { at + 1 };
                let spoke = self.spokes[at];
                // Inner edges move to the new vertex: they count twice and must not be boundaries.
                if !is_free || (left > 0 && spoke.is_virtual) {
                    continue 'starts;
                }
                sum += spoke.square << u32::from(left > 0);
            }
            self.starts.push((sum, start as u32));
        }
    }

    /// Removes and returns the start with the highest score; `is_sorted` says whether the list is sorted.
    fn next_start(&mut self, is_sorted: bool) -> Option<u32> {
        if is_sorted {
            return self.starts.pop().map(|(_, start)| start);
        }
        let best = (0..self.starts.len()).max_by_key(|&at| self.starts[at])?;
        Some(self.starts.swap_remove(best).1)
    }

    /// Does the work of `find_starts` by prefix sums, for rings and runs with many triangles.
    fn find_starts_by_prefix_sums(&mut self, n: usize, length: usize) {
        let mut sums = Vec::with_capacity(2 * n + 1);
        let mut sum = (0i64, 0u32, 0u32);
        sums.push(sum);
        for spoke in self.spokes.iter().chain(&self.spokes) {
            sum.0 = sum.0.wrapping_add(spoke.square);
            sum.1 += u32::from(!spoke.is_free);
            sum.2 += u32::from(spoke.is_virtual);
            sums.push(sum);
        }
        for start in 0..n {
            let (first, end) = (start + 1, start + length);
            let is_free = sums[end].1 == sums[start].1;
            if is_free && sums[end].2 == sums[first].2 {
                let inside = sums[end].0.wrapping_sub(sums[first].0);
                let ends = self.spokes[start].square.wrapping_add(self.spokes[end % n].square);
                self.starts.push((ends.wrapping_add(inside).wrapping_add(inside), start as u32));
            }
        }
        self.starts.sort_unstable();
    }
}
