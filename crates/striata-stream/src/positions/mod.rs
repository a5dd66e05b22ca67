//! Models for the positions of new vertices.
//!
//! A vertex is coded once its ring and the vertices beyond are known. From these we guess its position. Each
//! of its three coordinates is then coded relative to the expected value, with adaptive probabilities. Most
//! surfaces are sampled with some regularity, so one of many simple guesses is often nearly right. What makes
//! streams small is to use their mixture as a density instead of their mean \[Mah05\].
//!
//! | file | what it does |
//! | --- | --- |
//! | `local.rs` | surroundings of a vertex, in units of its ring's size |
//! | `guesses.rs` | guesses at the position, in six kinds |
//! | `bumps.rs` | densities made of guesses |
//! | `blend.rs` | the expected position |
//! | `position_density.rs` | guesses, their weights and densities, axis by axis |
//! | `axis.rs` | input for coding one coordinate |
//! | `halving.rs` | a coordinate as a chain of mixed binary decisions |
//! | `cells.rs` | a coordinate as one of sixteen cells |
//! | `mixed.rs` | the thorough models, which combine all of these |
//! | `plain.rs` | the quick model of version 1: one prediction and counters |
//! | `ahead.rs` | predictions for many vertices in one go |
//! | `quick.rs` | the quick model of version 2: such a prediction, one symbol per axis |
//! | `residual.rs` | residual of a prediction, as a symbol and its low bits |
//!
//! All arithmetic is on integers. Time per vertex on one core: 0.15 microseconds with one prediction, 0.9
//! with one density and one cell per axis, 1.1 with one density and halvings, 2.7 with eighteen densities.

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
mod position_density;
mod quick;
mod residual;

use crate::entropy::Coder;
use crate::format::version::{Effort, StreamVersion};
use crate::topology::neighborhood::Neighborhood;
pub(super) use ahead::Surroundings;
use cells::CellModel;
use halving::AxisModel;
use mixed::MixedModel;
use plain::PlainModel;
use quick::QuickPositions;

/// Adaptive model of grid coordinates.
#[derive(Clone, Debug)]
pub(super) struct PositionModel(Model);

/// The model for each combination of effort and version.
#[derive(Clone, Debug)]
enum Model {
    /// One prediction, counters (version 1).
    Plain(Box<PlainModel>),
    /// One prediction, made ahead (version 2).
    Quick(Box<QuickPositions>),
    /// Guesses from the ring and the triangles around it; coordinates by halving (version 1).
    Halving(Box<MixedModel<4, 1, 1, AxisModel<1>>>),
    /// The guesses of `Halving`, coordinates by cells (version 2).
    Cells(Box<MixedModel<4, 1, 1, CellModel>>),
    /// Guesses from two rings, under several widths.
    Full(Box<MixedModel<6, 6, 3, AxisModel<3>>>),
}

impl PositionModel {
    /// Creates an untrained model.
    pub(super) fn new(effort: Effort, version: StreamVersion) -> Self {
        Self(match effort {
            Effort::Fast if version > StreamVersion::One => Model::Quick(Box::new(QuickPositions::new())),
            Effort::Fast => Model::Plain(Box::new(PlainModel::new())),
            Effort::Default if version > StreamVersion::One => {
                Model::Cells(Box::new(MixedModel::new([[5], [4]])))
            }
            Effort::Default => Model::Halving(Box::new(MixedModel::new([[5], [4]]))),
            Effort::Small => Model::Full(Box::new(MixedModel::new([[2, 5, 8], [1, 4, 7]]))),
        })
    }

    /// Reserves memory for a total number of vertices.
    pub(super) fn reserve(&mut self, vertex_count: usize) {
        match &mut self.0 {
            Model::Plain(_) | Model::Quick(_) => {}
            Model::Halving(model) => model.reserve(vertex_count),
            Model::Cells(model) => model.reserve(vertex_count),
            Model::Full(model) => model.reserve(vertex_count),
        }
    }

    /// Adapts to a surface that was rebuilt between two batches. `old_of_new` contains the old index of
    /// each vertex, or [`NONE`](crate::topology::surface::NONE).
    pub(super) fn renumber(&mut self, old_of_new: &[u32]) {
        match &mut self.0 {
            Model::Plain(_) | Model::Quick(_) => {}
            Model::Halving(model) => model.renumber(old_of_new),
            Model::Cells(model) => model.renumber(old_of_new),
            Model::Full(model) => model.renumber(old_of_new),
        }
    }

    /// Returns the model that predicts all vertices of a stretch, from `first` on, before they are
    /// created. `None` if the model examines the surroundings of each vertex when it is coded.
    pub(super) fn ahead(&mut self, first: u32) -> Option<&mut QuickPositions> {
        let Model::Quick(model) = &mut self.0 else { return None };
        model.begin_stretch(first);
        Some(model)
    }

    /// Codes the grid coordinates of a new vertex. A reader ignores `actual`.
    pub(super) fn code<C: Coder>(
        &mut self,
        coder: &mut C,
        neighborhood: &Neighborhood<'_>,
        actual: [i32; 3],
    ) -> [i32; 3] {
        match &mut self.0 {
            Model::Plain(model) => model.code(coder, neighborhood, actual),
            Model::Quick(model) => model.code(coder, neighborhood.vertex, actual),
            Model::Halving(model) => model.code(coder, neighborhood, actual),
            Model::Cells(model) => model.code(coder, neighborhood, actual),
            Model::Full(model) => model.code(coder, neighborhood, actual),
        }
    }
}

#[cfg(test)]
mod tests;
