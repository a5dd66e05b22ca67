//! What predictions were off, under what is expected of them; and which of several predictions to trust.

use super::super::entropy::{AdaptiveNumber, Coder, Rate, log2_q8};
use super::layer_hood::KINDS;
use super::mixed_number::MixedNumber;
use super::{Effort, StreamVersion};

/// Buckets of half octaves for what is expected.
pub(super) const SCALES: usize = 36;

/// The bucket of an expected size in 1/16.
pub(super) fn scale_of(sixteenths: u64) -> usize {
    let bounded = sixteenths.min(u64::from(u32::MAX)) as u32;
    (log2_q8(bounded) / 128).clamp(0, SCALES as i32 - 1) as usize
}

/// Buckets of one and a half octaves for two sizes together.
const PAIRS: usize = SCALES.div_ceil(3) * SCALES.div_ceil(3);

/// Codes what predictions were off.
#[derive(Clone, Debug)]
pub(super) enum Residuals {
    /// Under one context for each scale.
    Quick(AdaptiveNumber),
    /// Under all contexts.
    Mixed(MixedNumber<4>),
    /// Under all contexts, the first two also together.
    Paired(MixedNumber<5>),
}

impl Residuals {
    /// Nothing learned; version 1 does not tell kinds of vertices apart.
    pub(super) fn new((effort, version): (Effort, StreamVersion), component_count: usize) -> Self {
        let sets = if version == StreamVersion::One { component_count } else { KINDS * component_count };
        let count = sets * SCALES;
        match (effort, version) {
            (Effort::Fast, _) => Self::Quick(AdaptiveNumber::new(count, Rate::Steady)),
            (_, StreamVersion::One) => Self::Mixed(MixedNumber::new([count; 4], 1)),
            _ => Self::Paired(MixedNumber::new([count, count, count, count, sets * PAIRS], sets)),
        }
    }

    /// Codes what a prediction was off, given four scales that tell of that; `set` is a component of a kind of vertex.
    pub(super) fn signed<C: Coder>(&mut self, coder: &mut C, set: usize, scales: [usize; 4], off: i32) -> i32 {
        let contexts = scales.map(|scale| set * SCALES + scale);
        match self {
            Self::Quick(numbers) => {
                let scale = (2 * scales[0] + scales[1] + scales[2]) / 4;
                numbers.signed(coder, set * SCALES + scale, off)
            }
            Self::Mixed(numbers) => numbers.signed(coder, (contexts, 0), off),
            Self::Paired(numbers) => {
                let pair = set * PAIRS + scales[0] / 3 * SCALES.div_ceil(3) + scales[1] / 3;
                let [a, b, c, d] = contexts;
                numbers.signed(coder, ([a, b, c, d, pair], set), off)
            }
        }
    }
}

/// Which of several predictions did best lately.
#[derive(Clone, Copy, Debug)]
pub(super) struct Contest<const N: usize> {
    /// Fading sums of the logarithms of what each was off.
    losses: [i32; N],
}

impl<const N: usize> Contest<N> {
    pub(super) fn new() -> Self {
        Self { losses: [0; N] }
    }

    /// The best of the first `count`.
    pub(super) fn best(&self, count: usize) -> usize {
        (0..count).min_by_key(|&i| self.losses[i]).unwrap_or(0)
    }

    pub(super) fn learn(&mut self, off: [u64; N]) {
        for (loss, off) in self.losses.iter_mut().zip(off) {
            let bits = log2_q8(off.saturating_add(1).min(u64::from(u32::MAX)) as u32) << 8;
            *loss += (bits - *loss) >> 5;
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
    fn the_better_prediction_wins_and_loses_again() {
        let mut contest = Contest::<3>::new();
        (0..50).for_each(|_| contest.learn([9, 2, 7]));
        assert_eq!(contest.best(3), 1);
        (0..100).for_each(|_| contest.learn([9, 20, 7]));
        assert_eq!(contest.best(3), 2);
        (0..500).for_each(|_| contest.learn([0, u64::MAX, u64::MAX]));
        assert_eq!(contest.best(3), 0);
    }
}
