//! Why a mesh or its sequence makes no view-dependent progressive mesh.

/// What keeps a mesh from being refined with \[Hop97\]: that takes manifold surfaces at every level.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum ViewDependentError {
    /// A position has several vertices: there is a seam.
    #[error(
        "position {position} has {vertex_count} vertices, where view-dependent progressive meshes allow one"
    )]
    Seam {
        /// The position.
        position: usize,
        /// Its vertices.
        vertex_count: usize,
    },
    /// An edge has more than two triangles, or two that face opposite ways.
    #[error("the edge of vertices {} and {} has {triangle_count} triangles that do not make one surface", ends[0], ends[1])]
    Edge {
        /// The vertices.
        ends: [u32; 2],
        /// Its triangles.
        triangle_count: usize,
    },
    /// A collapse does not lead from one manifold surface to another.
    #[error("step {step} collapses vertex {vertex} to vertex {target}, but {reason}")]
    Step {
        /// The step.
        step: usize,
        /// The vertex that it removes.
        vertex: u32,
        /// What that becomes.
        target: u32,
        /// What is in its way.
        reason: &'static str,
    },
    /// Triangles cannot be numbered.
    #[error("{triangle_count} triangles are more than 32 bits can number")]
    TooMany {
        /// Numbers that are needed.
        triangle_count: usize,
    },
}
