//! The walk that every way is timed on, in turns.
//!
//! In each round every way goes the whole walk, each round beginning with another one; of all rounds each frame keeps its
//! quickest. A frame is finished before the next one begins: what is told is how long it takes, not how many fit into a second.

use std::time::Instant;

use serde::Serialize;
use striata_gpu::FrameClock;

use super::stage::Stage;
use super::ways::{Entry, Way};
use striata_command::failure::Failure;
use striata_command::output::Bar;

/// Rounds, where time allows.
const ROUND_COUNT: usize = 3;

/// Seconds after which no further round begins.
const COURSE_SECS: f64 = 20.0;

/// Frames that a way draws before it is timed: pipelines are then compiled and buffers have grown.
const WARM_UP_FRAMES: usize = 8;

/// How one frame went.
#[derive(Clone, Copy, Debug)]
struct Frame {
    /// From one level to the next, on the processor: indices made and handed over.
    update: f64,
    /// By the time stamps of the GPU.
    gpu: Option<f64>,
    /// All, from the wish for a level to the finished picture.
    whole: f64,
}

/// The middle of all frames, and what all but a twentieth stay below.
#[derive(Clone, Copy, Debug, Serialize)]
pub(super) struct Spread {
    /// Of all frames.
    pub(super) median: f64,
    /// The 95th of a hundred.
    pub(super) p95: f64,
}

/// What a way costs.
#[derive(Debug, Serialize)]
pub(super) struct Cost {
    pub(super) name: &'static str,
    /// Whether levels stay on the GPU, so that none is made or sent.
    pub(super) is_resident: bool,
    pub(super) update_secs: Spread,
    /// None where the adapter has no time stamps.
    pub(super) gpu_secs: Option<Spread>,
    pub(super) frame_secs: Spread,
    /// Of a frame, the mean.
    pub(super) uploaded_bytes: f64,
    /// Of a frame, the mean.
    pub(super) index_count: f64,
    /// Bytes of indices, draws and tables that it keeps on the GPU.
    pub(super) gpu_bytes: usize,
}

/// All that was timed.
pub(super) struct Course {
    pub(super) costs: Vec<Cost>,
    pub(super) rounds: usize,
}

/// A way and how its frames went.
struct Runner<'s> {
    entry: &'static Entry,
    way: Box<dyn Way + 's>,
    frames: Vec<Frame>,
    uploaded_bytes: f64,
    index_count: f64,
}

/// Split counts from the full mesh to the base mesh and back, none at the turn twice.
fn walk(step_count: usize, frames: usize) -> Vec<usize> {
    let at = |frame: usize| (frames - frame) * step_count / frames;
    (1..=frames).chain((0..frames).rev()).map(at).collect()
}

impl Course {
    /// Builds all ways and lets them take turns.
    ///
    /// # Errors
    /// Where one does not fit onto the GPU, or the GPU fails.
    pub(super) fn run(
        stage: &Stage<'_>,
        entries: &[&'static Entry],
        frames: usize,
        bar: &mut Bar,
    ) -> Result<Self, Failure> {
        let clock = FrameClock::new(stage.gpu)?;
        let levels = walk(stage.step_count(), frames);
        let mut runners = Vec::new();
        for (at, entry) in entries.iter().enumerate() {
            bar.share("models", at as f64 / entries.len() as f64);
            runners.push(Runner::new(entry, stage, &levels)?);
        }
        for runner in &mut runners {
            runner.warm_up(stage, clock.as_ref(), &levels)?;
        }
        let (started, count) = (Instant::now(), runners.len());
        let mut rounds = 0;
        while rounds < ROUND_COUNT && (rounds == 0 || started.elapsed().as_secs_f64() < COURSE_SECS) {
            for turn in 0..count {
                runners[(rounds + turn) % count].go(stage, clock.as_ref(), &levels)?;
                bar.share("frames", (rounds * count + turn + 1) as f64 / (ROUND_COUNT * count) as f64);
            }
            rounds += 1;
        }
        Ok(Self { costs: runners.iter().map(Runner::cost).collect(), rounds })
    }
}

impl<'s> Runner<'s> {
    fn new(entry: &'static Entry, stage: &'s Stage<'_>, levels: &[usize]) -> Result<Self, Failure> {
        let way = entry.build(stage, levels)?;
        let unknown = Frame { update: f64::INFINITY, gpu: None, whole: f64::INFINITY };
        let frames = vec![unknown; levels.len()];
        Ok(Self { entry, way, frames, uploaded_bytes: 0.0, index_count: 0.0 })
    }

    fn warm_up(
        &mut self,
        stage: &Stage<'_>,
        clock: Option<&FrameClock>,
        levels: &[usize],
    ) -> Result<(), Failure> {
        let ahead = levels.iter().take(WARM_UP_FRAMES);
        for &split_count in ahead.chain(levels.last()) {
            self.frame(stage, clock, split_count)?;
        }
        Ok(())
    }

    /// Goes the walk once; it ends where it began.
    fn go(&mut self, stage: &Stage<'_>, clock: Option<&FrameClock>, levels: &[usize]) -> Result<(), Failure> {
        let sent_before = self.way.uploaded_bytes();
        let mut index_count = 0;
        for (at, &split_count) in levels.iter().enumerate() {
            let frame = self.frame(stage, clock, split_count)?;
            self.frames[at].keep_quicker(frame);
            index_count += self.way.index_count();
        }
        let per_frame = |total: f64| total / levels.len() as f64;
        self.uploaded_bytes = per_frame((self.way.uploaded_bytes() - sent_before) as f64);
        self.index_count = per_frame(index_count as f64);
        Ok(())
    }

    fn frame(
        &mut self,
        stage: &Stage<'_>,
        clock: Option<&FrameClock>,
        split_count: usize,
    ) -> Result<Frame, Failure> {
        let Stage { gpu, canvas, painter, scene, vertices, look, .. } = stage;
        let started = Instant::now();
        self.way.move_to(gpu, split_count)?;
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
        Ok(Frame { update, gpu: clock.map(|clock| clock.secs(gpu)).transpose()?, whole })
    }

    fn cost(&self) -> Cost {
        let spread = |number: fn(&Frame) -> f64| Spread::of(self.frames.iter().map(number));
        let gpu_secs = self.frames.iter().map(|frame| frame.gpu).collect::<Option<Vec<f64>>>();
        Cost {
            name: self.entry.name,
            is_resident: self.entry.is_resident,
            update_secs: spread(|frame| frame.update),
            gpu_secs: gpu_secs.map(|secs| Spread::of(secs.into_iter())),
            frame_secs: spread(|frame| frame.whole),
            uploaded_bytes: self.uploaded_bytes,
            index_count: self.index_count,
            gpu_bytes: self.way.gpu_bytes(),
        }
    }
}

impl Frame {
    fn keep_quicker(&mut self, other: Self) {
        self.update = self.update.min(other.update);
        self.whole = self.whole.min(other.whole);
        self.gpu = match (self.gpu, other.gpu) {
            (Some(a), Some(b)) => Some(a.min(b)),
            (a, b) => a.or(b),
        };
    }
}

impl Spread {
    fn of(numbers: impl Iterator<Item = f64>) -> Self {
        let mut numbers: Vec<f64> = numbers.collect();
        numbers.sort_by(f64::total_cmp);
        let at = |share: f64| {
            let place = (share * numbers.len() as f64).ceil() as usize;
            numbers.get(place.clamp(1, numbers.len().max(1)) - 1).copied().unwrap_or(0.0)
        };
        Self { median: at(0.5), p95: at(0.95) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_walk_goes_by_even_steps_to_the_base_and_back() {
        assert_eq!(walk(100, 4), [75, 50, 25, 0, 25, 50, 75, 100]);
        assert_eq!(walk(7, 1), [0, 7]);
        assert_eq!(walk(0, 2), [0; 4]);
        let large = walk(1_000_003, 333);
        assert_eq!((large.len(), large[332], large[665]), (666, 0, 1_000_003));
    }

    #[test]
    fn spreads_are_numbers_of_the_list() {
        let spread = Spread::of((1..=100).rev().map(f64::from));
        assert_eq!((spread.median, spread.p95), (50.0, 95.0));
        let one = Spread::of(std::iter::once(3.0));
        assert_eq!((one.median, one.p95), (3.0, 3.0));
    }
}
