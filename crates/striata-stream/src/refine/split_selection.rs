//! Selection of the vertices that split, and of how they split.

use super::models::Connectivity;
use super::refiner::MeshRefiner;
use super::source::StreamSide;
use crate::connectivity::SplitStar;
use crate::connectivity::quick::CutOfSplit;
use crate::entropy::Coder;

impl MeshRefiner {
    /// Codes which vertices split and how, up to `most` splits or the end of the batch.
    pub(super) fn code_splits<C: Coder>(&mut self, coder: &mut C, source: &impl StreamSide, most: usize) {
        self.stretch.clear();
        match &self.models.connectivity {
            Connectivity::Quick(_) => self.code_quickly(coder, source, most),
            Connectivity::Thorough(_) => self.code_each(coder, source, most),
        }
    }

    /// Codes the flag and cut of one vertex after another.
    fn code_each<C: Coder>(&mut self, coder: &mut C, source: &impl StreamSide, most: usize) {
        let Self { level, models, batch, limits, stretch } = self;
        let Connectivity::Thorough(model) = &mut models.connectivity else { return };
        while stretch.split_count() < most {
            let Some(vertex) = batch.walk.next_vertex() else {
                batch.is_under_way = false;
                return;
            };
            stretch.corners.clear();
            stretch.corners.extend(level.surface.ring(vertex));
            let split_context = level.split_context(&batch.walk, limits);
            let actual = source.input().and_then(|input| input.cut(vertex));
            let cut =
                model.code(coder, &split_context, SplitStar { vertex, corners: &stretch.corners }, actual);
            batch.walk.record_visit(vertex, cut.is_some());
            if let Some(cut) = cut {
                stretch.push_split(&mut level.surface, cut, batch.walk.batch());
            }
        }
    }

    /// Codes all flags with the quick model, then all cuts.
    fn code_quickly<C: Coder>(&mut self, coder: &mut C, source: &impl StreamSide, most: usize) {
        let Self { level, models, batch, limits, stretch } = self;
        let Connectivity::Quick(model) = &mut models.connectivity else { return };
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
