//! Figures computed from a run: means, the worst frame, and a series for charts.

use serde::Serialize;

use super::super::walks::{mean, thinned};
use super::scenario::ScenarioRun;

/// Figures of one follower in one scenario.
#[derive(Clone, Debug, Serialize)]
pub(super) struct Figures {
    /// Mean time per frame to evaluate the criterion.
    pub criterion_ms: f64,
    /// Mean time per frame to apply changes.
    pub update_ms: f64,
    /// Mean time per frame of criterion and update together.
    pub follow_ms: f64,
    /// Mean time per frame to write the indices.
    pub emission_ms: f64,
    /// Mean total time per frame.
    pub frame_ms: f64,
    /// Total time of the slowest frame after the first.
    pub worst_ms: f64,
    /// Criterion and update time of the first frame, which begins at the base.
    pub first_ms: f64,
    /// Mean criterion and update time, and mean total time, as multiples of those of fans.
    pub ratio_to_fans: f64,
    pub frame_ratio_to_fans: f64,
    /// Mean number of triangles shown.
    pub triangles: f64,
    /// Mean number of steps evaluated.
    pub asked_per_frame: f64,
    /// Mean number of splits and collapses after the first frame.
    pub changes_per_frame: f64,
    /// Splits and collapses per second of criterion and update time; null if that time is negligible.
    pub changes_per_sec: Option<f64>,
    /// The largest distance of a point from where it should be, in pixels; null if no point is visible.
    pub max_error_px: Option<f64>,
    /// The 99th percentile of these distances, in pixels.
    pub p99_error_px: Option<f64>,
    /// Static bytes per vertex, without positions and normals.
    bytes_per_vertex: f64,
    /// Including positions, and normals of 4 bytes.
    bytes_per_vertex_packed: f64,
    /// Including positions, and normals of 12 bytes.
    bytes_per_vertex_plain: f64,
    /// Maximum bytes owned by the instance.
    pub bytes_per_instance: usize,
    /// Maximum bytes owned by the instance, per vertex of the full mesh.
    pub instance_bytes_per_vertex: f64,
    /// Maximum bytes owned by the instance, per vertex of the full mesh, without indices that can be drawn as is.
    state_bytes_per_vertex: f64,
    /// Values by frame.
    pub series: Series,
}

/// Values of some frames of a run, evenly spaced.
#[derive(Clone, Debug, Serialize)]
pub(super) struct Series {
    /// Indices of these frames.
    pub frame: Vec<usize>,
    /// Number of triangles shown.
    pub triangles: Vec<usize>,
    asked: Vec<usize>,
    changes: Vec<usize>,
    /// Time of criterion and update.
    pub follow_ms: Vec<f64>,
    /// Time to write the indices.
    pub emission_ms: Vec<f64>,
}

/// Shorter times may be due to reading the clock alone.
const MIN_MS: f64 = 2e-4;

/// Bytes of a position, of a packed normal, and of a plain normal.
pub(super) const POSITION_BYTES: f64 = 12.0;
pub(super) const PACKED_NORMAL_BYTES: f64 = size_of::<[i16; 2]>() as f64;
pub(super) const NORMAL_BYTES: f64 = 12.0;

impl Figures {
    /// Computes the figures of a run, relative to those of fans, for a model of `static_bytes` and a mesh
    /// of `vertex_count`.
    pub(super) fn new(
        run: &ScenarioRun,
        fans: &ScenarioRun,
        static_bytes: usize,
        vertex_count: usize,
    ) -> Self {
        let bytes_per_vertex = static_bytes as f64 / vertex_count as f64;
        let frames = run.later_frames();
        let ms = |secs: &dyn Fn(usize) -> f64| 1e3 * mean(frames.clone().map(secs));
        let criterion_ms = ms(&|frame| run.criterion(frame));
        let update_ms = ms(&|frame| run.update(frame));
        let emission_ms = ms(&|frame| run.emission_secs[frame]);
        let (follow_ms, frame_ms) = (criterion_ms + update_ms, criterion_ms + update_ms + emission_ms);
        let fans_follow_ms = 1e3 * mean(fans.later_frames().map(|frame| fans.follow_secs[frame]));
        let fans_frame_ms = 1e3 * mean(fans.later_frames().map(|frame| fans.whole(frame)));
        let count = |counts: &[usize]| mean(frames.clone().map(|frame| counts[frame] as f64));
        let (asked_per_frame, changes_per_frame) = (count(&run.evaluated), count(&run.changes));
        let ratio = |a: f64, b: f64| if b > 0.0 { a / b } else { 0.0 };
        Self {
            criterion_ms,
            update_ms,
            follow_ms,
            emission_ms,
            frame_ms,
            worst_ms: 1e3 * frames.clone().map(|frame| run.whole(frame)).fold(0.0, f64::max),
            first_ms: 1e3 * run.follow_secs[0],
            ratio_to_fans: ratio(follow_ms, fans_follow_ms),
            frame_ratio_to_fans: ratio(frame_ms, fans_frame_ms),
            triangles: count(&run.triangles),
            asked_per_frame,
            changes_per_frame,
            // A follower that evaluates nothing jumps to a level and has no step-by-step changes.
            changes_per_sec: (asked_per_frame > 0.0 && follow_ms > MIN_MS)
                .then(|| 1e3 * changes_per_frame / follow_ms),
            max_error_px: run.errors.max(),
            p99_error_px: run.errors.p99(),
            bytes_per_vertex,
            bytes_per_vertex_packed: bytes_per_vertex + POSITION_BYTES + PACKED_NORMAL_BYTES,
            bytes_per_vertex_plain: bytes_per_vertex + POSITION_BYTES + NORMAL_BYTES,
            bytes_per_instance: run.instance_bytes,
            instance_bytes_per_vertex: run.instance_bytes as f64 / vertex_count as f64,
            state_bytes_per_vertex: run.state_bytes as f64 / vertex_count as f64,
            series: Series::of(run),
        }
    }
}

impl Series {
    fn of(run: &ScenarioRun) -> Self {
        let frame = thinned(run.triangles.len());
        let counts = |all: &[usize]| frame.iter().map(|&frame| all[frame]).collect();
        let ms = |all: &[f64]| frame.iter().map(|&frame| 1e3 * all[frame]).collect();
        Self {
            triangles: counts(&run.triangles),
            asked: counts(&run.evaluated),
            changes: counts(&run.changes),
            follow_ms: ms(&run.follow_secs),
            emission_ms: ms(&run.emission_secs),
            frame,
        }
    }
}
