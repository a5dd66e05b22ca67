//! [`AdaptiveBit`]: the probability of one decision, learned from its earlier outcomes.
//!
//! The first outcomes count as in a plain average (the second weighs a half, the third a third, ...), so
//! that a model is useful after a handful of decisions; then the weight becomes constant and old outcomes
//! fade. Small meshes never leave the first phase: a fixed rate would cost them several percent.

use super::coder::Coder;

/// How quickly a probability adapts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rate {
    /// Averages about 30 decisions: for statistics that vary over the mesh.
    Quick,
    /// Averages about 250 decisions: for statistics that are stable.
    Steady,
}

/// Number of low bits of the state for rate and count; the probability is in the bits above them.
const COUNT_BITS: u32 = 10;
/// Flag in the state of a quick probability; the count is in the bits below.
const QUICK: u32 = 1 << (COUNT_BITS - 1);
const COUNT_MASK: u32 = QUICK - 1;
const QUICK_LIMIT: u32 = 30;
const STEADY_LIMIT: u32 = 250;

/// Weight of the next outcome by the number of earlier ones, in 1/65536.
const WEIGHTS: [u32; STEADY_LIMIT as usize + 1] = {
    let mut weights = [0; STEADY_LIMIT as usize + 1];
    let mut count = 0;
    while count < weights.len() {
        // As if a fraction of each outcome had already been seen: 1 / (count + 1.6).
        weights[count] = 655_360 / (10 * count as u32 + 16);
        count += 1;
    }
    weights
};

/// A probability that adapts to the decisions coded with it.
#[derive(Clone, Copy, Debug)]
pub struct AdaptiveBit {
    /// 22 bits of probability, one bit for the rate, 9 bits of count.
    state: u32,
}

impl AdaptiveBit {
    /// Creates an untrained model: even odds.
    pub const fn new(rate: Rate) -> Self {
        let quick = if matches!(rate, Rate::Quick) { QUICK } else { 0 };
        Self { state: 1 << 31 | quick }
    }

    /// Returns the probability of `true`, in 1/65536: 16 to 65520.
    #[inline]
    pub fn p_one(self) -> u32 {
        (self.state >> 16).clamp(16, 65520)
    }

    /// Learns the outcome of a decision.
    #[inline]
    pub fn update(&mut self, bit: bool) {
        let count = self.state & COUNT_MASK;
        let limit = if self.state & QUICK != 0 { QUICK_LIMIT } else { STEADY_LIMIT };
        let probability = self.state >> COUNT_BITS;
        let target = if bit { (1 << 22) - 1 } else { 0 };
        let step =
            ((i64::from(target) - i64::from(probability)) * i64::from(WEIGHTS[count as usize & 255])) >> 16;
        let moved = (i64::from(probability) + step) as u32;
        self.state = moved << COUNT_BITS | self.state & QUICK | (count + 1).min(limit);
    }

    /// Codes a decision and learns its outcome.
    #[inline]
    pub fn code<C: Coder>(&mut self, coder: &mut C, bit: bool) -> bool {
        let bit = coder.bit(bit, self.p_one());
        self.update(bit);
        bit
    }
}

#[cfg(test)]
mod tests {
    use striata::mesh::Random;

    use super::super::{RangeReader, RangeWriter};
    use super::*;

    #[test]
    fn first_outcomes_count_most() {
        for rate in [Rate::Quick, Rate::Steady] {
            let mut bit = AdaptiveBit::new(rate);
            let seen = [(); 4].map(|()| {
                bit.update(true);
                bit.p_one() >> 10
            });
            assert_eq!(seen, [51, 56, 58, 59]);
        }
    }

    #[test]
    fn adaptation_converges_to_the_rate() {
        let converged = [Rate::Quick, Rate::Steady].map(|rate| {
            let mut bit = AdaptiveBit::new(rate);
            (0..2000).for_each(|_| bit.update(true));
            let before = bit.p_one();
            bit.update(false);
            (before, before - bit.p_one())
        });
        assert_eq!(converged, [(65520, 2058), (65520, 248)]);
    }

    #[test]
    fn a_skewed_source_costs_little_more_than_its_entropy() {
        let mut random = Random::new(4);
        let message: Vec<bool> = (0..20_000).map(|_| random.below(100) < 7).collect();
        let share = message.iter().filter(|&&bit| bit).count() as f64 / 20_000.0;
        let entropy = -20_000.0 * (share * share.log2() + (1.0 - share) * (1.0 - share).log2());
        let mut writer = RangeWriter::new();
        let mut model = AdaptiveBit::new(Rate::Steady);
        message.iter().for_each(|&bit| assert_eq!(model.code(&mut writer, bit), bit));
        let (bytes, _) = writer.finish();
        assert!((bytes.len() as f64 * 8.0) < entropy * 1.015, "{} bytes for {entropy} bits", bytes.len());
        let mut reader = RangeReader::new(&bytes, true);
        let mut model = AdaptiveBit::new(Rate::Steady);
        message.iter().for_each(|&bit| assert_eq!(model.code(&mut reader, false), bit));
    }
}
