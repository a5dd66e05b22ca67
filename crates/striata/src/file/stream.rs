//! What the container knows of progressive streams: where their bytes are, and who decodes them.
//!
//! A stream may be all that a file has of its mesh. The crate `striata-stream` codes and decodes streams, and hands its decoder
//! over as a [`StreamCodec`].

use std::fmt::Debug;

use super::{DecodeError, Summary};
use crate::mesh::RefinableMesh;

/// The first bytes of a stream.
pub const STREAM_MAGIC: [u8; 4] = *b"\x89STR";

/// A stream as a file stores it: its bytes, and the counts that its head names.
///
/// `striata_stream::file_model` makes it of the bytes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct StoredStream<'s> {
    /// All bytes of the stream.
    pub bytes: &'s [u8],
    /// Vertices of the full mesh.
    pub vertex_count: usize,
    /// Triangles of the full mesh.
    pub triangle_count: usize,
    /// Steps from the base to the full mesh.
    pub step_count: usize,
    /// Groups of triangles; 0 if the mesh names none.
    pub group_count: usize,
}

/// What the beginning of a stream says of all of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StreamHead {
    /// Bytes of the whole stream.
    pub stream_bytes: u64,
    /// Counts; the bounds may be unknown.
    pub summary: Summary,
}

/// What the bytes of a stream give.
#[derive(Clone, Debug, PartialEq)]
pub struct StreamMesh {
    /// The mesh that has come, with the sequence that leads to it.
    pub refinable: RefinableMesh,
    /// Whether that is all of the stream.
    pub is_complete: bool,
}

/// Decodes the streams of files.
pub trait StreamCodec: Debug + Sync {
    /// Reads what the beginning of a stream says, from bytes that may be cut off.
    ///
    /// # Errors
    /// [`DecodeError`] if they begin no sound stream, go on after its end, or end before its base mesh does.
    fn head(&self, stream: &[u8]) -> Result<StreamHead, DecodeError>;

    /// The texts in the head of a stream, by key.
    ///
    /// # Errors
    /// [`DecodeError`] if the head is unsound.
    fn metadata(&self, stream: &[u8]) -> Result<Vec<(String, String)>, DecodeError>;

    /// Decodes a stream; only one that is cut off may end before it says.
    ///
    /// # Errors
    /// [`DecodeError`] if the stream is unsound, ends too early, or ends before its base mesh does.
    fn decode(&self, stream: &[u8], is_cut: bool) -> Result<StreamMesh, DecodeError>;
}
