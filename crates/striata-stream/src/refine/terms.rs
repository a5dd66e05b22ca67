//! What both sides agree on before the first bit.

use super::walk::WalkOrder;
use crate::base::coder::BaseLimits;
use crate::format::form::{Effort, StreamVersion};
use crate::format::grid::PositionGrid;
use crate::layers::form::LayerForm;

/// What both sides agree on before the first bit.
#[derive(Clone, Debug)]
pub(crate) struct Terms {
    /// What the bits mean.
    pub(crate) version: StreamVersion,
    /// Whether there are general batches.
    pub(crate) has_general: bool,
    /// How hard models try.
    pub(crate) effort: Effort,
    /// The grid of positions.
    pub(crate) grid: PositionGrid,
    /// Whether positions are exact as well.
    pub(crate) is_exact: bool,
    /// Most triangles that a new vertex takes over.
    pub(crate) max_patch: u32,
    /// Positions of the full mesh.
    pub(crate) position_count: u32,
    /// What the base may be at most.
    pub(crate) base: BaseLimits,
    /// Vertices of the full mesh.
    pub(crate) vertex_count: u32,
    /// Groups of the full mesh.
    pub(crate) group_count: u32,
    /// How attribute layers are stored.
    pub(crate) layers: Vec<LayerForm>,
}

impl Terms {
    /// Whether what corners show has to be coded.
    pub(crate) fn has_wedges(&self) -> bool {
        self.vertex_count != self.position_count || self.group_count > 1
    }

    /// Whether vertices are asked by the quick model.
    pub(crate) fn is_quick(&self) -> bool {
        match self.effort {
            Effort::Fast => true,
            Effort::Default => self.version > StreamVersion::One,
            Effort::Small => false,
        }
    }

    /// In which order vertices are asked.
    pub(crate) fn walk_order(&self) -> WalkOrder {
        match (self.version, self.effort) {
            (StreamVersion::One, Effort::Small) => WalkOrder::Near,
            (StreamVersion::One, _) => WalkOrder::Numbers,
            _ => WalkOrder::Families,
        }
    }

    /// How often vertices may be asked in all: what real batches need many times over, and a bound for hostile ones.
    pub(crate) fn most_visits(&self) -> u64 {
        256 * u64::from(self.position_count) + 65_536
    }
}
