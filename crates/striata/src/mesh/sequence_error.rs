//! Errors of inconsistent sequences.

/// Why the arrays of a sequence are inconsistent.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum SequenceError {
    /// The length of an array does not match the others.
    #[error("the sequence has {found} {what}, expected {expected}")]
    Length {
        /// Name of the array.
        what: &'static str,
        /// Length of the array.
        found: usize,
        /// Length that the other arrays imply.
        expected: usize,
    },
    /// The first vertices of the positions do not increase from 0 to the vertex count.
    #[error("position {position} begins at vertex {first}, which is out of order")]
    PositionOrder {
        /// Index of the position.
        position: usize,
        /// Its first vertex.
        first: u32,
    },
    /// A vertex collapses to a vertex that does not come before its own position.
    #[error("vertex {vertex} collapses to vertex {target}, but its target must be below {limit}")]
    Target {
        /// The collapsed vertex.
        vertex: usize,
        /// Its target.
        target: u32,
        /// First vertex of the collapsed position.
        limit: u32,
    },
    /// The wedges of one position collapse to different positions.
    #[error(
        "vertex {vertex} collapses to position {found}, but another wedge of its position collapses \
         to {expected}"
    )]
    SplitTarget {
        /// The collapsed vertex.
        vertex: usize,
        /// Position that this vertex collapses to.
        found: u32,
        /// Position that the first wedge collapses to.
        expected: u32,
    },
    /// An error is negative, not finite, or grows with detail.
    #[error("step {step} has the error {error}, after {previous}: errors must be at least 0 and never rise")]
    Error {
        /// Index of the step.
        step: usize,
        /// Its error.
        error: f32,
        /// Error of the previous step.
        previous: f32,
    },
    /// The counts of removed triangles exceed the triangles of the full mesh.
    #[error("the steps remove {removed} triangles, but the full mesh has {triangle_count}")]
    TriangleCount {
        /// Number of triangles that all steps remove together.
        removed: u64,
        /// Number of triangles of the full mesh.
        triangle_count: usize,
    },
}

/// Checks that an array has the expected length.
pub(super) fn check_length(what: &'static str, found: usize, expected: usize) -> Result<(), SequenceError> {
    if found == expected { Ok(()) } else { Err(SequenceError::Length { what, found, expected }) }
}
