//! Errors of reading and writing files of scenes.

use striata::file::{DecodeError, EncodeError};
use striata_io::SceneError;

use crate::error::SceneMismatch;

/// Why bytes are not a valid file of a scene.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum SceneDecodeError {
    /// The container or one of its sections is damaged.
    #[error(transparent)]
    Container(#[from] DecodeError),
    /// The document is not valid JSON.
    #[error("section SCND: {0}")]
    Json(#[from] serde_json::Error),
    /// The parts of the scene do not match.
    #[error(transparent)]
    Scene(#[from] SceneError),
    /// The levels do not belong to the meshes of the document.
    #[error(transparent)]
    Mismatch(#[from] SceneMismatch),
    /// An image is malformed.
    #[error("section SCIM {image}, byte {offset}: {reason}")]
    Image {
        /// Number of the image.
        image: usize,
        /// Offset within the section, in bytes.
        offset: usize,
        /// Description of the problem.
        reason: &'static str,
    },
    /// The list of meshes with equal levels is malformed.
    #[error("section SCSH: a mesh without levels of its own has those of an earlier one, up to a limit")]
    Sharing,
    /// The file of a mesh is invalid.
    #[error("meshes[{mesh}]: {error}")]
    Mesh {
        /// Index of the mesh in the document.
        mesh: usize,
        /// Reason why its file cannot be read.
        #[source]
        error: DecodeError,
    },
}

/// Why a scene cannot be written.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum SceneEncodeError {
    /// A part is too large for the format, or writing failed.
    #[error(transparent)]
    Container(#[from] EncodeError),
    /// The levels do not belong to the meshes of the document.
    #[error(transparent)]
    Mismatch(#[from] SceneMismatch),
    /// The levels of a mesh cannot be stored.
    #[error("meshes[{mesh}]: {error}")]
    Mesh {
        /// Index of the mesh in the document.
        mesh: usize,
        /// Reason why it cannot be stored.
        #[source]
        error: EncodeError,
    },
    /// The bytes that were given for a mesh are not a valid file.
    #[error("meshes[{mesh}]: {error}")]
    MeshFile {
        /// Index of the mesh in the document.
        mesh: usize,
        /// Reason why the bytes cannot be read.
        #[source]
        error: DecodeError,
    },
}
