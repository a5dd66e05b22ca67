//! A request for a level, and the level that was reached.

use striata::view::Camera;

use crate::window::mesh_subject::MeshSubject;
use crate::window::state::Goal;

/// A request for a level.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::window) struct LevelRequest {
    pub goal: Goal,
    /// Camera for view-dependent levels; none if there is no picture.
    pub camera: Option<Camera>,
    /// Whether changes are animated by geomorphs.
    pub morphs: bool,
}

/// Properties of the level that was reached.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(in crate::window) struct AchievedLevel {
    /// Number of refined steps.
    pub split_count: usize,
    pub triangle_count: usize,
    /// Largest error, mesh units.
    pub error: f32,
    /// Screen error in pixels, for view-dependent levels.
    pub error_px: Option<f32>,
    /// Number of steps in motion.
    pub moving_count: usize,
    /// Time taken to reach the level, seconds.
    pub secs: f64,
}

/// Split count of the uniform level for a request.
pub(super) fn split_count_for(subject: &MeshSubject, request: &LevelRequest) -> usize {
    let levels = subject.steps.levels();
    match request.goal {
        Goal::Detail(detail) => levels.split_count_for_detail(detail),
        Goal::Triangles(count) | Goal::Budget(count) => levels.split_count_for_triangles(count),
        Goal::Pixels(pixels) => {
            let unit_px =
                request.camera.map_or(f32::INFINITY, |camera| camera.error_px(1.0, &subject.sphere));
            levels.split_count_for_error(f64::from(pixels / unit_px))
        }
    }
}

/// Properties of a uniform level.
pub(super) fn uniform(subject: &MeshSubject, split_count: usize) -> AchievedLevel {
    let levels = subject.steps.levels();
    AchievedLevel {
        split_count,
        triangle_count: levels.triangle_count_at(split_count),
        error: levels.error_at(split_count),
        ..AchievedLevel::default()
    }
}
