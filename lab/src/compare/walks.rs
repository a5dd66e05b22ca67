//! Walks away from an object and back, as the papers measure them: the linear test of \[RCRG06\] and
//! \[BRR02\], section 4.3, and the exponential test of the latter.
//!
//! A walk is a list of levels from near to far. Each level is visited on the way away and again on the way
//! back. Moving to it is timed alone, and together with sending all indices to a buffer, which is the CPU
//! work of the papers' immediate mode. Each frame keeps its fastest time of several rounds.

use std::hint::black_box;
use std::time::Instant;

use serde::Serialize;
use striata::mesh::CollapseSequence;
use striata::model::DrawCounts;

use super::contenders::Contender;
use crate::pace::Pace;

/// Maximum number of points in a series.
const MAX_POINTS: usize = 100;

/// A walk, the fastest times of its frames, and their draw counts.
#[derive(Clone, Debug)]
pub(super) struct TimedWalk {
    pace: Pace,
    split_counts: Vec<usize>,
    away: Vec<FrameSecs>,
    back: Vec<FrameSecs>,
    shown: Vec<WalkLevel>,
}

#[derive(Clone, Copy, Debug)]
struct FrameSecs {
    extract: f64,
    with_sending: f64,
}

#[derive(Clone, Copy, Debug, Default)]
struct WalkLevel {
    split_count: usize,
    counts: DrawCounts,
}

impl TimedWalk {
    /// Creates a walk that has not been run.
    pub(super) fn new(pace: Pace, step_count: usize, frames: usize) -> Self {
        let split_counts = pace.split_counts(step_count, frames);
        let unmeasured = FrameSecs { extract: f64::INFINITY, with_sending: f64::INFINITY };
        let times = vec![unmeasured; split_counts.len()];
        let shown = vec![WalkLevel::default(); split_counts.len()];
        Self { pace, split_counts, away: times.clone(), back: times, shown }
    }

    /// Runs the walk away and back once; indices are sent to `buffer`.
    pub(super) fn run(&mut self, contender: &mut dyn Contender, buffer: &mut Vec<u32>) {
        contender.move_to(self.split_counts[0]);
        let last = self.split_counts.len() - 1;
        for frame in 1..=last {
            self.away[frame].keep_fastest(frame_secs(contender, self.split_counts[frame], buffer));
        }
        for frame in (0..last).rev() {
            self.back[frame].keep_fastest(frame_secs(contender, self.split_counts[frame], buffer));
        }
    }

    /// Records the draw counts of each frame, without timing.
    pub(super) fn count_draws(&mut self, contender: &mut dyn Contender) {
        for (shown, &split_count) in self.shown.iter_mut().zip(&self.split_counts) {
            contender.move_to(split_count);
            *shown = WalkLevel { split_count: contender.split_count(), counts: contender.draw_counts() };
        }
    }

    /// Computes means over the frames of both directions, and the series.
    pub(super) fn report(&self, sequence: &CollapseSequence) -> WalkReport {
        let last = self.split_counts.len() - 1;
        let (away, back) = (&self.away[1..], &self.back[..last]);
        let both = || away.iter().chain(back);
        let drawn = || self.shown[1..].iter().chain(&self.shown[..last]);
        WalkReport {
            extract_secs: mean(both().map(|frame| frame.extract)),
            extract_and_send_secs: mean(both().map(|frame| frame.with_sending)),
            extract_away_secs: mean(away.iter().map(|frame| frame.extract)),
            extract_back_secs: mean(back.iter().map(|frame| frame.extract)),
            index_count: mean(drawn().map(|shown| shown.counts.index_count as f64)),
            strip_count: mean(drawn().map(|shown| shown.counts.strip_count as f64)),
            triangle_count: mean(drawn().map(|shown| sequence.triangle_count_at(shown.split_count) as f64)),
            series: self.series(sequence),
        }
    }

    fn series(&self, sequence: &CollapseSequence) -> WalkSeries {
        let frames = thinned(self.split_counts.len());
        let both_ways = |value_of: fn(&FrameSecs) -> f64| -> Vec<f64> {
            let of_frame = |&frame: &usize| {
                let ways = [&self.away[frame], &self.back[frame]].map(value_of);
                // The nearest frame is timed only on the way back, the farthest only on the way away.
                mean(ways.into_iter().filter(|secs| secs.is_finite()))
            };
            frames.iter().map(of_frame).collect()
        };
        let shown = || frames.iter().map(|&frame| self.shown[frame]);
        WalkSeries {
            split_count: shown().map(|shown| shown.split_count).collect(),
            triangle_count: shown().map(|shown| sequence.triangle_count_at(shown.split_count)).collect(),
            index_count: shown().map(|shown| shown.counts.index_count).collect(),
            strip_count: shown().map(|shown| shown.counts.strip_count).collect(),
            extract_secs: both_ways(|frame| frame.extract),
            extract_and_send_secs: both_ways(|frame| frame.with_sending),
            frame: frames,
        }
    }

    /// The pace of the walk.
    pub(super) fn pace(&self) -> Pace {
        self.pace
    }
}

impl FrameSecs {
    fn keep_fastest(&mut self, other: Self) {
        self.extract = self.extract.min(other.extract);
        self.with_sending = self.with_sending.min(other.with_sending);
    }
}

fn frame_secs(contender: &mut dyn Contender, split_count: usize, buffer: &mut Vec<u32>) -> FrameSecs {
    let started = Instant::now();
    contender.move_to(split_count);
    let extract = started.elapsed().as_secs_f64();
    buffer.clear();
    contender.indices_into(buffer);
    black_box(&*buffer);
    FrameSecs { extract, with_sending: started.elapsed().as_secs_f64() }
}

/// The mean, or 0 if there are no values.
pub(super) fn mean(values: impl Iterator<Item = f64>) -> f64 {
    let (sum, count) = values.fold((0.0, 0usize), |(sum, count), value| (sum + value, count + 1));
    if count == 0 { 0.0 } else { sum / count as f64 }
}

/// At most [`MAX_POINTS`] of `count` indices, evenly spaced, including the first and the last.
pub(super) fn thinned(count: usize) -> Vec<usize> {
    if count <= MAX_POINTS {
        return (0..count).collect();
    }
    (0..MAX_POINTS).map(|i| i * (count - 1) / (MAX_POINTS - 1)).collect()
}

/// Report of a walk of one model: means over all frames in both directions.
#[derive(Clone, Debug, Serialize)]
pub(super) struct WalkReport {
    /// Seconds to move to a frame's level.
    pub extract_secs: f64,
    /// Seconds to move there and copy its indices.
    pub extract_and_send_secs: f64,
    extract_away_secs: f64,
    extract_back_secs: f64,
    /// Number of indices drawn.
    pub index_count: f64,
    /// Number of strips drawn.
    pub strip_count: f64,
    /// Number of triangles shown.
    pub triangle_count: f64,
    /// Values by frame.
    pub series: WalkSeries,
}

/// Frames of a walk from near to far; times are means of both directions.
#[derive(Clone, Debug, Serialize)]
pub(super) struct WalkSeries {
    /// Indices of the frames.
    pub frame: Vec<usize>,
    split_count: Vec<usize>,
    triangle_count: Vec<usize>,
    /// Number of indices drawn.
    pub index_count: Vec<usize>,
    /// Number of strips drawn.
    pub strip_count: Vec<usize>,
    /// Seconds to move there.
    pub extract_secs: Vec<f64>,
    /// Seconds to move there and copy the indices.
    pub extract_and_send_secs: Vec<f64>,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn thinned_series_keeps_its_ends() {
        assert_eq!(thinned(3), [0, 1, 2]);
        for count in [100, 101, 199, 201, 10_001] {
            let kept = thinned(count);
            assert_eq!((kept.len(), kept[0], kept[MAX_POINTS - 1]), (MAX_POINTS, 0, count - 1));
            assert!(kept.is_sorted_by(|a, b| a < b));
        }
    }

    #[test]
    fn mean_of_no_values_is_zero() {
        assert_eq!((mean([].into_iter()), mean([1.0, 2.0].into_iter())), (0.0, 1.5));
    }
}
