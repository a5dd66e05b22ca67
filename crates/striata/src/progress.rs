//! Progress and cancellation by a plain callback: no thread, no clock, no terminal in the library.

use std::ops::ControlFlow;

/// Progress of a long operation, passed to the caller's callback from time to time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Progress {
    /// Current activity, as one word fit for a progress bar (`"simplify"`).
    pub phase: &'static str,
    /// Units of work done so far.
    pub done: u64,
    /// Total units of work; an estimate if the operation may stop early.
    pub total: u64,
}

impl Progress {
    /// Hands itself to the caller's callback.
    ///
    /// # Errors
    /// [`Cancelled`] if the callback asks to stop.
    pub fn report(self, progress: &mut ProgressFn<'_>) -> Result<(), Cancelled> {
        match progress(self) {
            ControlFlow::Continue(()) => Ok(()),
            ControlFlow::Break(()) => Err(Cancelled),
        }
    }
}

/// The callback of long operations: answer [`ControlFlow::Break`] to cancel.
pub type ProgressFn<'a> = dyn FnMut(Progress) -> ControlFlow<()> + 'a;

/// A callback for callers who need neither progress nor cancellation.
pub fn ignore_progress(_: Progress) -> ControlFlow<()> {
    ControlFlow::Continue(())
}

/// The caller's progress callback asked to stop.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("cancelled")]
pub struct Cancelled;
