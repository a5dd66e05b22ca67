//! Finds the level of a sequence that a [`Target`] asks for.

use crate::mesh::{CollapseSequence, LevelTable};

use crate::simplify::options::{StopReason, Target};

impl Target {
    /// Returns the split count of the level that this target selects, and how well that level meets it.
    ///
    /// This is the most detailed level that does not exceed the target. If even the base mesh exceeds
    /// it, the base mesh is selected; if the full mesh falls short of it, the full mesh. For
    /// [`Target::Error`] it is the coarsest level within the error.
    pub fn resolve(&self, sequence: &CollapseSequence) -> (usize, StopReason) {
        self.resolve_in(sequence.levels())
    }

    /// Resolves the target against the levels of any kind of sequence; see [`Self::resolve`].
    pub fn resolve_in(&self, sequence: &LevelTable) -> (usize, StopReason) {
        let step_count = sequence.step_count();
        let (split_count, is_above_full, is_below_base) = match *self {
            Self::Triangles(n) => (
                sequence.split_count_for_triangles(n),
                n > sequence.triangle_count_at(step_count),
                n < sequence.triangle_count_at(0),
            ),
            Self::Vertices(n) => (
                sequence.split_count_for_vertices(n),
                n > sequence.vertex_count_at(step_count),
                n < sequence.vertex_count_at(0),
            ),
            Self::Detail(detail) => (sequence.split_count_for_detail(detail), detail > 1.0, detail < 0.0),
            Self::Error(error) => (
                sequence.split_count_for_error(error),
                error < 0.0,
                step_count > 0 && error > f64::from(sequence.error_at(0)),
            ),
            Self::SplitCount(n) => (n.min(step_count), n > step_count, false),
        };
        let stop_reason = if is_above_full {
            StopReason::FullMesh
        } else if is_below_base {
            StopReason::BaseReached
        } else {
            StopReason::TargetReached
        };
        (split_count, stop_reason)
    }
}
