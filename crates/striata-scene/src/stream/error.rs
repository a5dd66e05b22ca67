//! Errors of writing and reading scene streams.

use striata::simplify::SimplifyError;
use striata_io::SceneError;
use striata_stream::{DecodeError, StreamError};

/// Why a scene cannot be encoded.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum SceneEncodeError {
    /// A mesh cannot be simplified.
    #[error("meshes[{mesh}]: {source}")]
    Simplify {
        /// Index of the mesh.
        mesh: usize,
        /// Error of the simplification.
        source: SimplifyError,
    },
    /// A mesh cannot be encoded.
    #[error("meshes[{mesh}]: {source}")]
    Stream {
        /// Index of the mesh.
        mesh: usize,
        /// Error of encoding its stream.
        source: StreamError,
    },
    /// A part is too long for the format.
    #[error("{what} has {length} bytes, more than a scene stream can store")]
    TooLong {
        /// Name of the part.
        what: &'static str,
        /// Its length, bytes.
        length: usize,
    },
    /// The progress callback cancelled.
    #[error("cancelled")]
    Cancelled,
}

/// Why bytes cannot be decoded as a scene stream.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum SceneStreamError {
    /// The bytes do not begin with the magic bytes of a scene stream.
    #[error("not a scene stream: it begins with {found:02x?}")]
    Magic {
        /// The first bytes, at most 8.
        found: Vec<u8>,
    },
    /// This reader does not know the version of the stream.
    #[error("scene stream version {found}, but this reader knows up to {supported}")]
    Version {
        /// The version of the stream.
        found: u32,
        /// The latest version that this reader supports.
        supported: u32,
    },
    /// The stream is longer than its header states, or ends too early.
    #[error("the scene stream has {found} bytes, expected {expected}")]
    Length {
        /// Number of bytes given.
        found: u64,
        /// Number of bytes expected.
        expected: u64,
    },
    /// A packet is malformed or does not belong where it is.
    #[error("packet at byte {offset}: {reason}")]
    Packet {
        /// Byte offset of the packet in the stream.
        offset: u64,
        /// Reason in words.
        reason: String,
    },
    /// The checksum of a packet does not match.
    #[error("the packet at byte {offset} is damaged: checksum {found:08x}, expected {expected:08x}")]
    Checksum {
        /// Byte offset of the packet in the stream.
        offset: u64,
        /// Checksum of the bytes.
        found: u32,
        /// Checksum stored in the packet.
        expected: u32,
    },
    /// The document or its table is malformed.
    #[error("the document is malformed: {0}")]
    Document(String),
    /// The stream of a mesh is damaged.
    #[error("meshes[{mesh}]: {source}")]
    Mesh {
        /// Index of the mesh.
        mesh: usize,
        /// Error of decoding its stream.
        source: DecodeError,
    },
    /// A mesh, an image or the buffer contradicts the document.
    #[error(transparent)]
    Scene(#[from] SceneError),
    /// The scene cannot be drawn yet: more bytes have to arrive.
    #[error("not complete yet: a first picture needs at least {needed} bytes, and {found} are there")]
    NotDrawable {
        /// Number of bytes that have arrived.
        found: u64,
        /// Length of the prefix that shows every mesh; of the document, while that is not known. Bytes.
        needed: u64,
    },
    /// The decoder accepts no more bytes after an error or after `finish`.
    #[error("the decoder accepts no more bytes after an error or after finish")]
    Over,
}
