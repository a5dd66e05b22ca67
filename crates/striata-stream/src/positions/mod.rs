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
//! | `guesses.rs` | guesses at the position, in four kinds |
//! | `bumps.rs` | densities made of guesses |
//! | `blend.rs` | the expected position |
//! | `position_density.rs` | guesses, their weights and densities, axis by axis |
//! | `axis.rs` | input for coding one coordinate |
//! | `cells.rs` | a coordinate as one of sixteen cells |
//! | `mixed.rs` | the compact model, which combines all of these |
//! | `ahead.rs` | predictions for many vertices in one go |
//! | `quick.rs` | the quick model: such a prediction, one symbol per axis |
//! | `residual.rs` | residual of a prediction, as a symbol and its low bits |
//!
//! All arithmetic is on integers. Time per vertex on one core: 0.15 microseconds with one prediction, 0.9
//! with a density.

mod ahead;
mod axis;
mod blend;
mod bumps;
mod cells;
mod guesses;
mod local;
mod mixed;
mod position_density;
mod quick;
mod residual;

use crate::entropy::Coder;
use crate::format::effort::Effort;
use crate::topology::neighborhood::Neighborhood;
pub(super) use ahead::Surroundings;
use mixed::MixedModel;
use quick::QuickPositions;

/// Adaptive model of grid coordinates.
#[derive(Clone, Debug)]
pub(super) struct PositionModel(EffortModel);

/// The model for each effort.
#[derive(Clone, Debug)]
enum EffortModel {
    /// One prediction, made ahead.
    Quick(Box<QuickPositions>),
    /// Guesses from the ring and the triangles around it.
    Mixed(Box<MixedModel>),
}

impl PositionModel {
    /// Creates an untrained model.
    pub(super) fn new(effort: Effort) -> Self {
        Self(match effort {
            Effort::Fast => EffortModel::Quick(Box::new(QuickPositions::new())),
            Effort::Compact => EffortModel::Mixed(Box::new(MixedModel::new())),
        })
    }

    /// Reserves memory for a total number of vertices.
    pub(super) fn reserve(&mut self, vertex_count: usize) {
        match &mut self.0 {
            EffortModel::Quick(_) => {}
            EffortModel::Mixed(model) => model.reserve(vertex_count),
        }
    }

    /// Adapts to a surface that was rebuilt between two batches. `old_of_new` contains the old index of
    /// each vertex, or [`NONE`](crate::topology::surface::NONE).
    pub(super) fn renumber(&mut self, old_of_new: &[u32]) {
        match &mut self.0 {
            EffortModel::Quick(_) => {}
            EffortModel::Mixed(model) => model.renumber(old_of_new),
        }
    }

    /// Returns the model that predicts all vertices of a stretch, from `first` on, before they are
    /// created. `None` if the model examines the surroundings of each vertex when it is coded.
    pub(super) fn ahead(&mut self, first: u32) -> Option<&mut QuickPositions> {
        let EffortModel::Quick(model) = &mut self.0 else { return None };
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
            EffortModel::Quick(model) => model.code(coder, neighborhood.vertex, actual),
            EffortModel::Mixed(model) => model.code(coder, neighborhood, actual),
        }
    }
}

#[cfg(test)]
mod tests;
