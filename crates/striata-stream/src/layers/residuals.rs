//! Coding of prediction residuals, and selection of the best of several predictors.

use crate::entropy::MixedNumber;
use crate::entropy::{AdaptiveNumber, Coder, Rate, log2_q8};
use crate::format::effort::Effort;
use crate::layers::layer_neighborhood::KINDS;

/// Number of half-octave buckets for expected sizes.
pub(crate) const SCALES: usize = 36;

/// Returns the bucket of an expected size, given in 1/16.
pub(crate) fn scale_of(sixteenths: u64) -> usize {
    let bounded = sixteenths.min(u64::from(u32::MAX)) as u32;
    (log2_q8(bounded) / 128).clamp(0, SCALES as i32 - 1) as usize
}

/// Number of buckets for a pair of sizes, of one and a half octaves each.
const PAIRS: usize = SCALES.div_ceil(3) * SCALES.div_ceil(3);

/// Number of half-octave buckets for each sign, up to 2^11.
const BUCKETS_PER_SIGN: usize = 23;
const SIGNED_BUCKETS: usize = 1 + 2 * BUCKETS_PER_SIGN;

/// The context of a residual.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Expected {
    /// Scales of the spread of surrounding values, of the conflict between predictions, of the
    /// surrounding residuals, and of one more quantity.
    pub scales: [usize; 4],
    /// Differences of other predictions from the one in use.
    pub others: [i64; 3],
}

/// Codes the residuals of predictions.
#[derive(Clone, Debug)]
pub(crate) enum Residuals {
    /// Uses one context, the average scale.
    Quick(AdaptiveNumber),
    /// Mixes contexts of the scales and of the other predictions, since the actual value is often close
    /// to one of them.
    Mixed(MixedNumber<6>),
}

impl Residuals {
    /// Creates an untrained model.
    pub(crate) fn new(effort: Effort, component_count: usize) -> Self {
        let sets = KINDS * component_count;
        let count = sets * SCALES;
        if effort == Effort::Fast {
            return Self::Quick(AdaptiveNumber::new(count, Rate::Steady));
        }
        let [signed, pairs] = [SIGNED_BUCKETS, PAIRS].map(|each| sets * each);
        Self::Mixed(MixedNumber::new([count, signed, signed, signed, pairs, count], sets))
    }

    /// Whether the differences of other predictions are used.
    pub(crate) fn looks_at_others(&self) -> bool {
        matches!(self, Self::Mixed(_))
    }

    /// Codes a residual. `set` identifies the component and the kind of vertex.
    pub(crate) fn signed<C: Coder>(
        &mut self,
        coder: &mut C,
        set: usize,
        Expected { scales, others }: Expected,
        off: i32,
    ) -> i32 {
        match self {
            Self::Quick(numbers) => {
                let scale = (2 * scales[0] + scales[1] + scales[2]) / 4;
                numbers.signed(coder, set * SCALES + scale, off)
            }
            Self::Mixed(numbers) => {
                let [spread, conflict, around, last] = scales;
                let [a, b, c] = others.map(|other| set * SIGNED_BUCKETS + signed_bucket(other));
                let pair = set * PAIRS + around / 3 * SCALES.div_ceil(3) + conflict / 3;
                let [spread, last] = [spread, last].map(|scale| set * SCALES + scale);
                numbers.signed(coder, ([spread, a, b, c, pair, last], set), off)
            }
        }
    }
}

/// Returns the bucket of a signed number.
fn signed_bucket(number: i64) -> usize {
    let size = scale_of(number.unsigned_abs()).min(BUCKETS_PER_SIGN - 1);
    match number.signum() {
        0 => 0,
        1 => 1 + size,
        _ => 1 + BUCKETS_PER_SIGN + size,
    }
}

/// Each update reduces the losses of predictors by one part in 2 to this power.
const FADE: u32 = 6;

/// Selects the predictor that did best recently.
#[derive(Clone, Copy, Debug)]
pub(crate) struct PredictorSelector<const N: usize> {
    /// Decaying sums of the logarithms of each predictor's errors.
    losses: [i32; N],
}

impl<const N: usize> PredictorSelector<N> {
    /// Creates an untrained selector.
    pub(crate) fn new() -> Self {
        Self { losses: [0; N] }
    }

    /// Returns the best of the first `count` predictors.
    pub(crate) fn best(&self, count: usize) -> usize {
        (0..count).min_by_key(|&i| self.losses[i]).unwrap_or(0)
    }

    /// Updates the sums with the error of each predictor.
    pub(crate) fn learn(&mut self, off: [u64; N]) {
        for (loss, off) in self.losses.iter_mut().zip(off) {
            let bits = log2_q8(off.saturating_add(1).min(u64::from(u32::MAX)) as u32) << 8;
            *loss += (bits - *loss) >> FADE;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn scales_rise_by_half_octaves() {
        assert_eq!([0, 1, 2, 4, 8, 16].map(scale_of), [0, 0, 2, 4, 6, 8]);
        assert_eq!([scale_of(u64::MAX), scale_of(u64::from(u32::MAX))], [SCALES - 1; 2]);
        assert!((0..5000).all(|x| scale_of(x) <= scale_of(x + 1)));
    }

    #[test]
    fn selects_the_recently_better_prediction() {
        let mut selector = PredictorSelector::<3>::new();
        (0..100).for_each(|_| selector.learn([9, 2, 7]));
        assert_eq!(selector.best(3), 1);
        (0..200).for_each(|_| selector.learn([9, 20, 7]));
        assert_eq!(selector.best(3), 2);
        (0..1000).for_each(|_| selector.learn([0, u64::MAX, u64::MAX]));
        assert_eq!(selector.best(3), 0);
    }
}
