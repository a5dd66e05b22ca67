//! Why a sequence cannot be written as batches.

/// What keeps a step from being coded as a vertex split.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum StepDefect {
    /// The position is not manifold.
    #[error("its position is not manifold")]
    Locked,
    /// The position is not joined to its target by exactly one edge.
    #[error("it is not joined to its target by exactly one edge")]
    Edge,
    /// The triangles around the position do not form a simple ring, or too small a one.
    #[error("the triangles around it do not form a simple ring")]
    Ring,
    /// A boundary position leaves the boundary.
    #[error("it leaves the boundary")]
    Boundary,
}

/// Why a sequence is not one of batches.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum BatchDefect {
    /// A step is no vertex split of a surface.
    #[error("step {step} cannot be coded: {defect}")]
    Step {
        /// The step, coarse to fine.
        step: usize,
        /// What is wrong.
        defect: StepDefect,
    },
    /// A triangle would have two vertices of one position below a step.
    #[error("step {step} leaves a triangle with two corners at one position")]
    Wedges {
        /// The step, coarse to fine.
        step: usize,
    },
    /// A position of the base is in no triangle.
    #[error("position {position} of the base is in no triangle")]
    Lonely {
        /// The position.
        position: usize,
    },
    /// The splits of a batch are not independent of each other.
    #[error("the steps of batch {batch} depend on each other")]
    Dependent {
        /// The batch, coarse to fine from 0.
        batch: usize,
    },
    /// Batches do not cover the steps in order.
    #[error("the batches do not rise from 0 to the {step_count} steps")]
    Cover {
        /// Steps of the sequence.
        step_count: usize,
    },
}
