//! A scene as a source of levels.

use std::convert::Infallible;

use striata::levels::{self, FoundLevel, Levels, LevelsFacts};
use striata::mesh::Bounds;
use striata::simplify::{StopReason, Target};
use striata::view::ScreenError;
use striata_io::Scene;

use super::SceneLevel;
use crate::lod_scene::LodScene;

/// Smallest pixel tolerance used with a triangle limit, so that tolerances can be multiplied.
const LEAST_PIXELS: f32 = 1e-4;

impl LodScene {
    /// Returns the importance of the least important instance, at most 1; views allow it the largest errors.
    pub fn least_importance(&self) -> f64 {
        let instances = self.scene().instances().iter();
        instances.fold(1.0, |least: f64, instance| least.min(instance.importance))
    }

    /// Describes a level of the scene, whose meshes are those given.
    pub fn found_level(&self, level: &SceneLevel, shape: Scene) -> FoundLevel<Scene> {
        let &SceneLevel { triangle_count, vertex_count, error, stop_reason, .. } = level;
        let error = Some(error);
        let split_count = level.split_counts.iter().sum();
        FoundLevel { shape, split_count, vertex_count, triangle_count, error, stop_reason, relaxation: 1.0 }
    }
}

impl Levels for LodScene {
    type Shape = Scene;
    type Error = Infallible;

    fn facts(&self) -> LevelsFacts {
        LevelsFacts {
            vertex_count: self.levels().vertex_count(),
            triangle_count: self.triangle_count(),
            step_count: self.levels().step_count(),
            has_guaranteed_errors: self.has_guaranteed_errors(),
            origin: [0.0; 3],
        }
    }

    fn bounds(&mut self) -> Result<Option<Bounds>, Infallible> {
        Ok(self.full_scene().bounds())
    }

    fn find(&mut self, target: Target) -> Result<FoundLevel<Scene>, Infallible> {
        let level = LodScene::level(self, target);
        Ok(self.found_level(&level, self.level_scene(&level)))
    }

    /// Each object may err by the tolerance divided by its importance.
    fn find_for_view(
        &mut self,
        criterion: &ScreenError,
        triangle_limit: Option<usize>,
    ) -> Result<FoundLevel<Scene>, Infallible> {
        let (shape, factor) = match triangle_limit {
            None => (self.view_scene(criterion), 1.0),
            Some(limit) => {
                let raised = criterion.clone().at_least(LEAST_PIXELS);
                let (shape, factor) = self.view_scene_within(&raised, limit);
                (shape, factor * raised.pixels() / criterion.pixels().max(levels::LEAST_PIXELS))
            }
        };
        let triangle_count = shape.triangle_count();
        let vertex_count = shape.meshes().iter().flatten().map(|mesh| mesh.vertex_count()).sum();
        let is_above = triangle_limit.is_some_and(|limit| triangle_count > limit);
        let stop_reason = if is_above { StopReason::BaseReached } else { StopReason::TargetReached };
        let (split_count, relaxation) = (0, f64::from(factor));
        Ok(FoundLevel {
            shape,
            split_count,
            vertex_count,
            triangle_count,
            error: None,
            stop_reason,
            relaxation,
        })
    }
}
