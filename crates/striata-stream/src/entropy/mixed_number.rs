//! Adaptive coding of integers by several contexts, whose predictions are mixed.
//!
//! The decisions are those of [`AdaptiveNumber`](crate::entropy::AdaptiveNumber): zero, sign, doubling
//! buckets, two bits below the leading one. Each context has its own probabilities, and a mixer weighs them
//! \[Mah05\], so a context without information costs nothing. Takes about four times as long as a single
//! context.

use super::adaptive::{AdaptiveBit, Rate};
use super::coder::Coder;
use super::logistic::log_odds;
use super::mixer::Mixer;
use super::number::{NODE_COUNT, NodeCoder, code_signed};

/// One context of each kind, and the set of weights to mix them with.
pub(crate) type Contexts<const N: usize> = ([usize; N], usize);

/// Codes integers of up to 32 bits by `N` kinds of contexts.
#[derive(Clone, Debug)]
pub(crate) struct MixedNumber<const N: usize> {
    /// For each kind, the probabilities of all nodes in each of its contexts.
    bits: [Vec<AdaptiveBit>; N],
    mixer: Mixer<N>,
}

impl<const N: usize> MixedNumber<N> {
    /// Creates an untrained model, given the number of contexts of each kind and the number of sets of
    /// weights.
    pub(crate) fn new(context_counts: [usize; N], set_count: usize) -> Self {
        let bits = context_counts.map(|count| vec![AdaptiveBit::new(Rate::Steady); count * NODE_COUNT]);
        Self { bits, mixer: Mixer::new(set_count * NODE_COUNT, [(1 << 16) * 5 / (4 * N as i32); N]) }
    }

    /// Codes a signed integer.
    pub(crate) fn signed<C: Coder>(&mut self, coder: &mut C, contexts: Contexts<N>, value: i32) -> i32 {
        code_signed(coder, &mut MixedNodes { number: self, contexts }, value)
    }
}

/// The decisions of one integer in its contexts.
struct MixedNodes<'a, const N: usize> {
    number: &'a mut MixedNumber<N>,
    contexts: Contexts<N>,
}

impl<const N: usize> NodeCoder for MixedNodes<'_, N> {
    #[inline]
    fn code_node<C: Coder>(&mut self, coder: &mut C, node: usize, bit: bool) -> bool {
        let MixedNumber { bits, mixer } = &mut *self.number;
        let (contexts, set) = &self.contexts;
        let inputs = std::array::from_fn(|i| log_odds(bits[i][contexts[i] * NODE_COUNT + node].p_one()));
        mixer.mix(&inputs, set * NODE_COUNT + node);
        let bit = coder.bit(bit, mixer.p_one());
        mixer.update(bit);
        for (bits, context) in bits.iter_mut().zip(contexts) {
            bits[context * NODE_COUNT + node].update(bit);
        }
        bit
    }
}

#[cfg(test)]
mod tests {
    use striata::mesh::Random;

    use super::*;
    use crate::entropy::{AdaptiveNumber, RangeReader, RangeWriter};

    #[test]
    fn integers_of_all_sizes_round_trip() {
        let mut random = Random::new(11);
        let mut numbers = vec![0, 1, -1, 2, -2, 3, 4, 7, 8, i32::MAX, i32::MIN, i32::MIN + 1, i32::MAX - 1];
        numbers.extend((0..4000).map(|_| (random.next_u64() as i32) >> random.below(32)));
        let mut writer = RangeWriter::new();
        let mut model = MixedNumber::new([1, 2, 3], 2);
        for (at, &number) in numbers.iter().enumerate() {
            assert_eq!(model.signed(&mut writer, ([0, at % 2, at % 3], at % 2), number), number);
        }
        let (bytes, _) = writer.finish();
        let mut reader = RangeReader::new(&bytes, true);
        let mut model = MixedNumber::new([1, 2, 3], 2);
        for (at, &number) in numbers.iter().enumerate() {
            assert_eq!(model.signed(&mut reader, ([0, at % 2, at % 3], at % 2), 0), number);
        }
    }

    #[test]
    fn mixer_finds_the_informative_context() {
        let mut random = Random::new(2);
        // The second context gives the number of bits; the first carries no information.
        let numbers: Vec<(usize, i32)> = (0..20_000)
            .map(|_| {
                let bits = random.below(8);
                (bits as usize, random.below(2 << bits) as i32 - (1 << bits))
            })
            .collect();
        let entropy: f64 = numbers.iter().map(|&(bits, _)| bits as f64 + 1.0).sum();
        let mut writer = RangeWriter::new();
        let mut model = MixedNumber::new([1, 8], 1);
        numbers.iter().for_each(|&(bits, number)| {
            assert_eq!(model.signed(&mut writer, ([0, bits], 0), number), number)
        });
        let mixed = writer.finish().0.len() as f64 * 8.0;
        let mut writer = RangeWriter::new();
        let mut model = AdaptiveNumber::new(1, Rate::Steady);
        numbers.iter().for_each(|&(_, number)| assert_eq!(model.signed(&mut writer, 0, number), number));
        let alone = writer.finish().0.len() as f64 * 8.0;
        assert!(
            mixed < 1.06 * entropy && mixed < 0.85 * alone,
            "{mixed} bits for {entropy}, {alone} without context"
        );
    }
}
