//! What is told of a run: means, the worst frame, and a series for charts.

use serde::Serialize;

use super::super::walks::{mean, thinned};
use super::course::Run;

/// A follower on a course.
#[derive(Clone, Debug, Serialize)]
pub(super) struct Figures {
    /// Of a frame: questions, the mean.
    pub(super) criterion_ms: f64,
    /// Of a frame: changes, the mean.
    pub(super) update_ms: f64,
    /// Criterion and update together, the mean per frame.
    pub(super) follow_ms: f64,
    /// Of a frame: making the indices, the mean.
    pub(super) emission_ms: f64,
    /// All of these, the mean.
    pub(super) frame_ms: f64,
    /// All of these in the slowest frame after the first.
    pub(super) worst_ms: f64,
    /// Questions and changes of the first frame, which begins at the base.
    pub(super) first_ms: f64,
    /// Mean of questions and changes, and of all, as multiples of those of fans.
    pub(super) ratio_to_fans: f64,
    pub(super) frame_ratio_to_fans: f64,
    /// Shown, the mean.
    pub(super) triangles: f64,
    /// Steps whose weight was asked for, the mean.
    pub(super) asked_per_frame: f64,
    /// Splits and collapses, the mean after the first frame.
    pub(super) changes_per_frame: f64,
    /// Of the time of questions and changes; null where that is next to nothing.
    pub(super) changes_per_sec: Option<f64>,
    /// The largest distance to where a point should be, in pixels; null where none is in the picture.
    pub(super) max_error_px: Option<f64>,
    /// What 99 of 100 points do not exceed.
    pub(super) p99_error_px: Option<f64>,
    /// Of what is built once, without positions and normals.
    bytes_per_vertex: f64,
    /// With positions, and normals of 4 bytes.
    bytes_per_vertex_packed: f64,
    /// With positions, and normals of 12 bytes.
    bytes_per_vertex_plain: f64,
    /// The most that the instance owned on the way.
    pub(super) bytes_per_instance: usize,
    /// The largest size of the instance, per vertex of the full mesh.
    pub(super) instance_bytes_per_vertex: f64,
    /// Frame by frame.
    pub(super) series: Series,
}

/// Some frames of a run, evenly spread.
#[derive(Clone, Debug, Serialize)]
pub(super) struct Series {
    /// Which frames these are.
    pub(super) frame: Vec<usize>,
    /// Shown.
    pub(super) triangles: Vec<usize>,
    asked: Vec<usize>,
    changes: Vec<usize>,
    /// Questions and changes.
    pub(super) follow_ms: Vec<f64>,
    /// Making the indices.
    pub(super) emission_ms: Vec<f64>,
}

/// What takes no longer may as well be looking at the clock.
const LEAST_MS: f64 = 2e-4;

/// Bytes of a position, and of a normal packed and plain.
pub(super) const POSITION_BYTES: f64 = 12.0;
pub(super) const PACKED_NORMAL_BYTES: f64 = size_of::<[i16; 2]>() as f64;
pub(super) const NORMAL_BYTES: f64 = 12.0;

impl Figures {
    /// The figures of a run next to those of fans, for a model of `static_bytes` and a mesh of `vertex_count`.
    pub(super) fn new(run: &Run, fans: &Run, static_bytes: usize, vertex_count: usize) -> Self {
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
        let (asked_per_frame, changes_per_frame) = (count(&run.asked), count(&run.changes));
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
            // Who asks nothing sets a level at once, and changes nothing step by step.
            changes_per_sec: (asked_per_frame > 0.0 && follow_ms > LEAST_MS)
                .then(|| 1e3 * changes_per_frame / follow_ms),
            max_error_px: run.errors.max(),
            p99_error_px: run.errors.p99(),
            bytes_per_vertex,
            bytes_per_vertex_packed: bytes_per_vertex + POSITION_BYTES + PACKED_NORMAL_BYTES,
            bytes_per_vertex_plain: bytes_per_vertex + POSITION_BYTES + NORMAL_BYTES,
            bytes_per_instance: run.instance_bytes,
            instance_bytes_per_vertex: run.instance_bytes as f64 / vertex_count as f64,
            series: Series::of(run),
        }
    }
}

impl Series {
    fn of(run: &Run) -> Self {
        let frame = thinned(run.triangles.len());
        let counts = |all: &[usize]| frame.iter().map(|&frame| all[frame]).collect();
        let ms = |all: &[f64]| frame.iter().map(|&frame| 1e3 * all[frame]).collect();
        Self {
            triangles: counts(&run.triangles),
            asked: counts(&run.asked),
            changes: counts(&run.changes),
            follow_ms: ms(&run.follow_secs),
            emission_ms: ms(&run.emission_secs),
            frame,
        }
    }
}
