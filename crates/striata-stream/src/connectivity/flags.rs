//! Whether a vertex splits: many small contexts, mixed.

use crate::entropy::{AdaptiveBit, Coder, Mixer, Rate, Refiner, log_odds};

/// Contexts are below this.
const CONTEXT_SIZE: usize = 1024;
/// Sets of weights, and contexts of what is refined in the end.
const WEIGHT_SETS: usize = 32;
const REFINED_SETS: usize = 64;
/// One in weights of a mixer.
const WEIGHT_ONE: i32 = 1 << 16;
/// Log-odds that are given stay within this.
const LOG_ODDS_REACH: i32 = 2047;

/// What is known when a flag is asked for.
pub(super) struct Question<const N: usize> {
    /// Contexts, the last one unused.
    pub(super) contexts: [usize; N],
    /// What else there is to say, in its place.
    pub(super) log_odds: i32,
    /// Which weights mix the opinions, below 32.
    pub(super) weights: usize,
    /// In which context the result is refined, below 64.
    pub(super) refined: usize,
}

/// Mixes the opinions of `N - 1` contexts and one more.
#[derive(Clone, Debug)]
pub(super) struct FlagModel<const N: usize> {
    bits: Vec<AdaptiveBit>,
    mixer: Mixer<N>,
    refiner: Refiner,
}

impl<const N: usize> FlagModel<N> {
    /// Nothing learned.
    pub(super) fn new() -> Self {
        let mut first = [3 * WEIGHT_ONE / N as i32; N];
        first[N - 1] = 0;
        Self {
            bits: vec![AdaptiveBit::new(Rate::Steady); (N - 1) * CONTEXT_SIZE],
            mixer: Mixer::new(WEIGHT_SETS, first),
            refiner: Refiner::new(REFINED_SETS),
        }
    }

    /// Codes the flag, and learns.
    #[inline]
    pub(super) fn code<C: Coder>(&mut self, coder: &mut C, question: &Question<N>, actual: bool) -> bool {
        let mut inputs = [0; N];
        let tables = self.bits.chunks_exact(CONTEXT_SIZE);
        for ((input, table), &context) in inputs.iter_mut().zip(tables).zip(&question.contexts) {
            *input = log_odds(table[context].p_one());
        }
        inputs[N - 1] = question.log_odds.clamp(-LOG_ODDS_REACH, LOG_ODDS_REACH);
        let mixed = self.mixer.mix(&inputs, question.weights);
        let p_one = self.refiner.refine(mixed, question.refined);
        let flag = coder.bit(actual, p_one);
        self.mixer.update(flag);
        self.refiner.update(flag);
        for (table, &context) in self.bits.chunks_exact_mut(CONTEXT_SIZE).zip(&question.contexts) {
            table[context].update(flag);
        }
        flag
    }
}
