//! Errors of decoding a stream.

use striata::file::{self, SectionKind};

use crate::format::grid::GridError;
use crate::topology::surface::SurfaceDefect;

/// Why bytes could not be decoded as a progressive stream.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum DecodeError {
    /// The bytes do not begin with the magic bytes of a stream.
    #[error("not a progressive stream: it begins with {found:02x?}")]
    Magic {
        /// The first bytes, at most 8.
        found: Vec<u8>,
    },
    /// The stream has a format version that this reader does not support.
    #[error(
        "the stream has format version {found}, but this reader supports only version {supported}{}",
        if .found < .supported { "; an older version of striata made it, so it must be encoded again" } else { "" }
    )]
    Version {
        /// Version of the stream.
        found: u32,
        /// Supported version.
        supported: u32,
    },
    /// The bytes end before the first mesh does: more of them have to arrive.
    #[error("not complete yet: a first mesh needs at least {needed} bytes, and {found} are there")]
    Incomplete {
        /// Number of bytes given.
        found: u64,
        /// Number of bytes up to the end of the base mesh; of the header, while that is not known.
        needed: u64,
    },
    /// The stream is longer than its header says.
    #[error("the stream has {found} bytes, expected {expected}")]
    FileLength {
        /// Number of bytes given.
        found: u64,
        /// Number of bytes expected.
        expected: u64,
    },
    /// The header's checksum does not match.
    #[error("the header is damaged: checksum {found:08x}, expected {expected:08x}")]
    HeaderChecksum {
        /// Checksum of the bytes.
        found: u32,
        /// Checksum stored in the header.
        expected: u32,
    },
    /// A field of the header is invalid.
    #[error("section {}, byte {offset}: {reason}", SectionKind::STREAM)]
    Malformed {
        /// Byte offset in the stream.
        offset: usize,
        /// Why the field is invalid.
        reason: &'static str,
    },
    /// The header's materials or images are invalid.
    #[error(transparent)]
    Appearance(file::DecodeError),
    /// The header is valid, but what follows is not.
    #[error("the stream is damaged: {0}")]
    Stream(#[from] StreamDefect),
}

impl From<DecodeError> for file::DecodeError {
    fn from(error: DecodeError) -> Self {
        match error {
            DecodeError::Magic { found } => Self::Magic { found },
            DecodeError::Version { found, supported } => Self::Version { found, supported },
            DecodeError::Incomplete { found, needed } => Self::Incomplete { found, needed },
            DecodeError::FileLength { found, expected } => Self::FileLength { found, expected },
            DecodeError::HeaderChecksum { found, expected } => Self::HeaderChecksum { found, expected },
            DecodeError::Malformed { offset, reason } => {
                Self::Malformed { kind: SectionKind::STREAM, offset, reason }
            }
            DecodeError::Appearance(error) => error,
            DecodeError::Stream(defect) => defect.into(),
        }
    }
}

impl From<StreamDefect> for file::DecodeError {
    fn from(defect: StreamDefect) -> Self {
        Self::Stream(defect.to_string())
    }
}

/// Defects in what a stream encodes, and checksum mismatches in its chunks.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum StreamDefect {
    /// The batches split too few vertices each, so that decoding would take far too long.
    #[error("the stream has {batch_count} batches or more, too many for the number of its splits")]
    TooManyBatches {
        /// Number of batches decoded so far.
        batch_count: u32,
    },
    /// The grid of positions in the header is invalid.
    #[error(transparent)]
    Grid(#[from] GridError),
    /// The stream ends before the base mesh is complete.
    #[error("it ends before the base mesh is complete")]
    NoBase,
    /// The base mesh is not a closed surface.
    #[error("the base mesh is not a closed surface: {0}")]
    Base(#[from] SurfaceDefect),
    /// A position lies outside the grid.
    #[error("position {position} lies outside the grid")]
    OffGrid {
        /// Index of the position, in stream order.
        position: usize,
    },
    /// The chunks decoded so far create more vertices than chunks of their size may.
    #[error("chunk {chunk} creates more vertices than its length allows")]
    TooManyVertices {
        /// Index of the chunk; chunk 0 contains the base mesh.
        chunk: usize,
    },
    /// A chunk's checksum does not match.
    #[error("chunk {chunk} at byte {offset} is damaged: checksum {found:08x}, expected {expected:08x}")]
    Checksum {
        /// Index of the chunk; chunk 0 contains the base mesh.
        chunk: usize,
        /// Byte offset of the chunk in the stream.
        offset: u64,
        /// Checksum of the bytes.
        found: u32,
        /// Checksum stored in the header.
        expected: u32,
    },
    /// A total differs from the one in the header.
    #[error("it decodes to {found} {what}, but its header says {expected}")]
    Count {
        /// The items counted, for example `"triangles"`.
        what: &'static str,
        /// Number of items decoded.
        found: u64,
        /// Number of items given in the header.
        expected: u64,
    },
    /// A step creates a triangle with two corners at one position.
    #[error("step {step} creates a triangle with two corners at one position")]
    DegenerateTriangle {
        /// Index of the step, from 0.
        step: usize,
    },
    /// The bits of a step are no fragment of the level before.
    #[error("step {step} is no fragment of the level before it")]
    Fragment {
        /// Index of the step, from 0.
        step: usize,
    },
    /// A batch splits no vertex, so the stream would never end.
    #[error("batch {batch} splits no vertex")]
    EmptyBatch {
        /// Number of the batch, from 1.
        batch: u32,
    },
}
