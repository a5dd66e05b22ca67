//! Errors of building and combining scenes.

use striata::simplify::SimplifyError;

/// Why the levels of a scene cannot be built.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("mesh {mesh}{}: {error}", in_quotes(.name))]
pub struct BuildError {
    /// Index of the mesh in the document.
    pub mesh: usize,
    /// Name of the mesh; may be empty.
    pub name: String,
    /// Reason why the mesh cannot be simplified.
    #[source]
    pub error: SimplifyError,
}

impl BuildError {
    pub(crate) fn new(mesh: usize, name: String, error: SimplifyError) -> Self {
        Self { mesh, name, error }
    }
}

fn in_quotes(name: &str) -> String {
    if name.is_empty() { String::new() } else { format!(" {name:?}") }
}

/// Difference between a scene and the levels that are to belong to it.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum SceneMismatch {
    /// There are levels for another number of meshes.
    #[error("there are levels for {found} meshes, but the document has {expected}")]
    MeshCount {
        /// Number of entries with levels.
        found: usize,
        /// Number of meshes of the document.
        expected: usize,
    },
    /// The groups of a mesh differ from its triangle primitives.
    #[error("meshes[{mesh}]: {found} groups for {expected} triangle primitives")]
    GroupCount {
        /// Index of the mesh in the document.
        mesh: usize,
        /// Number of groups of its levels.
        found: usize,
        /// Number of its triangle primitives.
        expected: usize,
    },
}
