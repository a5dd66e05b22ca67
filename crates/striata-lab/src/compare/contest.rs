//! Times models against each other, fairly on a machine that does other things too.
//!
//! In each round every model does all there is to time, one model after the other, each round beginning with another
//! one; nothing else runs meanwhile. Of all rounds the quickest counts, for each frame, jump and lap apart.

use std::time::Instant;

use striata::mesh::Random;

use super::contenders::{Contender, Entry};
use super::sweep::Sweep;
use super::walks::{Pace, Walk, mean};

/// Rounds, where time allows.
const ROUND_COUNT: usize = 5;

/// Seconds after which no further round begins.
const CONTEST_SECS: f64 = 10.0;

/// Jumps between random levels.
const JUMP_COUNT: usize = 64;

/// Seed of those levels.
const JUMP_SEED: u64 = 1;

/// A model and what it has been timed at.
pub(super) struct Contestant {
    /// Which model it is.
    pub(super) entry: &'static Entry,
    /// The model.
    pub(super) contender: Box<dyn Contender>,
    sweep: Sweep,
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
        let sweep =
            if entry.has_few_levels { Sweep::default() } else { Sweep::new(&mut *contender, step_count) };
        let mut walks = Pace::ALL.map(|pace| Walk::new(pace, step_count, frames)).to_vec();
        walks.iter_mut().for_each(|walk| walk.look(&mut *contender));
        let jump_secs = vec![f64::INFINITY; JUMP_COUNT];
        Self { entry, contender, sweep, jump_secs, walks }
    }

    fn go(&mut self, jumps: &[usize], buffer: &mut Vec<u32>) {
        let contender = &mut *self.contender;
        self.sweep.go(contender);
        contender.move_to(jumps[0]);
        for (best, &split_count) in self.jump_secs.iter_mut().zip(&jumps[1..]) {
            let started = Instant::now();
            contender.move_to(split_count);
            *best = best.min(started.elapsed().as_secs_f64());
        }
        self.walks.iter_mut().for_each(|walk| walk.go(contender, buffer));
    }

    /// Its sweep.
    pub(super) fn sweep(&self) -> &Sweep {
        &self.sweep
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
