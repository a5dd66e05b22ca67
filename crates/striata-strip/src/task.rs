//! Input of every stripifier, and what limits it: a budget, or a progress callback.

use std::ops::{ControlFlow, Range};

use striata::mesh::is_proper;
use striata::{Cancelled, Progress, ProgressFn};

use crate::options::StripOptions;

/// Callback that receives the number of moves made so far and returns the spent share of the budget. The
/// search ends at 1.
///
/// Searches plan by this share (annealing cools as it grows). It should grow steadily, and it must reach 1:
/// `cheapest` has no other end.
pub type SpentFn<'a> = dyn FnMut(u64) -> f64 + 'a;

/// Mesh and options of one call.
pub(crate) struct StripTask<'a> {
    pub triangles: &'a [[u32; 3]],
    pub positions: &'a [[f32; 3]],
    pub groups: &'a [Range<usize>],
    pub options: &'a StripOptions,
}

impl StripTask<'_> {
    /// Whether a triangle has three distinct corners; other triangles are in no strip.
    pub(crate) fn is_proper(&self, triangle: u32) -> bool {
        is_proper(&self.triangles[triangle as usize])
    }
}

/// Limits of a call: progress, cancellation and the moves that are allowed.
pub(crate) trait SearchLimits {
    /// Returns the spent share of the budget after a number of moves; see [`SpentFn`].
    fn spent(&mut self, moves: u64) -> f64;

    /// Reports progress of a part that has no budget.
    fn report(&mut self, now: Progress) -> ControlFlow<()>;

    /// Fails if the caller asked to stop; a search that was stopped returns like one whose budget is spent.
    fn check(&self) -> Result<(), Cancelled>;
}

/// The caller's budget, which cannot cancel.
pub(crate) struct CallerBudget<'a, 'f>(pub(crate) &'a mut SpentFn<'f>);

impl SearchLimits for CallerBudget<'_, '_> {
    fn spent(&mut self, moves: u64) -> f64 {
        (self.0)(moves)
    }

    fn report(&mut self, _: Progress) -> ControlFlow<()> {
        ControlFlow::Continue(())
    }

    fn check(&self) -> Result<(), Cancelled> {
        Ok(())
    }
}

/// A number of moves, and the caller's progress callback.
pub(crate) struct Reported<'a, 'p> {
    progress: &'a mut ProgressFn<'p>,
    /// Number of moves of the search; infinite if it ends by itself.
    allowed: f64,
    is_cancelled: bool,
}

impl<'a, 'p> Reported<'a, 'p> {
    pub(crate) fn new(progress: &'a mut ProgressFn<'p>, allowed: f64) -> Self {
        Self { progress, allowed: allowed.max(1.0), is_cancelled: false }
    }
}

impl SearchLimits for Reported<'_, '_> {
    fn spent(&mut self, moves: u64) -> f64 {
        // How many moves a search without a budget will make is unknown.
        let total = if self.allowed.is_finite() { self.allowed as u64 } else { moves };
        match self.report(Progress { phase: "strip", done: moves.min(total), total }) {
            ControlFlow::Continue(()) => moves as f64 / self.allowed,
            ControlFlow::Break(()) => 1.0,
        }
    }

    fn report(&mut self, now: Progress) -> ControlFlow<()> {
        self.is_cancelled = self.is_cancelled || (self.progress)(now).is_break();
        if self.is_cancelled { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    }

    fn check(&self) -> Result<(), Cancelled> {
        if self.is_cancelled { Err(Cancelled) } else { Ok(()) }
    }
}
