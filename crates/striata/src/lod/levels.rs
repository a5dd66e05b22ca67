//! A built [`Lod`] as a source of levels.

use std::convert::Infallible;

use super::Lod;
use crate::levels::{FoundLevel, Levels, LevelsFacts, fan_level};
use crate::mesh::{Bounds, IndexedMesh};
use crate::simplify::Target;
use crate::view::ScreenError;

impl Levels for Lod {
    type Shape = IndexedMesh;
    type Error = Infallible;

    fn facts(&self) -> LevelsFacts {
        LevelsFacts::of(self.mesh(), self.sequence().levels(), self.has_guaranteed_errors())
    }

    fn bounds(&mut self) -> Result<Option<Bounds>, Infallible> {
        Ok(self.mesh().bounds())
    }

    fn find(&mut self, target: Target) -> Result<FoundLevel<IndexedMesh>, Infallible> {
        let (split_count, stop_reason) = target.resolve(self.sequence());
        let (mesh, error) = (self.level_mesh(target), self.sequence().error_at(split_count));
        Ok(FoundLevel::of_mesh(mesh, split_count, error, stop_reason))
    }

    fn find_for_view(
        &mut self,
        criterion: &ScreenError,
        triangle_limit: Option<usize>,
    ) -> Result<FoundLevel<IndexedMesh>, Infallible> {
        Ok(fan_level(self.fans(), self.tables.refinable(), criterion, triangle_limit))
    }
}
