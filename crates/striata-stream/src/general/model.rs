//! Models of general steps: the split position, the triangles that move to the new position, the new
//! triangles, and the coordinates of the new position.
//!
//! General steps are rare compared with surface splits, so each is coded by itself. What nearly all of them
//! have in common keeps them cheap: the moved triangles are connected, and new triangles fill the gaps at
//! the ends of the moved ones and agree with the winding of their neighbors.

use std::collections::HashMap;

use super::complex::Complex;
use super::step::{CodedStep, NewTriangle, ReferenceStep};
use crate::entropy::{AdaptiveBit, AdaptiveNumber, Coder, Rate, code_uniform};

/// Rings with more triangles than this are not sorted.
const MAX_SORTED_RING: usize = 32;
/// Maximum number of triangles that a step creates.
const MAX_NEW_TRIANGLES: u32 = 255;
/// Number of size classes for the contexts of residuals.
const SIZE_CLASSES: usize = 32;
/// Number of recent positions that are considered for new triangles because they have none yet.
const MAX_RECENT: usize = 8;

/// Adaptive models of general steps.
#[derive(Clone, Debug)]
pub(super) struct GeneralModel {
    /// Whether the split position is the previous one, or the newest one.
    is_near: [AdaptiveBit; 2],
    gap: AdaptiveNumber,
    any_moves: AdaptiveBit,
    /// Whether a triangle moves; the context is the decision for the previous triangle, the number of
    /// changes so far, and whether the two share an edge.
    moves: [AdaptiveBit; 18],
    new_triangle_count: AdaptiveNumber,
    /// Index of a third position in the list of likely ones.
    rank: AdaptiveNumber,
    is_forward: [AdaptiveBit; 3],
    residuals: AdaptiveNumber,
    last_split: u32,
    /// Last split position that was coded by its gap to the one before.
    last_ascending: u32,
    /// New positions of this batch that were created without triangles, newest last.
    isolated: Vec<u32>,
    /// Size class of the last residual of an isolated position, and whether the last position was isolated.
    isolated_size: usize,
    follows_isolated: bool,
    /// Scratch memory.
    ring: Vec<SplitCorner>,
    thirds: Vec<(u8, u32)>,
}

/// A corner at the split position.
#[derive(Clone, Copy, Debug)]
struct SplitCorner {
    corner: u32,
    edge: [u32; 2],
    /// Whether it shares an edge with the previous spoke.
    is_linked: bool,
    moves: bool,
}

impl GeneralModel {
    /// Creates an untrained model.
    pub(super) fn new() -> Self {
        let bit = AdaptiveBit::new(Rate::Steady);
        Self {
            is_near: [bit; 2],
            gap: AdaptiveNumber::new(1, Rate::Steady),
            any_moves: bit,
            moves: [bit; 18],
            new_triangle_count: AdaptiveNumber::new(2, Rate::Steady),
            rank: AdaptiveNumber::new(3, Rate::Steady),
            is_forward: [bit; 3],
            residuals: AdaptiveNumber::new(4 * SIZE_CLASSES, Rate::Steady),
            last_split: 0,
            last_ascending: 0,
            isolated: Vec::new(),
            isolated_size: 0,
            follows_isolated: false,
            ring: Vec::new(),
            thirds: Vec::new(),
        }
    }

    /// Resets the state that is kept within a batch.
    pub(super) fn begin_batch(&mut self) {
        self.last_split = 0;
        self.last_ascending = 0;
        self.isolated.clear();
        self.follows_isolated = false;
    }

    /// Codes the split position.
    pub(super) fn code_split<C: Coder>(
        &mut self,
        coder: &mut C,
        position_count: u32,
        actual: Option<&ReferenceStep>,
    ) -> u32 {
        let actual = actual.map_or(0, |step| step.split);
        let newest = position_count - 1;
        for (bit, near) in self.is_near.iter_mut().zip([self.last_split, newest]) {
            if bit.code(coder, actual == near) {
                self.last_split = near;
                return near;
            }
        }
        // Split positions are in ascending order, except for steps that depend on others of the batch.
        let gap = actual.wrapping_sub(self.last_ascending) as i32;
        let found = self.last_ascending.wrapping_add(self.gap.signed(coder, 0, gap) as u32);
        self.last_ascending = found.min(newest);
        self.last_split = self.last_ascending;
        self.last_ascending
    }

    /// Codes which corners at the split position move to the new one; fills in `moved` and `fan`.
    pub(super) fn moved<C: Coder>(
        &mut self,
        coder: &mut C,
        complex: &Complex,
        actual: Option<&ReferenceStep>,
        out: &mut CodedStep,
    ) {
        out.moved.clear();
        out.fan.clear();
        self.ring.clear();
        self.ring.extend(complex.corners(out.split).map(|corner| SplitCorner {
            corner,
            edge: complex.edge(corner),
            is_linked: false,
            moves: false,
        }));
        let any = actual.is_some_and(|step| !step.moved.is_empty());
        if self.ring.is_empty() || !self.any_moves.code(coder, any) {
            return;
        }
        if self.ring.len() <= MAX_SORTED_RING {
            sort_ring(&mut self.ring);
        }
        let (mut before, mut changes) = (2, 0usize);
        for spoke in &mut self.ring {
            let context = (before * 3 + changes.min(2)) * 2 + usize::from(spoke.is_linked);
            let actual = actual.is_some_and(|step| step.moves(spoke.corner));
            spoke.moves = self.moves[context].code(coder, actual);
            let now = usize::from(spoke.moves);
            changes += usize::from(before != 2 && before != now);
            before = now;
        }
        out.fan.extend(self.ring.iter().filter(|spoke| spoke.moves).map(|spoke| spoke.corner));
        if self.ring.len() <= MAX_SORTED_RING {
            let moves = |corner: &u32| out.fan.contains(corner);
            out.moved.extend(complex.corners(out.split).filter(moves));
        } else {
            // The ring has not been sorted, so it is in the order of the complex.
            out.moved.clone_from(&out.fan);
        }
    }

    /// Codes the triangles that the step creates; fills in `new_triangles` and `reference_triangles`.
    pub(super) fn new_triangles<C: Coder>(
        &mut self,
        coder: &mut C,
        complex: &Complex,
        actual: Option<&ReferenceStep>,
        out: &mut CodedStep,
    ) {
        out.new_triangles.clear();
        out.reference_triangles.clear();
        self.find_thirds(complex, out.split);
        let rank_of = |thirds: &[(u8, u32)], third: u32| thirds.iter().position(|t| t.1 == third);
        let mut remaining: Vec<usize> = (0..actual.map_or(0, |step| step.new_triangles.len())).collect();
        if let Some(step) = actual {
            let thirds = &self.thirds;
            remaining.sort_by_key(|&at| {
                rank_of(thirds, step.new_triangles[at].triangle.third).unwrap_or(usize::MAX)
            });
        }
        let context = usize::from(out.fan.is_empty());
        let count =
            self.new_triangle_count.unsigned(coder, context, remaining.len() as u32).min(MAX_NEW_TRIANGLES);
        let others = complex.position_count() as u32;
        for at in 0..count as usize {
            let actual_index = remaining.get(at).copied();
            let actual = actual_index
                .and_then(|index| Some(actual?.new_triangles[index].triangle))
                .unwrap_or_default();
            let actual_rank = rank_of(&self.thirds, actual.third).unwrap_or(self.thirds.len());
            let class = usize::from(self.thirds.first().map_or(2, |third| third.0)).min(2);
            let rank = self.rank.unsigned(coder, class, actual_rank as u32) as usize;
            let third = match self.thirds.get(rank) {
                Some(&(_, third)) => {
                    self.thirds.drain(..=rank);
                    third
                }
                None => code_uniform(coder, others, actual.third),
            };
            let context = self.winding(third);
            // If the neighbors suggest a winding, the bit says whether it agrees; otherwise it is the
            // winding itself.
            let agrees = self.is_forward[context].code(coder, actual.is_forward == (context != 1));
            out.new_triangles.push(NewTriangle { third, is_forward: agrees == (context != 1) });
            out.reference_triangles.push(actual_index.unwrap_or(0));
        }
    }

    /// Lists the candidates for the third position of a new triangle, likely ones first.
    fn find_thirds(&mut self, complex: &Complex, split: u32) {
        self.thirds.clear();
        // Positions around, in order of first occurrence, with the number of triangles that stay and that
        // move.
        let mut candidates: Vec<(u32, [u32; 2])> = Vec::with_capacity(2 * self.ring.len());
        let mut index_of = HashMap::new();
        for spoke in &self.ring {
            for position in spoke.edge {
                let index = *index_of.entry(position).or_insert(candidates.len());
                if index == candidates.len() {
                    candidates.push((position, [0; 2]));
                }
                candidates[index].1[usize::from(spoke.moves)] += 1;
            }
        }
        let class = |[stay, go]: [u32; 2]| match (stay, go) {
            (1.., 1..) => 0,
            (0, 1) | (1, 0) => 1,
            _ => 2,
        };
        let is_free = |p: &u32| *p != split && complex.corners(*p).next().is_none();
        // Most of the earlier positions have triangles by now.
        let isolated = self.isolated.iter().rev().copied().take(MAX_RECENT).filter(is_free);
        self.thirds.extend(isolated.map(|p| (if candidates.is_empty() { 0 } else { 1 }, p)));
        self.thirds.extend(
            candidates.iter().filter(|candidate| candidate.0 != split).map(|&(p, counts)| (class(counts), p)),
        );
        self.thirds.sort_by_key(|third| third.0);
    }

    /// Returns the winding of a new triangle that its neighbors suggest: 0 forward, 1 backward, 2 unknown.
    fn winding(&self, third: u32) -> usize {
        let mut votes = 0i32;
        for spoke in &self.ring {
            let [after, before] = spoke.edge;
            // The spoke's triangle has the directed edges corner -> `after` and `before` -> corner.
            let vote = i32::from(before == third) - i32::from(after == third);
            votes += if spoke.moves { -vote } else { vote };
        }
        match votes.signum() {
            1 => 0,
            -1 => 1,
            _ => 2,
        }
    }

    /// Codes the grid coordinates of the new position; `grid_points` are those of all positions so far.
    pub(super) fn grid_point<C: Coder>(
        &mut self,
        coder: &mut C,
        (complex, grid_points): (&Complex, &[[i32; 3]]),
        (actual, out): (Option<&ReferenceStep>, &mut CodedStep),
    ) {
        let mut around = vec![out.split];
        around.extend(out.fan.iter().flat_map(|&corner| complex.edge(corner)));
        around.extend(out.new_triangles.iter().map(|triangle| triangle.third));
        around.sort_unstable();
        around.dedup();
        let is_isolated = around.len() == 1;
        let (kind, guess, size) = match self.isolated.last() {
            _ if !is_isolated => {
                let (guess, size) = mean_position(&around, grid_points);
                (usize::from(around.len() < 4), guess, size)
            }
            Some(&last) if self.follows_isolated => (2, grid_points[last as usize], self.isolated_size),
            _ => (3, grid_points[out.split as usize], self.isolated_size),
        };
        let mut largest = 0;
        for (axis, guess) in guess.into_iter().enumerate() {
            let residual = actual.map_or(0, |step| step.grid_point[axis].wrapping_sub(guess));
            let residual = self.residuals.signed(coder, kind * SIZE_CLASSES + size, residual);
            largest = largest.max(residual.unsigned_abs());
            out.grid_point[axis] = guess.wrapping_add(residual);
        }
        if is_isolated {
            self.isolated_size = ((largest | 1).ilog2() as usize).min(SIZE_CLASSES - 1);
            self.isolated.push(complex.position_count() as u32);
        }
        self.follows_isolated = is_isolated;
    }
}

/// Returns the mean of some positions, and the binary logarithm of their mean distance from it.
fn mean_position(around: &[u32], grid_points: &[[i32; 3]]) -> ([i32; 3], usize) {
    let count = around.len() as i64;
    let sum = |axis: usize| around.iter().map(|&p| i64::from(grid_points[p as usize][axis])).sum::<i64>();
    let mean = [0, 1, 2].map(|axis| sum(axis).div_euclid(count));
    let distance = |p: u32| {
        (0..3).map(|a| (i64::from(grid_points[p as usize][a]) - mean[a]).unsigned_abs()).sum::<u64>()
    };
    let mean_distance = around.iter().map(|&p| distance(p)).sum::<u64>() / count as u64;
    (mean.map(|x| x as i32), ((mean_distance | 1).ilog2() as usize).min(SIZE_CLASSES - 1))
}

/// Sorts a ring so that corners whose triangles share edges follow each other; an open fan starts at its
/// first triangle.
fn sort_ring(ring: &mut [SplitCorner]) {
    let begins = |ring: &[SplitCorner], at: usize| ring.iter().all(|other| other.edge[1] != ring[at].edge[0]);
    for at in 0..ring.len() {
        let before = at.checked_sub(1).map(|before| ring[before].edge);
        let rest = at..ring.len();
        let linked = before.and_then(|[_, end]| rest.clone().find(|&other| ring[other].edge[0] == end));
        let linked = linked.or_else(|| {
            before.and_then(|edge| rest.clone().find(|&o| ring[o].edge.iter().any(|p| edge.contains(p))))
        });
        let chosen = linked.or_else(|| rest.clone().find(|&other| begins(ring, other))).unwrap_or(at);
        ring.swap(at, chosen);
        ring[at].is_linked = linked.is_some();
    }
}
