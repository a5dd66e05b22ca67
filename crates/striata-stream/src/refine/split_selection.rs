//! Selection of the vertices that split, and of how they split.

use super::refiner::MeshRefiner;
use super::source::StreamSide;
use crate::connectivity::CutOfSplit;
use crate::entropy::Coder;

impl MeshRefiner {
    /// Codes which vertices split, up to `most` splits or the end of the batch, then how each does.
    pub(super) fn code_splits<C: Coder>(&mut self, coder: &mut C, source: &impl StreamSide, most: usize) {
        self.stretch.clear();
        let Self { level, models, batch, limits, stretch } = self;
        let model = &mut models.connectivity;
        let does_split = |vertex| source.input().is_some_and(|input| input.cut(vertex).is_some());
        batch.is_under_way = !model.flags(coder, &mut batch.walk, most, does_split);
        model.find_rings(&level.surface, &level.grid_points);
        for split in 0..model.splits().len() {
            let split_context = level.split_context(&batch.walk, limits);
            let actual = source.input().and_then(|input| input.cut(model.splits()[split]));
            if model.cut(coder, &split_context, CutOfSplit { split, actual }, &mut stretch.patches) {
                stretch.close_split(&mut level.surface, batch.walk.batch());
            }
        }
    }
}
