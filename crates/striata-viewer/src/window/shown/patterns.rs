//! Patterns that are shown, of a view or the same everywhere.

use striata::model::{Overlap, PatternChange, PatternInstance};
use striata::view::{Criterion, ScreenError};

use super::wish::{Achieved, Wish, uniform};
use crate::window::state::Goal;
use crate::window::subject::Subject;

/// Whether anything changed, and what came of it.
pub(super) fn follow_patterns(
    instance: &mut PatternInstance,
    subject: &Subject,
    wish: &Wish,
    split_count: usize,
) -> (bool, Achieved) {
    let Some(scene) = subject.pattern_scene() else { return (false, Achieved::default()) };
    let patterns = scene.patterns();
    let (Goal::Pixels(pixels), Some(camera)) = (wish.goal, wish.camera) else {
        let first_left_out = split_count as u32;
        let change = instance.adapt(patterns, &|overlap: Overlap| overlap.upper < first_left_out);
        return (change != PatternChange::default(), uniform(subject, split_count));
    };
    let criterion = ScreenError::new(camera, pixels);
    let is_wanted = |overlap: Overlap| criterion.weigh(&scene.part(overlap.upper)).should_refine();
    let change = instance.adapt(patterns, &is_wanted);
    let mut left_out = (0..patterns.fragment_count() as u32).filter(|&step| !instance.is_refined(step));
    let achieved = Achieved {
        split_count: instance.split_count(),
        triangle_count: instance.triangle_count(),
        error: left_out.next().map_or(0.0, |step| scene.part(step).error),
        error_px: Some(pixels),
        ..Achieved::default()
    };
    (change != PatternChange::default(), achieved)
}
