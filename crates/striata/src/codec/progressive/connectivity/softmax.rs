//! Choosing one of many: weights from scores, and the choice as a chain of decisions.
//!
//! Scores are natural logarithms in 1/65536. Their exponentials come from a table that is made by integer arithmetic
//! when the library is compiled.

use super::super::super::entropy::{Coder, Refiner, log_odds, log2_q8};

/// One in scores.
pub(super) const SCORE_ONE: i32 = 1 << 16;

/// `exp(-1/64)` in 1/2^62.
const DECAY: u128 = 4_540_188_453_729_421_604;
const STEPS: usize = 12 * 64;

/// Exponentials of 0 down to -12 in steps of 1/64, in 1/2^20.
static EXPONENTIALS: [u32; STEPS] = {
    let mut table = [0; STEPS];
    let mut decay: u128 = 1 << 62;
    let mut at = 0;
    while at < STEPS {
        table[at] = ((decay + (1 << 41)) >> 42) as u32;
        decay = decay * DECAY >> 62;
        at += 1;
    }
    table
};

/// The exponential of a score below another one by `below`, in 1/2^20; never 0.
#[inline]
pub(super) fn exponential(below: i32) -> u32 {
    let at = (below.max(0) >> 10) as usize;
    EXPONENTIALS[at.min(STEPS - 1)]
}

/// The natural logarithm of a sum of exponentials, in 1/256.
#[inline]
pub(super) fn log_sum(sum: u64) -> i32 {
    let spare = (64 - sum.leading_zeros()).saturating_sub(32);
    let log2 = log2_q8((sum >> spare) as u32) + ((spare as i32 - 20) << 8);
    log2 * 177 >> 8
}

/// How often the likeliest is asked for by itself before the rest is halved.
const GUESSES: usize = 3;

/// Codes which of several was meant.
#[derive(Clone, Debug)]
pub(super) struct Choice {
    refiner: Refiner,
}

impl Choice {
    /// Nothing learned.
    pub(super) fn new() -> Self {
        Self { refiner: Refiner::new(GUESSES * 3) }
    }

    /// Codes an index into `weights`, which add up to `total` and are not changed in the end.
    pub(super) fn code<C: Coder>(
        &mut self,
        coder: &mut C,
        weights: &mut [u32],
        (total, guesses): (u64, usize),
        actual: usize,
    ) -> usize {
        let mut left = total;
        let mut asked = [(0, 0); GUESSES];
        let mut count = 0;
        let mut found = None;
        let size = match weights.len() {
            0..10 => 0,
            10..20 => 1,
            _ => 2,
        };
        while count < guesses.min(GUESSES) && count + 1 < weights.len() && found.is_none() {
            let (best, weight) = likeliest(weights);
            let p_one = share(u64::from(weight), left);
            let p_one = self.refiner.refine(log_odds(p_one), count * 3 + size);
            let is_it = coder.bit(actual == best, p_one);
            self.refiner.update(is_it);
            asked[count] = (best, weight);
            count += 1;
            if is_it {
                found = Some(best);
            }
            left -= u64::from(weight);
            weights[best] = 0;
        }
        let found = found.unwrap_or_else(|| halve(coder, weights, left, actual));
        for &(at, weight) in &asked[..count] {
            weights[at] = weight;
        }
        found
    }
}

fn likeliest(weights: &[u32]) -> (usize, u32) {
    let mut best = (0, 0);
    for (at, &weight) in weights.iter().enumerate() {
        if weight > best.1 {
            best = (at, weight);
        }
    }
    best
}

/// A part of a whole in 1/65536, never quite none or all of it.
#[inline]
fn share(part: u64, whole: u64) -> u32 {
    let share = (part << 16) / whole.max(1);
    (share as u32).clamp(32, 65536 - 32)
}

/// Codes an index into weights by halves; indices of no weight are passed over by a reader as well.
fn halve<C: Coder>(coder: &mut C, weights: &[u32], total: u64, actual: usize) -> usize {
    let (mut low, mut high, mut left) = (0, weights.len(), total);
    while low + 1 < high {
        let middle = low.midpoint(high);
        let upper: u64 = weights[middle..high].iter().map(|&w| u64::from(w)).sum();
        if upper == 0 || upper == left {
            if upper == 0 { high = middle } else { low = middle }
            continue;
        }
        if coder.bit(actual >= middle, share(upper, left)) {
            low = middle;
            left = upper;
        } else {
            high = middle;
            left -= upper;
        }
    }
    low
}
