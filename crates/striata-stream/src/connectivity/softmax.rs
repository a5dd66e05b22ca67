//! Softmax: turns scores into probabilities, and codes one of many candidates by these.
//!
//! Scores are natural logarithms in 1/65536. Their exponentials come from a table that is computed at
//! compile time by integer arithmetic.

use crate::entropy::{Coder, ProbabilityMap, log_odds, log2_q8};

/// The score 1.
pub(super) const SCORE_ONE: i32 = 1 << 16;

/// `exp(-1/64)` in 1/2^62.
const DECAY: u128 = 4_540_188_453_729_421_604;
const STEPS: usize = 12 * 64;

/// Exponentials from 0 down to -12 in steps of 1/64, in 1/2^20.
static EXPONENTIALS: [u32; STEPS] = {
    let mut table = [0; STEPS];
    let mut decay: u128 = 1 << 62;
    let mut at = 0;
    while at < STEPS {
        table[at] = ((decay + (1 << 41)) >> 42) as u32;
        decay = (decay * DECAY) >> 62;
        at += 1;
    }
    table
};

/// Returns the exponential of a score that is lower than the best one by `below`, in 1/2^20; never 0.
#[inline]
pub(super) fn exponential(below: i32) -> u32 {
    let at = (below.max(0) >> 10) as usize;
    EXPONENTIALS[at.min(STEPS - 1)]
}

/// Returns the natural logarithm of a sum of exponentials, in 1/256.
#[inline]
pub(super) fn log_sum(sum: u64) -> i32 {
    let spare = (64 - sum.leading_zeros()).saturating_sub(32);
    let log2 = log2_q8((sum >> spare) as u32) + ((spare as i32 - 20) << 8);
    // ln 2 in 1/65536.
    (log2 * 45_426) >> 16
}

/// Number of candidates that are coded one by one, most likely first, before the rest is bisected.
const GUESSES: usize = 3;

/// Codes one of several candidates.
#[derive(Clone, Debug)]
pub(super) struct ChoiceModel {
    probability_map: ProbabilityMap,
}

/// The candidates to choose from.
pub(super) struct Candidates<'a> {
    /// Weight of each candidate, proportional to its probability.
    pub weights: &'a mut [u32],
    /// Sum of the weights.
    pub total: u64,
}

impl ChoiceModel {
    /// Creates an untrained model.
    pub(super) fn new() -> Self {
        Self { probability_map: ProbabilityMap::new(GUESSES * 3) }
    }

    /// Codes the index of a candidate. The weights are modified temporarily and then restored.
    pub(super) fn code<C: Coder>(
        &mut self,
        coder: &mut C,
        Candidates { weights, total }: Candidates<'_>,
        actual: usize,
    ) -> usize {
        let mut left = total;
        let mut tried = [(0, 0); GUESSES];
        let mut count = 0;
        let mut found = None;
        let size = match weights.len() {
            0..10 => 0,
            10..20 => 1,
            _ => 2,
        };
        while count < GUESSES && count + 1 < weights.len() && found.is_none() {
            let (best, weight) = most_likely(weights);
            let p_one = probability(u64::from(weight), left);
            let p_one = self.probability_map.refine(log_odds(p_one), count * 3 + size);
            let is_hit = coder.bit(actual == best, p_one);
            self.probability_map.update(is_hit);
            tried[count] = (best, weight);
            count += 1;
            if is_hit {
                found = Some(best);
            }
            left -= u64::from(weight);
            weights[best] = 0;
        }
        let found = found.unwrap_or_else(|| bisect(coder, weights, left, actual));
        for &(at, weight) in &tried[..count] {
            weights[at] = weight;
        }
        found
    }
}

fn most_likely(weights: &[u32]) -> (usize, u32) {
    let mut best = (0, 0);
    for (at, &weight) in weights.iter().enumerate() {
        if weight > best.1 {
            best = (at, weight);
        }
    }
    best
}

/// Returns the ratio in 1/65536, kept away from 0 and 1.
#[inline]
fn probability(part: u64, whole: u64) -> u32 {
    let probability = (part << 16) / whole.max(1);
    (probability as u32).clamp(32, 65536 - 32)
}

/// Codes an index by bisection; halves without weight are skipped on both sides.
fn bisect<C: Coder>(coder: &mut C, weights: &[u32], total: u64, actual: usize) -> usize {
    let (mut low, mut high, mut left) = (0, weights.len(), total);
    while low + 1 < high {
        let middle = low.midpoint(high);
        let upper: u64 = weights[middle..high].iter().map(|&w| u64::from(w)).sum();
        if upper == 0 || upper == left {
            if upper == 0 {
                high = middle
            } else {
                low = middle
            }
            continue;
        }
        if coder.bit(actual >= middle, probability(upper, left)) {
            low = middle;
            left = upper;
        } else {
            high = middle;
            left -= upper;
        }
    }
    low
}

#[cfg(test)]
mod tests {
    use striata::mesh::Random;

    use super::*;
    use crate::entropy::{RangeReader, RangeWriter};

    #[test]
    fn exponentials_and_logarithms_are_accurate() {
        for below in (0..11 * SCORE_ONE).step_by(997) {
            let expected = (-f64::from(below >> 10) / 64.0).exp() * f64::from(1 << 20);
            assert!((f64::from(exponential(below)) - expected).abs() < 0.6, "{below}");
        }
        assert!(exponential(i32::MAX) > 0 && exponential(-5) == 1 << 20);
        for sum in [1u64, 1 << 20, 3 << 20, 987_654_321, 1 << 40] {
            let expected = (sum as f64 / f64::from(1 << 20)).ln() * 256.0;
            assert!((f64::from(log_sum(sum)) - expected).abs() < 5.0, "{sum}");
        }
    }

    #[test]
    fn choices_round_trip_and_cost_little_more_than_their_information() {
        let mut random = Random::new(5);
        let (mut writer, mut choice) = (RangeWriter::new(), ChoiceModel::new());
        let (mut message, mut information) = (Vec::new(), 0.0);
        for _ in 0..4000 {
            let count = 1 + random.below(30);
            let weights: Vec<u32> = (0..count).map(|_| exponential(random.below(6 << 16) as i32)).collect();
            let total: u64 = weights.iter().map(|&w| u64::from(w)).sum();
            let mut left = u64::from(random.below(total as u32));
            let chosen = weights.iter().position(|&weight| {
                let is_here = left < u64::from(weight);
                left = left.wrapping_sub(weight.into());
                is_here
            });
            let chosen = chosen.unwrap();
            information -= (f64::from(weights[chosen]) / total as f64).log2();
            let mut changing = weights.clone();
            assert_eq!(
                choice.code(&mut writer, Candidates { weights: &mut changing, total }, chosen),
                chosen
            );
            assert_eq!(changing, weights);
            message.push((weights, total, chosen));
        }
        let bytes = writer.finish().0;
        assert!((bytes.len() as f64 * 8.0) < information * 1.01, "{} for {information}", bytes.len() * 8);
        let (mut reader, mut choice) = (RangeReader::new(&bytes, true), ChoiceModel::new());
        for (mut weights, total, chosen) in message {
            assert_eq!(choice.code(&mut reader, Candidates { weights: &mut weights, total }, 0), chosen);
        }
    }
}
