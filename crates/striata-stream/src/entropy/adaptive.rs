//! The probability of one decision, learned from how it went before.
//!
//! The first decisions count as in a plain average (the second weighs a half, the third a third, ...), so that a
//! model is of use after a handful of them; then the weight settles and old decisions fade. Small meshes live in
//! the first phase: a fixed rate would cost them several percent.

use super::coder::Coder;

/// How long a probability remembers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Rate {
    /// Some 30 decisions: for what changes over the mesh.
    Quick,
    /// Some 250 decisions: for what stays.
    Steady,
}

/// The bits of the state that count decisions; the probability is above them.
const COUNT_BITS: u32 = 10;
/// Set in the state of a quick probability; the count is below.
const QUICK: u32 = 1 << (COUNT_BITS - 1);
const COUNT_MASK: u32 = QUICK - 1;
const QUICK_LIMIT: u32 = 30;
const STEADY_LIMIT: u32 = 250;

/// The weight of the next decision after so many, in 1/65536.
const WEIGHTS: [u32; STEADY_LIMIT as usize + 1] = {
    let mut weights = [0; STEADY_LIMIT as usize + 1];
    let mut count = 0;
    while count < weights.len() {
        // As if one decision of each kind had been seen in halves: 1 / (count + 1.6).
        weights[count] = 655_360 / (10 * count as u32 + 16);
        count += 1;
    }
    weights
};

/// A probability that follows the decisions made with it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct AdaptiveBit {
    /// 22 bits of probability, the rate, 9 bits of count.
    state: u32,
}

impl AdaptiveBit {
    /// Even odds, nothing seen.
    pub(crate) const fn new(rate: Rate) -> Self {
        let quick = if matches!(rate, Rate::Quick) { QUICK } else { 0 };
        Self { state: 1 << 31 | quick }
    }

    /// The probability of true, in 1/65536: 16 to 65520.
    #[inline]
    pub(crate) fn p_one(self) -> u32 {
        (self.state >> 16).clamp(16, 65520)
    }

    /// Learns how the decision went.
    #[inline]
    pub(crate) fn update(&mut self, bit: bool) {
        let count = self.state & COUNT_MASK;
        let limit = if self.state & QUICK != 0 { QUICK_LIMIT } else { STEADY_LIMIT };
        let probability = self.state >> COUNT_BITS;
        let target = if bit { (1 << 22) - 1 } else { 0 };
        let step =
            ((i64::from(target) - i64::from(probability)) * i64::from(WEIGHTS[count as usize & 255])) >> 16;
        let moved = (i64::from(probability) + step) as u32;
        self.state = moved << COUNT_BITS | self.state & QUICK | (count + 1).min(limit);
    }

    /// Codes one decision and learns from it.
    #[inline]
    pub(crate) fn code<C: Coder>(&mut self, coder: &mut C, bit: bool) -> bool {
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
    fn first_decisions_count_most() {
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
    fn memory_settles_at_the_rate() {
        let settled = [Rate::Quick, Rate::Steady].map(|rate| {
            let mut bit = AdaptiveBit::new(rate);
            (0..2000).for_each(|_| bit.update(true));
            let before = bit.p_one();
            bit.update(false);
            (before, before - bit.p_one())
        });
        assert_eq!(settled, [(65520, 2058), (65520, 248)]);
    }

    #[test]
    fn a_skewed_source_takes_little_more_than_its_entropy() {
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
