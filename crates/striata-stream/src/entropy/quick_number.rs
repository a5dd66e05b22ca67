//! Adaptive coding of integers with few operations: one symbol for the size, one modeled bit, and raw bits.
//!
//! The size is the number of significant bits. The bit below the leading one is modeled per size, which makes the
//! classes half octaves; sign and all other bits are nearly uniform and are coded raw, at once. Takes a third of the
//! time of [`AdaptiveNumber`](super::AdaptiveNumber), and about a tenth of a bit more.

use super::adaptive::{AdaptiveBit, Rate};
use super::coder::Coder;
use super::symbol::AdaptiveSymbol;

/// Symbol of integers with at least this many bits; their size follows raw.
const LARGE: u32 = 15;
/// Largest number of significant bits.
const MAX_BITS: u32 = 62;
/// Number of raw bits that are coded at once.
const RAW_BITS: u32 = 24;

/// Codes integers of up to 62 bits; frequent sizes become cheap.
#[derive(Clone, Debug)]
pub struct QuickNumber {
    contexts: Vec<Context>,
    last_shift: u32,
}

/// The probabilities of one context.
#[derive(Clone, Copy, Debug)]
struct Context {
    size: AdaptiveSymbol,
    /// The bit below the leading one, for each size.
    second: [AdaptiveBit; LARGE as usize + 1],
}

/// The context of a number, and how many values it has.
struct NumberContext {
    /// Index of the context.
    pub context: usize,
    /// Number of values.
    pub size: u32,
}

impl QuickNumber {
    /// Creates an untrained model with `context_count` contexts.
    pub fn new(context_count: usize, rate: Rate) -> Self {
        let context = Context { size: AdaptiveSymbol::new(16), second: [AdaptiveBit::new(rate); 16] };
        let last_shift = if rate == Rate::Quick { 5 } else { 7 };
        Self { contexts: vec![context; context_count.max(1)], last_shift }
    }

    /// Codes a signed integer of up to 62 bits.
    #[inline]
    pub fn signed<C: Coder>(&mut self, coder: &mut C, context: usize, value: i64) -> i64 {
        let size = self.size(coder, context, value.unsigned_abs());
        if size == 0 {
            return 0;
        }
        let signed = value.unsigned_abs() << 1 | u64::from(value < 0);
        let (magnitude, sign) = self.below(coder, NumberContext { context, size }, signed, 1);
        if sign == 0 { magnitude as i64 } else { -(magnitude as i64) }
    }

    /// Codes an unsigned integer of up to 62 bits.
    #[inline]
    pub fn unsigned<C: Coder>(&mut self, coder: &mut C, context: usize, value: u64) -> u64 {
        let size = self.size(coder, context, value);
        if size == 0 { 0 } else { self.below(coder, NumberContext { context, size }, value, 0).0 }
    }

    /// Codes the number of significant bits.
    #[inline]
    fn size<C: Coder>(&mut self, coder: &mut C, context: usize, magnitude: u64) -> u32 {
        let actual = (u64::BITS - magnitude.leading_zeros()).min(MAX_BITS);
        let symbol =
            self.contexts[context].size.code(coder, actual.min(LARGE) as usize, self.last_shift) as u32;
        if symbol < LARGE {
            symbol
        } else {
            LARGE + coder.raw(actual.saturating_sub(LARGE), 6).min(MAX_BITS - LARGE)
        }
    }

    /// Codes everything below the leading bit, with `extra` (0 or 1) further bits at the end; returns the
    /// integer and those bits.
    #[inline]
    fn below<C: Coder>(
        &mut self,
        coder: &mut C,
        NumberContext { context, size }: NumberContext,
        value: u64,
        extra: u32,
    ) -> (u64, u64) {
        let mut decoded = 1;
        let mut left = size - 1 + extra;
        if size > 1 {
            left -= 1;
            let second = &mut self.contexts[context].second[size.min(LARGE) as usize];
            decoded = 2 | u64::from(second.code(coder, value >> left & 1 != 0));
        }
        while left > 0 {
            let bits = left.min(RAW_BITS);
            left -= bits;
            decoded = decoded << bits | u64::from(coder.raw((value >> left) as u32, bits));
        }
        (decoded >> extra, decoded & ((1 << extra) - 1))
    }
}

#[cfg(test)]
mod tests {
    use striata::mesh::Random;

    use super::super::{RangeReader, RangeWriter};
    use super::*;

    fn numbers() -> Vec<i64> {
        let mut random = Random::new(11);
        let most = (1 << MAX_BITS) - 1;
        let mut numbers = vec![0, 1, -1, 2, -2, 3, 4, 7, 8, most, -most, most >> 1, 1 << 15, (1 << 14) - 1];
        numbers.extend((0..4000).map(|_| (random.next_u64() as i64) >> (2 + random.below(61))));
        numbers
    }

    #[test]
    fn integers_of_all_sizes_round_trip() {
        let mut writer = RangeWriter::new();
        let mut model = QuickNumber::new(3, Rate::Quick);
        for (at, &number) in numbers().iter().enumerate() {
            assert_eq!(model.signed(&mut writer, at % 2, number), number);
            assert_eq!(model.unsigned(&mut writer, 2, number.unsigned_abs()), number.unsigned_abs());
        }
        let (bytes, _) = writer.finish();
        let mut reader = RangeReader::new(&bytes, true);
        let mut model = QuickNumber::new(3, Rate::Quick);
        for (at, &number) in numbers().iter().enumerate() {
            assert_eq!(model.signed(&mut reader, at % 2, 0), number);
            assert_eq!(model.unsigned(&mut reader, 2, 0), number.unsigned_abs());
        }
    }

    #[test]
    fn residuals_cost_little_more_than_their_entropy() {
        let mut random = Random::new(12);
        let draw = |random: &mut Random| (0..8).map(|_| i64::from(random.below(64))).sum::<i64>() - 252;
        let numbers: Vec<i64> = (0..60_000).map(|_| draw(&mut random)).collect();
        let mut counts = std::collections::BTreeMap::<i64, f64>::new();
        numbers.iter().for_each(|&number| *counts.entry(number).or_default() += 1.0);
        let total = numbers.len() as f64;
        let entropy: f64 = counts.values().map(|count| -count * (count / total).log2()).sum();
        let mut writer = RangeWriter::new();
        let mut model = QuickNumber::new(1, Rate::Steady);
        for &number in &numbers {
            model.signed(&mut writer, 0, number);
        }
        let bits = writer.finish().0.len() as f64 * 8.0;
        assert!(bits < entropy + 0.12 * total, "{} bits a number for {}", bits / total, entropy / total);
    }

    #[test]
    fn arbitrary_bytes_decode_without_panicking() {
        let mut random = Random::new(13);
        for _ in 0..100 {
            let bytes: Vec<u8> = (0..30).map(|_| random.next_u64() as u8).collect();
            let mut reader = RangeReader::new(&bytes, true);
            let mut model = QuickNumber::new(1, Rate::Quick);
            for _ in 0..40 {
                model.signed(&mut reader, 0, 0);
                model.unsigned(&mut reader, 0, 0);
            }
        }
    }
}
