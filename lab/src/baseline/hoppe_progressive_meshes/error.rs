//! The error type of building progressive meshes with split records.

/// Reason why a mesh has no split records, which require an oriented manifold surface at every level.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum HoppeProgressiveMeshesError {
    /// An edge has more than two triangles, or two of opposite orientation.
    #[error(
        "triangle {triangle} has an edge from position {} to {} that another triangle has too",
        ends[0], ends[1]
    )]
    Edge {
        /// A triangle of the edge.
        triangle: usize,
        /// The positions of the edge, in the order of the triangle.
        ends: [u32; 2],
    },
    /// A collapse does not lead from one manifold surface to another.
    #[error("step {step} collapses vertex {vertex}, but {reason}")]
    Step {
        /// The step.
        step: usize,
        /// The removed vertex.
        vertex: u32,
        /// The reason.
        reason: &'static str,
    },
    /// There are more groups than 16-bit material indices can address.
    #[error("{found} groups are more than the {limit} that a record can address")]
    Groups {
        /// Number of groups.
        found: usize,
        /// Largest number of groups.
        limit: usize,
    },
}
