//! Errors about sequences that cannot be encoded in batches.

/// Why a step cannot be encoded as a vertex split.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum StepDefect {
    /// The surface is not manifold at the position.
    #[error("its position is not manifold")]
    Locked,
    /// The position and its target are not connected by exactly one edge.
    #[error("it is not connected to its target by exactly one edge")]
    Edge,
    /// The triangles around the position do not form a simple ring, or the ring is too small.
    #[error("the triangles around it do not form a simple ring")]
    Ring,
    /// The collapse moves a boundary position off the boundary.
    #[error("its collapse leaves the boundary")]
    Boundary,
}

/// Why a sequence does not consist of valid batches.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum BatchDefect {
    /// A step cannot be encoded as a vertex split of a surface.
    #[error("step {step} cannot be encoded: {defect}")]
    Step {
        /// Index of the step, coarse to fine.
        step: usize,
        /// The defect of the step.
        defect: StepDefect,
    },
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
