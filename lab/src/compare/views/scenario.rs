//! Runs all followers along one path: first a rehearsal that inspects what they show, then timed rounds.
//!
//! In each round every follower runs the whole path, one after the other, and each round starts with a
//! different follower; per frame, the fastest time of all rounds counts. The rehearsal measures the time
//! of the criterion; the rest of the follow time is the update.

use std::hint::black_box;
use std::time::Instant;

use striata::mesh::{IndexedMesh, canonical_triangles};
use striata::view::ScreenError;

use super::followers::{FANS, KEPT, ModelFollower, Models, NAMES, STATELESS, VDPM, VDPM_KEPT, View};
use super::logged_criterion::QueryLog;
use super::paths::{Path, PathFrame};
use super::screen_errors::{ScreenErrors, VisiblePoints};
use striata_command::failure::Failure;

/// Maximum number of rounds.
const ROUND_COUNT: usize = 4;

/// No further round of a path starts after this many seconds.
const MAX_SECS: f64 = 4.5;

/// Number of frames of a path in which errors are measured.
const INSPECTED_FRAMES: usize = 8;

/// A path and the allowed screen error.
#[derive(Clone, Copy, Debug)]
pub(super) struct Scenario {
    /// The path of the camera.
    pub path: Path,
    /// Allowed screen error in pixels.
    pub pixels: f32,
}

/// Measurements of one follower in one scenario, by frame.
#[derive(Clone, Debug, Default)]
pub(super) struct ScenarioRun {
    /// Seconds to evaluate the criterion and apply changes, fastest round.
    pub follow_secs: Vec<f64>,
    /// Seconds to evaluate the criterion, measured separately.
    pub criterion_secs: Vec<f64>,
    /// Seconds to write the indices.
    pub emission_secs: Vec<f64>,
    /// Number of steps evaluated.
    pub evaluated: Vec<usize>,
    /// Number of splits and collapses.
    pub changes: Vec<usize>,
    /// Number of triangles shown.
    pub triangles: Vec<usize>,
    /// Maximum bytes owned by the instance.
    pub instance_bytes: usize,
    /// Maximum bytes owned by the instance, without indices that can be drawn as they are.
    pub state_bytes: usize,
    /// Errors on the screen.
    pub errors: ScreenErrors,
}

/// The frames of a scenario with the criterion and uniform level of each.
struct ScenarioFrames {
    frames: Vec<PathFrame>,
    screens: Vec<ScreenError>,
    split_counts: Vec<usize>,
}

impl ScenarioFrames {
    fn new(scenario: Scenario, models: &Models<'_>) -> Result<Self, Failure> {
        let mesh = &models.refinable.mesh;
        let frames = scenario.path.frames(mesh);
        let model = models.scene().sphere();
        let screen = |frame: &PathFrame| {
            let camera = frame.camera().map_err(|error| Failure::internal(error.to_string()))?;
            Ok::<_, Failure>(ScreenError::new(camera, scenario.pixels).with_model_bounds(model))
        };
        let screens = frames.iter().map(screen).collect::<Result<_, _>>()?;
        let sequence = &models.refinable.sequence;
        let split_count = |frame: &PathFrame| match max_pixels_per_unit(mesh, frame) {
            Some(pixels) => sequence.split_count_for_error(f64::from(scenario.pixels) / pixels),
            None => 0,
        };
        let split_counts = frames.iter().map(split_count).collect();
        Ok(Self { frames, screens, split_counts })
    }

    fn view(&self, frame: usize) -> View<'_> {
        View { screen: &self.screens[frame], split_count: self.split_counts[frame] }
    }

    fn is_inspected(&self, frame: usize) -> bool {
        let every = self.frames.len().div_ceil(INSPECTED_FRAMES).max(1);
        // Avoids the first frame, in which all followers begin at the base.
        frame % every == every / 2
    }
}

/// The largest number of pixels per unit length at any visible vertex, which is where the surface is nearest.
fn max_pixels_per_unit(mesh: &IndexedMesh, frame: &PathFrame) -> Option<f64> {
    mesh.positions.iter().filter_map(|point| frame.pixels_at(point.map(f64::from))).reduce(f64::max)
}

impl Scenario {
    /// Runs all followers. Returns a run for each of [`NAMES`], and the number of rounds.
    ///
    /// # Errors
    /// If a follower shows wrong triangles, which would be a bug.
    pub(super) fn run(
        self,
        models: &Models<'_>,
        show: &mut dyn FnMut(f64),
    ) -> Result<(Vec<Option<ScenarioRun>>, usize), Failure> {
        let scenario_frames = ScenarioFrames::new(self, models)?;
        let log = QueryLog::default();
        let mut followers: Vec<Option<Box<dyn ModelFollower<'_> + '_>>> =
            models.followers().into_iter().map(Result::ok).collect();
        let mut runs = rehearse(&scenario_frames, models, &mut followers, &log)?;
        let started = Instant::now();
        let (mut buffer, count) = (Vec::new(), followers.len());
        for round in 0..ROUND_COUNT {
            for i in 0..count {
                let at = (round + i) % count;
                if let (Some(follower), Some(run)) = (&mut followers[at], &mut runs[at]) {
                    run.time(&scenario_frames, &mut **follower, &mut buffer);
                }
                show((round * count + i + 1) as f64 / (ROUND_COUNT * count) as f64);
            }
            if started.elapsed().as_secs_f64() > MAX_SECS {
                return Ok((runs, round + 1));
            }
        }
        Ok((runs, ROUND_COUNT))
    }
}

/// Runs the path once, with all followers frame by frame, and inspects what they show. All variants of
/// fans have to show the same triangles.
fn rehearse<'a>(
    scenario_frames: &'a ScenarioFrames,
    models: &Models<'_>,
    followers: &mut [Option<Box<dyn ModelFollower<'a> + 'a>>],
    log: &'a QueryLog,
) -> Result<Vec<Option<ScenarioRun>>, Failure> {
    let mesh = &models.refinable.mesh;
    let mut runs: Vec<Option<ScenarioRun>> = followers
        .iter()
        .map(|follower| follower.as_ref().map(|_| ScenarioRun::of(scenario_frames)))
        .collect();
    for (frame, camera_frame) in scenario_frames.frames.iter().enumerate() {
        let points = scenario_frames.is_inspected(frame).then(|| VisiblePoints::new(mesh, camera_frame));
        let mut shown: Vec<(Vec<[u32; 3]>, ScreenErrors)> = Vec::new();
        for (i, (follower, run)) in followers.iter_mut().zip(&mut runs).enumerate() {
            let (Some(follower), Some(run)) = (follower, run) else { continue };
            log.clear();
            let changes = follower.follow(scenario_frames.view(frame), Some(log));
            run.evaluated.push(changes.evaluated.unwrap_or_else(|| log.evaluated_count()));
            run.changes.push(changes.split_count + changes.collapse_count);
            run.criterion_secs.push(log.evaluation_secs(&scenario_frames.screens[frame]));
            let owned = follower.instance_bytes();
            run.instance_bytes = run.instance_bytes.max(owned);
            run.state_bytes = run.state_bytes.max(owned - follower.index_bytes());
            let mut indices = Vec::new();
            follower.emit_into(&mut indices);
            run.triangles.push(indices.len() / 3);
            let Some(points) = &points else { continue };
            let triangles = canonical_triangles(indices.as_chunks().0);
            let same_as = match i {
                KEPT | STATELESS => Some(FANS),
                VDPM_KEPT => Some(VDPM),
                _ => None,
            };
            if let Some(other) = same_as
                && shown.get(other).map(|(other, _)| other) != Some(&triangles)
            {
                let [name, other] = [i, other].map(|i| NAMES[i]);
                let message = format!("{name} and {other} show different triangles in frame {frame}");
                return Err(Failure::internal(message));
            }
            let errors = match shown.iter().find(|(other, _)| *other == triangles) {
                Some((_, errors)) => errors.clone(),
                None => points.errors(mesh, &triangles)?,
            };
            run.errors.merge(&errors);
            shown.push((triangles, errors));
        }
    }
    Ok(runs)
}

impl ScenarioRun {
    fn of(scenario_frames: &ScenarioFrames) -> Self {
        let unmeasured = vec![f64::INFINITY; scenario_frames.frames.len()];
        Self { follow_secs: unmeasured.clone(), emission_secs: unmeasured, ..Self::default() }
    }

    /// Runs the path under the clock.
    fn time<'a>(
        &mut self,
        scenario_frames: &'a ScenarioFrames,
        follower: &mut (dyn ModelFollower<'a> + 'a),
        buffer: &mut Vec<u32>,
    ) {
        follower.restart();
        for frame in 0..scenario_frames.frames.len() {
            let started = Instant::now();
            follower.follow(scenario_frames.view(frame), None);
            let followed = started.elapsed().as_secs_f64();
            buffer.clear();
            follower.emit_into(buffer);
            black_box(&*buffer);
            let emitted = started.elapsed().as_secs_f64() - followed;
            self.follow_secs[frame] = self.follow_secs[frame].min(followed);
            self.emission_secs[frame] = self.emission_secs[frame].min(emitted);
        }
    }

    /// Seconds of the criterion in a frame, limited to the whole follow time.
    pub(super) fn criterion(&self, frame: usize) -> f64 {
        self.criterion_secs[frame].min(self.follow_secs[frame])
    }

    /// Seconds of a frame's changes.
    pub(super) fn update(&self, frame: usize) -> f64 {
        self.follow_secs[frame] - self.criterion(frame)
    }

    /// All frames except the first.
    pub(super) fn later_frames(&self) -> std::ops::Range<usize> {
        1..self.triangles.len()
    }

    /// Total seconds of a frame.
    pub(super) fn whole(&self, frame: usize) -> f64 {
        self.follow_secs[frame] + self.emission_secs[frame]
    }
}
