//! Times models against each other, in a way that is fair on a machine with other load.
//!
//! In each round every model does all the work, one model after the other, and each round starts with a
//! different model; nothing else runs meanwhile. The fastest time of all rounds counts, separately for
//! each frame, jump and lap.

use std::time::Instant;

use striata::mesh::Random;

use super::contenders::{Contender, Entry};
use super::sweep::StepSweep;
use super::walks::{TimedWalk, mean};
use crate::pace::Pace;

/// Maximum number of rounds.
const ROUND_COUNT: usize = 5;

/// No further round starts after this many seconds.
const MAX_SECS: f64 = 10.0;

/// Number of jumps between random levels.
const JUMP_COUNT: usize = 64;

/// Seed of the random levels.
const JUMP_SEED: u64 = 1;

/// A model and its times.
pub(super) struct TimedModel {
    /// The kind of model.
    pub entry: &'static Entry,
    /// The model.
    pub contender: Box<dyn Contender>,
    sweep: StepSweep,
    jump_secs: Vec<f64>,
    walks: Vec<TimedWalk>,
}

impl TimedModel {
    /// Wraps a model that has not been timed yet.
    pub(super) fn new(
        entry: &'static Entry,
        mut contender: Box<dyn Contender>,
        step_count: usize,
        frames: usize,
    ) -> Self {
        let sweep = if entry.has_few_levels {
            StepSweep::default()
        } else {
            StepSweep::new(&mut *contender, step_count)
        };
        let mut walks = Pace::ALL.map(|pace| TimedWalk::new(pace, step_count, frames)).to_vec();
        walks.iter_mut().for_each(|walk| walk.count_draws(&mut *contender));
        let jump_secs = vec![f64::INFINITY; JUMP_COUNT];
        Self { entry, contender, sweep, jump_secs, walks }
    }

    fn run(&mut self, jumps: &[usize], buffer: &mut Vec<u32>) {
        let contender = &mut *self.contender;
        self.sweep.run(contender);
        contender.move_to(jumps[0]);
        for (best, &split_count) in self.jump_secs.iter_mut().zip(&jumps[1..]) {
            let started = Instant::now();
            contender.move_to(split_count);
            *best = best.min(started.elapsed().as_secs_f64());
        }
        self.walks.iter_mut().for_each(|walk| walk.run(contender, buffer));
    }

    /// The times of its sweep.
    pub(super) fn sweep(&self) -> &StepSweep {
        &self.sweep
    }

    /// Mean seconds of a move between random levels.
    pub(super) fn seek_secs(&self) -> f64 {
        mean(self.jump_secs.iter().copied())
    }

    /// The times of its walks, in the order of [`Pace::ALL`].
    pub(super) fn walks(&self) -> &[TimedWalk] {
        &self.walks
    }
}

/// Runs all rounds with all models and returns the number of rounds; `show` receives the completed share.
pub(super) fn run_rounds(
    timed_models: &mut [TimedModel],
    step_count: usize,
    show: &mut dyn FnMut(f64),
) -> usize {
    let mut random = Random::new(JUMP_SEED);
    let jumps: Vec<usize> = (0..=JUMP_COUNT).map(|_| random.below(step_count as u32 + 1) as usize).collect();
    let mut buffer = Vec::new();
    let started = Instant::now();
    let count = timed_models.len();
    for round in 0..ROUND_COUNT {
        for i in 0..count {
            timed_models[(round + i) % count].run(&jumps, &mut buffer);
            show((round * count + i + 1) as f64 / (ROUND_COUNT * count) as f64);
        }
        if started.elapsed().as_secs_f64() > MAX_SECS {
            return round + 1;
        }
    }
    ROUND_COUNT
}
