//! Adaptive coding of integers of any size as a sequence of binary decisions (Elias-gamma style).
//!
//! The decisions are: is it zero, its sign, its bucket in unary (1, 2 to 3, 4 to 7, ...), and the two bits
//! below the leading one, which are modeled per bucket. The remaining bits are nearly uniform and are coded
//! raw. A small context selects among independent sets of probabilities.

use super::adaptive::{AdaptiveBit, Rate};
use super::coder::Coder;

/// Number of modeled decisions: zero, sign, 31 bucket boundaries, and 3 for the top bits of each of 32
/// buckets.
pub(super) const NODE_COUNT: usize = 2 + 31 + 32 * 3;
const ZERO: usize = 0;
const SIGN: usize = 1;
const ABOVE_BUCKET: usize = 2;
const TOP_BITS: usize = 33;

/// Codes the decisions that make up an integer.
pub(super) trait NodeCoder {
    /// Codes the decision of one node of the decision tree.
    fn code_node<C: Coder>(&mut self, coder: &mut C, node: usize, bit: bool) -> bool;
}

/// Codes a signed integer.
#[inline]
pub(super) fn code_signed<C: Coder>(coder: &mut C, nodes: &mut impl NodeCoder, value: i32) -> i32 {
    if nodes.code_node(coder, ZERO, value == 0) {
        return 0;
    }
    let is_negative = nodes.code_node(coder, SIGN, value < 0);
    let magnitude = code_magnitude(coder, nodes, value.unsigned_abs()) as i32;
    if is_negative { magnitude.wrapping_neg() } else { magnitude }
}

/// Codes an integer above zero.
#[inline]
fn code_magnitude<C: Coder>(coder: &mut C, nodes: &mut impl NodeCoder, value: u32) -> u32 {
    let actual_bucket = value.max(1).ilog2();
    let mut bucket = 0;
    while bucket < 31 && nodes.code_node(coder, ABOVE_BUCKET + bucket as usize, actual_bucket > bucket) {
        bucket += 1;
    }
    let mut decoded = 1;
    let top_count = bucket.min(2);
    for depth in 1..=top_count {
        let node = TOP_BITS + 3 * bucket as usize + decoded as usize - 1;
        let bit = nodes.code_node(coder, node, value >> (bucket - depth) & 1 != 0);
        decoded = decoded << 1 | u32::from(bit);
    }
    let mut raw_bits_left = bucket - top_count;
    while raw_bits_left > 0 {
        let bits = raw_bits_left.min(24);
        raw_bits_left -= bits;
        decoded = decoded << bits | coder.raw(value >> raw_bits_left, bits);
    }
    decoded
}

/// Codes integers of up to 32 bits: small ones are cheap from the start, frequent ones become cheap.
#[derive(Clone, Debug)]
pub struct AdaptiveNumber {
    contexts: Vec<NumberContext>,
}

/// The probabilities of one context.
#[derive(Clone, Copy, Debug)]
struct NumberContext([AdaptiveBit; NODE_COUNT]);

impl NodeCoder for NumberContext {
    #[inline]
    fn code_node<C: Coder>(&mut self, coder: &mut C, node: usize, bit: bool) -> bool {
        self.0[node].code(coder, bit)
    }
}

impl AdaptiveNumber {
    /// Creates an untrained model with `context_count` contexts.
    pub fn new(context_count: usize, rate: Rate) -> Self {
        Self { contexts: vec![NumberContext([AdaptiveBit::new(rate); NODE_COUNT]); context_count.max(1)] }
    }

    /// Codes a signed integer.
    pub fn signed<C: Coder>(&mut self, coder: &mut C, context: usize, value: i32) -> i32 {
        code_signed(coder, &mut self.contexts[context], value)
    }

    /// Codes an unsigned integer.
    pub fn unsigned<C: Coder>(&mut self, coder: &mut C, context: usize, value: u32) -> u32 {
        let nodes = &mut self.contexts[context];
        if nodes.code_node(coder, ZERO, value == 0) { 0 } else { code_magnitude(coder, nodes, value) }
    }
}

/// Codes an integer below `count`, all being equally likely.
pub fn code_uniform<C: Coder>(coder: &mut C, count: u32, actual: u32) -> u32 {
    let (mut low, mut high) = (0, count.max(1));
    while high - low > 1 {
        let middle = low + (high - low) / 2;
        let p_one = (u64::from(high - middle) * 65_536 / u64::from(high - low)) as u32;
        if coder.bit(actual >= middle, p_one) { low = middle } else { high = middle }
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
    fn integers_of_all_sizes_round_trip() {
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
    fn small_integers_cost_little_more_than_their_entropy() {
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
    fn arbitrary_bytes_decode_without_panicking() {
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
