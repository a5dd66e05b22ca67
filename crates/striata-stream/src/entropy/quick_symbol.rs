//! One of sixteen at once, in 16-bit lanes.
//!
//! [`super::AdaptiveSymbol`] for the second version of streams: shares have 15 bits, so that all sixteen fit two vectors, and an
//! even share is mixed in when a symbol is coded, so that what is learned needs no floor of its own.

use wide::i16x8;

use super::coder::{Coder, QuickShares, SYMBOLS};

/// Logarithm of the part of the whole that is shared evenly: no symbol's share falls below a sixteenth of it.
const EVEN_LOG: u32 = 7;
/// A symbol moves shares by one part in two to this power at first.
const FIRST_SHIFT: u32 = 2;

/// How often each of sixteen symbols came.
#[derive(Clone, Copy, Debug)]
pub(crate) struct QuickSymbol {
    begins: [i16x8; 2],
    /// Symbols seen, as far as they still count.
    seen: u16,
}

/// Where shares begin after so many symbols like the one at the index.
static GOALS: [[i16; SYMBOLS]; SYMBOLS] = {
    let mut goals = [[0; SYMBOLS]; SYMBOLS];
    let mut symbol = 0;
    while symbol < SYMBOLS {
        let mut at = symbol + 1;
        while at < SYMBOLS {
            goals[symbol][at] = i16::MAX;
            at += 1;
        }
        symbol += 1;
    }
    goals
};

/// The beginnings of shares when all are the same, of 2 to the power of 15 less [`EVEN_LOG`].
const EVEN: [i16; SYMBOLS] = {
    let mut even = [0; SYMBOLS];
    let mut at = 0;
    while at < SYMBOLS {
        even[at] = (at << (11 - EVEN_LOG)) as i16;
        at += 1;
    }
    even
};

fn halves(all: &[i16; SYMBOLS]) -> [i16x8; 2] {
    let (low, high) = all.split_at(8);
    [low, high].map(i16x8::from_slice_unaligned)
}

impl QuickSymbol {
    /// The first `count` symbols alike, others hardly.
    pub(crate) fn new(count: usize) -> Self {
        let begins: QuickShares = std::array::from_fn(|i| ((i << 15) / count.max(1)).min(32_767) as i16);
        Self { begins: halves(&begins), seen: 0 }
    }

    #[inline]
    fn learn(&mut self, symbol: usize, last_shift: u32) {
        let shift = (FIRST_SHIFT + (u32::from(self.seen >> 2) + 1).ilog2()).min(last_shift);
        self.seen = (self.seen + 1).min(1 << 10);
        for (begins, goal) in self.begins.iter_mut().zip(halves(&GOALS[symbol & 15])) {
            *begins += (goal - *begins) >> shift;
        }
    }

    /// Codes a symbol, and learns it, in the end by one part in two to this power.
    #[inline]
    pub(crate) fn code<C: Coder>(&mut self, coder: &mut C, meant: usize, last_shift: u32) -> usize {
        let symbol = coder.quick_symbol(meant, &shares_of(self.begins));
        self.learn(symbol, last_shift);
        symbol
    }
}

#[inline]
fn shares_of(begins: [i16x8; 2]) -> QuickShares {
    let mut shares = [0; SYMBOLS];
    for ((shares, begins), even) in shares.chunks_exact_mut(8).zip(begins).zip(halves(&EVEN)) {
        let mixed = begins - (begins >> EVEN_LOG) + even;
        shares.copy_from_slice(mixed.as_array());
    }
    shares
}

/// Codes a symbol by where shares begin as a model has them: an even share is mixed in.
#[inline]
pub(crate) fn code_shares<C: Coder>(coder: &mut C, meant: usize, begins: &QuickShares) -> usize {
    coder.quick_symbol(meant, &shares_of(halves(begins)))
}

/// Codes a symbol by the mean of two models, which learn it.
#[inline]
pub(crate) fn code_by_two<C: Coder>(
    coder: &mut C,
    models: [&mut QuickSymbol; 2],
    meant: usize,
    last_shift: u32,
) -> usize {
    let begins = [0, 1].map(|half| (models[0].begins[half] >> 1u32) + (models[1].begins[half] >> 1u32));
    let symbol = coder.quick_symbol(meant, &shares_of(begins));
    models.into_iter().for_each(|model| model.learn(symbol, last_shift));
    symbol
}

/// The last symbol whose share begins at a place or before it.
#[inline]
pub(super) fn symbol_at(shares: &QuickShares, place: i16) -> usize {
    let [low, high] = halves(shares).map(|begins| begins.simd_gt(i16x8::splat(place)).to_bitmask());
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

    fn models() -> [QuickSymbol; 2] {
        [QuickSymbol::new(16), QuickSymbol::new(7)]
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
    fn symbols_come_back_near_their_entropy() {
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
    fn shares_stay_in_order() {
        let mut random = Random::new(22);
        let mut model = QuickSymbol::new(3);
        for round in 0..5000 {
            model
                .learn(if round % 100 < 90 { 15 * (round / 1000 % 2) } else { random.below(16) as usize }, 5);
            let shares = shares_of(model.begins);
            assert!(shares[0] == 0 && shares.windows(2).all(|w| w[0] < w[1]), "{shares:?}");
            for place in [0, 1, shares[7] - 1, shares[7], i16::MAX] {
                let expected = shares.iter().rposition(|&begin| begin <= place);
                assert_eq!(Some(symbol_at(&shares, place)), expected);
            }
        }
    }

    #[test]
    fn a_cut_message_is_noticed() {
        let symbols = triangular(400, 23);
        let bytes = write(&symbols);
        for cut in 0..bytes.len() {
            let (mut reader, mut models) = (RangeReader::new(&bytes[..cut], false), models());
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
