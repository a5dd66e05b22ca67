//! What a level is to be, and what it is.

use striata::view::Camera;

use crate::window::state::Goal;
use crate::window::subject::Subject;

/// What a level is to be.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::window) struct Wish {
    pub(in crate::window) goal: Goal,
    /// The view that it is for, where the level depends on it; none where there is no picture, either.
    pub(in crate::window) camera: Option<Camera>,
    /// Whether changes are motions.
    pub(in crate::window) morphs: bool,
}

/// What a level is.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(in crate::window) struct Achieved {
    /// Steps that are undone.
    pub(in crate::window) split_count: usize,
    pub(in crate::window) triangle_count: usize,
    /// Mesh units.
    pub(in crate::window) error: f32,
    /// The same on the screen, where the level was made for a view.
    pub(in crate::window) error_px: Option<f32>,
    /// Steps that move.
    pub(in crate::window) moving_count: usize,
    /// Time that it took.
    pub(in crate::window) secs: f64,
}

/// The level that a wish comes to where all of a mesh has the same.
pub(super) fn split_count_for(subject: &Subject, wish: &Wish) -> usize {
    let levels = subject.steps.levels();
    match wish.goal {
        Goal::Detail(detail) => levels.split_count_for_detail(detail),
        Goal::Triangles(count) | Goal::Budget(count) => levels.split_count_for_triangles(count),
        Goal::Pixels(pixels) => {
            let unit_px = wish.camera.map_or(f32::INFINITY, |camera| camera.error_px(1.0, &subject.sphere));
            levels.split_count_for_error(f64::from(pixels / unit_px))
        }
    }
}

/// What a level is that is the same everywhere.
pub(super) fn uniform(subject: &Subject, split_count: usize) -> Achieved {
    let levels = subject.steps.levels();
    Achieved {
        split_count,
        triangle_count: levels.triangle_count_at(split_count),
        error: levels.error_at(split_count),
        ..Achieved::default()
    }
}
