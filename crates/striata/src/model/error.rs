//! Why strips, baselines or stored arrays do not make a model.

use crate::strip::StripSetError;

/// What keeps strips and a sequence from becoming a model, or makes a stored model unusable.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum ModelError {
    /// The strips have other groups than the mesh.
    #[error("the strips have {found} groups, the mesh has {expected}")]
    GroupCount {
        /// Groups of the strips.
        found: usize,
        /// Groups of the mesh.
        expected: usize,
    },
    /// The strips hold other triangles than the mesh.
    #[error("the strips of group {group} hold {found} triangles, the mesh has {expected}")]
    TriangleCount {
        /// The group.
        group: usize,
        /// Triangles of the strips.
        found: usize,
        /// Triangles of the mesh.
        expected: usize,
    },
    /// A strip names a vertex that is not there.
    #[error("strip {strip} uses vertex {vertex}, but there are {vertex_count} vertices")]
    Vertex {
        /// The strip.
        strip: usize,
        /// The vertex it names.
        vertex: u32,
        /// Vertices that exist.
        vertex_count: usize,
    },
    /// Offsets of strips or groups do not fit.
    #[error(transparent)]
    Offsets(#[from] StripSetError),
    /// Arrays of a stored model do not fit together.
    #[error("{what} number {found}, expected {expected}")]
    Length {
        /// Which array.
        what: &'static str,
        /// Its length.
        found: usize,
        /// The length that fits.
        expected: usize,
    },
    /// A record does not fit the strips that it edits.
    #[error("the record of step {step} {reason}")]
    Record {
        /// The step.
        step: usize,
        /// What is wrong.
        reason: &'static str,
    },
    /// The model would be too large to number its parts.
    #[error("the model needs {found} {what}, and 32-bit numbers reach to {limit}")]
    TooMany {
        /// What there would be too many of.
        what: &'static str,
        /// How many.
        found: u64,
        /// The most there can be.
        limit: u64,
    },
    /// Patterns stand for more triangles than their size lets expect.
    #[error("the patterns make {found} triangles on the way to the full mesh, at most {limit} can be stored")]
    Dense {
        /// Triangles of all ceilings.
        found: u64,
        /// The most there can be.
        limit: u64,
    },
    /// A model as published has fields that are too narrow for the mesh.
    #[error("the published form holds at most {limit} {what}, and there are {found}")]
    Form {
        /// What there is too much of.
        what: &'static str,
        /// How many.
        found: u64,
        /// The most there can be.
        limit: u64,
    },
    /// The fans of a vertex make no sense.
    #[error("the entry of vertex {vertex} {reason}")]
    Entry {
        /// The vertex.
        vertex: usize,
        /// What is wrong.
        reason: &'static str,
    },
    /// What is stored of a step does not fit what others say of it.
    #[error("step {step} {reason}")]
    Step {
        /// The step.
        step: usize,
        /// What is wrong.
        reason: &'static str,
    },
    /// A list is out of order, or names what is not there.
    #[error("{what} {place} {reason}")]
    Listed {
        /// What is listed.
        what: &'static str,
        /// Its place in the list.
        place: usize,
        /// What is wrong.
        reason: &'static str,
    },
    /// What is stored of a strip makes no sense.
    #[error("strip {strip} {reason}")]
    Strip {
        /// The strip.
        strip: usize,
        /// What is wrong.
        reason: &'static str,
    },
}
