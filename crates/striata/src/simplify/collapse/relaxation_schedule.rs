//! Decides when relaxed collapses begin.
//!
//! A position that has no strict collapse gets a relaxed one at its cost. On a closed surface of a few
//! large parts, relaxed collapses begin only after the last strict one, and nothing is prepared for
//! them until then.

use crate::mesh::Welded;

use super::cost_evaluator::CostEvaluator;
use super::relaxed_state::{RelaxedState, RemovedPositions};
use crate::simplify::options::TopologyRule;

/// On a closed surface of several parts, relaxed collapses are postponed if the parts have at least
/// this many triangles on average: strict collapses alone reduce them to a twenty-fifth.
const MIN_CLOSED_PART_TRIANGLES: usize = 100;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum ScheduleState {
    Never,
    /// No position has needed one yet.
    Undecided,
    /// Begin once no strict collapse is left anywhere.
    AfterStrict,
    Active,
}

/// Schedule of relaxed collapses: whether positions without a strict collapse may have one already.
pub(in crate::simplify) struct RelaxationSchedule<'a> {
    welded: &'a Welded,
    keeps_parts: bool,
    state: ScheduleState,
    /// State prepared for relaxed collapses that begin later.
    pending: Option<RelaxedState<'a>>,
}

impl<'a> RelaxationSchedule<'a> {
    pub(in crate::simplify) fn new(welded: &'a Welded, rule: TopologyRule) -> Self {
        let state = if rule == TopologyRule::Keep { ScheduleState::Never } else { ScheduleState::Undecided };
        Self { welded, keeps_parts: rule == TopologyRule::KeepParts, state, pending: None }
    }

    /// Whether there may ever be relaxed collapses.
    pub(in crate::simplify) fn is_possible(&self) -> bool {
        self.state != ScheduleState::Never
    }

    /// Whether relaxed collapses are postponed until no strict one is left.
    pub(in crate::simplify) fn is_postponed(&self) -> bool {
        self.state == ScheduleState::AfterStrict
    }

    /// Called when a position has no strict collapse: begins relaxed collapses, or postpones them.
    pub(in crate::simplify) fn begin_or_postpone(
        &mut self,
        evaluator: &mut CostEvaluator<'a>,
        removed: RemovedPositions<'_>,
    ) {
        if self.state != ScheduleState::Undecided {
            return;
        }
        let relaxed = RelaxedState::new(self.welded, self.keeps_parts);
        let part_count = relaxed.part_count();
        let is_postponed = self.welded.positions.is_identity()
            && (part_count == 1
                || MIN_CLOSED_PART_TRIANGLES * part_count <= self.welded.mesh.triangle_count())
            && evaluator.is_closed();
        self.pending = Some(relaxed);
        if is_postponed {
            self.state = ScheduleState::AfterStrict;
        } else {
            self.begin(evaluator, removed);
        }
    }

    /// Begins relaxed collapses; if they are ruled out, still begins tracking parts and their losses.
    pub(in crate::simplify) fn begin(
        &mut self,
        evaluator: &mut CostEvaluator<'a>,
        removed: RemovedPositions<'_>,
    ) {
        let mut relaxed =
            self.pending.take().unwrap_or_else(|| RelaxedState::new(self.welded, self.keeps_parts));
        relaxed.begins_last = self.is_postponed();
        relaxed.begin(&evaluator.links, &evaluator.is_locked, removed);
        evaluator.relaxed = Some(relaxed);
        if self.state != ScheduleState::Never {
            self.state = ScheduleState::Active;
        }
    }
}
