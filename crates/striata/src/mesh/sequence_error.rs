//! What is wrong with a sequence that does not hang together.

/// What makes the arrays of a sequence inconsistent.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum SequenceError {
    /// An array's length does not fit the others.
    #[error("the sequence holds {found} {what}, expected {expected}")]
    Length {
        /// Which array.
        what: &'static str,
        /// Its length.
        found: usize,
        /// The length that fits.
        expected: usize,
    },
    /// The first vertices of the positions do not rise from 0 to the vertex count.
    #[error("position {position} begins at vertex {first}, which is out of order")]
    PositionOrder {
        /// The position.
        position: usize,
        /// Its first vertex.
        first: u32,
    },
    /// A vertex collapses to one that is not older than its own position.
    #[error("vertex {vertex} collapses to {target}, but only vertices below {limit} are there")]
    Target {
        /// The vertex.
        vertex: usize,
        /// Its target.
        target: u32,
        /// First vertex of its position.
        limit: u32,
    },
    /// The wedges of one position collapse to different positions.
    #[error("vertex {vertex} collapses to position {found}, its neighbor wedge to {expected}")]
    SplitTarget {
        /// The vertex.
        vertex: usize,
        /// Position that it collapses to.
        found: u32,
        /// Position that the first wedge collapses to.
        expected: u32,
    },
    /// An error is negative, not a number, or grows with detail.
    #[error("step {step} carries the error {error}, after {previous}")]
    Error {
        /// The step.
        step: usize,
        /// Its error.
        error: f32,
        /// The error of the step before.
        previous: f32,
    },
    /// The counts of removed triangles do not lead from the full mesh to a base mesh.
    #[error("the steps remove {removed} triangles of {triangle_count}")]
    TriangleCount {
        /// Triangles that all steps remove.
        removed: u64,
        /// Triangles of the full mesh.
        triangle_count: usize,
    },
}

/// Checks that an array has the length that it should have.
pub(super) fn check_length(what: &'static str, found: usize, expected: usize) -> Result<(), SequenceError> {
    if found == expected { Ok(()) } else { Err(SequenceError::Length { what, found, expected }) }
}
