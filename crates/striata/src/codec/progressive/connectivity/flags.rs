//! Whether a vertex splits: many small contexts, mixed.

use super::super::super::entropy::{AdaptiveBit, Coder, Mixer, Rate, Refiner, log_odds};

/// Contexts below this.
pub(super) const CONTEXT_SIZE: usize = 1024;

/// One in weights of a mixer.
const WEIGHT_ONE: i32 = 1 << 16;

/// Mixes the opinions of the contexts; `N` is their number, and one more for what else there is to say.
#[derive(Clone, Debug)]
pub(super) struct FlagModel<const N: usize> {
    bits: Vec<AdaptiveBit>,
    mixer: Mixer<N>,
    refiner: Refiner,
}

impl<const N: usize> FlagModel<N> {
    pub(super) fn new() -> Self {
        let mut first = [WEIGHT_ONE * 3 / N as i32; N];
        first[N - 1] = 0;
        Self {
            bits: vec![AdaptiveBit::new(Rate::Steady); N * CONTEXT_SIZE],
            mixer: Mixer::new(32, first),
            refiner: Refiner::new(64),
        }
    }

    /// Codes the flag. The last key is no context but log-odds, in 1/256; `selectors` are below 32 and 64.
    #[inline]
    pub(super) fn code<C: Coder>(
        &mut self,
        coder: &mut C,
        keys: &[i32; N],
        selectors: [usize; 2],
        actual: bool,
    ) -> bool {
        let mut inputs = [0; N];
        for (at, &key) in keys[..N - 1].iter().enumerate() {
            inputs[at] = log_odds(self.bits[at * CONTEXT_SIZE + key as usize].p_one());
        }
        inputs[N - 1] = keys[N - 1].clamp(-2047, 2047);
        let mixed = self.mixer.mix(&inputs, selectors[0]);
        let p_one = self.refiner.refine(mixed, selectors[1]);
        let splits = coder.bit(actual, p_one);
        self.mixer.update(splits);
        self.refiner.update(splits);
        for (at, &key) in keys[..N - 1].iter().enumerate() {
            self.bits[at * CONTEXT_SIZE + key as usize].update(splits);
        }
        splits
    }
}
