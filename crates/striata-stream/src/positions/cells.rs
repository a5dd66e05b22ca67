//! Codes one coordinate as one of sixteen cells and the offset within the cell.
//!
//! Fourteen cells surround the expected value, narrow in the middle and wider outside; two more contain
//! everything else. The score of a cell is a sum of logarithms: the mass of the density of guesses in the
//! cell, and one weight per cell for each of four contexts. After each coordinate, all weights move along
//! the gradient of the coding cost. An axis thus takes one decision among sixteen instead of four or five
//! halvings.

use wide::{i16x8, i32x4};

use super::axis::{AxisInput, CONTEXTS, DISTANCES, SIZES, SPREADS};
use super::bumps::{Bumps, Width, below};
use crate::entropy::{AdaptiveBit, AdaptiveNumber, Coder, Rate, Shares, code_shares, log2_q16};

/// Number of cells of an axis.
const CELLS: usize = 16;
/// Upper ends of the cells, in cell steps; the last cell is unbounded.
const ENDS: [i32; CELLS - 1] = [-16, -10, -7, -5, -3, -2, -1, 0, 1, 2, 3, 5, 7, 10, 16];
/// Cell steps are wider than one grid step if half the interval is wider than 2 to this power.
const SPAN_LOG: u32 = 5;

/// Fixed-point unit of scores as a power of two; it corresponds to one bit.
const SCORE_LOG: u32 = 9;
/// Additional fraction bits of weights compared with scores.
const WEIGHT_LOG: u32 = 8;
/// Fixed-point unit of the density's weight.
const DENSITY_ONE: i32 = 1 << 14;
/// Mass added to every cell so that none is impossible, in quantization steps: 192 of 2^14.
const DOUBT: usize = 192 >> MASS_LOG;
/// Masses are quantized in steps of 2 to this power.
const MASS_LOG: u32 = 2;
/// Number of tabulated powers of two, from 2^0 down in steps of 1/64 of the exponent.
const POWERS: usize = 1024;

/// `2^(15 - at / 64)`, rounded down, by repeated multiplication with `2^(-1/64)` in 1/2^62.
static EXPONENTIALS: [u16; POWERS] = {
    let mut table = [0; POWERS];
    let mut power: u128 = (1 << 62) - 1;
    let mut at = 0;
    while at < POWERS {
        table[at] = (power >> 47) as u16;
        power = (power * 4_562_008_997_483_360_256) >> 62;
        at += 1;
    }
    table
};

/// Base-2 logarithms of masses plus a small constant, in 1/256.
static LOGARITHMS: [i16; (1 << (14 - MASS_LOG)) + 1] = {
    let mut table = [0; (1 << (14 - MASS_LOG)) + 1];
    let mut at = 0;
    while at < table.len() {
        table[at] = (log2_q16((at + DOUBT) as u64) >> 8) as i16;
        at += 1;
    }
    table
};

/// Score of each cell under the density: base-2 logarithms, in 1/256.
type CellScores = [i16x8; 2];

/// Weight of each cell in one context.
#[derive(Clone, Copy, Debug)]
struct CellWeights {
    weights: [i32x4; CELLS / 4],
    /// Number of coordinates learned from.
    seen: u32,
}

/// Learned weights of one axis.
#[derive(Clone, Debug)]
pub(super) struct CellModel {
    by_size: Vec<CellWeights>,
    by_context: Vec<CellWeights>,
    by_spread: Vec<CellWeights>,
    by_distance: Vec<CellWeights>,
    /// Weight of the density, by context class.
    trust: [i32; CONTEXTS],
    /// Whether a coordinate lies in the upper half of the remaining interval within a cell, by its width
    /// and the density's probability.
    halves: Vec<AdaptiveBit>,
    /// Distances in the unbounded cells.
    far: AdaptiveNumber,
}

/// Numbers of classes for the width of the interval and for the density's probability.
const WIDTHS: usize = 16;
const CHANCES: usize = 32;

/// A range of grid coordinates, both ends included.
struct GridSpan {
    /// Smallest coordinate.
    pub low: i32,
    /// Largest coordinate.
    pub high: i32,
}

impl CellModel {
    /// Creates an untrained model.
    pub(super) fn new() -> Self {
        let weights = |count: usize| vec![CellWeights { weights: [i32x4::ZERO; CELLS / 4], seen: 0 }; count];
        Self {
            by_size: weights(SIZES),
            by_context: weights(CONTEXTS),
            by_spread: weights(SPREADS),
            by_distance: weights(DISTANCES),
            trust: [FIRST_TRUST; CONTEXTS],
            halves: vec![AdaptiveBit::new(Rate::Steady); WIDTHS * CHANCES],
            far: AdaptiveNumber::new(2 * SIZES, Rate::Steady),
        }
    }

    /// Codes a grid coordinate.
    pub(super) fn code<C: Coder>(&mut self, coder: &mut C, axis: &AxisInput<'_>, actual: i32) -> i32 {
        let span_log = (11 - axis.local.shift - i32::from(axis.is_last)).clamp(1, 29) as u32;
        let step_log = span_log.saturating_sub(SPAN_LOG);
        let scores = density_scores(axis, step_log);
        let actual = actual.wrapping_sub(axis.center);
        let flip = if axis.is_mirrored { CELLS - 1 } else { 0 };
        let actual_cell = ENDS.iter().filter(|&&end| actual >= end << step_log).count() ^ flip;
        let cell = self.cell(coder, axis, &scores, actual_cell) ^ flip;
        let off = if cell == 0 {
            let beyond = (ENDS[0] << step_log).wrapping_sub(1).wrapping_sub(actual) as u32;
            (ENDS[0] << step_log)
                .wrapping_sub(1)
                .wrapping_sub(self.far.unsigned(coder, axis.size, beyond) as i32)
        } else if cell == CELLS - 1 {
            let first = ENDS[CELLS - 2] << step_log;
            let beyond = actual.wrapping_sub(first) as u32;
            first.wrapping_add(self.far.unsigned(coder, SIZES + axis.size, beyond) as i32)
        } else {
            self.within(
                coder,
                axis,
                GridSpan { low: ENDS[cell - 1] << step_log, high: ENDS[cell] << step_log },
                actual,
            )
        };
        axis.center.wrapping_add(off)
    }

    /// Returns the weights of an axis's four contexts.
    fn contexts(&mut self, axis: &AxisInput<'_>) -> [&mut CellWeights; 4] {
        [
            &mut self.by_size[axis.size],
            &mut self.by_context[axis.context],
            &mut self.by_spread[axis.spread],
            &mut self.by_distance[axis.distance],
        ]
    }

    /// Codes a cell, numbered as counters see it, given the density's scores.
    #[inline]
    fn cell<C: Coder>(
        &mut self,
        coder: &mut C,
        axis: &AxisInput<'_>,
        density: &CellScores,
        actual_cell: usize,
    ) -> usize {
        let trust = i16x8::splat(self.trust[axis.context] as i16);
        // Multiplies the density (in 1/256) by its weight (in 1/16384); the product is in score units.
        let weighted = density.map(|score| (score << (SCORE_LOG - 6)).mul_keep_high(trust));
        let contexts = self.contexts(axis);
        let scores = add_weights(&contexts, weighted);
        let (parts, shares) = parts_of(&scores);
        let cell = code_shares(coder, actual_cell, &shares);
        let mut errors = parts.map(|part| -part);
        errors[cell & 15] += i16::MAX;
        let steps: [i32x4; CELLS / 4] = std::array::from_fn(|quarter| {
            i32x4::new(std::array::from_fn(|at| i32::from(errors[4 * quarter + at]) << 1))
        });
        contexts.into_iter().for_each(|weights| weights.learn(&steps));
        let errors = [0, 8].map(|at| i16x8::from_slice_unaligned(&errors[at..at + 8]));
        let pull: i32 = (density[0].dot(errors[0]) + density[1].dot(errors[1])).to_array().iter().sum();
        let trust = &mut self.trust[axis.context];
        *trust = (*trust + (pull >> TRUST_SHIFT)).clamp(0, 2 * DENSITY_ONE - 1);
        cell
    }

    /// Codes the offset within a cell that lies between two offsets from the center.
    fn within<C: Coder>(
        &mut self,
        coder: &mut C,
        axis: &AxisInput<'_>,
        GridSpan { mut low, mut high }: GridSpan,
        actual: i32,
    ) -> i32 {
        if high - low < 2 {
            return low;
        }
        let mass = |off: i32| below_all(axis, off);
        let [mut below_low, mut below_high] = [low, high].map(mass);
        while high - low > 1 {
            let middle = low.midpoint(high);
            let below = mass(middle);
            let [up, all] =
                [below_high - below, below_high - below_low].map(|m| i64::from(m.max(0)) + (1 << 16));
            let chance = ((up * CHANCES as i64) / (all + (1 << 16))).clamp(0, CHANCES as i64 - 1) as usize;
            let width = (high - low).ilog2().min(WIDTHS as u32 - 1) as usize;
            let is_up = self.halves[width * CHANCES + chance].code(coder, actual >= middle);
            if is_up {
                (low, below_low) = (middle, below);
            } else {
                (high, below_high) = (middle, below);
            }
        }
        low
    }
}

/// Final learning rates of the cell weights and of the density's weight, as right shifts.
const LAST_SHIFT: u32 = 4;
const TRUST_SHIFT: u32 = 15;
/// Initial weight of the density.
const FIRST_TRUST: i32 = 16_000;

impl CellWeights {
    /// Moves the weights by a step that shrinks with experience.
    #[inline]
    fn learn(&mut self, steps: &[i32x4; CELLS / 4]) {
        self.seen = (self.seen + 1).min(1 << 12);
        let shift = (1 + (self.seen >> 2)).ilog2().min(LAST_SHIFT);
        for (weights, &step) in self.weights.iter_mut().zip(steps) {
            *weights += step >> shift;
        }
    }
}

/// Adds the weights of all contexts to the density's scores.
#[inline]
fn add_weights(contexts: &[&mut CellWeights; 4], density: [i16x8; 2]) -> [i16; CELLS] {
    let mut scores = [0; CELLS];
    let density = density.map(|half| half.to_array());
    for (quarter, (scores, density)) in
        scores.chunks_exact_mut(4).zip(density.as_flattened().chunks_exact(4)).enumerate()
    {
        let sum = contexts.iter().fold(i32x4::ZERO, |sum, weights| sum + weights.weights[quarter]);
        let sum = (sum >> WEIGHT_LOG).to_array();
        for ((score, sum), &density) in scores.iter_mut().zip(sum).zip(density) {
            *score = (sum + i32::from(density)).clamp(-16_000, 16_000) as i16;
        }
    }
    scores
}

/// Returns the probability of each cell, in 1/32768, and the cumulative probability at which it begins.
#[inline]
fn parts_of(scores: &[i16; CELLS]) -> ([i16; CELLS], Shares) {
    let [low, high] = [0, 8].map(|at| i16x8::from_slice_unaligned(&scores[at..at + 8]));
    let best = i16x8::splat(low.max(high).reduce_max());
    let last = i16x8::splat(POWERS as i16 - 1);
    let steps = [low, high].map(|half| (best.saturating_sub(half) >> (SCORE_LOG - 6)).min(last).to_array());
    let (mut parts, mut shares) = ([0; CELLS], [0; CELLS]);
    let mut sum = 0;
    for (part, &step) in parts.iter_mut().zip(steps.as_flattened()) {
        *part = EXPONENTIALS[step as usize % POWERS] as i16;
        sum += *part as u32;
    }
    let inverse = ((1u32 << 31) - 1) / sum.max(1);
    let mut begin = 0;
    for (part, share) in parts.iter_mut().zip(&mut shares) {
        *part = ((*part as u32 * inverse) >> 16) as i16;
        *share = begin;
        begin += *part;
    }
    (parts, shares)
}

/// Ends of the cells in local units, for each power of two of a cell step from [`LEAST_STEP_LOG`] on. The
/// last end is beyond everything.
static LOCAL_ENDS: [[i16; CELLS]; 16 - LEAST_STEP_LOG as usize] = {
    let mut table = [[i16::MAX; CELLS]; 16 - LEAST_STEP_LOG as usize];
    let mut log = 0;
    while log < table.len() {
        let mut at = 0;
        while at < CELLS - 1 {
            let end = ENDS[at] << (log + LEAST_STEP_LOG as usize);
            table[log][at] = if end > 16_000 {
                16_000
            } else if end < -16_000 {
                -16_000
            } else {
                end as i16
            };
            at += 1;
        }
        log += 1;
    }
    table
};
/// Smallest cell step in [`LOCAL_ENDS`], as a power of two.
const LEAST_STEP_LOG: u32 = 4;

/// Returns the mass of the density below a coordinate, given relative to the center.
fn below_all(axis: &AxisInput<'_>, off: i32) -> i32 {
    below(axis.bumps, axis.local.border(axis.center.wrapping_add(off), axis.axis), axis.width)
}

/// Returns the density's score of each cell, in the order in which counters see the cells.
#[inline]
fn density_scores(axis: &AxisInput<'_>, step_log: u32) -> CellScores {
    let local_log = (step_log as i32 + axis.local.shift - LEAST_STEP_LOG as i32).max(0) as usize;
    let center = i16x8::splat(axis.local.border(axis.center, axis.axis));
    let (low, high) = LOCAL_ENDS[local_log.min(LOCAL_ENDS.len() - 1)].split_at(8);
    let ends = [low, high].map(|ends| i16x8::from_slice_unaligned(ends).saturating_add(center));
    let flip = if axis.is_mirrored { CELLS - 1 } else { 0 };
    let (mut scores, mut below) = ([0; CELLS], 0);
    for (cell, &sum) in below_ends(axis.bumps, ends, axis.width).iter().enumerate() {
        let mass = (sum - below).max(0) as usize >> MASS_LOG;
        scores[cell ^ flip] = LOGARITHMS[mass.min(LOGARITHMS.len() - 1)];
        below = sum;
    }
    [0, 8].map(|at| i16x8::from_slice_unaligned(&scores[at..at + 8]))
}

/// Returns the mass of the density below each end. The total is about 2^13 to 2^14.
#[inline]
fn below_ends(density: &[Bumps], ends: [i16x8; 2], width: Width) -> [i16; CELLS] {
    // Zeros that the compiler cannot see through. It would otherwise split shifts and products into
    // 32-bit lanes.
    let opaque = i16x8::new(std::hint::black_box([0; 8]));
    let mut sums = [i16x8::ZERO; 2];
    for bumps in density {
        for (&at, &weight) in bumps.at.iter().zip(&bumps.weight).filter(|&(_, &weight)| weight != 0) {
            let (at, weight) = (i16x8::splat(at), i16x8::splat(weight) ^ opaque);
            for (sum, end) in sums.iter_mut().zip(ends) {
                let below: i16x8 = (width.below(end.saturating_sub(at)) ^ opaque) << 2u32;
                *sum += (below ^ opaque).mul_keep_high(weight);
            }
        }
    }
    let mut all = [0; CELLS];
    all[..8].copy_from_slice(sums[0].as_array());
    all[8..].copy_from_slice(sums[1].as_array());
    all
}

#[cfg(test)]
mod tests {
    use super::super::local::LocalRing;
    use super::*;

    #[test]
    fn tables_of_exponentials_and_logarithms_are_accurate() {
        for (at, &power) in EXPONENTIALS.iter().enumerate() {
            let expected = 32_768.0 * (-(at as f64) / 64.0).exp2();
            assert!((f64::from(power) - expected).abs() <= 1.01, "{at}: {power} for {expected}");
        }
        for (at, &logarithm) in LOGARITHMS.iter().enumerate() {
            let expected = ((at + DOUBT) as f64).log2() * 256.0;
            assert!((f64::from(logarithm) - expected).abs() < 1.01, "{at}: {logarithm} for {expected}");
        }
    }

    #[test]
    fn parts_sum_to_one() {
        let mut scores = [-600; CELLS];
        scores[3] = 512;
        scores[9] = 1024;
        let (parts, shares) = parts_of(&scores);
        // One bit apart.
        assert!((parts[9] - 2 * parts[3]).abs() < 40, "{parts:?}");
        assert!(shares.is_sorted() && shares[0] == 0);
        let sum: i32 = parts.iter().map(|&part| i32::from(part)).sum();
        assert!((32_700..=32_768).contains(&sum), "{sum}");
        let even = parts_of(&[-16_000; CELLS]).0;
        assert!(even.iter().all(|&part| (2040..=2048).contains(&part)), "{even:?}");
    }

    /// A density of one bump, and an axis centered on it.
    fn axis<'a>(local: &'a LocalRing, bumps: &'a [Bumps], is_mirrored: bool) -> AxisInput<'a> {
        AxisInput {
            local,
            axis: 0,
            bumps,
            width: Width::new(7),
            center: 40,
            is_mirrored,
            is_last: false,
            size: 20,
            context: 1,
            distance: 2,
            spread: 3,
        }
    }

    #[test]
    fn the_cell_with_most_density_scores_best() {
        // One grid step is 64 local units.
        let local =
            LocalRing { origin: [40, 0, 0], shift: 6, factor: 1 << 22, radius: 1200, ..LocalRing::default() };
        let bumps = [Bumps { at: [130, 0, 0, 0, 0, 0, 0, 0], weight: [16_000, 0, 0, 0, 0, 0, 0, 0] }];
        for is_mirrored in [false, true] {
            let scores = density_scores(&axis(&local, &bumps, is_mirrored), 0).map(|half| half.to_array());
            let scores = scores.as_flattened();
            let best = (0..CELLS).max_by_key(|&cell| scores[cell]).unwrap();
            // Two steps above the center, counted from either end.
            assert_eq!(best, if is_mirrored { CELLS - 1 - 10 } else { 10 }, "{scores:?}");
        }
    }
}
