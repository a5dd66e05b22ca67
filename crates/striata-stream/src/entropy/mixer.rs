//! Logistic mixing: combines several predictions of one decision, weighted by how good they have been.
//!
//! Each prediction is given as log-odds. Their weighted sum is the log-odds of the mixed prediction; after
//! the decision, each weight moves along the gradient that lowers its coding cost \[Mah05\]. A small
//! context selects among sets of weights, each of which learns quickly at first.

use super::logistic::{LOG_ODDS_LIMIT, probability};

/// The weight 1.
const WEIGHT_ONE: i32 = 1 << 16;
/// Limit on the magnitude of weights.
const WEIGHT_LIMIT: i32 = 8 * WEIGHT_ONE;
/// Minimum distance of mixed probabilities from 0 and 1, in 1/65536.
const MIN_PROBABILITY: u32 = 24;
/// Initial and final learning rate of a set of weights.
const FIRST_RATE: i32 = 30 * 32;
const LAST_RATE: i32 = 4 * 32;
/// With each update, the learning rate covers 1 / 2^`RATE_DECAY_SHIFT` of the distance to its final value.
const RATE_DECAY_SHIFT: u32 = 8;

/// A set of weights and its learning rate.
#[derive(Clone, Copy, Debug)]
struct MixerWeights<const N: usize> {
    weights: [i32; N],
    rate: i32,
}

/// Mixes `N` predictions.
#[derive(Clone, Debug)]
pub(crate) struct Mixer<const N: usize> {
    sets: Vec<MixerWeights<N>>,
    inputs: [i32; N],
    selected: usize,
    p_one: u32,
}

impl<const N: usize> Mixer<N> {
    /// Creates `set_count` sets of weights, all starting at `first` (in 1/65536).
    pub(crate) fn new(set_count: usize, first: [i32; N]) -> Self {
        let sets = vec![MixerWeights { weights: first, rate: FIRST_RATE }; set_count.max(1)];
        Self { sets, inputs: [0; N], selected: 0, p_one: 1 << 15 }
    }

    /// Mixes predictions with the weights of a context; returns the log-odds of the decision, in 1/256.
    /// Pass the outcome to [`update`](Self::update).
    #[inline]
    pub(crate) fn mix(&mut self, inputs: &[i32; N], context: usize) -> i32 {
        debug_assert!(context < self.sets.len(), "context {context} of {}", self.sets.len());
        self.selected = context;
        self.inputs = *inputs;
        let weights = &self.sets[context].weights;
        let sum: i64 =
            weights.iter().zip(inputs).map(|(&weight, &input)| i64::from(weight) * i64::from(input)).sum();
        let log_odds = (sum >> 16).clamp(-i64::from(LOG_ODDS_LIMIT), i64::from(LOG_ODDS_LIMIT)) as i32;
        self.p_one = probability(log_odds);
        log_odds
    }

    /// Returns the probability mixed last, in 1/65536; never 0 or 1.
    #[inline]
    pub(crate) fn p_one(&self) -> u32 {
        self.p_one.clamp(MIN_PROBABILITY, 65536 - MIN_PROBABILITY)
    }

    /// Learns the outcome of the decision mixed last.
    #[inline]
    pub(crate) fn update(&mut self, bit: bool) {
        let set = &mut self.sets[self.selected];
        let error = (i32::from(bit) << 16) - self.p_one as i32;
        let push = (error * (set.rate >> 5)) >> 4;
        for (weight, &input) in set.weights.iter_mut().zip(&self.inputs) {
            let step = (i64::from(input) * i64::from(push) + (1 << 13)) >> 14;
            *weight = (*weight + step as i32).clamp(-WEIGHT_LIMIT, WEIGHT_LIMIT);
        }
        set.rate -= (set.rate - LAST_RATE + (1 << RATE_DECAY_SHIFT) - 1) >> RATE_DECAY_SHIFT;
    }
}

#[cfg(test)]
mod tests {
    use striata::mesh::Random;

    use super::super::logistic::log_odds;
    use super::*;

    fn cost(p_one: u32, bit: bool) -> f64 {
        -(f64::from(if bit { p_one } else { 65536 - p_one }) / 65536.0).log2()
    }

    #[test]
    fn mixer_learns_which_input_to_trust() {
        let mut random = Random::new(8);
        let mut mixer = Mixer::new(2, [WEIGHT_ONE / 3; 3]);
        let (mut spent, mut ideal) = (0.0, 0.0);
        for at in 0..20_000 {
            let p = 3000 + random.below(59_000);
            let bit = random.below(65536) < p;
            // In context 0 the first input is right; in context 1 the last one is exactly wrong.
            let context = at % 2;
            let noise = random.below(1000) as i32 - 500;
            let inputs = if context == 0 { [log_odds(p), noise, 256] } else { [noise, 256, -log_odds(p)] };
            mixer.mix(&inputs, context);
            if at >= 2000 {
                spent += cost(mixer.p_one(), bit);
                ideal += cost(p, bit);
            }
            mixer.update(bit);
        }
        assert!(spent < ideal * 1.01, "{spent} bits for {ideal}");
    }

    #[test]
    fn extreme_inputs_stay_in_range() {
        let mut mixer = Mixer::new(1, [WEIGHT_LIMIT; 4]);
        for at in 0..3000 {
            let sign = if at % 3 == 0 { -1 } else { 1 };
            mixer.mix(&[LOG_ODDS_LIMIT * sign; 4], 0);
            assert!((1..65536).contains(&mixer.p_one()));
            mixer.update(at % 2 == 0);
        }
    }
}
