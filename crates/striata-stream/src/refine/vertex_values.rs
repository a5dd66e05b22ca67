//! Coding of new vertices: their positions, the vertices that corners around them refer to, and their
//! attributes.

use super::refiner::{CodingResult, MeshRefiner};
use super::source::StreamSide;
use crate::entropy::{Coder, Part};
use crate::format::error::StreamDefect;
use crate::layers::attributes::{AttributeContext, NewVertex, actual_layers};
use crate::topology::neighborhood::Neighborhood;
use crate::topology::surface::next;
use crate::wedges::model::WedgeContext;

impl MeshRefiner {
    /// Prepares the predictions of the next vertices' positions in one go. Returns false if the model
    /// predicts them one by one.
    pub(super) fn predict_ahead(&mut self, first: u32) -> bool {
        let Self { level, models, stretch, .. } = self;
        let Some(positions) = models.positions.ahead(first) else { return false };
        let patches = (stretch.patches.as_slice(), stretch.ends.as_slice());
        models.connectivity.for_each_surroundings(&level.surface, &level.grid_points, patches, |around| {
            positions.look_ahead(around)
        });
        true
    }

    /// Reads the memory that new vertices are predicted from, so that cache misses of several vertices
    /// overlap.
    pub(super) fn prefetch(&self, first: u32) {
        let surface = &self.level.surface;
        let grid_x = |vertex: u32| self.level.grid_points.get(vertex as usize).map_or(0, |point| point[0]);
        let mut sum = 0;
        for (vertex, patch) in (first..).zip(self.stretch.patches()) {
            let a = surface.corner_of(vertex);
            for &corner in patch {
                sum ^= grid_x(surface.vertex(next(corner)));
                sum ^= grid_x(surface.vertex(surface.opposite(corner)));
            }
            for corner in [a, a + 4] {
                sum ^= grid_x(surface.vertex(next(corner)));
                sum ^= grid_x(surface.vertex(surface.opposite(corner)));
            }
        }
        std::hint::black_box(sum);
    }

    /// Codes the values of a new vertex and adds it to the mesh.
    pub(super) fn code_vertex<C: Coder>(
        &mut self,
        coder: &mut C,
        source: &mut impl StreamSide,
        vertex: u32,
    ) -> Result<CodingResult, StreamDefect> {
        let Self { level, models, stretch, .. } = self;
        let corners = &stretch.corners;
        let neighborhood =
            Neighborhood { surface: &level.surface, coords: &level.grid_points, vertex, corners };
        coder.part(Part::Positions);
        let actual = source.input().map_or([0; 3], |input| input.coords(vertex));
        let grid_point = models.positions.code(coder, &neighborhood, actual);
        if !level.grid.contains(grid_point) {
            let position = level.growth.first_vertex.len() - 1;
            return if coder.overran() {
                Ok(CodingResult::OutOfData)
            } else {
                Err(StreamDefect::OffGrid { position })
            };
        }
        let position = match &mut models.corrections {
            Some(model) => {
                let exact = source.input().map_or([0.0; 3], |input| input.exact(vertex));
                model.code(coder, &level.grid, grid_point, exact)
            }
            None => level.grid.position(grid_point),
        };
        level.grid_points.push(grid_point);
        if let Some(general) = &mut models.general {
            general.push_grid_point(grid_point);
        }
        coder.part(Part::Wedges);
        self.code_wedges_and_attributes(coder, source, vertex);
        let Self { level, models, limits, stretch, .. } = self;
        let excess = level.growth.excess_count() as u64 + stretch.shown.targets.len() as u64;
        if coder.overran() || excess > limits.most_wedges + 1 {
            if let Some(attributes) = &mut models.attributes {
                attributes.truncate(level.growth.positions.len());
            }
            return Ok(CodingResult::OutOfData);
        }
        match &models.wedges {
            Some(_) => {
                level.growth.add_wedges(&mut level.surface, &stretch.corners, position, &stretch.shown);
            }
            None => level.growth.add(&level.surface, &stretch.corners, position),
        }
        Ok(CodingResult::Complete)
    }

    /// Codes which vertices the corners around a new vertex refer to, and their attributes.
    fn code_wedges_and_attributes<C: Coder>(
        &mut self,
        coder: &mut C,
        source: &mut impl StreamSide,
        vertex: u32,
    ) {
        let Self { level, models, limits, stretch, .. } = self;
        let (surface, growth, corners) = (&level.surface, &level.growth, &stretch.corners);
        if let Some(model) = &mut models.wedges {
            if let Some(observer) = source.observer() {
                observer.refine(vertex, corners);
            }
            let most_beyond = limits.most_wedges.saturating_sub(growth.excess_count() as u64);
            let split = WedgeContext { surface, growth, corners, source: &*source, most_beyond };
            model.code(coder, &split, &mut stretch.shown);
            if let Some(observer) = source.observer() {
                observer.name(&stretch.shown.source_vertices);
            }
        }
        let Some(attributes) = &mut models.attributes else { return };
        let split_wedges = models.wedges.as_ref().map(|_| &stretch.shown);
        let around =
            AttributeContext { surface, growth, grid_points: &level.grid_points, corners, split_wedges };
        let grid_point = level.grid_points[vertex as usize];
        if split_wedges.is_none() {
            let kept = surface.vertex(next(corners[0]));
            let actual = actual_layers(source.input(), |input| input.wedges(vertex).start);
            let target = growth.wedges(kept).start;
            attributes.vertex(coder, around, NewVertex { grid_point, wedge: 0, target }, actual);
            return;
        }
        attributes.begin_position(around, grid_point);
        for (wedge, &target) in (0..).zip(&stretch.shown.targets) {
            let actual = actual_layers(source.input(), |_| stretch.shown.source_vertices[wedge as usize]);
            attributes.vertex(coder, around, NewVertex { grid_point, wedge, target }, actual);
        }
    }
}
