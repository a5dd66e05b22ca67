//! Where the new vertices are.
//!
//! A vertex is coded once its ring and what lies beyond are known. Its place is guessed from there, and each of its three
//! coordinates is found by halving an interval around what is expected, where each answer has a probability. Most of a
//! surface is sampled with some regularity, so that one of many simple guesses is often nearly right: their mixture as a
//! density, not their mean, is what makes streams small \[Mah05\].
//!
//! | file | what it does |
//! | --- | --- |
//! | `local.rs` | what is known around a vertex, in units of its ring's size |
//! | `guesses.rs` | where the vertex might be, in six kinds |
//! | `bumps.rs` | densities made of guesses |
//! | `blend.rs` | the one place that is expected |
//! | `sight.rs` | what of this goes into each axis, given the axes before |
//! | `axis.rs` | what a coordinate is coded with |
//! | `halving.rs` | a coordinate as a chain of mixed decisions |
//! | `cells.rs` | a coordinate as one of sixteen cells |
//! | `mixed.rs` | the thorough models: these together |
//! | `plain.rs` | the quick model of the first version: one prediction, counters alone |
//! | `ahead.rs` | predictions for many vertices at once |
//! | `quick.rs` | the quick model: such a prediction, a symbol an axis |
//! | `residual.rs` | how far off these two are, as one symbol and the bits below |
//!
//! All of it is integers. Time a vertex on one core: 0.15 microseconds with one prediction, 0.9 with one density and a cell an
//! axis, 1.1 with one density and halvings, 2.7 with eighteen densities.

mod ahead;
mod axis;
mod blend;
mod bumps;
mod cells;
mod guesses;
mod halving;
mod local;
mod mixed;
mod plain;
mod quick;
mod residual;
mod sight;

use crate::entropy::Coder;
use crate::format::form::{Effort, StreamVersion};
use crate::topology::neighborhood::Neighborhood;
pub(super) use ahead::Surroundings;
use cells::CellModel;
use halving::AxisModel;
use mixed::MixedModel;
use plain::PlainModel;
use quick::QuickPositions;

/// Adaptive models of grid coordinates.
#[derive(Clone, Debug)]
pub(super) struct PositionModel(Model);

#[derive(Clone, Debug)]
enum Model {
    /// One prediction.
    One(Box<PlainModel>),
    /// One prediction, made ahead.
    Ahead(Box<QuickPositions>),
    /// Guesses from the ring and the triangles around it.
    Some(Box<MixedModel<4, 1, 1, AxisModel<1>>>),
    /// The same, an axis at once.
    Cells(Box<MixedModel<4, 1, 1, CellModel>>),
    /// Guesses from two rings, under several widths.
    All(Box<MixedModel<6, 6, 3, AxisModel<3>>>),
}

impl PositionModel {
    /// Knows nothing yet.
    pub(super) fn new(effort: Effort, version: StreamVersion) -> Self {
        Self(match effort {
            Effort::Fast if version > StreamVersion::One => Model::Ahead(Box::new(QuickPositions::new())),
            Effort::Fast => Model::One(Box::new(PlainModel::new())),
            Effort::Default if version > StreamVersion::One => {
                Model::Cells(Box::new(MixedModel::new([[5], [4]])))
            }
            Effort::Default => Model::Some(Box::new(MixedModel::new([[5], [4]]))),
            Effort::Small => Model::All(Box::new(MixedModel::new([[2, 5, 8], [1, 4, 7]]))),
        })
    }

    /// Makes room for so many vertices in all.
    pub(super) fn reserve(&mut self, vertex_count: usize) {
        match &mut self.0 {
            Model::One(_) | Model::Ahead(_) => {}
            Model::Some(model) => model.reserve(vertex_count),
            Model::Cells(model) => model.reserve(vertex_count),
            Model::All(model) => model.reserve(vertex_count),
        }
    }

    /// The surface has been built anew between two batches: here is the old number of each vertex, or
    /// [`NONE`](crate::topology::surface::NONE).
    pub(super) fn renumber(&mut self, old_of_new: &[u32]) {
        match &mut self.0 {
            Model::One(_) | Model::Ahead(_) => {}
            Model::Some(model) => model.renumber(old_of_new),
            Model::Cells(model) => model.renumber(old_of_new),
            Model::All(model) => model.renumber(old_of_new),
        }
    }

    /// The model that looks ahead at all vertices that a stretch makes, from `first` on, before they are made; none if the
    /// model looks around each one when it comes.
    pub(super) fn ahead(&mut self, first: u32) -> Option<&mut QuickPositions> {
        let Model::Ahead(model) = &mut self.0 else { return None };
        model.begin_stretch(first);
        Some(model)
    }

    /// Codes the place of the new vertex; a reader ignores `actual`.
    pub(super) fn code<C: Coder>(
        &mut self,
        coder: &mut C,
        neighborhood: &Neighborhood<'_>,
        actual: [i32; 3],
    ) -> [i32; 3] {
        match &mut self.0 {
            Model::One(model) => model.code(coder, neighborhood, actual),
            Model::Ahead(model) => model.code(coder, neighborhood.vertex, actual),
            Model::Some(model) => model.code(coder, neighborhood, actual),
            Model::Cells(model) => model.code(coder, neighborhood, actual),
            Model::All(model) => model.code(coder, neighborhood, actual),
        }
    }
}

#[cfg(test)]
mod tests;
