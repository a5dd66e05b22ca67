//! A weighted mean of means, its weights learned from what came.

use super::guesses::{ACROSS, INSIDE, KINDS, STRAIGHT};

/// What is blended: kinds of guesses, and two more.
pub(super) const FEATURES: usize = KINDS + 2;
/// The vertex that split.
pub(super) const KEPT: usize = KINDS;
/// The mean of its neighbours in the ring.
pub(super) const BESIDE: usize = KINDS + 1;

/// Weights in 1/65536 at first.
const FIRST: i32 = 10_000;
/// How much of an error the weights take in, in 1/65536.
const RATE: i64 = 300;
/// What is added to the squares of the features.
const CALM: i64 = 40_000;

/// Weights of the features.
#[derive(Clone, Copy, Debug)]
pub(super) struct Blend {
    weights: [i32; FEATURES],
}

/// What is blended: how far each kind's mean lies from the middle of the ring; in the place of the
/// middles that of all guesses.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Features {
    /// The middle of the ring.
    pub(super) base: i32,
    /// How far others lie from there.
    pub(super) off: [i32; FEATURES],
}

impl Features {
    /// How much they disagree.
    pub(super) fn spread(&self) -> u32 {
        [INSIDE, ACROSS, STRAIGHT].iter().map(|&kind| self.off[kind].unsigned_abs()).sum()
    }
}

impl Blend {
    pub(super) fn new() -> Self {
        Self { weights: [FIRST; FEATURES] }
    }

    /// Where the features point to.
    pub(super) fn predict(&self, features: &Features) -> i32 {
        let sum: i64 = self.weights.iter().zip(features.off).map(|(&w, x)| i64::from(w) * i64::from(x)).sum();
        features.base + (sum >> 16) as i32
    }

    /// Learns how far off the prediction was: normalised least mean squares.
    pub(super) fn learn(&mut self, features: &Features, error: i32) {
        let power = features.off.iter().map(|&x| i64::from(x) * i64::from(x)).sum::<i64>() + CALM;
        let pull = (i64::from(error) * (RATE << 12)) / power;
        for (weight, x) in self.weights.iter_mut().zip(features.off) {
            let step = (i64::from(x) * pull) >> 12;
            *weight = (i64::from(*weight) + step).clamp(-1 << 18, 1 << 18) as i32;
        }
    }
}
