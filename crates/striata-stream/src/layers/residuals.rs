//! What predictions were off, under what is expected of them; and which of several predictions to trust.

use crate::entropy::MixedNumber;
use crate::entropy::{AdaptiveNumber, Coder, Rate, log2_q8};
use crate::format::form::{Effort, StreamVersion};
use crate::layers::hood::KINDS;

/// Buckets of half octaves for what is expected.
pub(crate) const SCALES: usize = 36;

/// The bucket of an expected size in 1/16.
pub(crate) fn scale_of(sixteenths: u64) -> usize {
    let bounded = sixteenths.min(u64::from(u32::MAX)) as u32;
    (log2_q8(bounded) / 128).clamp(0, SCALES as i32 - 1) as usize
}

/// Buckets of one and a half octaves for two sizes together.
const PAIRS: usize = SCALES.div_ceil(3) * SCALES.div_ceil(3);

/// Buckets of half octaves on either side of zero, up to 2^11.
const SIDE: usize = 23;
const TURNS: usize = 1 + 2 * SIDE;

/// What is expected of a residual.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Expected {
    /// How far the values around spread, predictions conflict, predictions were off around, and anything else.
    pub(crate) scales: [usize; 4],
    /// Where other predictions are, as seen from the one that was taken.
    pub(crate) others: [i64; 3],
}

/// Codes what predictions were off.
#[derive(Clone, Debug)]
pub(crate) enum Residuals {
    /// Under one context for each scale.
    Quick(AdaptiveNumber),
    /// Under the four scales.
    Mixed(MixedNumber<4>),
    /// Under scales and where other predictions are: what was off often leads to one of them.
    Directed(MixedNumber<6>),
}

impl Residuals {
    /// Nothing learned; version 1 does not tell kinds of vertices apart.
    pub(crate) fn new((effort, version): (Effort, StreamVersion), component_count: usize) -> Self {
        let sets = if version == StreamVersion::One { component_count } else { KINDS * component_count };
        let count = sets * SCALES;
        match (effort, version) {
            (Effort::Fast, _) => Self::Quick(AdaptiveNumber::new(count, Rate::Steady)),
            (_, StreamVersion::One) => Self::Mixed(MixedNumber::new([count; 4], 1)),
            _ => {
                let [turns, pairs] = [TURNS, PAIRS].map(|each| sets * each);
                Self::Directed(MixedNumber::new([count, turns, turns, turns, pairs, count], sets))
            }
        }
    }

    /// True if it matters where other predictions are.
    pub(crate) fn looks_at_others(&self) -> bool {
        matches!(self, Self::Directed(_))
    }

    /// Codes what a prediction was off; `set` is a component of a kind of vertex.
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
            Self::Mixed(numbers) => numbers.signed(coder, (scales.map(|scale| set * SCALES + scale), 0), off),
            Self::Directed(numbers) => {
                let [spread, conflict, around, last] = scales;
                let [a, b, c] = others.map(|other| set * TURNS + turn_of(other));
                let pair = set * PAIRS + around / 3 * SCALES.div_ceil(3) + conflict / 3;
                let [spread, last] = [spread, last].map(|scale| set * SCALES + scale);
                numbers.signed(coder, ([spread, a, b, c, pair, last], set), off)
            }
        }
    }
}

/// The bucket of a number of either sign.
fn turn_of(number: i64) -> usize {
    let size = scale_of(number.unsigned_abs()).min(SIDE - 1);
    match number.signum() {
        0 => 0,
        1 => 1 + size,
        _ => 1 + SIDE + size,
    }
}

/// Which of several predictions did best lately.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Contest<const N: usize> {
    /// Fading sums of the logarithms of what each was off.
    losses: [i32; N],
    /// How fast: by one part in 2 to this each time.
    fade: u32,
}

impl<const N: usize> Contest<N> {
    /// Nothing learned; version 1 forgets faster.
    pub(crate) fn new(version: StreamVersion) -> Self {
        Self { losses: [0; N], fade: if version == StreamVersion::One { 5 } else { 6 } }
    }

    /// The best of the first `count`.
    pub(crate) fn best(&self, count: usize) -> usize {
        (0..count).min_by_key(|&i| self.losses[i]).unwrap_or(0)
    }

    pub(crate) fn learn(&mut self, off: [u64; N]) {
        for (loss, off) in self.losses.iter_mut().zip(off) {
            let bits = log2_q8(off.saturating_add(1).min(u64::from(u32::MAX)) as u32) << 8;
            *loss += (bits - *loss) >> self.fade;
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
        let mut contest = Contest::<3>::new(StreamVersion::One);
        (0..50).for_each(|_| contest.learn([9, 2, 7]));
        assert_eq!(contest.best(3), 1);
        (0..100).for_each(|_| contest.learn([9, 20, 7]));
        assert_eq!(contest.best(3), 2);
        (0..500).for_each(|_| contest.learn([0, u64::MAX, u64::MAX]));
        assert_eq!(contest.best(3), 0);
    }
}
