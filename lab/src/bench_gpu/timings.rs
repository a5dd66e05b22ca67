//! Times every way on the same walk through the levels, taking turns.
//!
//! Each round runs the whole walk once with every way, and each round starts with a different way. Per
//! frame, the fastest time of all rounds is kept. A frame finishes before the next one begins, so this
//! measures the latency of a frame, not the throughput.

use std::time::Instant;

use serde::Serialize;
use striata_render::gpu::FrameClock;

use super::bench_scene::BenchScene;
use super::ways::{Way, WayEntry};
use crate::pace::Pace;
use striata_command::failure::Failure;
use striata_command::output::Bar;

/// Maximum number of rounds.
const ROUND_COUNT: usize = 3;

/// No further round starts after this many seconds.
const MAX_SECS: f64 = 20.0;

/// Frames drawn before timing starts, so that pipelines are compiled and buffers have grown.
const WARM_UP_FRAMES: usize = 8;

/// Times of one frame, in seconds.
#[derive(Clone, Copy, Debug)]
struct FrameTimes {
    /// CPU time to move the model to the level: recovery, as the papers call it.
    recover: f64,
    /// CPU time to move to the next level: recovery, making the indices and handing them over.
    update: f64,
    /// GPU time from time stamps, or `None` if the adapter has no time stamps.
    gpu: Option<f64>,
    /// From requesting the level to the finished picture.
    whole: f64,
}

/// Median and 95th percentile over all frames.
#[derive(Clone, Copy, Debug, Serialize)]
pub(super) struct TimeSpread {
    /// Median, in seconds.
    pub median: f64,
    /// 95th percentile, in seconds.
    pub p95: f64,
}

/// Measured cost of one way.
#[derive(Debug, Serialize)]
pub(super) struct WayCost {
    pub name: &'static str,
    /// Whether all levels stay on the GPU, so that nothing is computed or uploaded.
    pub is_resident: bool,
    pub recover_secs: TimeSpread,
    pub update_secs: TimeSpread,
    /// `None` if the adapter has no time stamps.
    pub gpu_secs: Option<TimeSpread>,
    pub frame_secs: TimeSpread,
    /// Mean over all frames.
    pub mean_frame_secs: f64,
    /// Share of the frames' time that recovery takes, `%rec` in \[RCRG06\]; the rest is `%drw`.
    pub recover_share: f64,
    /// Frames per second in the nearest, the middle and the farthest third of the walk.
    pub frames_per_sec: [f64; 3],
    /// Mean per frame.
    pub uploaded_bytes: f64,
    /// Mean per frame.
    pub index_count: f64,
    /// Bytes of indices, draw commands and tables kept on the GPU.
    pub gpu_bytes: usize,
}

/// Result of timing all ways.
pub(super) struct Timings {
    pub costs: Vec<WayCost>,
    pub rounds: usize,
}

/// A way and the times of its frames.
struct TimedWay<'s> {
    entry: &'static WayEntry,
    way: Box<dyn Way + 's>,
    frames: Vec<FrameTimes>,
    uploaded_bytes: f64,
    index_count: f64,
}

/// Split counts from the full mesh to the base mesh and back; the base mesh appears once, and the full mesh
/// at the end.
fn walk(pace: Pace, step_count: usize, frames: usize) -> Vec<usize> {
    let away = pace.split_counts(step_count, frames);
    away.iter().skip(1).chain(away.iter().rev().skip(1)).copied().collect()
}

impl Timings {
    /// Builds all ways and times them in turns.
    ///
    /// # Errors
    /// If a way does not fit onto the GPU, or the GPU fails.
    pub(super) fn run(
        bench: &BenchScene<'_>,
        entries: &[&'static WayEntry],
        pace: Pace,
        frames: usize,
        bar: &mut Bar,
    ) -> Result<Self, Failure> {
        let clock = FrameClock::new(bench.gpu)?;
        let levels = walk(pace, bench.step_count(), frames);
        let mut timed_ways = Vec::new();
        for (at, entry) in entries.iter().enumerate() {
            bar.share("models", at as f64 / entries.len() as f64);
            timed_ways.push(TimedWay::new(entry, bench, &levels)?);
        }
        for timed_way in &mut timed_ways {
            timed_way.warm_up(bench, clock.as_ref(), &levels)?;
        }
        let (started, count) = (Instant::now(), timed_ways.len());
        let mut rounds = 0;
        while rounds < ROUND_COUNT && (rounds == 0 || started.elapsed().as_secs_f64() < MAX_SECS) {
            for turn in 0..count {
                timed_ways[(rounds + turn) % count].go(bench, clock.as_ref(), &levels)?;
                bar.share("frames", (rounds * count + turn + 1) as f64 / (ROUND_COUNT * count) as f64);
            }
            rounds += 1;
        }
        Ok(Self { costs: timed_ways.iter().map(TimedWay::cost).collect(), rounds })
    }
}

impl<'s> TimedWay<'s> {
    fn new(entry: &'static WayEntry, bench: &'s BenchScene<'_>, levels: &[usize]) -> Result<Self, Failure> {
        let way = entry.build(bench, levels)?;
        let unmeasured =
            FrameTimes { recover: f64::INFINITY, update: f64::INFINITY, gpu: None, whole: f64::INFINITY };
        let frames = vec![unmeasured; levels.len()];
        Ok(Self { entry, way, frames, uploaded_bytes: 0.0, index_count: 0.0 })
    }

    fn warm_up(
        &mut self,
        bench: &BenchScene<'_>,
        clock: Option<&FrameClock>,
        levels: &[usize],
    ) -> Result<(), Failure> {
        let ahead = levels.iter().take(WARM_UP_FRAMES);
        for &split_count in ahead.chain(levels.last()) {
            self.frame(bench, clock, split_count)?;
        }
        Ok(())
    }

    /// Runs the walk once; it ends at the level where it started.
    fn go(
        &mut self,
        bench: &BenchScene<'_>,
        clock: Option<&FrameClock>,
        levels: &[usize],
    ) -> Result<(), Failure> {
        let sent_before = self.way.uploaded_bytes();
        let mut index_count = 0;
        for (at, &split_count) in levels.iter().enumerate() {
            let frame = self.frame(bench, clock, split_count)?;
            self.frames[at].keep_fastest(frame);
            index_count += self.way.index_count();
        }
        let per_frame = |total: f64| total / levels.len() as f64;
        self.uploaded_bytes = per_frame((self.way.uploaded_bytes() - sent_before) as f64);
        self.index_count = per_frame(index_count as f64);
        Ok(())
    }

    fn frame(
        &mut self,
        bench: &BenchScene<'_>,
        clock: Option<&FrameClock>,
        split_count: usize,
    ) -> Result<FrameTimes, Failure> {
        let BenchScene { gpu, canvas, painter, scene, vertices, look, .. } = bench;
        let started = Instant::now();
        self.way.move_to(split_count);
        let recover = started.elapsed().as_secs_f64();
        self.way.send(gpu)?;
        let update = started.elapsed().as_secs_f64();
        let mut encoder = gpu.device().create_command_encoder(&Default::default());
        clock.inspect(|clock| clock.start(&mut encoder));
        self.way.extract(&mut encoder);
        let mut pass = canvas.begin(&mut encoder, look.background);
        painter.draw(&mut pass, scene, vertices, self.way.drawing());
        drop(pass);
        clock.inspect(|clock| clock.stop(&mut encoder));
        gpu.queue().submit([encoder.finish()]);
        gpu.wait()?;
        let whole = started.elapsed().as_secs_f64();
        Ok(FrameTimes { recover, update, gpu: clock.map(|clock| clock.secs(gpu)).transpose()?, whole })
    }

    fn cost(&self) -> WayCost {
        let spread = |value: fn(&FrameTimes) -> f64| TimeSpread::of(self.frames.iter().map(value));
        let gpu_secs = self.frames.iter().map(|frame| frame.gpu).collect::<Option<Vec<f64>>>();
        let sum = |value: fn(&FrameTimes) -> f64| self.frames.iter().map(value).sum::<f64>();
        let whole = sum(|frame| frame.whole);
        WayCost {
            mean_frame_secs: whole / self.frames.len().max(1) as f64,
            recover_share: sum(|frame| frame.recover) / whole,
            frames_per_sec: frames_per_sec_by_third(&self.frames),
            recover_secs: spread(|frame| frame.recover),
            name: self.entry.name,
            is_resident: self.entry.is_resident,
            update_secs: spread(|frame| frame.update),
            gpu_secs: gpu_secs.map(|secs| TimeSpread::of(secs.into_iter())),
            frame_secs: spread(|frame| frame.whole),
            uploaded_bytes: self.uploaded_bytes,
            index_count: self.index_count,
            gpu_bytes: self.way.gpu_bytes(),
        }
    }
}

/// Frames per second in three thirds of a walk away, of which the way back is the mirror image.
fn frames_per_sec_by_third(frames: &[FrameTimes]) -> [f64; 3] {
    let distance = |at: usize| at.min(frames.len() - 1 - at);
    let half = frames.len().div_ceil(2);
    [0, 1, 2].map(|third| {
        let is_here = |at: &usize| 3 * distance(*at) / half == third;
        let (mut secs, mut count) = (0.0, 0);
        for at in (0..frames.len()).filter(is_here) {
            secs += frames[at].whole;
            count += 1;
        }
        if count == 0 { 0.0 } else { f64::from(count) / secs }
    })
}

impl FrameTimes {
    fn keep_fastest(&mut self, other: Self) {
        self.recover = self.recover.min(other.recover);
        self.update = self.update.min(other.update);
        self.whole = self.whole.min(other.whole);
        self.gpu = match (self.gpu, other.gpu) {
            (Some(a), Some(b)) => Some(a.min(b)),
            (a, b) => a.or(b),
        };
    }
}

impl TimeSpread {
    fn of(values: impl Iterator<Item = f64>) -> Self {
        let mut values: Vec<f64> = values.collect();
        values.sort_by(f64::total_cmp);
        let at = |share: f64| {
            let rank = (share * values.len() as f64).ceil() as usize;
            values.get(rank.clamp(1, values.len().max(1)) - 1).copied().unwrap_or(0.0)
        };
        Self { median: at(0.5), p95: at(0.95) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn walk_reaches_the_base_and_returns_in_even_steps() {
        assert_eq!(walk(Pace::Linear, 100, 4), [75, 50, 25, 0, 25, 50, 75, 100]);
        assert_eq!(walk(Pace::Linear, 7, 1), [0, 7]);
        assert_eq!(walk(Pace::Linear, 0, 2), [0; 4]);
        for pace in Pace::ALL {
            let large = walk(pace, 1_000_003, 333);
            assert_eq!((large.len(), large[332], large[665]), (666, 0, 1_000_003));
        }
    }

    #[test]
    fn thirds_of_the_way_back_are_those_of_the_way_away() {
        let frame = |whole| FrameTimes { recover: 0.0, update: 0.0, gpu: None, whole };
        let frames = [0.5, 0.5, 0.25, 0.25, 0.125, 0.125, 0.125, 0.25, 0.25, 0.5, 0.5].map(frame);
        assert_eq!(frames_per_sec_by_third(&frames), [2.0, 4.0, 8.0]);
        assert_eq!(frames_per_sec_by_third(&frames[..1]), [2.0, 0.0, 0.0]);
    }

    #[test]
    fn spread_values_come_from_the_list() {
        let spread = TimeSpread::of((1..=100).rev().map(f64::from));
        assert_eq!((spread.median, spread.p95), (50.0, 95.0));
        let one = TimeSpread::of(std::iter::once(3.0));
        assert_eq!((one.median, one.p95), (3.0, 3.0));
    }
}
