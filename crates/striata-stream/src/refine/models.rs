//! All that is learned while a stream is coded.

use super::terms::Terms;
use crate::connectivity::ConnectivityModel;
use crate::connectivity::quick::QuickModel;
use crate::format::grid::CorrectionModel;
use crate::general::General;
use crate::layers::attributes::Attributes;
use crate::positions::PositionModel;
use crate::topology::surface::Surface;
use crate::wedges::model::WedgeModel;

/// Who is asked which vertices split.
#[derive(Clone, Debug)]
pub(crate) enum Connectivity {
    /// All that is around a vertex is looked at.
    Thorough(Box<ConnectivityModel>),
    /// Next to nothing is looked at to see whether it splits.
    Quick(Box<QuickModel>),
}

impl Connectivity {
    /// Nothing learned about a base.
    pub(crate) fn new(surface: &Surface, terms: &Terms) -> Self {
        if terms.is_quick() {
            Self::Quick(Box::new(QuickModel::new(surface, (terms.effort, terms.version))))
        } else {
            Self::Thorough(Box::new(ConnectivityModel::new(terms.effort)))
        }
    }

    /// A batch begins.
    pub(crate) fn begin_batch(&mut self, surface: &Surface) {
        match self {
            Self::Thorough(model) => model.begin_batch(surface),
            Self::Quick(model) => model.begin_batch(surface),
        }
    }
}

/// A model for each part of what a stream says.
#[derive(Clone, Debug)]
pub(crate) struct Models {
    /// Which vertices split, and how.
    pub(crate) connectivity: Connectivity,
    /// Where new vertices are on the grid.
    pub(crate) positions: PositionModel,
    /// What grid coordinates lack, if positions are exact.
    pub(crate) corrections: Option<CorrectionModel>,
    /// What corners show, if positions have several vertices or triangles several groups.
    pub(crate) wedges: Option<WedgeModel>,
    /// Attribute layers, if there are any.
    pub(crate) attributes: Option<Attributes>,
    /// General batches, if there are any.
    pub(crate) general: Option<General>,
}

impl Models {
    /// Makes room for so many more vertices, on top of those that a surface has.
    pub(crate) fn reserve(&mut self, surface: &Surface, steps: usize) {
        // These know nothing yet of the vertices that are there.
        let all = surface.vertex_count() + steps;
        self.positions.reserve(all);
        match &mut self.connectivity {
            Connectivity::Thorough(model) => model.reserve(all),
            Connectivity::Quick(model) => model.reserve(steps),
        }
    }

    /// Follows a surface that was built anew between two batches: here is the old number of each of its vertices, or
    /// [`NONE`](crate::topology::surface::NONE) for those that are new. Only in streams of the second version.
    pub(crate) fn renumber(&mut self, old_of_new: &[u32]) {
        match &mut self.connectivity {
            Connectivity::Thorough(model) => model.renumber(old_of_new),
            Connectivity::Quick(model) => model.renumber(old_of_new),
        }
        self.positions.renumber(old_of_new);
    }
}
