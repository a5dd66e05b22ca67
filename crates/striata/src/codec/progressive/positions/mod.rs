//! Where the new vertices are.

mod axis;
mod blend;
mod bumps;
mod guesses;
mod local;
mod mixed;
mod plain;
mod sight;

use super::super::entropy::Coder;
use super::Effort;
use super::hood::Hood;
use mixed::MixedModel;
use plain::PlainModel;

/// Adaptive models of grid coordinates.
#[derive(Clone, Debug)]
pub(super) struct PositionModel(Model);

#[derive(Clone, Debug)]
enum Model {
    /// One prediction.
    One(Box<PlainModel>),
    /// Guesses from the ring and the triangles around it.
    Some(Box<MixedModel<4, 1, 1, 1>>),
    /// Guesses from two rings, under several widths.
    All(Box<MixedModel<6, 6, 3, 3>>),
}

impl PositionModel {
    pub(super) fn new(effort: Effort) -> Self {
        Self(match effort {
            Effort::Fast => Model::One(Box::new(PlainModel::new())),
            Effort::Default => Model::Some(Box::new(MixedModel::new([[5], [4]]))),
            Effort::Small => Model::All(Box::new(MixedModel::new([[2, 5, 8], [1, 4, 7]]))),
        })
    }

    /// Codes the place of the new vertex; a reader ignores `actual`.
    pub(super) fn code<C: Coder>(&mut self, coder: &mut C, hood: &Hood<'_>, actual: [i32; 3]) -> [i32; 3] {
        match &mut self.0 {
            Model::One(model) => model.code(coder, hood, actual),
            Model::Some(model) => model.code(coder, hood, actual),
            Model::All(model) => model.code(coder, hood, actual),
        }
    }
}

#[cfg(test)]
mod tests;
