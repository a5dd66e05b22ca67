//! Errors of GLB files with streams.

use striata::Cancelled;
use striata::file::DecodeError;
use striata_io::{ReadError, WriteError};
use striata_stream::StreamError;

use crate::error::{BuildError, SceneMismatch};

/// Why a scene cannot be written with streams.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum GlbStreamError {
    /// A mesh cannot be simplified.
    #[error(transparent)]
    Build(#[from] BuildError),
    /// A mesh cannot be encoded.
    #[error("meshes[{mesh}]: {error}")]
    Stream {
        /// Index of the mesh in the document.
        mesh: usize,
        /// Reason why it cannot be encoded.
        #[source]
        error: StreamError,
    },
    /// glTF cannot store a mesh of the scene.
    #[error(transparent)]
    Write(#[from] WriteError),
    /// The progress callback cancelled.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
}

/// Why the streams of a file cannot be read; its coarse level may still be readable by
/// [`read_scene_bytes`](striata_io::read_scene_bytes).
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum GlbStreamReadError {
    /// The glTF file itself is damaged.
    #[error(transparent)]
    Read(#[from] ReadError),
    /// The extension has a version that this reader does not support.
    #[error("meshes[{mesh}].extensions.STRIATA_lod.version: {found} is not supported, only 1")]
    Version {
        /// Index of the mesh in the document.
        mesh: usize,
        /// The version in the file, as JSON.
        found: String,
    },
    /// A stream is damaged.
    #[error("meshes[{mesh}].extensions.STRIATA_lod: {error}")]
    Stream {
        /// Index of the mesh in the document.
        mesh: usize,
        /// Reason why its stream cannot be decoded.
        #[source]
        error: DecodeError,
    },
    /// A stream ends too early.
    #[error("meshes[{mesh}].extensions.STRIATA_lod: the stream is truncated")]
    Truncated {
        /// Index of the mesh in the document.
        mesh: usize,
    },
    /// The groups of a stream differ from the triangle primitives of its mesh.
    #[error(transparent)]
    Mismatch(#[from] SceneMismatch),
    /// A mesh without a stream is inconsistent.
    #[error(transparent)]
    Build(#[from] BuildError),
    /// The progress callback cancelled.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
}
