//! Adaptive coding of one of sixteen symbols with a single division, instead of several binary decisions.
//!
//! A model stores cumulative shares and moves them toward the coded symbol. They have 15 bits, so that all
//! sixteen fit into two vectors of 16-bit lanes, and are updated by the same operation. The mean of two
//! models is again a valid model. A uniform share is mixed in when a symbol is coded, so that the learned
//! shares need no lower bound.

use wide::i16x8;

use super::coder::{Coder, SYMBOLS, Shares};

/// Negative binary logarithm of the weight of the uniform share; each symbol gets at least a sixteenth of it.
const UNIFORM_SHIFT: u32 = 7;
/// Negative binary logarithm of the rate at which shares move toward the coded symbol at first.
const FIRST_SHIFT: u32 = 2;

/// Adaptive frequencies of sixteen symbols.
#[derive(Clone, Copy, Debug)]
pub struct AdaptiveSymbol {
    begins: [i16x8; 2],
    /// Number of symbols learned, up to a limit.
    seen: u16,
}

/// For each symbol, the cumulative shares if it were certain.
static CERTAIN: [[i16; SYMBOLS]; SYMBOLS] = {
    let mut certain = [[0; SYMBOLS]; SYMBOLS];
    let mut symbol = 0;
    while symbol < SYMBOLS {
        let mut at = symbol + 1;
        while at < SYMBOLS {
            certain[symbol][at] = i16::MAX;
            at += 1;
        }
        symbol += 1;
    }
    certain
};

/// Cumulative uniform shares, scaled by the weight of [`UNIFORM_SHIFT`].
const UNIFORM: [i16; SYMBOLS] = {
    let mut uniform = [0; SYMBOLS];
    let mut at = 0;
    while at < SYMBOLS {
        uniform[at] = (at << (11 - UNIFORM_SHIFT)) as i16;
        at += 1;
    }
    uniform
};

#[inline]
fn halves(all: &[i16; SYMBOLS]) -> [i16x8; 2] {
    let (low, high) = all.split_at(8);
    [low, high].map(i16x8::from_slice_unaligned)
}

impl AdaptiveSymbol {
    /// Creates an untrained model in which the first `count` symbols are equally likely and the others
    /// nearly impossible.
    pub fn new(count: usize) -> Self {
        let begins: Shares = std::array::from_fn(|i| ((i << 15) / count.max(1)).min(32_767) as i16);
        Self { begins: halves(&begins), seen: 0 }
    }

    #[inline]
    fn learn(&mut self, symbol: usize, last_shift: u32) {
        let shift = (FIRST_SHIFT + (u32::from(self.seen >> 2) + 1).ilog2()).min(last_shift);
        self.seen = (self.seen + 1).min(1 << 10);
        for (begins, certain) in self.begins.iter_mut().zip(halves(&CERTAIN[symbol & 15])) {
            *begins += (certain - *begins) >> shift;
        }
    }

    /// Codes a symbol and learns it; `last_shift` is the final learning rate, as a negative power of two.
    #[inline]
    pub fn code<C: Coder>(&mut self, coder: &mut C, actual: usize, last_shift: u32) -> usize {
        let symbol = coder.symbol(actual, &with_uniform_share(self.begins));
        self.learn(symbol, last_shift);
        symbol
    }
}

#[inline]
fn with_uniform_share(begins: [i16x8; 2]) -> Shares {
    let mut shares = [0; SYMBOLS];
    for ((shares, begins), uniform) in shares.chunks_exact_mut(8).zip(begins).zip(halves(&UNIFORM)) {
        let mixed = begins - (begins >> UNIFORM_SHIFT) + uniform;
        shares.copy_from_slice(mixed.as_array());
    }
    shares
}

/// Codes a symbol by cumulative shares of the caller, mixed with the uniform share.
#[inline]
pub(crate) fn code_shares<C: Coder>(coder: &mut C, actual: usize, begins: &Shares) -> usize {
    coder.symbol(actual, &with_uniform_share(halves(begins)))
}

/// Codes a symbol by the mean of two models, and updates both.
#[inline]
pub(crate) fn code_by_two<C: Coder>(
    coder: &mut C,
    models: [&mut AdaptiveSymbol; 2],
    actual: usize,
    last_shift: u32,
) -> usize {
    let begins = [0, 1].map(|half| (models[0].begins[half] >> 1u32) + (models[1].begins[half] >> 1u32));
    let symbol = coder.symbol(actual, &with_uniform_share(begins));
    models.into_iter().for_each(|model| model.learn(symbol, last_shift));
    symbol
}

/// Returns the last symbol whose cumulative share is at most `value`.
#[inline]
pub(super) fn symbol_at(shares: &Shares, value: i16) -> usize {
    let [low, high] = halves(shares).map(|begins| begins.simd_gt(i16x8::splat(value)).to_bitmask());
    let above = low | high << 8 | 1 << SYMBOLS;
    (above.trailing_zeros() as usize).saturating_sub(1)
}

#[cfg(test)]
mod tests {
    use striata::mesh::Random;

    use super::super::{RangeReader, RangeWriter};
    use super::*;

    fn triangular(count: usize, seed: u64) -> Vec<usize> {
        let mut random = Random::new(seed);
        (0..count).map(|_| (random.below(4) + random.below(4)) as usize).collect()
    }

    fn models() -> [AdaptiveSymbol; 2] {
        [AdaptiveSymbol::new(16), AdaptiveSymbol::new(7)]
    }

    fn write(symbols: &[usize]) -> Vec<u8> {
        let (mut writer, mut models) = (RangeWriter::new(), models());
        for &symbol in symbols {
            let [one, other] = &mut models;
            assert_eq!(code_by_two(&mut writer, [one, other], symbol, 7), symbol);
        }
        writer.finish().0
    }

    #[test]
    fn symbols_round_trip_near_their_entropy() {
        let symbols = triangular(20_000, 21);
        let weights = [1.0, 2.0, 3.0, 4.0, 3.0, 2.0, 1.0].map(|w: f64| w / 16.0);
        let entropy: f64 = weights.iter().map(|w| -w * w.log2()).sum();
        let bytes = write(&symbols);
        let bits = bytes.len() as f64 * 8.0 / symbols.len() as f64;
        assert!(bits < entropy * 1.03, "{bits} bits for {entropy}");
        let (mut reader, mut models) = (RangeReader::new(&bytes, true), models());
        for symbol in symbols {
            let [one, other] = &mut models;
            assert_eq!(code_by_two(&mut reader, [one, other], 0, 7), symbol);
        }
    }

    #[test]
    fn cumulative_shares_stay_sorted() {
        let mut random = Random::new(22);
        let mut model = AdaptiveSymbol::new(3);
        for round in 0..5000 {
            model
                .learn(if round % 100 < 90 { 15 * (round / 1000 % 2) } else { random.below(16) as usize }, 5);
            let shares = with_uniform_share(model.begins);
            assert!(shares[0] == 0 && shares.windows(2).all(|w| w[0] < w[1]), "{shares:?}");
            for value in [0, 1, shares[7] - 1, shares[7], i16::MAX] {
                let expected = shares.iter().rposition(|&begin| begin <= value);
                assert_eq!(Some(symbol_at(&shares, value)), expected);
            }
        }
    }

    #[test]
    fn truncated_messages_overrun() {
        let symbols = triangular(400, 23);
        let bytes = write(&symbols);
        for length in 0..bytes.len() {
            let (mut reader, mut models) = (RangeReader::new(&bytes[..length], false), models());
            for &symbol in &symbols {
                let [one, other] = &mut models;
                let found = code_by_two(&mut reader, [one, other], 0, 7);
                if reader.overran() {
                    break;
                }
                assert_eq!(found, symbol);
            }
            assert!(reader.overran());
        }
    }
}
