//! Positions that the vertices of a simplified mesh or scene may have.

use striata::mesh::IndexedMesh;
use striata::simplify::{Placement, Target};

use crate::args::{PlacementArg, SimplifyArgs};
use striata_command::args::OrderArg;
use striata_command::failure::Failure;

/// Which meshes get vertices that are not those of the input.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum ChosenPlacement {
    /// None.
    Subset,
    /// Those in which nothing refers to vertices: see [`Placement::for_one_level`].
    Suitable,
    /// All that can.
    Optimal,
}

impl ChosenPlacement {
    /// Returns what the user chose, or what suits the arguments.
    ///
    /// # Errors
    /// If there is a flag that does not work with `--placement optimal`.
    pub(super) fn of(args: &SimplifyArgs) -> Result<Self, Failure> {
        let sequence = &args.sequence;
        let fixed = [
            ("--order", sequence.order != OrderArg::Quadric),
            ("--new-vertices", sequence.new_vertices.is_some()),
            ("--max-error", args.max_error.is_some()),
            ("--certify", sequence.certify),
            ("--lod-chain", args.levels.lod_chain),
        ];
        let fixed = fixed.into_iter().find(|&(_, is_given)| is_given);
        match (args.placement, fixed) {
            (Some(PlacementArg::Subset), _) => Ok(Self::Subset),
            (Some(PlacementArg::Optimal), Some((flag, _))) => {
                Err(Failure::usage(format!("{flag} does not work with --placement optimal"))
                    .with_hint(format!("remove --placement optimal or {flag}")))
            }
            (Some(PlacementArg::Optimal), None) => Ok(Self::Optimal),
            (None, Some(_)) => Ok(Self::Subset),
            (None, None) => {
                let has_locks = sequence.lock_boundary || sequence.lock_groups || sequence.keep_height_field;
                let stays = has_locks || args.levels.levels.is_some();
                Ok(if stays { Self::Subset } else { Self::Suitable })
            }
        }
    }

    /// Whether the vertices of a mesh may move.
    pub(super) fn moves(self, mesh: &IndexedMesh) -> bool {
        match self {
            Self::Subset => false,
            Self::Suitable => Placement::for_one_level(mesh) == Placement::Optimal,
            Self::Optimal => true,
        }
    }
}

/// Name of the placement in reports.
pub(super) fn placement_name(is_optimal: bool) -> &'static str {
    if is_optimal { "optimal" } else { "subset" }
}

/// Note on the placement for a report in words; none for the vertices of the input.
pub(super) fn placement_note(placement: &str) -> &'static str {
    if placement == placement_name(true) { ", optimal placement" } else { "" }
}

/// Largest error that moved vertices may have.
pub(super) fn fitting_limit(target: Target) -> f64 {
    match target {
        Target::Error(error) => error,
        _ => f64::INFINITY,
    }
}
