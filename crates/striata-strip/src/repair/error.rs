//! Errors of [`LiveStrips`](super::LiveStrips).

use striata::mesh::MeshError;

/// Reason why strips cannot follow a mesh.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum LiveStripsError {
    /// The mesh is inconsistent.
    #[error(transparent)]
    Mesh(#[from] MeshError),
    /// The collapse sequence belongs to another mesh.
    #[error("the sequence has {found} vertices, the mesh has {expected}")]
    VertexCount {
        /// Number of vertices of the sequence.
        found: usize,
        /// Number of vertices of the mesh.
        expected: usize,
    },
    /// The split count exceeds the step count.
    #[error("there is no level at split count {found}: the last is {step_count}")]
    SplitCount {
        /// The requested split count.
        found: usize,
        /// Number of steps of the sequence.
        step_count: usize,
    },
    /// The strips and the mesh have different numbers of groups.
    #[error("the strips have {found} groups, the mesh has {expected}")]
    GroupCount {
        /// Number of groups of the strips.
        found: usize,
        /// Number of groups of the mesh.
        expected: usize,
    },
    /// A strip contains a triangle that the level does not have, or has less often.
    #[error(
        "strip {strip} contains the triangle {triangle:?}, which the level at split count {split_count} lacks"
    )]
    Triangle {
        /// Index of the strip.
        strip: usize,
        /// Vertices of the triangle, the smallest first.
        triangle: [u32; 3],
        /// Split count of the level.
        split_count: usize,
    },
    /// The strips of a group contain a different number of triangles than the level.
    #[error(
        "group {group}: the strips have {found} triangles, the level at split count {split_count} \
         has {expected}"
    )]
    TriangleCount {
        /// Index of the group.
        group: usize,
        /// Number of triangles in the strips.
        found: usize,
        /// Number of triangles of the level.
        expected: usize,
        /// Split count of the level.
        split_count: usize,
    },
}
