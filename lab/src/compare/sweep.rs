//! Times moves through all levels one step at a time, from the full mesh to the base and back.
//!
//! A sweep is timed in laps, and each lap keeps the fastest time of its rounds: on a machine with other
//! load, few whole sweeps run undisturbed. If a whole sweep would take too long, stretches spread evenly
//! over all levels represent it.

use std::ops::Range;

use super::contenders::Contender;

/// Seconds that one model may sweep per round.
const SWEEP_SECS: f64 = 0.4;

/// Number of laps of a whole sweep, or of stretches that represent it.
const LAP_COUNT: usize = 32;

/// The steps to sweep, and the fastest times of each lap.
#[derive(Clone, Debug, Default)]
pub(super) struct StepSweep {
    laps: Vec<Lap>,
    /// Whether each lap begins where the previous one ends.
    is_whole: bool,
}

#[derive(Clone, Debug)]
struct Lap {
    levels: Range<usize>,
    down_secs: f64,
    up_secs: f64,
}

impl StepSweep {
    /// Creates a sweep with as many steps as the model can do in the time limit; it is not run yet.
    pub(super) fn new(contender: &mut dyn Contender, step_count: usize) -> Self {
        const TRIAL_SECS: f64 = 0.002;
        let mut secs_per_step = 0.0;
        // Few steps give imprecise times if steps are fast, and many take too long if steps are slow.
        for length in [1, 8, 64, 512] {
            let mut trial = Self::over(spread(step_count, 8, length), false);
            trial.run(contender);
            secs_per_step = trial.secs() / trial.step_count().max(1) as f64;
            if trial.secs() > TRIAL_SECS {
                break;
            }
        }
        let affordable = (SWEEP_SECS / secs_per_step.max(1e-10)) as usize;
        if affordable >= step_count {
            return Self::over(consecutive(step_count, LAP_COUNT), true);
        }
        let count = LAP_COUNT.min(affordable.max(1));
        Self::over(spread(step_count, count, affordable / count), false)
    }

    fn over(stretches: Vec<Range<usize>>, is_whole: bool) -> Self {
        let lap = |levels| Lap { levels, down_secs: f64::INFINITY, up_secs: f64::INFINITY };
        Self { laps: stretches.into_iter().map(lap).collect(), is_whole }
    }

    /// Runs the sweep down and up once.
    pub(super) fn run(&mut self, contender: &mut dyn Contender) {
        if !self.is_whole {
            self.laps.iter_mut().for_each(|lap| {
                contender.move_to(lap.levels.end);
                lap.go_down(contender);
                lap.go_up(contender);
            });
            return;
        }
        contender.move_to(self.laps.last().map_or(0, |lap| lap.levels.end));
        self.laps.iter_mut().rev().for_each(|lap| lap.go_down(contender));
        self.laps.iter_mut().for_each(|lap| lap.go_up(contender));
    }

    /// Number of steps covered, each down and up.
    pub(super) fn step_count(&self) -> usize {
        self.laps.iter().map(|lap| lap.levels.len()).sum()
    }

    /// Nanoseconds per step, or `None` if there are no steps.
    pub(super) fn ns_per_step(&self) -> Option<f64> {
        let moves = 2 * self.step_count();
        (moves > 0).then(|| self.secs() * 1e9 / moves as f64)
    }

    fn secs(&self) -> f64 {
        self.laps.iter().map(|lap| lap.down_secs + lap.up_secs).sum()
    }
}

impl Lap {
    fn go_down(&mut self, contender: &mut dyn Contender) {
        self.down_secs = self.down_secs.min(contender.step_over(self.levels.clone(), true).as_secs_f64());
    }

    fn go_up(&mut self, contender: &mut dyn Contender) {
        self.up_secs = self.up_secs.min(contender.step_over(self.levels.clone(), false).as_secs_f64());
    }
}

/// Divides all levels into up to `count` consecutive stretches.
fn consecutive(step_count: usize, count: usize) -> Vec<Range<usize>> {
    let end = |i: usize| i * step_count / count;
    (0..count).map(|i| end(i)..end(i + 1)).filter(|levels| !levels.is_empty()).collect()
}

/// Up to `count` disjoint stretches of `length` levels, spread evenly from the base to the full mesh.
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
    fn whole_sweep_covers_every_step_once() {
        for step_count in [0, 1, 31, 32, 33, 1000] {
            let laps = consecutive(step_count, LAP_COUNT);
            let steps: Vec<usize> = laps.iter().cloned().flatten().collect();
            assert!(steps.into_iter().eq(0..step_count));
            assert!(laps.len() <= LAP_COUNT);
        }
    }

    #[test]
    fn stretches_are_disjoint_and_reach_both_ends() {
        assert_eq!(spread(100, 3, 10), [0..10, 45..55, 90..100]);
        assert_eq!(spread(5, 32, 1), [0..1, 1..2, 2..3, 3..4, 4..5]);
        assert!(spread(0, 8, 4).is_empty());
        for (step_count, count, length) in [(34_000, 32, 200), (63, 32, 2), (7, 8, 64), (1, 1, 0)] {
            let stretches = spread(step_count, count, length);
            assert!(stretches.windows(2).all(|pair| pair[0].end <= pair[1].start), "{stretches:?}");
            let covered: usize = stretches.iter().map(ExactSizeIterator::len).sum();
            assert!(covered <= step_count && covered > 0, "{stretches:?}");
        }
    }

    #[test]
    fn empty_sweep_has_no_time_per_step() {
        assert_eq!(StepSweep::default().ns_per_step(), None);
        assert_eq!(StepSweep::over(vec![0..3, 5..9], false).step_count(), 7);
    }
}
