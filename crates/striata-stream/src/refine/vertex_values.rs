//! Coding of new vertices: their positions, the vertices that corners around them refer to, and their
//! attributes.

use super::models::Connectivity;
use super::refiner::{Ended, Refiner};
use super::source::Source;
use crate::entropy::{Coder, Part};
use crate::format::error::StreamDefect;
use crate::layers::attributes::{AttributeContext, NewVertex, actual_layers};
use crate::topology::neighborhood::Neighborhood;
use crate::topology::surface::next;
use crate::wedges::model::SplitContext;

impl Refiner {
    /// Prepares the predictions of the next vertices' positions in one go. Returns false if the model
    /// predicts them one by one.
    pub(super) fn predict_ahead(&mut self, first: u32) -> bool {
        let Self { level, models, stretch, .. } = self;
        let Connectivity::Quick(model) = &models.connectivity else { return false };
        let Some(positions) = models.positions.ahead(first) else { return false };
        let patches = (stretch.patches.as_slice(), stretch.ends.as_slice());
        model.look_around(&level.surface, &level.places, patches, |around| positions.look_ahead(around));
        true
    }

    /// Reads the memory that new vertices are predicted from, so that cache misses of several vertices
    /// overlap.
    pub(super) fn prefetch(&self, first: u32) {
        let surface = &self.level.surface;
        let place = |vertex: u32| self.level.places.get(vertex as usize).map_or(0, |place| place[0]);
        let mut sum = 0;
        for (vertex, patch) in (first..).zip(self.stretch.patches()) {
            let a = surface.corner_of(vertex);
            for &corner in patch {
                sum ^= place(surface.vertex(next(corner)));
                sum ^= place(surface.vertex(surface.opposite(corner)));
            }
            for corner in [a, a + 4] {
                sum ^= place(surface.vertex(next(corner)));
                sum ^= place(surface.vertex(surface.opposite(corner)));
            }
        }
        std::hint::black_box(sum);
    }

    /// Codes the values of a new vertex and adds it to the mesh.
    pub(super) fn code_vertex<C: Coder>(
        &mut self,
        coder: &mut C,
        source: &mut impl Source,
        vertex: u32,
    ) -> Result<Ended, StreamDefect> {
        let Self { level, models, stretch, .. } = self;
        let corners = &stretch.corners;
        let neighborhood = Neighborhood { surface: &level.surface, coords: &level.places, vertex, corners };
        coder.part(Part::Positions);
        let actual = source.plan().map_or([0; 3], |plan| plan.coords(vertex));
        let place = models.positions.code(coder, &neighborhood, actual);
        if !level.grid.holds(place) {
            let position = level.growth.first_vertex.len() - 1;
            return if coder.overran() { Ok(Ended::Short) } else { Err(StreamDefect::Place { position }) };
        }
        let position = match &mut models.corrections {
            Some(model) => {
                let exact = source.plan().map_or([0.0; 3], |plan| plan.exact(vertex));
                model.code(coder, &level.grid, place, exact)
            }
            None => level.grid.place(place),
        };
        level.places.push(place);
        if let Some(general) = &mut models.general {
            general.push_place(place);
        }
        coder.part(Part::Wedges);
        self.code_wedges_and_attributes(coder, source, vertex);
        let Self { level, models, limits, stretch, .. } = self;
        let beyond = level.growth.beyond() as u64 + stretch.shown.targets.len() as u64;
        if coder.overran() || beyond > limits.most_wedges + 1 {
            if let Some(attributes) = &mut models.attributes {
                attributes.truncate(level.growth.positions.len());
            }
            return Ok(Ended::Short);
        }
        match &models.wedges {
            Some(_) => {
                level.growth.add_wedges(&mut level.surface, &stretch.corners, position, &stretch.shown);
            }
            None => level.growth.add(&level.surface, &stretch.corners, position),
        }
        Ok(Ended::Whole)
    }

    /// Codes which vertices the corners around a new vertex refer to, and their attributes.
    fn code_wedges_and_attributes<C: Coder>(&mut self, coder: &mut C, source: &mut impl Source, vertex: u32) {
        let Self { level, models, limits, stretch, .. } = self;
        let (surface, growth, corners) = (&level.surface, &level.growth, &stretch.corners);
        if let Some(model) = &mut models.wedges {
            if let Some(follower) = source.follower() {
                follower.refine(vertex, corners);
            }
            let most_beyond = limits.most_wedges.saturating_sub(growth.beyond() as u64);
            let split = SplitContext { surface, growth, corners, source: &*source, most_beyond };
            model.code(coder, &split, &mut stretch.shown);
            if let Some(follower) = source.follower() {
                follower.name(&stretch.shown.source_vertices);
            }
        }
        let Some(attributes) = &mut models.attributes else { return };
        let split_wedges = models.wedges.as_ref().map(|_| &stretch.shown);
        let around = AttributeContext { surface, growth, places: &level.places, corners, split_wedges };
        let place = level.places[vertex as usize];
        if split_wedges.is_none() {
            let kept = surface.vertex(next(corners[0]));
            let actual = actual_layers(source.plan(), |plan| plan.wedges(vertex).start);
            let target = growth.wedges(kept).start;
            attributes.vertex(coder, around, NewVertex { place, wedge: 0, target }, actual);
            return;
        }
        attributes.begin_position(around, place);
        for (wedge, &target) in (0..).zip(&stretch.shown.targets) {
            let actual = actual_layers(source.plan(), |_| stretch.shown.source_vertices[wedge as usize]);
            attributes.vertex(coder, around, NewVertex { place, wedge, target }, actual);
        }
    }
}
