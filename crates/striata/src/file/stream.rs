//! Progressive streams inside files: their location, and the interface of their decoder.
//!
//! A stream may be the only representation of the mesh in a file. The crate `striata-stream` encodes and
//! decodes streams and provides its decoder as a [`StreamCodec`].

use std::fmt::Debug;

use super::{DecodeError, Summary};
use crate::mesh::Steps;

/// The first bytes of a stream.
pub const STREAM_MAGIC: [u8; 4] = *b"\x89STR";

/// The first bytes of a stream of a whole scene, which contains a stream for each of its meshes.
pub const SCENE_STREAM_MAGIC: [u8; 4] = *b"\x89SCN";

/// A stream to be stored in a file: its bytes and the counts from its head.
///
/// `striata_stream::file_model` creates one from the bytes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct StoredStream<'s> {
    /// All bytes of the stream.
    pub bytes: &'s [u8],
    /// Number of vertices of the full mesh.
    pub vertex_count: usize,
    /// Number of triangles of the full mesh.
    pub triangle_count: usize,
    /// Number of steps from the base mesh to the full mesh.
    pub step_count: usize,
    /// Number of triangle groups; 0 if the mesh has none.
    pub group_count: usize,
}

/// Contents of a stream's head.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StreamHead {
    /// Length of the whole stream, in bytes.
    pub stream_bytes: u64,
    /// Counts of the mesh; the bounds may be unknown.
    pub summary: Summary,
    /// Whether its steps are collapses.
    pub has_collapses: bool,
}

/// Result of decoding a stream.
#[derive(Clone, Debug, PartialEq)]
pub struct StreamMesh {
    /// The mesh decoded so far, with its steps.
    pub steps: Steps,
    /// Whether the whole stream has been decoded.
    pub is_complete: bool,
}

/// Decoder for the streams in files.
pub trait StreamCodec: Debug + Sync {
    /// Reads the head of a stream, which may be truncated.
    ///
    /// # Errors
    /// [`DecodeError`] if the bytes do not start a valid stream, continue after its end, or end before its
    /// base mesh is complete.
    fn head(&self, stream: &[u8]) -> Result<StreamHead, DecodeError>;

    /// Reads the key-value texts in the head of a stream.
    ///
    /// # Errors
    /// [`DecodeError`] if the head is invalid.
    fn metadata(&self, stream: &[u8]) -> Result<Vec<(String, String)>, DecodeError>;

    /// Decodes a stream. `is_truncated` allows the stream to be truncated.
    ///
    /// # Errors
    /// [`DecodeError`] if the stream is invalid, is truncated although `is_truncated` is false, or ends
    /// before its base mesh is complete.
    fn decode(&self, stream: &[u8], is_truncated: bool) -> Result<StreamMesh, DecodeError>;
}
