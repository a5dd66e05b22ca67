//! Errors of building a model from strips, or of loading one from stored arrays.

use crate::strip::StripSetError;

/// Error that prevents strips and a sequence from becoming a model, or makes a stored model invalid.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum ModelError {
    /// The strips and the mesh have different numbers of groups.
    #[error("the strips have {found} groups, the mesh has {expected}")]
    GroupCount {
        /// Number of groups of the strips.
        found: usize,
        /// Number of groups of the mesh.
        expected: usize,
    },
    /// The strips of a group and the mesh have different numbers of triangles.
    #[error("the strips of group {group} have {found} triangles, but the mesh has {expected}")]
    TriangleCount {
        /// Index of the group.
        group: usize,
        /// Number of triangles in the strips.
        found: usize,
        /// Number of triangles in the mesh.
        expected: usize,
    },
    /// A strip uses a vertex that does not exist.
    #[error("strip {strip} uses vertex {vertex}, but there are {vertex_count} vertices")]
    Vertex {
        /// Index of the strip.
        strip: usize,
        /// The invalid vertex.
        vertex: u32,
        /// Number of vertices.
        vertex_count: usize,
    },
    /// Offsets of strips or groups are inconsistent.
    #[error(transparent)]
    Offsets(#[from] StripSetError),
    /// An array of a stored model has the wrong length.
    #[error("{what}: found {found}, expected {expected}")]
    Length {
        /// Name of the counted elements.
        what: &'static str,
        /// Number found.
        found: usize,
        /// Number expected.
        expected: usize,
    },
    /// The record of a step does not match the strips that it edits.
    #[error("the record of step {step} {reason}")]
    Record {
        /// Index of the step.
        step: usize,
        /// Defect of the record.
        reason: &'static str,
    },
    /// The model has more elements than a 32-bit index can address.
    #[error("the model needs {found} {what}, but at most {limit} are supported")]
    TooMany {
        /// Name of the elements of which there are too many.
        what: &'static str,
        /// Number of elements.
        found: u64,
        /// Largest supported number.
        limit: u64,
    },
    /// Patterns expand to more triangles than their stored size allows.
    #[error("the patterns expand to {found} triangles over all steps, but at most {limit} can be stored")]
    Dense {
        /// Number of triangles of all ceilings.
        found: u64,
        /// Largest number allowed.
        limit: u64,
    },
    /// The mesh does not fit into the fixed-width fields of a model in its published form.
    #[error("the published form holds at most {limit} {what}, and there are {found}")]
    Form {
        /// Name of the elements of which there are too many.
        what: &'static str,
        /// Number of elements.
        found: u64,
        /// Largest number that fits.
        limit: u64,
    },
    /// The stored fans of a vertex are invalid.
    #[error("the entry of vertex {vertex} {reason}")]
    Entry {
        /// Index of the vertex.
        vertex: usize,
        /// Defect of the entry.
        reason: &'static str,
    },
    /// Data stored for a step contradicts the rest of the model.
    #[error("step {step} {reason}")]
    Step {
        /// Index of the step.
        step: usize,
        /// Defect of the step.
        reason: &'static str,
    },
    /// A list is out of order, or one of its entries refers to something that does not exist.
    #[error("{what} {place} {reason}")]
    Listed {
        /// Name of the listed elements.
        what: &'static str,
        /// Index of the entry in the list.
        place: usize,
        /// Defect of the entry.
        reason: &'static str,
    },
    /// Data stored for a strip is invalid.
    #[error("strip {strip} {reason}")]
    Strip {
        /// Index of the strip.
        strip: usize,
        /// Defect of the strip.
        reason: &'static str,
    },
}
