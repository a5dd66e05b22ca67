//! The adaptive models of a stream, which learn while it is coded.

use crate::connectivity::ConnectivityModel;
use crate::format::grid::CorrectionModel;
use crate::general::GeneralBatches;
use crate::layers::attributes::Attributes;
use crate::positions::PositionModel;
use crate::topology::surface::Surface;
use crate::wedges::model::WedgeModel;

/// One model for each part of a stream.
#[derive(Clone, Debug)]
pub(crate) struct PartModels {
    /// Connectivity: which vertices split, and how.
    pub connectivity: ConnectivityModel,
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
        // The model of positions does not store anything for the existing vertices yet.
        self.positions.reserve(surface.vertex_count() + steps);
        self.connectivity.reserve(steps);
    }

    /// Adapts the models to a surface that was rebuilt between two batches. `old_of_new` contains the old
    /// index of each of its vertices, or [`NONE`](crate::topology::surface::NONE) for a new one.
    pub(crate) fn renumber(&mut self, old_of_new: &[u32]) {
        self.connectivity.renumber(old_of_new);
        self.positions.renumber(old_of_new);
    }
}
