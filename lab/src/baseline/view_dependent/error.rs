//! The error type of building a view-dependent mesh.

/// Reason why a mesh cannot be refined as in \[Hop97\], which requires a manifold surface at every level.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum ViewDependentError {
    /// A position has several vertices, so there is a seam.
    #[error("position {position} has {vertex_count} vertices, but view-dependent meshes allow only one")]
    Seam {
        /// Index of the position.
        position: usize,
        /// Number of its vertices.
        vertex_count: usize,
    },
    /// An edge has more than two triangles, or two of opposite orientation.
    #[error(
        "the edge of vertices {} and {} has {triangle_count} triangles that do not form a manifold surface",
        ends[0], ends[1]
    )]
    Edge {
        /// The vertices of the edge.
        ends: [u32; 2],
        /// Number of its triangles.
        triangle_count: usize,
    },
    /// A collapse does not lead from one manifold surface to another.
    #[error("step {step} collapses vertex {vertex} to vertex {target}, but {reason}")]
    Step {
        /// The step.
        step: usize,
        /// The removed vertex.
        vertex: u32,
        /// The vertex it collapses to.
        target: u32,
        /// The reason.
        reason: &'static str,
    },
    /// There are too many triangles to index.
    #[error("{triangle_count} triangles are more than 32-bit indices can address")]
    TooMany {
        /// Number of indices needed.
        triangle_count: usize,
    },
}
