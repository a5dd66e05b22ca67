//! Many opinions about one decision, weighted by how well they did.
//!
//! Each opinion is given as log-odds. Their weighted sum is the mixer's own log-odds, and after the decision each
//! weight moves along what would have lowered its cost \[Mah05\]. A small context selects among sets of weights,
//! each of which learns quickly at first. [`Refiner`] then maps what the mixer said to what came of it, for each value of
//! another small context: it takes out what a weighted sum cannot see.

use super::logistic::{LOG_ODDS_LIMIT, LOG_ODDS_ONE, probability};

/// One in weights.
const WEIGHT_ONE: i32 = 1 << 16;
/// Weights stay within this.
const WEIGHT_LIMIT: i32 = 8 * WEIGHT_ONE;
/// Probabilities stay this far from certainty, in 1/65536.
const CAUTION: u32 = 24;
/// How fast a set of weights learns at first, and how fast in the end; a decision moves from the one to the other.
const FIRST_RATE: i32 = 30 * 32;
const LAST_RATE: i32 = 4 * 32;
/// A set's rate falls by one part in 2 to this each time.
const RATE_FALL: u32 = 8;

/// A set of weights.
#[derive(Clone, Copy, Debug)]
struct Weights<const N: usize> {
    weights: [i32; N],
    rate: i32,
}

/// Mixes `N` opinions.
#[derive(Clone, Debug)]
pub(crate) struct Mixer<const N: usize> {
    sets: Vec<Weights<N>>,
    inputs: [i32; N],
    selected: usize,
    p_one: u32,
}

impl<const N: usize> Mixer<N> {
    /// As many sets of weights as contexts, each beginning with `first` (in 1/65536).
    pub(crate) fn new(set_count: usize, first: [i32; N]) -> Self {
        let sets = vec![Weights { weights: first, rate: FIRST_RATE }; set_count.max(1)];
        Self { sets, inputs: [0; N], selected: 0, p_one: 1 << 15 }
    }

    /// The log-odds, in 1/256, of the decision under the weights of a context, and to be told by [`update`](Self::update)
    /// how it went.
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

    /// The probability of what was mixed last, in 1/65536, never quite certain.
    #[inline]
    pub(crate) fn p_one(&self) -> u32 {
        self.p_one.clamp(CAUTION, 65536 - CAUTION)
    }

    /// Learns how the decision mixed last went.
    #[inline]
    pub(crate) fn update(&mut self, bit: bool) {
        let set = &mut self.sets[self.selected];
        let error = (i32::from(bit) << 16) - self.p_one as i32;
        let push = (error * (set.rate >> 5)) >> 4;
        for (weight, &input) in set.weights.iter_mut().zip(&self.inputs) {
            let step = (i64::from(input) * i64::from(push) + (1 << 13)) >> 14;
            *weight = (*weight + step as i32).clamp(-WEIGHT_LIMIT, WEIGHT_LIMIT);
        }
        set.rate -= (set.rate - LAST_RATE + (1 << RATE_FALL) - 1) >> RATE_FALL;
    }
}

const STEPS: usize = 24;
/// Width of a step of log-odds.
const STEP: i32 = LOG_ODDS_ONE / 2;

/// Maps probabilities to what came of them, in small contexts.
#[derive(Clone, Debug)]
pub(crate) struct Refiner {
    /// For each context, the probability at each step of log-odds, in 1/65536.
    steps: Vec<[u16; STEPS + 1]>,
    /// Context and lower step of the last decision, and how far it lay above that step.
    context: usize,
    low: usize,
    above: i32,
}

impl Refiner {
    /// Changes nothing at first.
    pub(crate) fn new(context_count: usize) -> Self {
        let middle = STEPS as i32 / 2;
        let straight = std::array::from_fn(|at| probability((at as i32 - middle) * STEP) as u16);
        Self { steps: vec![straight; context_count.max(1)], context: 0, low: 0, above: 0 }
    }

    /// What log-odds (in 1/256) came to in this context, averaged with what they say: a probability in 1/65536.
    #[inline]
    pub(crate) fn refine(&mut self, log_odds: i32, context: usize) -> u32 {
        let reach = STEPS as i32 / 2 * STEP;
        let place = log_odds.clamp(-reach, reach - 1) + reach;
        self.context = context;
        self.low = (place / STEP) as usize;
        self.above = place % STEP;
        let steps = &self.steps[context];
        let [low, high] = [steps[self.low], steps[self.low + 1]].map(i32::from);
        let refined = (low * (STEP - self.above) + high * self.above) / STEP;
        ((refined as u32 + probability(log_odds)) / 2).clamp(CAUTION, 65536 - CAUTION)
    }

    /// Learns how the decision refined last went.
    #[inline]
    pub(crate) fn update(&mut self, bit: bool) {
        let nearer = self.low + usize::from(self.above >= STEP / 2);
        let step = &mut self.steps[self.context][nearer];
        let target = if bit { 65535 } else { 0 };
        *step = (i32::from(*step) + ((target - i32::from(*step)) >> 6)) as u16;
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
    fn a_mixer_finds_out_whom_to_trust() {
        let mut random = Random::new(8);
        let mut mixer = Mixer::new(2, [WEIGHT_ONE / 3; 3]);
        let (mut spent, mut ideal) = (0.0, 0.0);
        for at in 0..20_000 {
            let p = 3000 + random.below(59_000);
            let bit = random.below(65536) < p;
            // In context 0 the first opinion is right, in context 1 the last says the contrary.
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
    fn a_refiner_mends_what_is_wrong_in_one_context() {
        let mut random = Random::new(8);
        let mut refiner = Refiner::new(2);
        let (mut plain, mut refined) = ([0.0; 2], [0.0; 2]);
        for at in 0..40_000 {
            let p = 2000 + random.below(60_000);
            let context = at % 2;
            // Only in context 1 the opinion is too timid.
            let said = log_odds(p) / (1 + context as i32);
            let bit = random.below(65536) < p;
            plain[context] += cost(probability(said), bit);
            refined[context] += cost(refiner.refine(said, context), bit);
            refiner.update(bit);
        }
        assert!(refined[0] < plain[0] * 1.005, "{refined:?} for {plain:?}");
        assert!(refined[1] < plain[1] * 0.975, "{refined:?} for {plain:?}");
    }

    #[test]
    fn extreme_opinions_stay_in_range() {
        let mut mixer = Mixer::new(1, [WEIGHT_LIMIT; 4]);
        let mut refiner = Refiner::new(1);
        for at in 0..3000 {
            let sign = if at % 3 == 0 { -1 } else { 1 };
            let mixed = mixer.mix(&[LOG_ODDS_LIMIT * sign; 4], 0);
            assert!((1..65536).contains(&mixer.p_one()));
            assert!((1..65536).contains(&refiner.refine(mixed, 0)));
            mixer.update(at % 2 == 0);
            refiner.update(at % 5 == 0);
        }
    }
}
