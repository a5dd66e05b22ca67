//! One of sixteen at once: what would take several decisions one after the other takes one division.
//!
//! A model keeps where each symbol's share of the whole begins, and moves these towards the symbol that came. All
//! sixteen move alike, so that a processor does it in a few steps; and the mean of two models is a model.

use super::coder::{Coder, SYMBOLS, Shares};

/// What no symbol's share falls below, of 65536.
const LEAST: i32 = 24;
/// A symbol moves shares by one part in two to this power, at first and later.
const FIRST_SHIFT: u32 = 3;
const LAST_SHIFT: u32 = 6;

/// How often each of sixteen symbols came.
#[derive(Clone, Copy, Debug)]
pub(crate) struct AdaptiveSymbol {
    begins: Shares,
    /// Symbols seen, as far as they still count.
    seen: u32,
}

impl AdaptiveSymbol {
    /// All alike.
    pub(crate) fn new() -> Self {
        Self { begins: std::array::from_fn(|i| (i << 12) as i32), seen: 0 }
    }

    fn learn(&mut self, symbol: usize) {
        let shift = FIRST_SHIFT + self.seen.ilog2().min(LAST_SHIFT - FIRST_SHIFT);
        for (i, begin) in self.begins.iter_mut().enumerate() {
            let least = i as i32 * LEAST;
            let target = if i <= symbol { least } else { 65_536 - (SYMBOLS - i) as i32 * LEAST };
            *begin += (target - *begin) >> shift;
        }
    }
}

/// Codes a symbol by the mean of two models, which learn it.
#[inline]
pub(crate) fn code_symbol<C: Coder>(
    coder: &mut C,
    one: &mut AdaptiveSymbol,
    other: &mut AdaptiveSymbol,
    meant: usize,
) -> usize {
    let shares: Shares = std::array::from_fn(|i| (one.begins[i] + other.begins[i]) >> 1);
    let symbol = coder.symbol(meant, &shares);
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
    fn symbols_come_back_near_their_entropy() {
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
    fn shares_stay_in_order() {
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
    fn a_cut_message_is_noticed() {
        let mut models = [AdaptiveSymbol::new(); 2];
        let mut writer = RangeWriter::new();
        let mut random = Random::new(23);
        let symbols: Vec<usize> = (0..400).map(|_| random.below(16) as usize).collect();
        for &symbol in &symbols {
            let [one, other] = &mut models;
            code_symbol(&mut writer, one, other, symbol);
        }
        let (bytes, _) = writer.finish();
        for cut in 0..bytes.len() {
            let mut models = [AdaptiveSymbol::new(); 2];
            let mut reader = RangeReader::new(&bytes[..cut], false);
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
