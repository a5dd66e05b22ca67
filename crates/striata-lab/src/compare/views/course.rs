//! One path, gone by all followers: first a rehearsal that looks at what they do, then rounds against the clock.
//!
//! In each round every follower goes the whole way, one after the other, each round beginning with another one; of each frame
//! the quickest of all rounds counts. What the criterion takes is told by the rehearsal; the rest of the time is the update.

use std::hint::black_box;
use std::time::Instant;

use striata::mesh::{IndexedMesh, canonical_triangles};
use striata::view::ScreenError;

use super::asker::Log;
use super::followers::{FANS, Follower, KEPT, Models, NAMES, STATELESS, View};
use super::paths::{Frame, Path};
use super::seen::{SeenErrors, Watched};
use striata_command::failure::Failure;

/// Rounds, where time allows.
const ROUND_COUNT: usize = 4;

/// Seconds after which no further round of a path begins.
const COURSE_SECS: f64 = 4.5;

/// Frames of a path in which errors are looked at.
const WATCHED_FRAMES: usize = 8;

/// A path and the pixels that an error may take.
#[derive(Clone, Copy, Debug)]
pub(super) struct Course {
    /// The way.
    pub(super) path: Path,
    /// Pixels allowed.
    pub(super) pixels: f32,
}

/// What a follower did on a course, frame by frame.
#[derive(Clone, Debug, Default)]
pub(super) struct Run {
    /// Seconds of questions and changes, the quickest.
    pub(super) follow_secs: Vec<f64>,
    /// Seconds of questions, as far as they are told apart.
    pub(super) criterion_secs: Vec<f64>,
    /// Seconds of making the indices.
    pub(super) emission_secs: Vec<f64>,
    /// Steps asked for.
    pub(super) asked: Vec<usize>,
    /// Splits and collapses.
    pub(super) changes: Vec<usize>,
    /// Triangles shown.
    pub(super) triangles: Vec<usize>,
    /// The most that the instance owned.
    pub(super) instance_bytes: usize,
    /// What is wrong on the screen.
    pub(super) errors: SeenErrors,
}

/// The frames of a course with what followers are shown.
struct Stage {
    frames: Vec<Frame>,
    screens: Vec<ScreenError>,
    split_counts: Vec<usize>,
}

impl Stage {
    fn new(course: Course, models: &Models<'_>) -> Result<Self, Failure> {
        let mesh = &models.refinable.mesh;
        let frames = course.path.frames(mesh);
        let model = models.scene().sphere();
        let screen = |frame: &Frame| {
            let camera = frame.camera().map_err(|error| Failure::internal(error.to_string()))?;
            Ok::<_, Failure>(ScreenError::new(camera, course.pixels).with_model_bounds(model))
        };
        let screens = frames.iter().map(screen).collect::<Result<_, _>>()?;
        let sequence = &models.refinable.sequence;
        let split_count = |frame: &Frame| match most_pixels(mesh, frame) {
            Some(pixels) => sequence.split_count_for_error(f64::from(course.pixels) / pixels),
            None => 0,
        };
        let split_counts = frames.iter().map(split_count).collect();
        Ok(Self { frames, screens, split_counts })
    }

    fn view(&self, frame: usize) -> View<'_> {
        View { screen: &self.screens[frame], split_count: self.split_counts[frame] }
    }

    fn is_watched(&self, frame: usize) -> bool {
        let every = self.frames.len().div_ceil(WATCHED_FRAMES).max(1);
        // Not the very first one, where all begin at the base.
        frame % every == every / 2
    }
}

/// The most pixels that a unit takes at a vertex in the picture: there the surface is nearest, as the screen sees it.
fn most_pixels(mesh: &IndexedMesh, frame: &Frame) -> Option<f64> {
    mesh.positions.iter().filter_map(|point| frame.pixels_at(point.map(f64::from))).reduce(f64::max)
}

impl Course {
    /// Lets all followers go. A run for each of [`NAMES`], and how many rounds there were.
    ///
    /// # Errors
    /// Where a follower shows something else than it should, which is our fault.
    pub(super) fn go(
        self,
        models: &Models<'_>,
        show: &mut dyn FnMut(f64),
    ) -> Result<(Vec<Option<Run>>, usize), Failure> {
        let stage = Stage::new(self, models)?;
        let log = Log::default();
        let mut followers: Vec<Option<Box<dyn Follower<'_> + '_>>> =
            models.followers().into_iter().map(Result::ok).collect();
        let mut runs = rehearse(&stage, models, &mut followers, &log)?;
        let started = Instant::now();
        let (mut buffer, count) = (Vec::new(), followers.len());
        for round in 0..ROUND_COUNT {
            for i in 0..count {
                let at = (round + i) % count;
                if let (Some(follower), Some(run)) = (&mut followers[at], &mut runs[at]) {
                    run.time(&stage, &mut **follower, &mut buffer);
                }
                show((round * count + i + 1) as f64 / (ROUND_COUNT * count) as f64);
            }
            if started.elapsed().as_secs_f64() > COURSE_SECS {
                return Ok((runs, round + 1));
            }
        }
        Ok((runs, ROUND_COUNT))
    }
}

/// Goes the way once, all followers frame by frame, and looks at what they show. Fans have to show the same whatever they
/// remember.
fn rehearse<'a>(
    stage: &'a Stage,
    models: &Models<'_>,
    followers: &mut [Option<Box<dyn Follower<'a> + 'a>>],
    log: &'a Log,
) -> Result<Vec<Option<Run>>, Failure> {
    let mesh = &models.refinable.mesh;
    let mut runs: Vec<Option<Run>> =
        followers.iter().map(|follower| follower.as_ref().map(|_| Run::of(stage))).collect();
    for (frame, seen_from) in stage.frames.iter().enumerate() {
        let watched = stage.is_watched(frame).then(|| Watched::new(mesh, seen_from));
        let mut shown: Vec<(Vec<[u32; 3]>, SeenErrors)> = Vec::new();
        for (i, (follower, run)) in followers.iter_mut().zip(&mut runs).enumerate() {
            let (Some(follower), Some(run)) = (follower, run) else { continue };
            log.clear();
            let changes = follower.follow(stage.view(frame), Some(log));
            run.asked.push(log.asked_count());
            run.changes.push(changes.split_count + changes.collapse_count);
            run.criterion_secs.push(log.weighing_secs(&stage.screens[frame]));
            run.instance_bytes = run.instance_bytes.max(follower.instance_bytes());
            let mut indices = Vec::new();
            follower.emit_into(&mut indices);
            run.triangles.push(indices.len() / 3);
            let Some(watched) = &watched else { continue };
            let triangles = canonical_triangles(indices.as_chunks().0);
            let fans = shown.get(FANS).map(|(fans, _)| fans);
            if matches!(i, KEPT | STATELESS) && fans != Some(&triangles) {
                let name = NAMES[i];
                return Err(Failure::internal(format!(
                    "{name} and fans show different things in frame {frame}"
                )));
            }
            let errors = match shown.iter().find(|(other, _)| *other == triangles) {
                Some((_, errors)) => errors.clone(),
                None => watched.errors(mesh, &triangles)?,
            };
            run.errors.join(&errors);
            shown.push((triangles, errors));
        }
    }
    Ok(runs)
}

impl Run {
    fn of(stage: &Stage) -> Self {
        let unknown = vec![f64::INFINITY; stage.frames.len()];
        Self { follow_secs: unknown.clone(), emission_secs: unknown, ..Self::default() }
    }

    /// Goes the way against the clock.
    fn time<'a>(&mut self, stage: &'a Stage, follower: &mut (dyn Follower<'a> + 'a), buffer: &mut Vec<u32>) {
        follower.restart();
        for frame in 0..stage.frames.len() {
            let started = Instant::now();
            follower.follow(stage.view(frame), None);
            let followed = started.elapsed().as_secs_f64();
            buffer.clear();
            follower.emit_into(buffer);
            black_box(&*buffer);
            let emitted = started.elapsed().as_secs_f64() - followed;
            self.follow_secs[frame] = self.follow_secs[frame].min(followed);
            self.emission_secs[frame] = self.emission_secs[frame].min(emitted);
        }
    }

    /// Seconds of the criterion in a frame: no more than the whole took.
    pub(super) fn criterion(&self, frame: usize) -> f64 {
        self.criterion_secs[frame].min(self.follow_secs[frame])
    }

    /// Seconds of a frame's changes.
    pub(super) fn update(&self, frame: usize) -> f64 {
        self.follow_secs[frame] - self.criterion(frame)
    }

    /// Frames that have one before them.
    pub(super) fn later_frames(&self) -> std::ops::Range<usize> {
        1..self.triangles.len()
    }

    /// Seconds of a frame in all.
    pub(super) fn whole(&self, frame: usize) -> f64 {
        self.follow_secs[frame] + self.emission_secs[frame]
    }
}
