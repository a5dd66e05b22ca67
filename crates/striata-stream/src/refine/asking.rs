//! Which vertices split, and how.

use super::models::Connectivity;
use super::refiner::Refiner;
use super::source::Source;
use crate::entropy::Coder;

/// Flags that say yes before the cuts of their vertices are coded.
const GROUP: usize = 24;

impl Refiner {
    /// Which vertices split and how, until there are `most` or the batch is done.
    pub(super) fn ask<C: Coder>(&mut self, coder: &mut C, source: &impl Source, most: usize) {
        self.stretch.clear();
        match &self.models.connectivity {
            Connectivity::Quick(_) => self.ask_quickly(coder, source, most),
            Connectivity::Thorough(model) if model.is_thorough() => self.ask_thoroughly(coder, source, most),
            Connectivity::Thorough(_) => self.ask_in_groups(coder, source, most),
        }
    }

    /// Vertex by vertex.
    fn ask_thoroughly<C: Coder>(&mut self, coder: &mut C, source: &impl Source, most: usize) {
        let Self { level, models, batch, limits, stretch } = self;
        let Connectivity::Thorough(model) = &mut models.connectivity else { return };
        while stretch.split_count() < most {
            let Some(vertex) = batch.walk.next_vertex() else {
                batch.is_under_way = false;
                return;
            };
            stretch.corners.clear();
            stretch.corners.extend(level.surface.ring(vertex));
            let scene = level.scene(&batch.walk, limits);
            let actual = source.plan().and_then(|plan| plan.cut(vertex));
            let cut = model.code(coder, &scene, (vertex, &stretch.corners), actual);
            batch.walk.settle(&level.surface, vertex, &stretch.corners, cut.is_some());
            if let Some(cut) = cut {
                stretch.take(&mut level.surface, cut, batch.walk.batch());
            }
        }
    }

    /// Flags until some vertices split, then the cuts of these, so that rings can be found side by side.
    fn ask_in_groups<C: Coder>(&mut self, coder: &mut C, source: &impl Source, most: usize) {
        let Self { level, models, batch, limits, stretch } = self;
        let Connectivity::Thorough(model) = &mut models.connectivity else { return };
        while batch.is_under_way && stretch.split_count() < most {
            let room = GROUP.min(most - stretch.split_count());
            stretch.group.clear();
            while stretch.group.len() < room {
                let Some(vertex) = batch.walk.next_vertex() else {
                    batch.is_under_way = false;
                    break;
                };
                let actual = source.plan().is_some_and(|plan| plan.cut(vertex).is_some());
                let splits = model.flag(coder, vertex, actual);
                batch.walk.settle(&level.surface, vertex, &[], splits);
                if splits {
                    stretch.group.push(vertex);
                }
            }
            stretch.rings.find(&level.surface, &stretch.group);
            for at in 0..stretch.group.len() {
                let vertex = stretch.group[at];
                let scene = level.scene(&batch.walk, limits);
                let actual = source.plan().and_then(|plan| plan.cut(vertex));
                let corners = stretch.rings.of(at);
                let Some(cut) = model.cut(coder, &scene, (vertex, corners), actual) else { continue };
                stretch.take(&mut level.surface, cut, batch.walk.batch());
            }
        }
    }

    /// All flags by the quick model, then all cuts.
    fn ask_quickly<C: Coder>(&mut self, coder: &mut C, source: &impl Source, most: usize) {
        let Self { level, models, batch, limits, stretch } = self;
        let Connectivity::Quick(model) = &mut models.connectivity else { return };
        let does_split = |vertex| source.plan().is_some_and(|plan| plan.cut(vertex).is_some());
        batch.is_under_way = !model.flags(coder, &mut batch.walk, most, does_split);
        model.find_rings(&level.surface, &level.places);
        for split in 0..model.splits().len() {
            let scene = level.scene(&batch.walk, limits);
            let actual = source.plan().and_then(|plan| plan.cut(model.splits()[split]));
            if model.cut(coder, &scene, (split, actual), &mut stretch.patches) {
                stretch.close(&mut level.surface, batch.walk.batch());
            }
        }
    }
}
