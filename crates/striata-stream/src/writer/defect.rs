//! Errors about sequences that cannot be encoded in batches.

/// Why a sequence does not consist of valid batches.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum BatchDefect {
    /// Below this level, a triangle would have two corners at one position.
    #[error("step {step} leaves a triangle with two corners at one position")]
    Wedges {
        /// Index of the step, coarse to fine.
        step: usize,
    },
    /// A position of the base mesh is not used by any triangle.
    #[error("position {position} of the base mesh is not used by any triangle")]
    UnusedPosition {
        /// Index of the position.
        position: usize,
    },
    /// The splits of a batch depend on each other.
    #[error("the steps of batch {batch} depend on each other")]
    Dependent {
        /// Index of the batch, coarse to fine.
        batch: usize,
    },
    /// The batches do not cover all steps in ascending order.
    #[error("the batch boundaries do not rise from 0 to the step count, {step_count}")]
    Cover {
        /// Number of steps in the sequence.
        step_count: usize,
    },
}
