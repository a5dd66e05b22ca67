//! The collapse chosen for an edge.

use glam::DVec3;

use crate::simplify::collapse::collapse_choice::CollapseKind;

/// No edge chosen yet: the key is a lower bound.
pub(super) const UNDECIDED: u32 = u32::MAX;

/// An edge collapse whose cost has been evaluated in full.
#[derive(Clone, Copy, Debug)]
pub(super) struct EdgeChoice {
    pub other: u32,
    pub other_version: u32,
    /// Whether the other end is removed and this one kept.
    pub is_kept: bool,
    pub position: DVec3,
    pub kind: CollapseKind,
    /// Squared distance that a relaxed collapse leaves.
    pub distance_squared: f32,
}

pub(super) const NO_CHOICE: EdgeChoice = EdgeChoice {
    other: UNDECIDED,
    other_version: 0,
    is_kept: false,
    position: DVec3::ZERO,
    kind: CollapseKind::Strict,
    distance_squared: 0.0,
};
