//! Why strips cannot follow a mesh.

use striata::mesh::MeshError;

/// What keeps strips and a mesh from being followed together.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum LiveStripsError {
    /// The mesh's parts do not fit together.
    #[error(transparent)]
    Mesh(#[from] MeshError),
    /// The sequence is that of another mesh.
    #[error("the sequence is of {found} vertices, the mesh has {expected}")]
    VertexCount {
        /// Vertices of the sequence.
        found: usize,
        /// Vertices of the mesh.
        expected: usize,
    },
    /// There is no such level.
    #[error("there is no level at split count {found}: the last is {step_count}")]
    SplitCount {
        /// The level that was asked for.
        found: usize,
        /// Steps of the sequence.
        step_count: usize,
    },
    /// The strips have other groups than the mesh.
    #[error("the strips have {found} groups, the mesh has {expected}")]
    GroupCount {
        /// Groups of the strips.
        found: usize,
        /// Groups of the mesh.
        expected: usize,
    },
    /// A strip holds a triangle that the level has not, or once too often.
    #[error(
        "strip {strip} holds the triangle {triangle:?}, which the level at split count {split_count} lacks"
    )]
    Triangle {
        /// The strip.
        strip: usize,
        /// The triangle, its smallest vertex first.
        triangle: [u32; 3],
        /// The level.
        split_count: usize,
    },
    /// The strips hold fewer triangles than the level, or in another group.
    #[error(
        "the strips of group {group} hold {found} triangles, the level at split count {split_count} {expected}"
    )]
    TriangleCount {
        /// The group.
        group: usize,
        /// Triangles of the strips.
        found: usize,
        /// Triangles of the level.
        expected: usize,
        /// The level.
        split_count: usize,
    },
}
