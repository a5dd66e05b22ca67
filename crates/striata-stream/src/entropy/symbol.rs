//! Adaptive coding of one of sixteen symbols with a single division, instead of several binary decisions.
//!
//! A model stores cumulative shares and moves them toward the coded symbol. All sixteen are updated by the
//! same operation, which vectorizes well, and the mean of two models is again a valid model.

use super::coder::{Coder, SYMBOLS, Shares};

/// Minimum share of a symbol, in 1/65536.
const MIN_SHARE: i32 = 24;
/// Negative binary logarithm of the rate at which shares move toward the coded symbol: at first, and later.
const FIRST_SHIFT: u32 = 3;
const LAST_SHIFT: u32 = 6;

/// Adaptive frequencies of sixteen symbols.
#[derive(Clone, Copy, Debug)]
pub(crate) struct AdaptiveSymbol {
    begins: Shares,
    /// Number of symbols learned, up to a limit.
    seen: u32,
}

impl AdaptiveSymbol {
    /// Creates an untrained model: all symbols are equally likely.
    pub(crate) fn new() -> Self {
        Self { begins: std::array::from_fn(|i| (i << 12) as i32), seen: 0 }
    }

    fn learn(&mut self, symbol: usize) {
        let shift = FIRST_SHIFT + self.seen.ilog2().min(LAST_SHIFT - FIRST_SHIFT);
        for (i, begin) in self.begins.iter_mut().enumerate() {
            let min_begin = i as i32 * MIN_SHARE;
            let target = if i <= symbol { min_begin } else { 65_536 - (SYMBOLS - i) as i32 * MIN_SHARE };
            *begin += (target - *begin) >> shift;
        }
    }
}

/// Codes a symbol by the mean of two models, and updates both.
#[inline]
pub(crate) fn code_symbol<C: Coder>(
    coder: &mut C,
    one: &mut AdaptiveSymbol,
    other: &mut AdaptiveSymbol,
    actual: usize,
) -> usize {
    let shares: Shares = std::array::from_fn(|i| (one.begins[i] + other.begins[i]) >> 1);
    let symbol = coder.symbol(actual, &shares);
    for model in [one, other] {
        model.seen = (model.seen + 1).min(64);
        model.learn(symbol);
    }
    symbol
}

#[cfg(test)]
mod tests {
    use striata::mesh::Random;

    use super::super::{RangeReader, RangeWriter};
    use super::*;

    #[test]
    fn symbols_round_trip_near_their_entropy() {
        let mut random = Random::new(21);
        let symbols: Vec<usize> = (0..20_000).map(|_| (random.below(4) + random.below(4)) as usize).collect();
        let weights = [1.0, 2.0, 3.0, 4.0, 3.0, 2.0, 1.0].map(|w: f64| w / 16.0);
        let entropy: f64 = weights.iter().map(|w| -w * w.log2()).sum();
        let mut models = [AdaptiveSymbol::new(); 2];
        let mut writer = RangeWriter::new();
        for &symbol in &symbols {
            let [one, other] = &mut models;
            assert_eq!(code_symbol(&mut writer, one, other, symbol), symbol);
        }
        let (bytes, _) = writer.finish();
        let bits = bytes.len() as f64 * 8.0 / symbols.len() as f64;
        assert!(bits < entropy * 1.03, "{bits} bits for {entropy}");
        let mut models = [AdaptiveSymbol::new(); 2];
        let mut reader = RangeReader::new(&bytes, true);
        for &symbol in &symbols {
            let [one, other] = &mut models;
            assert_eq!(code_symbol(&mut reader, one, other, 0), symbol);
        }
    }

    #[test]
    fn cumulative_shares_stay_sorted() {
        let mut random = Random::new(22);
        let mut model = AdaptiveSymbol::new();
        for round in 0..5000 {
            model.seen = (model.seen + 1).min(64);
            model.learn(if round % 100 < 90 { 15 * (round / 1000 % 2) } else { random.below(16) as usize });
            assert_eq!(model.begins[0], 0);
            assert!(model.begins.windows(2).all(|w| w[0] < w[1]) && model.begins[15] < 65_536);
        }
    }

    #[test]
    fn truncated_messages_overrun() {
        let mut models = [AdaptiveSymbol::new(); 2];
        let mut writer = RangeWriter::new();
        let mut random = Random::new(23);
        let symbols: Vec<usize> = (0..400).map(|_| random.below(16) as usize).collect();
        for &symbol in &symbols {
            let [one, other] = &mut models;
            code_symbol(&mut writer, one, other, symbol);
        }
        let (bytes, _) = writer.finish();
        for length in 0..bytes.len() {
            let mut models = [AdaptiveSymbol::new(); 2];
            let mut reader = RangeReader::new(&bytes[..length], false);
            for &symbol in &symbols {
                let [one, other] = &mut models;
                let found = code_symbol(&mut reader, one, other, 0);
                if reader.overran() {
                    break;
                }
                assert_eq!(found, symbol);
            }
            assert!(reader.overran());
        }
    }
}
