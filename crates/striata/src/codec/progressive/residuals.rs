//! What predictions were off, under what is expected of them; and which of several predictions to trust.

use super::super::entropy::{AdaptiveNumber, Coder, Rate, log2_q8};
use super::Effort;
use super::mixed_number::MixedNumber;

/// Buckets of half octaves for what is expected.
pub(super) const SCALES: usize = 36;

/// The bucket of an expected size in 1/16.
pub(super) fn scale_of(sixteenths: u64) -> usize {
    let bounded = sixteenths.min(u64::from(u32::MAX)) as u32;
    (log2_q8(bounded) / 128).clamp(0, SCALES as i32 - 1) as usize
}

/// Codes what predictions were off.
#[derive(Clone, Debug)]
pub(super) enum Residuals {
    /// Under one context for each scale.
    Quick(AdaptiveNumber),
    /// Under all contexts.
    Mixed(MixedNumber<4>),
}

impl Residuals {
    pub(super) fn new(effort: Effort, component_count: usize) -> Self {
        let count = component_count * SCALES;
        match effort {
            Effort::Fast => Self::Quick(AdaptiveNumber::new(count, Rate::Steady)),
            _ => Self::Mixed(MixedNumber::new([count; 4])),
        }
    }

    /// Codes what a prediction of a component was off, given four scales that tell of that.
    pub(super) fn signed<C: Coder>(
        &mut self,
        coder: &mut C,
        component: usize,
        scales: [usize; 4],
        off: i32,
    ) -> i32 {
        match self {
            Self::Quick(numbers) => {
                let scale = (2 * scales[0] + scales[1] + scales[2]) / 4;
                numbers.signed(coder, component * SCALES + scale, off)
            }
            Self::Mixed(numbers) => {
                numbers.signed(coder, scales.map(|scale| component * SCALES + scale), off)
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

    pub(super) fn best(&self) -> usize {
        (0..N).min_by_key(|&i| self.losses[i]).unwrap_or(0)
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
        assert_eq!(contest.best(), 1);
        (0..100).for_each(|_| contest.learn([9, 20, 7]));
        assert_eq!(contest.best(), 2);
        (0..500).for_each(|_| contest.learn([0, u64::MAX, u64::MAX]));
        assert_eq!(contest.best(), 0);
    }
}
