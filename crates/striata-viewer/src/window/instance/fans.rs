//! An instance of fans: uniform or view-dependent, with geomorphs if requested.

use std::ops::Range;

use striata::model::{FanFront, FanInstance, FanMorphs, FanScene, FanTriangles};
use striata::view::ScreenError;

use super::level_request::{AchievedLevel, LevelRequest};
use crate::window::mesh_subject::MeshSubject;
use crate::window::state::Goal;

/// Screen errors below this many pixels count as equal to a budget, which keeps its weights finite.
const MIN_PIXELS: f32 = 1e-6;

/// Duration of a geomorph, frames.
pub(super) const MORPH_FRAMES: u16 = 24;

/// State of an instance of fans.
#[derive(Debug)]
pub(super) struct ShownFans {
    front: FanFront<ScreenError>,
    /// Split count and instance of a uniform level; none for view-dependent levels.
    uniform: Option<(usize, FanInstance)>,
    /// The instance to draw: the requested level, and vertices that are still moving out.
    pub drawn: FanInstance,
    /// Triangles of `drawn`; none if the GPU extracts them.
    pub triangles: Option<FanTriangles>,
    pub morphs: Option<FanMorphs>,
}

impl ShownFans {
    /// Starts with the front's initial level. `has_triangles` is false if the GPU extracts the triangles.
    pub(super) fn new(scene: &FanScene<'_>, has_triangles: bool) -> Self {
        let front = FanFront::new(scene);
        let drawn = front.instance().clone();
        let triangles = has_triangles.then(|| FanTriangles::new(scene.fans(), &drawn));
        Self { front, uniform: None, drawn, triangles, morphs: None }
    }

    /// Moves to the requested level; returns whether the picture changed, and the level reached.
    pub(super) fn follow(
        &mut self,
        subject: &MeshSubject,
        request: &LevelRequest,
        split_count: usize,
    ) -> (bool, AchievedLevel) {
        let Some(scene) = subject.fan_scene() else { return (false, AchievedLevel::default()) };
        let mut error_px = None;
        match (request.goal, request.camera) {
            (Goal::Pixels(pixels), Some(camera)) => {
                self.uniform = None;
                let criterion = ScreenError::new(camera, pixels).with_model_bounds(subject.sphere);
                self.front.update(&scene, &criterion, usize::MAX);
                error_px = Some(pixels);
            }
            (Goal::Budget(limit), Some(camera)) => {
                self.uniform = None;
                let criterion = ScreenError::new(camera, MIN_PIXELS).with_model_bounds(subject.sphere);
                let update = self.front.update_to_budget(&scene, &criterion, limit);
                error_px = Some(criterion.pixels() * update.threshold).filter(|pixels| pixels.is_finite());
            }
            _ if self.uniform.as_ref().is_none_or(|(current, _)| *current != split_count) => {
                self.uniform = Some((split_count, FanInstance::uniform(scene.fans(), split_count)));
            }
            _ => {}
        }
        let target = self.uniform.as_ref().map_or(self.front.instance(), |(_, instance)| instance);
        let was_moving = self.morphs.as_ref().is_some_and(|morphs| morphs.moving_count() > 0);
        // Without collapses, a vertex has no place to come from.
        if request.morphs && subject.has_collapses() {
            let morphs = self.morphs.get_or_insert_with(|| FanMorphs::new(&self.drawn, MORPH_FRAMES));
            morphs.advance(scene.fans(), target);
        } else {
            self.morphs = None;
        }
        let drawn = self.morphs.as_ref().map_or(target, FanMorphs::drawn);
        let is_changed = self.drawn != *drawn;
        if is_changed {
            self.drawn.clone_from(drawn);
            if let Some(triangles) = &mut self.triangles {
                triangles.follow(scene.fans(), drawn);
            }
        }
        let levels = subject.steps.levels();
        let coarsest = (0..levels.step_count()).find(|&step| !target.is_refined(step as u32));
        let moving_count = self.morphs.as_ref().map_or(0, FanMorphs::moving_count);
        let achieved = AchievedLevel {
            split_count: target.split_count(),
            triangle_count: match self.uniform {
                Some((split_count, _)) => levels.triangle_count_at(split_count),
                None => self.front.triangle_count(),
            },
            error: coarsest.map_or(0.0, |step| levels.error_at(step)),
            error_px,
            moving_count,
            secs: 0.0,
        };
        (is_changed || was_moving || moving_count > 0, achieved)
    }

    /// Writes the triangles group by group, unless the GPU extracts them.
    pub(super) fn indices_into(&self, indices: &mut Vec<u32>, groups: &mut Vec<Range<u32>>) {
        let Some(triangles) = &self.triangles else { return };
        indices.clear();
        indices.extend_from_slice(triangles.indices());
        groups.clear();
        groups.extend_from_slice(triangles.group_ranges());
    }
}
