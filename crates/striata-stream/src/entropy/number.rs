//! Integers of any size, as a chain of decisions.
//!
//! A number is zero or not, has a sign, lies in a bucket (1, 2 to 3, 4 to 7, ...: found by asking upwards), and its
//! two bits below the first are learned for each bucket; the rest is as good as noise. A small context chooses among
//! independent sets of probabilities.

use super::adaptive::{AdaptiveBit, Rate};
use super::coder::Coder;

/// Decisions there are: zero, sign, 31 buckets, 3 for the top bits of each.
pub(super) const NODES: usize = 2 + 31 + 32 * 3;
const ZERO: usize = 0;
const SIGN: usize = 1;
const ABOVE: usize = 2;
const TOP: usize = 33;

/// What makes the decisions that a number is a chain of.
pub(super) trait Decisions {
    /// Codes the decision of a node.
    fn decide<C: Coder>(&mut self, coder: &mut C, node: usize, bit: bool) -> bool;
}

/// Codes a number of either sign.
#[inline]
pub(super) fn code_signed<C: Coder>(coder: &mut C, decisions: &mut impl Decisions, value: i32) -> i32 {
    if decisions.decide(coder, ZERO, value == 0) {
        return 0;
    }
    let is_negative = decisions.decide(coder, SIGN, value < 0);
    let magnitude = code_magnitude(coder, decisions, value.unsigned_abs()) as i32;
    if is_negative { magnitude.wrapping_neg() } else { magnitude }
}

/// Codes a number above zero.
#[inline]
fn code_magnitude<C: Coder>(coder: &mut C, decisions: &mut impl Decisions, value: u32) -> u32 {
    let meant = value.max(1).ilog2();
    let mut bucket = 0;
    while bucket < 31 && decisions.decide(coder, ABOVE + bucket as usize, meant > bucket) {
        bucket += 1;
    }
    let mut decoded = 1;
    let top_count = bucket.min(2);
    for taken in 1..=top_count {
        let node = TOP + 3 * bucket as usize + decoded as usize - 1;
        let bit = decisions.decide(coder, node, value >> (bucket - taken) & 1 != 0);
        decoded = decoded << 1 | u32::from(bit);
    }
    let mut left = bucket - top_count;
    while left > 0 {
        let bits = left.min(24);
        left -= bits;
        decoded = decoded << bits | coder.raw(value >> left, bits);
    }
    decoded
}

/// Codes integers of up to 32 bits; small ones are cheap, and what is frequent gets cheaper.
#[derive(Clone, Debug)]
pub(crate) struct AdaptiveNumber {
    contexts: Vec<Learned>,
}

/// What is learned about numbers in one context.
#[derive(Clone, Copy, Debug)]
struct Learned([AdaptiveBit; NODES]);

impl Decisions for Learned {
    #[inline]
    fn decide<C: Coder>(&mut self, coder: &mut C, node: usize, bit: bool) -> bool {
        self.0[node].code(coder, bit)
    }
}

impl AdaptiveNumber {
    /// Nothing learned in any of the contexts.
    pub(crate) fn new(context_count: usize, rate: Rate) -> Self {
        Self { contexts: vec![Learned([AdaptiveBit::new(rate); NODES]); context_count.max(1)] }
    }

    /// Codes a number of either sign.
    pub(crate) fn signed<C: Coder>(&mut self, coder: &mut C, context: usize, value: i32) -> i32 {
        code_signed(coder, &mut self.contexts[context], value)
    }

    /// Codes a number without sign.
    pub(crate) fn unsigned<C: Coder>(&mut self, coder: &mut C, context: usize, value: u32) -> u32 {
        let learned = &mut self.contexts[context];
        if learned.decide(coder, ZERO, value == 0) { 0 } else { code_magnitude(coder, learned, value) }
    }
}

/// Codes a number below `count`, all being equally likely.
pub(crate) fn code_uniform<C: Coder>(coder: &mut C, count: u32, meant: u32) -> u32 {
    let (mut low, mut high) = (0, count.max(1));
    while high - low > 1 {
        let middle = low + (high - low) / 2;
        let share = (u64::from(high - middle) * 65_536 / u64::from(high - low)) as u32;
        if coder.bit(meant >= middle, share) { low = middle } else { high = middle }
    }
    low
}

#[cfg(test)]
mod tests {
    use striata::mesh::Random;

    use super::super::{RangeReader, RangeWriter};
    use super::*;

    fn numbers() -> Vec<i32> {
        let mut random = Random::new(11);
        let mut numbers = vec![0, 1, -1, 2, -2, 3, 4, 7, 8, i32::MAX, i32::MIN, i32::MIN + 1, i32::MAX - 1];
        numbers.extend((0..4000).map(|_| (random.next_u64() as i32) >> random.below(32)));
        numbers
    }

    #[test]
    fn numbers_of_all_sizes_come_back() {
        let mut writer = RangeWriter::new();
        let mut model = AdaptiveNumber::new(3, Rate::Quick);
        for (at, &number) in numbers().iter().enumerate() {
            assert_eq!(model.signed(&mut writer, at % 2, number), number);
            assert_eq!(model.unsigned(&mut writer, 2, number as u32), number as u32);
        }
        let (bytes, _) = writer.finish();
        let mut reader = RangeReader::new(&bytes, true);
        let mut model = AdaptiveNumber::new(3, Rate::Quick);
        for (at, &number) in numbers().iter().enumerate() {
            assert_eq!(model.signed(&mut reader, at % 2, 0), number);
            assert_eq!(model.unsigned(&mut reader, 2, 0), number as u32);
        }
    }

    #[test]
    fn small_numbers_take_little_more_than_their_entropy() {
        let mut random = Random::new(12);
        let numbers: Vec<i32> = (0..30_000).map(|_| (random.below(4) + random.below(4)) as i32 - 3).collect();
        let entropy: f64 =
            [1.0, 2.0, 3.0, 4.0, 3.0, 2.0, 1.0].map(|w: f64| -(w / 16.0) * (w / 16.0).log2()).iter().sum();
        let mut writer = RangeWriter::new();
        let mut model = AdaptiveNumber::new(1, Rate::Steady);
        for &number in &numbers {
            model.signed(&mut writer, 0, number);
        }
        let bits = writer.finish().0.len() as f64 * 8.0;
        assert!(bits < entropy * 30_000.0 * 1.02, "{} bits a number for {entropy}", bits / 30_000.0);
    }

    #[test]
    fn any_bytes_give_numbers() {
        let mut random = Random::new(13);
        for _ in 0..100 {
            let bytes: Vec<u8> = (0..30).map(|_| random.next_u64() as u8).collect();
            let mut reader = RangeReader::new(&bytes, true);
            let mut model = AdaptiveNumber::new(1, Rate::Quick);
            for _ in 0..40 {
                model.signed(&mut reader, 0, 0);
                model.unsigned(&mut reader, 0, 0);
            }
        }
    }
}
