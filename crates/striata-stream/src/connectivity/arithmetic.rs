//! Integer arithmetic on vectors and scores.
//!
//! Scores are natural logarithms in 1/65536. Their exponentials come from a table that is computed at
//! compile time by integer arithmetic.

use crate::entropy::log2_q8;

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

/// Returns the binary logarithm, in 1/256.
#[inline]
pub(super) fn log2_wide(number: u64) -> i32 {
    let spare = (64 - number.leading_zeros()).saturating_sub(32);
    log2_q8((number >> spare) as u32) + ((spare as i32) << 8)
}

/// 65536 / n, rounded up.
const INVERSES: [i64; 16] = {
    let mut table = [0; 16];
    let mut n = 1;
    while n < 16 {
        table[n] = 65536 / n as i64 + 1;
        n += 1;
    }
    table
};

/// Returns the mean, approximately rounded down; 0 if `count` is 0.
#[inline]
pub(super) fn mean(sum: i64, count: usize) -> i32 {
    match INVERSES.get(count) {
        Some(inverse) => ((sum * inverse) >> 16) as i32,
        None => (sum / count as i64) as i32,
    }
}

#[inline]
pub(super) fn dot(a: [i32; 3], b: [i32; 3]) -> i32 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

#[inline]
pub(super) fn dot_wide(a: [i64; 3], b: [i64; 3]) -> i64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

#[inline]
pub(super) fn cross(a: [i32; 3], b: [i32; 3]) -> [i32; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exponentials_are_accurate() {
        for below in (0..11 * SCORE_ONE).step_by(997) {
            let expected = (-f64::from(below >> 10) / 64.0).exp() * f64::from(1 << 20);
            assert!((f64::from(exponential(below)) - expected).abs() < 0.6, "{below}");
        }
        assert!(exponential(i32::MAX) > 0 && exponential(-5) == 1 << 20);
    }
}
