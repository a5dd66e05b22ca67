//! Cuts as chains of decisions: the length, then which of the free runs of that length, those with the longest edges first.

use super::scene::Scene;
use crate::entropy::{AdaptiveBit, Coder, Rate};
use crate::topology::rings::Neighbor;
use crate::topology::surface::{Cut, NONE, triangle_of};

/// Lengths and ranks that have probabilities of their own.
const MOST: usize = 16;

/// Runs are looked at triangle by triangle as long as that takes no more steps.
const MOST_STEPS: usize = 4096;

/// A model of cuts around vertices of any number of triangles.
#[derive(Clone, Debug)]
pub(super) struct ChainCuts {
    lengths: Vec<AdaptiveBit>,
    ranks: Vec<AdaptiveBit>,
    spokes: Vec<Spoke>,
    /// Where runs can begin, and how long their edges are.
    starts: Vec<(i64, u32)>,
}

/// The edges from a vertex that splits.
#[derive(Clone, Copy)]
pub(super) struct Edges<'a> {
    /// The corners around it.
    pub(super) corners: &'a [u32],
    /// The other ends.
    pub(super) neighbors: &'a [Neighbor],
    /// Where it is.
    pub(super) kept: [i32; 3],
}

/// An edge from a vertex that splits, and the triangle behind it.
#[derive(Clone, Copy, Debug)]
struct Spoke {
    /// Its squared length.
    square: i64,
    is_virtual: bool,
    /// Whether the triangle counter-clockwise of it is free.
    is_free: bool,
}

impl ChainCuts {
    /// Nothing learned.
    pub(super) fn new() -> Self {
        let bit = AdaptiveBit::new(Rate::Steady);
        Self {
            lengths: vec![bit; MOST * MOST],
            ranks: vec![bit; MOST * MOST * MOST],
            spokes: Vec::new(),
            starts: Vec::new(),
        }
    }

    /// Codes a cut around any vertex: where it begins in the ring, and its length.
    pub(super) fn code<C: Coder>(
        &mut self,
        coder: &mut C,
        scene: &Scene<'_>,
        edges: Edges<'_>,
        actual: Option<Cut>,
    ) -> Option<(usize, usize)> {
        let n = edges.corners.len();
        let most = (scene.max_patch as usize).min(n - 1);
        let meant = actual.map_or(0, |cut| cut.length as usize);
        let mut length = 1;
        while length < most {
            let bit = &mut self.lengths[n.min(MOST - 1) * MOST + length.min(MOST - 1)];
            if !bit.code(coder, meant > length) {
                break;
            }
            length += 1;
        }
        self.find_starts(scene, edges, length);
        let meant = actual.map_or(NONE, |cut| cut.first);
        let key = (n.min(MOST - 1) * MOST + length.min(MOST - 1)) * MOST;
        let mut rank = 0;
        let start = loop {
            let start = self.next_start(n * length > MOST_STEPS)?;
            let is_meant = edges.corners[start as usize] == meant;
            let is_last = self.starts.is_empty();
            if is_last || self.ranks[key + rank.min(MOST - 1)].code(coder, is_meant) {
                break start as usize;
            }
            rank += 1;
        };
        Some((start, length))
    }

    /// Where in a ring a run of free triangles can begin, and how long its edges are.
    fn find_starts(&mut self, scene: &Scene<'_>, edges: Edges<'_>, length: usize) {
        let Edges { corners, neighbors, kept } = edges;
        let n = corners.len();
        self.spokes.clear();
        self.spokes.extend(corners.iter().zip(neighbors).map(|(&corner, neighbor)| {
            let is_virtual = scene.surface.is_virtual(neighbor.vertex);
            let place = neighbor.place;
            let square = (0..3).map(|a| (i64::from(place[a]) - i64::from(kept[a])).pow(2)).sum::<i64>();
            Spoke {
                square: if is_virtual { 0 } else { square },
                is_virtual,
                is_free: !scene.is_taken(triangle_of(corner)),
            }
        }));
        self.starts.clear();
        if n * length > MOST_STEPS {
            self.find_far_starts(n, length);
            return;
        }
        'starts: for start in 0..n {
            let mut at = start;
            let mut sum = self.spokes[start].square;
            for left in (0..length).rev() {
                let is_free = self.spokes[at].is_free;
                at = if at + 1 == n { 0 } else { at + 1 };
                let spoke = self.spokes[at];
                // What is inside the run leaves the vertex: it counts twice, and is no boundary.
                if !is_free || (left > 0 && spoke.is_virtual) {
                    continue 'starts;
                }
                sum += spoke.square << u32::from(left > 0);
            }
            self.starts.push((sum, start as u32));
        }
    }

    /// The start with the longest edges of those that are left, which are perhaps in order.
    fn next_start(&mut self, in_order: bool) -> Option<u32> {
        if in_order {
            return self.starts.pop().map(|(_, start)| start);
        }
        let best = (0..self.starts.len()).max_by_key(|&at| self.starts[at])?;
        Some(self.starts.swap_remove(best).1)
    }

    /// The same where runs are so long, or so many, that each had better be the difference of two sums.
    fn find_far_starts(&mut self, n: usize, length: usize) {
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
