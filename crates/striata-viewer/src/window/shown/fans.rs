//! Fans that are shown: of a view or the same everywhere, at rest or on their way.

use std::ops::Range;

use striata::model::{FanFront, FanInstance, FanMorphs, FanScene, FanTriangles};
use striata::view::ScreenError;

use super::indices::ranges_of_groups;
use super::wish::{Achieved, Wish};
use crate::window::state::Goal;
use crate::window::subject::Subject;

/// Errors of fewer pixels than this are no smaller to a budget, so that what weighs them stays a number.
const LEAST_PIXELS: f32 = 1e-6;

/// Frames that a motion takes.
pub(super) const MORPH_FRAMES: u16 = 24;

#[derive(Debug)]
pub(super) struct FansShown {
    front: FanFront<ScreenError>,
    /// Where a level is the same everywhere; its split count.
    uniform: Option<(usize, FanInstance)>,
    /// The instance that is drawn: what is wanted, and what is still on its way out.
    pub(super) drawn: FanInstance,
    /// Its triangles, where they are not made on the GPU.
    pub(super) triangles: Option<FanTriangles>,
    pub(super) morphs: Option<FanMorphs>,
}

impl FansShown {
    /// Whatever the front begins with; its triangles are kept unless the GPU makes them.
    pub(super) fn new(scene: &FanScene<'_>, has_triangles: bool) -> Self {
        let front = FanFront::new(scene);
        let drawn = front.instance().clone();
        let triangles = has_triangles.then(|| FanTriangles::new(scene.fans(), &drawn));
        Self { front, uniform: None, drawn, triangles, morphs: None }
    }

    /// Whether anything changed, and what came of it.
    pub(super) fn follow(&mut self, subject: &Subject, wish: &Wish, split_count: usize) -> (bool, Achieved) {
        let Some((scene, refinable)) = subject.fan_scene() else { return (false, Achieved::default()) };
        let mut error_px = None;
        match (wish.goal, wish.camera) {
            (Goal::Pixels(pixels), Some(camera)) => {
                self.uniform = None;
                let criterion = ScreenError::new(camera, pixels).with_model_bounds(subject.sphere);
                self.front.update(&scene, &criterion, usize::MAX);
                error_px = Some(pixels);
            }
            (Goal::Budget(limit), Some(camera)) => {
                self.uniform = None;
                let criterion = ScreenError::new(camera, LEAST_PIXELS).with_model_bounds(subject.sphere);
                let update = self.front.update_to_budget(&scene, &criterion, limit);
                error_px = Some(criterion.pixels() * update.threshold).filter(|pixels| pixels.is_finite());
            }
            _ if self.uniform.as_ref().is_none_or(|(shown, _)| *shown != split_count) => {
                self.uniform = Some((split_count, FanInstance::uniform(scene.fans(), split_count)));
            }
            _ => {}
        }
        let wanted = self.uniform.as_ref().map_or(self.front.instance(), |(_, instance)| instance);
        let was_moving = self.morphs.as_ref().is_some_and(|morphs| morphs.moving_count() > 0);
        if wish.morphs {
            let morphs = self.morphs.get_or_insert_with(|| FanMorphs::new(&self.drawn, MORPH_FRAMES));
            morphs.advance(scene.fans(), wanted);
        } else {
            self.morphs = None;
        }
        let drawn = self.morphs.as_ref().map_or(wanted, FanMorphs::drawn);
        let is_changed = self.drawn != *drawn;
        if is_changed {
            self.drawn.clone_from(drawn);
            if let Some(triangles) = &mut self.triangles {
                triangles.follow(scene.fans(), &refinable.sequence, drawn);
            }
        }
        let levels = refinable.sequence.levels();
        let coarsest = (0..levels.step_count()).find(|&step| !wanted.is_refined(step as u32));
        let moving_count = self.morphs.as_ref().map_or(0, FanMorphs::moving_count);
        let achieved = Achieved {
            split_count: wanted.split_count(),
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

    /// The triangles, where they are not made on the GPU.
    pub(super) fn indices_into(
        &self,
        (indices, groups): (&mut Vec<u32>, &mut Vec<Range<u32>>),
        group_count: usize,
    ) {
        let Some(triangles) = &self.triangles else { return };
        indices.clear();
        ranges_of_groups(group_count, groups, |group| {
            indices.extend_from_slice(triangles.triangles(group).as_flattened());
            indices.len()
        });
    }
}
