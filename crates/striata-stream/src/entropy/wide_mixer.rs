//! [`WideMixer`]: a mixer in 16-bit SIMD lanes, for models with many inputs.
//!
//! Works like [`super::Mixer`], but weights and inputs are 16-bit integers, eight per vector, so that a
//! decision takes a few instructions per eight inputs. The coarser weights have no measurable cost.

use wide::i16x8;

use super::logistic::{LOG_ODDS_LIMIT, probability};

/// Initial and final learning rate of a set of weights.
const FIRST_RATE: i32 = 30 << 8;
const LAST_RATE: i32 = 4 << 8;
/// With each update, the learning rate covers 1 / 2^`RATE_DECAY_SHIFT` of the distance to its final value.
const RATE_DECAY_SHIFT: u32 = 8;

#[derive(Clone, Copy, Debug)]
struct WideWeights<const VECTORS: usize> {
    weights: [i16x8; VECTORS],
    rate: i32,
}

/// Mixes `VECTORS` times eight predictions.
#[derive(Clone, Debug)]
pub(crate) struct WideMixer<const VECTORS: usize> {
    sets: Vec<WideWeights<VECTORS>>,
    selected: usize,
    p_one: i32,
}

impl<const VECTORS: usize> WideMixer<VECTORS> {
    /// Creates `set_count` sets of weights, all starting at `first` (in 1/16384).
    pub(crate) fn new(set_count: usize, first: [[i16; 8]; VECTORS]) -> Self {
        let weights = first.map(i16x8::new);
        Self {
            sets: vec![WideWeights { weights, rate: FIRST_RATE }; set_count.max(1)],
            selected: 0,
            p_one: 1 << 15,
        }
    }

    /// Mixes predictions with the weights of a context; returns the log-odds of the decision, in 1/256.
    /// Pass the outcome to [`update`](Self::update).
    #[inline]
    pub(crate) fn mix(&mut self, inputs: &[[i16; 8]; VECTORS], context: usize) -> i32 {
        debug_assert!(context < self.sets.len(), "context {context} of {}", self.sets.len());
        self.selected = context;
        let mut sum = 0;
        for (weights, inputs) in self.sets[context].weights.iter().zip(inputs) {
            // Each product has at most 27 bits and a sign.
            sum += weights.dot(i16x8::new(*inputs)).to_array().iter().sum::<i32>() >> 2;
        }
        let log_odds = (sum >> 12).clamp(-LOG_ODDS_LIMIT, LOG_ODDS_LIMIT);
        self.p_one = probability(log_odds) as i32;
        log_odds
    }

    /// Learns the outcome of the decision mixed last; `inputs` are the ones that were mixed.
    #[inline]
    pub(crate) fn update(&mut self, inputs: &[[i16; 8]; VECTORS], bit: bool) {
        let set = &mut self.sets[self.selected];
        let error = (i32::from(bit) << 16) - self.p_one;
        // The high half of the product is taken with one extra bit, so that the result can be rounded.
        let push = ((error * (set.rate >> 8)) >> 6).clamp(-0x7FFF, 0x7FFF) as i16;
        for (weights, inputs) in set.weights.iter_mut().zip(inputs) {
            let input: i16x8 = i16x8::new(*inputs) << 3u32;
            let step = input.mul_keep_high(i16x8::splat(push));
            *weights = weights.saturating_add((step + i16x8::splat(1)) >> 1u32);
        }
        set.rate -= (set.rate - LAST_RATE + (1 << RATE_DECAY_SHIFT) - 1) >> RATE_DECAY_SHIFT;
    }
}

#[cfg(test)]
mod tests {
    use striata::mesh::Random;

    use super::super::logistic::log_odds;
    use super::*;

    fn cost(p_one: i32, bit: bool) -> f64 {
        -(f64::from(if bit { p_one } else { 65536 - p_one }) / 65536.0).log2()
    }

    #[test]
    fn mixer_learns_which_input_to_trust() {
        let mut random = Random::new(8);
        let mut mixer = WideMixer::new(2, [[2000; 8]; 2]);
        let (mut spent, mut ideal) = (0.0, 0.0);
        for at in 0..20_000 {
            let p = 3000 + random.below(59_000);
            let bit = random.below(65536) < p;
            // In context 0 an input of the first vector is right; in context 1 one of the last vector is
            // exactly wrong.
            let context = at % 2;
            let mut inputs = [[0; 8]; 2].map(|lanes| lanes.map(|_: i16| random.below(1000) as i16 - 500));
            if context == 0 {
                inputs[0][3] = log_odds(p) as i16;
            } else {
                inputs[1][7] = -log_odds(p) as i16;
            }
            mixer.mix(&inputs, context);
            if at >= 4000 {
                spent += cost(mixer.p_one, bit);
                ideal += cost(p as i32, bit);
            }
            mixer.update(&inputs, bit);
        }
        assert!(spent < ideal * 1.05, "{spent} bits for {ideal}");
    }

    #[test]
    fn extreme_inputs_stay_in_range() {
        let mut mixer = WideMixer::new(1, [[0x7FFF; 8]; 3]);
        for at in 0..3000 {
            let sign = if at % 3 == 0 { -1 } else { 1 };
            let inputs = [[LOG_ODDS_LIMIT as i16 * sign; 8]; 3];
            let mixed = mixer.mix(&inputs, 0);
            assert!((-LOG_ODDS_LIMIT..=LOG_ODDS_LIMIT).contains(&mixed));
            mixer.update(&inputs, at % 2 == 0);
        }
    }
}
