//! Whether a vertex splits: many small contexts, mixed.

use super::super::super::entropy::{AdaptiveBit, Coder, Mixer, Rate, Refiner, log_odds};

/// Contexts that are asked.
pub(super) const CONTEXTS: usize = 10;
const SIZE: usize = 1024;

/// The model.
#[derive(Clone, Debug)]
pub(super) struct FlagModel {
    bits: Vec<AdaptiveBit>,
    mixer: Mixer<{ CONTEXTS + 2 }>,
    refiner: Refiner,
}

impl FlagModel {
    pub(super) fn new() -> Self {
        let mut first = [65536 * 3 / 10; CONTEXTS + 2];
        first[CONTEXTS] = 0;
        first[CONTEXTS + 1] = 0;
        Self {
            bits: vec![AdaptiveBit::new(Rate::Steady); CONTEXTS * SIZE],
            mixer: Mixer::new(32, first),
            refiner: Refiner::new(64),
        }
    }

    /// Codes the flag.
    pub(super) fn code<C: Coder>(
        &mut self,
        coder: &mut C,
        keys: &[usize; CONTEXTS],
        log_sum: i32,
        selectors: [usize; 2],
        actual: bool,
    ) -> bool {
        let mut inputs = [0; CONTEXTS + 2];
        for (at, &key) in keys.iter().enumerate() {
            debug_assert!(key < SIZE, "context {at}: {key}");
            inputs[at] = log_odds(self.bits[at * SIZE + key].p_one());
        }
        inputs[CONTEXTS] = log_sum.clamp(-2047, 2047);
        inputs[CONTEXTS + 1] = 256;
        let mixed = self.mixer.mix(&inputs, selectors[0]);
        let p_one = self.refiner.refine(mixed, selectors[1]);
        let splits = coder.bit(actual, p_one);
        self.mixer.update(splits);
        self.refiner.update(splits);
        for (at, &key) in keys.iter().enumerate() {
            self.bits[at * SIZE + key].update(splits);
        }
        splits
    }
}
