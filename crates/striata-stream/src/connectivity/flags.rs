//! [`FlagModel`]: codes whether a vertex splits, by mixing the predictions of many small contexts.

use crate::entropy::{AdaptiveBit, Coder, Mixer, ProbabilityMap, Rate, log_odds};

/// Number of inputs of the mixer; the last one is not a context.
const INPUTS: usize = 9;
/// Number of values of each context.
const CONTEXT_SIZE: usize = 1024;
/// Number of weight sets of the mixer, and of contexts of the final refinement.
const WEIGHT_SETS: usize = 32;
const MAP_CONTEXTS: usize = 64;
/// The weight 1 of a mixer.
const WEIGHT_ONE: i32 = 1 << 16;
/// Limit on the magnitude of the additional log-odds.
const LOG_ODDS_LIMIT: i32 = 2047;

/// Data available when a flag is coded.
pub(super) struct FlagContext {
    /// Values of the contexts.
    pub contexts: [usize; INPUTS - 1],
    /// An additional prediction.
    pub log_odds: i32,
    /// Weight set of the mixer, below 32.
    pub weight_set: usize,
    /// Context in which the mixed result is refined, below 64.
    pub map_context: usize,
}

/// Mixes the predictions of the contexts and an additional one.
#[derive(Clone, Debug)]
pub(super) struct FlagModel {
    bits: Vec<AdaptiveBit>,
    mixer: Mixer<INPUTS>,
    probability_map: ProbabilityMap,
}

impl FlagModel {
    /// Creates an untrained model.
    pub(super) fn new() -> Self {
        let mut first = [3 * WEIGHT_ONE / INPUTS as i32; INPUTS];
        first[INPUTS - 1] = 0;
        Self {
            bits: vec![AdaptiveBit::new(Rate::Steady); (INPUTS - 1) * CONTEXT_SIZE],
            mixer: Mixer::new(WEIGHT_SETS, first),
            probability_map: ProbabilityMap::new(MAP_CONTEXTS),
        }
    }

    /// Codes a flag and learns it.
    #[inline]
    pub(super) fn code<C: Coder>(&mut self, coder: &mut C, context: &FlagContext, actual: bool) -> bool {
        let mut inputs = [0; INPUTS];
        let tables = self.bits.chunks_exact(CONTEXT_SIZE);
        for ((input, table), &context) in inputs.iter_mut().zip(tables).zip(&context.contexts) {
            *input = log_odds(table[context].p_one());
        }
        inputs[INPUTS - 1] = context.log_odds.clamp(-LOG_ODDS_LIMIT, LOG_ODDS_LIMIT);
        let mixed = self.mixer.mix(&inputs, context.weight_set);
        let p_one = self.probability_map.refine(mixed, context.map_context);
        let flag = coder.bit(actual, p_one);
        self.mixer.update(flag);
        self.probability_map.update(flag);
        for (table, &context) in self.bits.chunks_exact_mut(CONTEXT_SIZE).zip(&context.contexts) {
            table[context].update(flag);
        }
        flag
    }
}
