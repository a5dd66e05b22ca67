//! Models of general steps: which position splits, which of its triangles go to the new one, which triangles come, and where it is.
//!
//! Steps are few next to splits of the surface, so each is told by itself. What nearly all of them have in common makes them cheap:
//! triangles that move hang together, new triangles fill the gaps at the ends of what moves, and fit their neighbors' winding.

use std::collections::HashMap;

use super::complex::Complex;
use super::step::{Born, CodedStep, KnownStep};
use crate::entropy::{AdaptiveBit, AdaptiveNumber, Coder, Rate, code_uniform};

/// Rings of more triangles are not brought into order.
const LARGE_RING: usize = 32;
/// Most triangles that a step brings.
const MOST_BORN: u32 = 255;
/// Sizes that residuals are told apart by.
const SIZES: usize = 32;
/// Positions that came last and may be in need of triangles.
const RECENT: usize = 8;

/// Adaptive models of general steps.
#[derive(Clone, Debug)]
pub(super) struct GeneralModel {
    /// Whether the split position is the one before, or the last new one.
    is_near: [AdaptiveBit; 2],
    gap: AdaptiveNumber,
    moves_any: AdaptiveBit,
    /// Whether a triangle moves, by the one before it, how often that has changed, and whether they are neighbors.
    moves: [AdaptiveBit; 18],
    born_count: AdaptiveNumber,
    /// How far down a third position is in the list of those that are likely.
    rank: AdaptiveNumber,
    is_forward: [AdaptiveBit; 3],
    residuals: AdaptiveNumber,
    last_split: u32,
    /// How far the rising numbers of positions have come.
    reached: u32,
    /// New positions of this batch without triangles, the latest last.
    lonely: Vec<u32>,
    /// The size of the last residual of a position without triangles, and whether the last position was one.
    lonely_size: usize,
    follows_lonely: bool,
    /// Scratch.
    ring: Vec<Spoke>,
    thirds: Vec<(u8, u32)>,
}

/// A corner at the split position.
#[derive(Clone, Copy, Debug)]
struct Spoke {
    corner: u32,
    edge: [u32; 2],
    /// Whether it shares an edge with the one before.
    is_linked: bool,
    moves: bool,
}

impl GeneralModel {
    /// Nothing learned.
    pub(super) fn new() -> Self {
        let bit = AdaptiveBit::new(Rate::Steady);
        Self {
            is_near: [bit; 2],
            gap: AdaptiveNumber::new(1, Rate::Steady),
            moves_any: bit,
            moves: [bit; 18],
            born_count: AdaptiveNumber::new(2, Rate::Steady),
            rank: AdaptiveNumber::new(3, Rate::Steady),
            is_forward: [bit; 3],
            residuals: AdaptiveNumber::new(4 * SIZES, Rate::Steady),
            last_split: 0,
            reached: 0,
            lonely: Vec::new(),
            lonely_size: 0,
            follows_lonely: false,
            ring: Vec::new(),
            thirds: Vec::new(),
        }
    }

    /// A batch begins.
    pub(super) fn begin_batch(&mut self) {
        self.last_split = 0;
        self.reached = 0;
        self.lonely.clear();
        self.follows_lonely = false;
    }

    /// Codes which position splits.
    pub(super) fn split<C: Coder>(
        &mut self,
        coder: &mut C,
        position_count: u32,
        meant: Option<&KnownStep>,
    ) -> u32 {
        let meant = meant.map_or(0, |step| step.split);
        let newest = position_count - 1;
        for (bit, near) in self.is_near.iter_mut().zip([self.last_split, newest]) {
            if bit.code(coder, meant == near) {
                self.last_split = near;
                return near;
            }
        }
        // Steps come by rising positions as far as they do not wait for each other.
        let forward = meant.wrapping_sub(self.reached) as i32;
        let found = self.reached.wrapping_add(self.gap.signed(coder, 0, forward) as u32);
        self.reached = found.min(newest);
        self.last_split = self.reached;
        self.reached
    }

    /// Codes which corners at the split position go to the new one; fills in `moved` and `fan`.
    pub(super) fn moved<C: Coder>(
        &mut self,
        coder: &mut C,
        complex: &Complex,
        (meant, out): (Option<&KnownStep>, &mut CodedStep),
    ) {
        out.moved.clear();
        out.fan.clear();
        self.ring.clear();
        self.ring.extend(complex.corners(out.split).map(|corner| Spoke {
            corner,
            edge: complex.edge(corner),
            is_linked: false,
            moves: false,
        }));
        let any = meant.is_some_and(|step| !step.moved.is_empty());
        if self.ring.is_empty() || !self.moves_any.code(coder, any) {
            return;
        }
        if self.ring.len() <= LARGE_RING {
            arrange(&mut self.ring);
        }
        let (mut before, mut changes) = (2, 0usize);
        for spoke in &mut self.ring {
            let context = (before * 3 + changes.min(2)) * 2 + usize::from(spoke.is_linked);
            let meant = meant.is_some_and(|step| step.moves(spoke.corner));
            spoke.moves = self.moves[context].code(coder, meant);
            let now = usize::from(spoke.moves);
            changes += usize::from(before != 2 && before != now);
            before = now;
        }
        out.fan.extend(self.ring.iter().filter(|spoke| spoke.moves).map(|spoke| spoke.corner));
        if self.ring.len() <= LARGE_RING {
            let moves = |corner: &u32| out.fan.contains(corner);
            out.moved.extend(complex.corners(out.split).filter(moves));
        } else {
            // The order of the ring is that of the complex.
            out.moved.clone_from(&out.fan);
        }
    }

    /// Codes the triangles that come; fills in `born` and `known`.
    pub(super) fn born<C: Coder>(
        &mut self,
        coder: &mut C,
        complex: &Complex,
        (meant, out): (Option<&KnownStep>, &mut CodedStep),
    ) {
        out.born.clear();
        out.known.clear();
        self.find_thirds(complex, out.split);
        let rank_of = |thirds: &[(u8, u32)], third: u32| thirds.iter().position(|t| t.1 == third);
        let mut left: Vec<usize> = (0..meant.map_or(0, |step| step.born.len())).collect();
        if let Some(step) = meant {
            let thirds = &self.thirds;
            left.sort_by_key(|&at| rank_of(thirds, step.born[at].born.third).unwrap_or(usize::MAX));
        }
        let context = usize::from(out.fan.is_empty());
        let count = self.born_count.unsigned(coder, context, left.len() as u32).min(MOST_BORN);
        let others = complex.position_count() as u32;
        for at in 0..count as usize {
            let known = left.get(at).copied();
            let meant = known.and_then(|known| Some(meant?.born[known].born)).unwrap_or_default();
            let meant_rank = rank_of(&self.thirds, meant.third).unwrap_or(self.thirds.len());
            let class = usize::from(self.thirds.first().map_or(2, |third| third.0)).min(2);
            let rank = self.rank.unsigned(coder, class, meant_rank as u32) as usize;
            let third = match self.thirds.get(rank) {
                Some(&(_, third)) => {
                    self.thirds.drain(..=rank);
                    third
                }
                None => code_uniform(coder, others, meant.third),
            };
            let context = self.winding(third);
            // Where neighbors tell which way round it must be, the answer is whether that is so.
            let agrees = self.is_forward[context].code(coder, meant.is_forward == (context != 1));
            out.born.push(Born { third, is_forward: agrees == (context != 1) });
            out.known.push(known.unwrap_or(0));
        }
    }

    /// Lists the positions that may be the third of a new triangle, likely ones first.
    fn find_thirds(&mut self, complex: &Complex, split: u32) {
        self.thirds.clear();
        // By position, in the order in which they are met.
        let mut met: Vec<(u32, [u32; 2])> = Vec::with_capacity(2 * self.ring.len());
        let mut place_of = HashMap::new();
        for spoke in &self.ring {
            for position in spoke.edge {
                let place = *place_of.entry(position).or_insert(met.len());
                if place == met.len() {
                    met.push((position, [0; 2]));
                }
                met[place].1[usize::from(spoke.moves)] += 1;
            }
        }
        let class = |[stay, go]: [u32; 2]| match (stay, go) {
            (1.., 1..) => 0,
            (0, 1) | (1, 0) => 1,
            _ => 2,
        };
        let is_free = |p: &u32| *p != split && complex.corners(*p).next().is_none();
        // Most of those that came earlier have triangles by now.
        let lonely = self.lonely.iter().rev().copied().take(RECENT).filter(is_free);
        self.thirds.extend(lonely.map(|p| (if met.is_empty() { 0 } else { 1 }, p)));
        self.thirds.extend(met.iter().filter(|met| met.0 != split).map(|&(p, counts)| (class(counts), p)));
        self.thirds.sort_by_key(|third| third.0);
    }

    /// What the neighbors of a new triangle say of its winding: 0 forward, 1 backward, 2 nothing.
    fn winding(&self, third: u32) -> usize {
        let mut votes = 0i32;
        for spoke in &self.ring {
            let [after, before] = spoke.edge;
            // The triangle runs from its corner to `after`, and from `before` to its corner.
            let vote = i32::from(before == third) - i32::from(after == third);
            votes += if spoke.moves { -vote } else { vote };
        }
        match votes.signum() {
            1 => 0,
            -1 => 1,
            _ => 2,
        }
    }

    /// Codes where the new position is; `places` are those of positions.
    pub(super) fn place<C: Coder>(
        &mut self,
        coder: &mut C,
        (complex, places): (&Complex, &[[i32; 3]]),
        (meant, out): (Option<&KnownStep>, &mut CodedStep),
    ) {
        let mut around = vec![out.split];
        around.extend(out.fan.iter().flat_map(|&corner| complex.edge(corner)));
        around.extend(out.born.iter().map(|born| born.third));
        around.sort_unstable();
        around.dedup();
        let is_lonely = around.len() == 1;
        let (kind, guess, size) = match self.lonely.last() {
            _ if !is_lonely => {
                let (guess, size) = middle(&around, places);
                (usize::from(around.len() < 4), guess, size)
            }
            Some(&last) if self.follows_lonely => (2, places[last as usize], self.lonely_size),
            _ => (3, places[out.split as usize], self.lonely_size),
        };
        let mut largest = 0;
        for (axis, guess) in guess.into_iter().enumerate() {
            let off = meant.map_or(0, |step| step.place[axis].wrapping_sub(guess));
            let off = self.residuals.signed(coder, kind * SIZES + size, off);
            largest = largest.max(off.unsigned_abs());
            out.place[axis] = guess.wrapping_add(off);
        }
        if is_lonely {
            self.lonely_size = ((largest | 1).ilog2() as usize).min(SIZES - 1);
            self.lonely.push(complex.position_count() as u32);
        }
        self.follows_lonely = is_lonely;
    }
}

/// The middle of some positions, and the logarithm of how far they lie from it.
fn middle(around: &[u32], places: &[[i32; 3]]) -> ([i32; 3], usize) {
    let count = around.len() as i64;
    let sum = |axis: usize| around.iter().map(|&p| i64::from(places[p as usize][axis])).sum::<i64>();
    let middle = [0, 1, 2].map(|axis| sum(axis).div_euclid(count));
    let off =
        |p: u32| (0..3).map(|a| (i64::from(places[p as usize][a]) - middle[a]).unsigned_abs()).sum::<u64>();
    let mean = around.iter().map(|&p| off(p)).sum::<u64>() / count as u64;
    (middle.map(|x| x as i32), ((mean | 1).ilog2() as usize).min(SIZES - 1))
}

/// Puts the corners of a ring after each other that share edges, from the beginning of an open fan where there is one.
fn arrange(ring: &mut [Spoke]) {
    let begins = |ring: &[Spoke], at: usize| ring.iter().all(|other| other.edge[1] != ring[at].edge[0]);
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
