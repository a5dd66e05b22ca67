//! The adaptive models of a stream, which learn while it is coded.

use super::parameters::StreamParameters;
use crate::connectivity::ConnectivityModel;
use crate::connectivity::quick::QuickModel;
use crate::format::grid::CorrectionModel;
use crate::general::GeneralBatches;
use crate::layers::attributes::Attributes;
use crate::positions::PositionModel;
use crate::topology::surface::Surface;
use crate::wedges::model::WedgeModel;

/// The model that codes which vertices split and how.
#[derive(Clone, Debug)]
pub(crate) enum Connectivity {
    /// Examines the whole neighborhood of each vertex.
    Thorough(Box<ConnectivityModel>),
    /// Uses very little context to decide whether a vertex splits.
    Quick(Box<QuickModel>),
}

impl Connectivity {
    /// Creates an untrained model for the surface of the base mesh.
    pub(crate) fn new(surface: &Surface, parameters: &StreamParameters) -> Self {
        if parameters.is_quick() {
            Self::Quick(Box::new(QuickModel::new(surface, parameters.effort)))
        } else {
            Self::Thorough(Box::new(ConnectivityModel::new()))
        }
    }

    /// Prepares the model for the next batch.
    pub(crate) fn begin_batch(&mut self, surface: &Surface) {
        match self {
            Self::Thorough(model) => model.begin_batch(surface),
            Self::Quick(model) => model.begin_batch(surface),
        }
    }
}

/// One model for each part of a stream.
#[derive(Clone, Debug)]
pub(crate) struct PartModels {
    /// Connectivity: which vertices split, and how.
    pub connectivity: Connectivity,
    /// Grid coordinates of new vertices.
    pub positions: PositionModel,
    /// Differences between exact positions and the grid, if positions are lossless.
    pub corrections: Option<CorrectionModel>,
    /// Vertices that corners refer to, if some position has several vertices or the mesh has several groups.
    pub wedges: Option<WedgeModel>,
    /// Attribute layers, if there are any.
    pub attributes: Option<Attributes>,
    /// General batches, if there are any.
    pub general: Option<GeneralBatches>,
}

impl PartModels {
    /// Reserves memory for a number of vertices beyond those of the surface.
    pub(crate) fn reserve(&mut self, surface: &Surface, steps: usize) {
        // These models do not store anything for the existing vertices yet.
        let all = surface.vertex_count() + steps;
        self.positions.reserve(all);
        match &mut self.connectivity {
            Connectivity::Thorough(model) => model.reserve(all),
            Connectivity::Quick(model) => model.reserve(steps),
        }
    }

    /// Adapts the models to a surface that was rebuilt between two batches. `old_of_new` contains the old
    /// index of each of its vertices, or [`NONE`](crate::topology::surface::NONE) for a new one.
    pub(crate) fn renumber(&mut self, old_of_new: &[u32]) {
        match &mut self.connectivity {
            Connectivity::Thorough(model) => model.renumber(old_of_new),
            Connectivity::Quick(model) => model.renumber(old_of_new),
        }
        self.positions.renumber(old_of_new);
    }
}
