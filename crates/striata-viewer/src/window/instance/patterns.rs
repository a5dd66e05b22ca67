//! Moves an instance of patterns to a uniform or view-dependent level.

use striata::model::{Overlap, PatternChange, PatternInstance};
use striata::view::{Criterion, ScreenError};

use super::level_request::{AchievedLevel, LevelRequest, uniform};
use crate::window::mesh_subject::MeshSubject;
use crate::window::state::Goal;

/// Moves to the requested level; returns whether anything changed, and the level reached.
pub(super) fn follow_patterns(
    instance: &mut PatternInstance,
    subject: &MeshSubject,
    request: &LevelRequest,
    split_count: usize,
) -> (bool, AchievedLevel) {
    let Some(scene) = subject.pattern_scene() else { return (false, AchievedLevel::default()) };
    let patterns = scene.patterns();
    let (Goal::Pixels(pixels), Some(camera)) = (request.goal, request.camera) else {
        let first_unrefined = split_count as u32;
        let change = instance.adapt(patterns, &|overlap: Overlap| overlap.upper < first_unrefined);
        return (change != PatternChange::default(), uniform(subject, split_count));
    };
    let criterion = ScreenError::new(camera, pixels);
    let is_wanted = |overlap: Overlap| criterion.weigh(&scene.part(overlap.upper)).should_refine();
    let change = instance.adapt(patterns, &is_wanted);
    let mut unrefined = (0..patterns.fragment_count() as u32).filter(|&step| !instance.is_refined(step));
    let achieved = AchievedLevel {
        split_count: instance.split_count(),
        triangle_count: instance.triangle_count(),
        error: unrefined.next().map_or(0.0, |step| scene.part(step).error),
        error_px: Some(pixels),
        ..AchievedLevel::default()
    };
    (change != PatternChange::default(), achieved)
}
