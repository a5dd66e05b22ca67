//! Codes one coordinate as a chain of halvings.
//!
//! The coordinate is searched in an interval around the expected value that is as wide as the ring; each
//! decision codes whether it lies in the upper or the lower half, until one value is left. Most
//! coordinates lie in the middle of the interval, so a first decision codes whether this one does, which
//! saves two decisions afterward. The inputs of each decision are its probability under every density,
//! and counters of earlier outcomes at this node of the tree in similar contexts. Two mixers weight the
//! inputs, and the mean of their outputs is used.

use super::axis::{AxisCoder, AxisInput, CONTEXTS, DISTANCES, Masses, SIZES, SPREADS};
use super::guesses::KINDS;
use crate::entropy::{
    AdaptiveBit, AdaptiveNumber, Coder, ProbabilityMap, Rate, WideMixer, log_odds, log2_q8, log2_q16,
};

/// Number of widths of the bumps.
const WIDTHS: usize = 3;
/// Number of counters that give inputs to the mixers.
const COUNTERS: usize = 4;
/// Number of vectors of 8 inputs: one for each kind of guess and width, the counters, and a constant.
const VECTORS: usize = (KINDS * WIDTHS + COUNTERS + 1).div_ceil(8);
/// Number of depth classes of the tree.
const DEPTHS: usize = 6;
/// Nodes of the tree that have counters; all others share node 0.
const NODES: usize = 64;
/// The near interval is the whole one divided by 2 to this power.
const NEAR_LOG: u32 = 2;
/// Number of classes for the probability of lying outside the near interval.
const CHANCES: usize = 24;

/// An interval around the expected coordinate.
struct Interval {
    /// Half its width.
    half: i32,
    /// Mass of each density below its ends.
    masses: [Masses<KINDS, WIDTHS>; 2],
    /// Whether it is the narrow one.
    is_near: bool,
}

/// A decision between the halves of an interval.
struct Decision {
    /// Node of the tree.
    node: usize,
    depth: usize,
    /// The outcome that a writer codes.
    bit: bool,
}

/// Learned statistics of one axis.
#[derive(Clone, Debug)]
pub(super) struct HalvingModel {
    /// Whether a coordinate lies outside the near interval, by spread class and by the densities.
    is_outside: [Vec<AdaptiveBit>; 2],
    /// Whether a coordinate lies outside even the wide interval, by spread class.
    is_beyond: Vec<AdaptiveBit>,
    /// Coordinates outside the wide interval.
    far: AdaptiveNumber,
    by_size: Vec<AdaptiveBit>,
    by_context: Vec<AdaptiveBit>,
    by_spread: Vec<AdaptiveBit>,
    by_distance: Vec<AdaptiveBit>,
    /// Mixes by context and depth.
    mixer: WideMixer<VECTORS>,
    /// Mixes by size class.
    other: WideMixer<VECTORS>,
    probability_map: ProbabilityMap,
}

impl AxisCoder<KINDS, WIDTHS> for HalvingModel {
    fn new() -> Self {
        let bits = |count: usize| vec![AdaptiveBit::new(Rate::Steady); count * NODES];
        let mut first = [[(18_000 / VECTORS / 8) as i16; 8]; VECTORS];
        first.as_flattened_mut()[..COUNTERS].fill(3250);
        Self {
            is_outside: [SPREADS, CHANCES].map(|count| vec![AdaptiveBit::new(Rate::Steady); count]),
            is_beyond: vec![AdaptiveBit::new(Rate::Steady); SPREADS],
            far: AdaptiveNumber::new(SIZES, Rate::Steady),
            by_size: bits(SIZES),
            by_context: bits(CONTEXTS),
            by_spread: bits(SPREADS),
            by_distance: bits(DISTANCES),
            mixer: WideMixer::new(DEPTHS * CONTEXTS, first),
            other: WideMixer::new(SIZES, first),
            probability_map: ProbabilityMap::new(DEPTHS),
        }
    }

    fn code<C: Coder>(&mut self, coder: &mut C, axis: &AxisInput<'_, KINDS, WIDTHS>, actual: i32) -> i32 {
        let span_log = (11 - axis.local.shift - i32::from(axis.is_last)).clamp(1, 29) as u32;
        let half = 1i32 << span_log;
        let actual = actual.wrapping_sub(axis.center);
        let near = half >> NEAR_LOG;
        let masses = [axis.below(-near), axis.below(near)];
        let off = if near > 0 && !self.is_outside(coder, axis, WeighedEnd { near, masses: &masses }, actual) {
            self.halve(coder, axis, Interval { half: near, masses, is_near: true }, actual)
        } else if !self.is_beyond[axis.spread].code(coder, !(-half..half).contains(&actual)) {
            let masses = [axis.below(-half), axis.below(half)];
            self.halve(coder, axis, Interval { half, masses, is_near: false }, actual)
        } else {
            self.far.signed(coder, axis.size, actual)
        };
        axis.center.wrapping_add(off)
    }
}

/// The near interval around the center, and the masses below its two ends.
struct WeighedEnd<'a> {
    /// Distance of its ends from the center.
    pub near: i32,
    /// Masses below the lower and the upper end, by context.
    pub masses: &'a [Masses<KINDS, WIDTHS>; 2],
}

impl HalvingModel {
    /// Codes whether a coordinate lies outside the near interval.
    #[inline]
    fn is_outside<C: Coder>(
        &mut self,
        coder: &mut C,
        axis: &AxisInput<'_, KINDS, WIDTHS>,
        WeighedEnd { near, masses }: WeighedEnd<'_>,
        actual: i32,
    ) -> bool {
        let [all, low, high] = [&axis.all(), &masses[0], &masses[1]]
            .map(|masses| masses.iter().map(|masses| masses[WIDTHS / 2] >> 4).sum::<i32>());
        let outside = (all - (high - low)).max(1) as u32;
        // In half bits.
        let chance = (log2_q8(all.max(1) as u32) - log2_q8(outside)) >> 7;
        let [one, other] = &mut self.is_outside;
        let counters = [&mut one[axis.spread], &mut other[chance.clamp(0, CHANCES as i32 - 1) as usize]];
        let p_one = (counters[0].p_one() + counters[1].p_one()) >> 1;
        let bit = coder.bit(!(-near..near).contains(&actual), p_one);
        counters.into_iter().for_each(|counter| counter.update(bit));
        bit
    }

    /// Codes a coordinate within an interval by halving it.
    fn halve<C: Coder>(
        &mut self,
        coder: &mut C,
        axis: &AxisInput<'_, KINDS, WIDTHS>,
        interval: Interval,
        actual: i32,
    ) -> i32 {
        let Interval { half, masses: [mut below_low, mut below_high], is_near } = interval;
        let (mut low, mut high) = (-half, half);
        let mut node = 1;
        let mut depth = 0;
        while high - low > 1 {
            let middle = (low + high) >> 1;
            let below = axis.below(middle);
            let mut inputs = [[0; 8]; VECTORS];
            let (from, to) =
                if axis.is_mirrored { (&below_high, &below_low) } else { (&below_low, &below_high) };
            weigh(from, &below, to, &mut inputs.as_flattened_mut()[COUNTERS..]);
            let bit = (actual >= middle) ^ axis.is_mirrored;
            let bit = self.decide(coder, axis, Decision { node, depth, bit }, &mut inputs);
            let is_up = bit ^ axis.is_mirrored;
            if is_up {
                (low, below_low) = (middle, below);
            } else {
                (high, below_high) = (middle, below);
            }
            node = node << 1 | usize::from(bit);
            if depth == 0 && is_near {
                // As if the inner half had been chosen each time.
                node = (0..NEAR_LOG).fold(node, |node, _| node << 1 | usize::from(!bit));
                depth = NEAR_LOG as usize;
            }
            depth = (depth + 1).min(DEPTHS - 1);
        }
        low
    }

    /// Codes one decision from the mixed inputs.
    #[inline]
    fn decide<C: Coder>(
        &mut self,
        coder: &mut C,
        axis: &AxisInput<'_, KINDS, WIDTHS>,
        Decision { node, depth, bit }: Decision,
        inputs: &mut [[i16; 8]; VECTORS],
    ) -> bool {
        let node = if node < NODES { node } else { 0 };
        let counters = [
            &mut self.by_size[axis.size * NODES + node],
            &mut self.by_context[axis.context * NODES + node],
            &mut self.by_spread[axis.spread * NODES + node],
            &mut self.by_distance[axis.distance * NODES + node],
        ];
        let all = inputs.as_flattened_mut();
        for (input, counter) in all.iter_mut().zip(&counters) {
            *input = log_odds(counter.p_one()) as i16;
        }
        all[KINDS * WIDTHS + COUNTERS] = 128;
        let odds =
            (self.mixer.mix(inputs, axis.context * DEPTHS + depth) + self.other.mix(inputs, axis.size)) >> 1;
        let bit = coder.bit(bit, self.probability_map.refine(odds, depth));
        self.mixer.update(inputs, bit);
        self.other.update(inputs, bit);
        self.probability_map.update(bit);
        counters.into_iter().for_each(|counter| counter.update(bit));
        bit
    }
}

/// Computes the log-odds of the upper half under each density. Densities with little mass here give
/// values near zero.
#[inline]
fn weigh(
    low: &Masses<KINDS, WIDTHS>,
    middle: &Masses<KINDS, WIDTHS>,
    high: &Masses<KINDS, WIDTHS>,
    inputs: &mut [i16],
) {
    for kind in 0..KINDS {
        for width in 0..WIDTHS {
            let middle = middle[kind][width];
            let [up, down] = [high[kind][width] - middle, middle - low[kind][width]];
            inputs[kind * WIDTHS + width] = (logarithm(up.abs()) - logarithm(down.abs())) as i16;
        }
    }
}

/// Masses are quantized in steps of 2 to this power.
const STEP_LOG: u32 = 16;
/// Minimum mass of every interval, of 2^28, in steps.
const DOUBT: usize = 32;

/// Natural logarithms of masses, in 1/256.
static LOGARITHMS: [i16; (1 << (28 - STEP_LOG)) + 1] = {
    let mut table = [0; (1 << (28 - STEP_LOG)) + 1];
    let mut at = 0;
    while at < table.len() {
        // ln 2 is 177.446 / 256.
        let log2 = log2_q16((2 * (DOUBT + at) + 1) as u64) as i64;
        table[at] = ((log2 * 177_446 / 1000) >> 16) as i16;
        at += 1;
    }
    table
};

/// Returns the logarithm of a mass plus a small constant, which dominates small masses.
#[inline]
fn logarithm(mass: i32) -> i32 {
    let at = (mass.max(0) >> STEP_LOG) as usize;
    i32::from(LOGARITHMS[at.min(LOGARITHMS.len() - 1)])
}
