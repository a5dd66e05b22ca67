//! Times models against each other, fairly on a machine that does other things too.
//!
//! In each round every model does all there is to time, one model after the other, each round beginning with another
//! one; nothing else runs meanwhile. Of all rounds the quickest counts, for each frame and each jump apart. Where a full
//! sweep would take too long, stretches of it spread evenly over all levels stand for the whole.

use std::ops::Range;
use std::time::Instant;

use striata::mesh::Random;

use super::contenders::{Contender, Entry};
use super::walks::{Pace, Walk, mean};

/// Rounds, where time allows.
const ROUND_COUNT: usize = 5;

/// Seconds after which no further round begins.
const CONTEST_SECS: f64 = 10.0;

/// Jumps between random levels.
const JUMP_COUNT: usize = 64;

/// Seed of those levels.
const JUMP_SEED: u64 = 1;

/// Seconds that one model may sweep in one round.
const SWEEP_SECS: f64 = 0.4;

/// Stretches that stand for a sweep that would take longer.
const STRETCH_COUNT: usize = 32;

/// A model and what it has been timed at.
pub(super) struct Contestant {
    /// Which model it is.
    pub(super) entry: &'static Entry,
    /// The model.
    pub(super) contender: Box<dyn Contender>,
    stretches: Vec<Range<usize>>,
    sweep_secs: f64,
    jump_secs: Vec<f64>,
    walks: Vec<Walk>,
}

impl Contestant {
    /// A model that has not been timed yet.
    pub(super) fn new(
        entry: &'static Entry,
        mut contender: Box<dyn Contender>,
        step_count: usize,
        frames: usize,
    ) -> Self {
        let stretches =
            if entry.has_few_levels { Vec::new() } else { stretches_for(&mut *contender, step_count) };
        let mut walks = Pace::ALL.map(|pace| Walk::new(pace, step_count, frames)).to_vec();
        walks.iter_mut().for_each(|walk| walk.look(&mut *contender));
        let jump_secs = vec![f64::INFINITY; JUMP_COUNT];
        Self { entry, contender, stretches, sweep_secs: f64::INFINITY, jump_secs, walks }
    }

    fn go(&mut self, jumps: &[usize], buffer: &mut Vec<u32>) {
        let contender = &mut *self.contender;
        let sweep_secs: f64 =
            self.stretches.iter().map(|levels| contender.sweep(levels.clone()).as_secs_f64()).sum();
        self.sweep_secs = self.sweep_secs.min(sweep_secs);
        contender.move_to(jumps[0]);
        for (best, &split_count) in self.jump_secs.iter_mut().zip(&jumps[1..]) {
            let started = Instant::now();
            contender.move_to(split_count);
            *best = best.min(started.elapsed().as_secs_f64());
        }
        self.walks.iter_mut().for_each(|walk| walk.go(contender, buffer));
    }

    /// Steps of the sweep that were timed, each down and up.
    pub(super) fn swept_steps(&self) -> usize {
        self.stretches.iter().map(ExactSizeIterator::len).sum()
    }

    /// Nanoseconds a step; none where there are no steps.
    pub(super) fn sweep_ns_per_step(&self) -> Option<f64> {
        let moves = 2 * self.swept_steps();
        (moves > 0).then(|| self.sweep_secs * 1e9 / moves as f64)
    }

    /// Seconds of a move from a random level to another, the mean.
    pub(super) fn seek_secs(&self) -> f64 {
        mean(self.jump_secs.iter().copied())
    }

    /// Its walks, in the order of [`Pace::ALL`].
    pub(super) fn walks(&self) -> &[Walk] {
        &self.walks
    }
}

/// Lets all models go through all rounds; `show` is told which share is done. How many rounds there were.
pub(super) fn hold(contestants: &mut [Contestant], step_count: usize, show: &mut dyn FnMut(f64)) -> usize {
    let mut random = Random::new(JUMP_SEED);
    let jumps: Vec<usize> = (0..=JUMP_COUNT).map(|_| random.below(step_count as u32 + 1) as usize).collect();
    let mut buffer = Vec::new();
    let started = Instant::now();
    let count = contestants.len();
    for round in 0..ROUND_COUNT {
        for i in 0..count {
            contestants[(round + i) % count].go(&jumps, &mut buffer);
            show((round * count + i + 1) as f64 / (ROUND_COUNT * count) as f64);
        }
        if started.elapsed().as_secs_f64() > CONTEST_SECS {
            return round + 1;
        }
    }
    ROUND_COUNT
}

/// All steps where they can be swept within [`SWEEP_SECS`], else as many as can, in stretches.
fn stretches_for(contender: &mut dyn Contender, step_count: usize) -> Vec<Range<usize>> {
    const TRIED_SECS: f64 = 0.002;
    let mut secs_per_step = 0.0;
    // Few steps tell little where steps are quick, and many take long where they are slow.
    for length in [1, 8, 64, 512] {
        let tried = spread(step_count, 8, length);
        let secs: f64 = tried.iter().map(|levels| contender.sweep(levels.clone()).as_secs_f64()).sum();
        secs_per_step = secs / tried.iter().map(ExactSizeIterator::len).sum::<usize>().max(1) as f64;
        if secs > TRIED_SECS {
            break;
        }
    }
    let affordable = (SWEEP_SECS / secs_per_step.max(1e-10)) as usize;
    if affordable >= step_count {
        return spread(step_count, 1, step_count);
    }
    let count = STRETCH_COUNT.min(affordable.max(1));
    spread(step_count, count, affordable / count)
}

/// Up to `count` stretches of `length` levels each, evenly spread from the base to the full mesh, none overlapping.
fn spread(step_count: usize, count: usize, length: usize) -> Vec<Range<usize>> {
    let length = length.clamp(1, step_count.max(1));
    let count = count.min(step_count / length);
    let first = |i: usize| if count < 2 { 0 } else { i * (step_count - length) / (count - 1) };
    (0..count).map(|i| first(i)..first(i) + length).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn stretches_lie_apart_and_reach_both_ends() {
        assert_eq!(spread(100, 1, 100), [0..100]);
        assert_eq!(spread(100, 3, 10), [0..10, 45..55, 90..100]);
        assert_eq!(spread(5, 32, 1), [0..1, 1..2, 2..3, 3..4, 4..5]);
        assert_eq!(spread(0, 8, 4), []);
        for (step_count, count, length) in [(34_000, 32, 200), (63, 32, 2), (7, 8, 64), (1, 1, 0)] {
            let stretches = spread(step_count, count, length);
            assert!(stretches.windows(2).all(|pair| pair[0].end <= pair[1].start), "{stretches:?}");
            assert_eq!(stretches.last().map(|levels| levels.end), Some(step_count));
        }
    }
}
