//! Integers under several contexts at once: what each has learned of a decision is mixed.
//!
//! The decisions are those of [`AdaptiveNumber`](crate::entropy::AdaptiveNumber): zero, sign, doubling buckets, two bits below the first. Each context has
//! probabilities of its own, and a mixer weighs them \[Mah05\], so a context that tells nothing costs nothing. Some four
//! times the work of one context.

use super::adaptive::{AdaptiveBit, Rate};
use super::coder::Coder;
use super::logistic::log_odds;
use super::mixer::Mixer;

/// Decisions there are: zero, sign, 31 buckets, 3 for the top bits of each.
const NODES: usize = 2 + 31 + 32 * 3;
const ABOVE: usize = 2;
const TOP: usize = 33;

/// A context of each kind, and the set of weights that they are mixed with.
pub(crate) type Contexts<const N: usize> = ([usize; N], usize);

/// Codes integers of up to 32 bits under `N` contexts.
#[derive(Clone, Debug)]
pub(crate) struct MixedNumber<const N: usize> {
    /// For each of the kinds of contexts, as many as there are, all nodes.
    bits: [Vec<AdaptiveBit>; N],
    mixer: Mixer<N>,
}

impl<const N: usize> MixedNumber<N> {
    /// Nothing learned; so many contexts of each kind, and sets of weights.
    pub(crate) fn new(context_counts: [usize; N], set_count: usize) -> Self {
        let bits = context_counts.map(|count| vec![AdaptiveBit::new(Rate::Steady); count * NODES]);
        Self { bits, mixer: Mixer::new(set_count * NODES, [(1 << 16) * 5 / (4 * N as i32); N]) }
    }

    fn bit<C: Coder>(
        &mut self,
        coder: &mut C,
        (contexts, set): &Contexts<N>,
        node: usize,
        bit: bool,
    ) -> bool {
        let inputs = std::array::from_fn(|i| log_odds(self.bits[i][contexts[i] * NODES + node].p_one()));
        self.mixer.mix(&inputs, set * NODES + node);
        let bit = coder.bit(bit, self.mixer.p_one());
        self.mixer.update(bit);
        for (bits, context) in self.bits.iter_mut().zip(contexts) {
            bits[context * NODES + node].update(bit);
        }
        bit
    }

    /// Codes a number of either sign.
    pub(crate) fn signed<C: Coder>(&mut self, coder: &mut C, contexts: Contexts<N>, value: i32) -> i32 {
        if self.bit(coder, &contexts, 0, value == 0) {
            return 0;
        }
        let is_negative = self.bit(coder, &contexts, 1, value < 0);
        let magnitude = self.magnitude(coder, &contexts, value.unsigned_abs()) as i32;
        if is_negative { magnitude.wrapping_neg() } else { magnitude }
    }

    /// Codes a number above zero.
    fn magnitude<C: Coder>(&mut self, coder: &mut C, contexts: &Contexts<N>, value: u32) -> u32 {
        let meant = value.max(1).ilog2();
        let mut bucket = 0;
        while bucket < 31 && self.bit(coder, contexts, ABOVE + bucket as usize, meant > bucket) {
            bucket += 1;
        }
        let mut decoded = 1;
        let top_count = bucket.min(2);
        for taken in 1..=top_count {
            let node = TOP + 3 * bucket as usize + decoded as usize - 1;
            let bit = self.bit(coder, contexts, node, value >> (bucket - taken) & 1 != 0);
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
}

#[cfg(test)]
mod tests {
    use striata::mesh::Random;

    use super::*;
    use crate::entropy::{AdaptiveNumber, RangeReader, RangeWriter};

    #[test]
    fn numbers_of_all_sizes_come_back() {
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
    fn the_context_that_tells_is_found() {
        let mut random = Random::new(2);
        // The second context says how many bits a number has, the first nothing.
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
