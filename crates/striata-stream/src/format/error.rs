//! What can be wrong with the bytes of a stream.

use striata::file::{self, SectionKind};

use crate::format::grid::GridError;
use crate::topology::surface::SurfaceDefect;

/// Why bytes are not a progressive stream, or not a sound one.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum DecodeError {
    /// The bytes do not begin with the magic bytes of a stream.
    #[error("not a .striata file: it begins with {found:02x?}")]
    Magic {
        /// The first bytes, at most 8.
        found: Vec<u8>,
    },
    /// The stream is of a version that this reader does not know.
    #[error("format version {found}, but this reader knows up to {supported}")]
    Version {
        /// The stream's version.
        found: u32,
        /// The latest known version.
        supported: u32,
    },
    /// The stream is shorter or longer than it says, or than its head needs.
    #[error("the file has {found} bytes, expected {expected}")]
    FileLength {
        /// Bytes that are there.
        found: u64,
        /// Bytes that should be.
        expected: u64,
    },
    /// The head is damaged.
    #[error("the header is damaged: checksum {found:08x}, expected {expected:08x}")]
    HeaderChecksum {
        /// Checksum of the bytes.
        found: u32,
        /// Checksum that the head holds.
        expected: u32,
    },
    /// The head makes no sense.
    #[error("section {}, byte {offset}: {reason}", SectionKind::STREAM)]
    Malformed {
        /// Where in the stream.
        offset: usize,
        /// What is wrong.
        reason: &'static str,
    },
    /// The materials and images in the head make no sense.
    #[error(transparent)]
    Appearance(file::DecodeError),
    /// The stream is unsound.
    #[error("the stream is damaged: {0}")]
    Stream(#[from] StreamDefect),
}

impl From<DecodeError> for file::DecodeError {
    fn from(error: DecodeError) -> Self {
        match error {
            DecodeError::Magic { found } => Self::Magic { found },
            DecodeError::Version { found, supported } => Self::Version { found, supported },
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

/// What can be wrong within a stream whose bytes are as they were written.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum StreamDefect {
    /// There are so many batches of so few splits that reading them would take for ever.
    #[error("{batch_count} batches were read, and they are too many for so few splits")]
    Batches {
        /// Batches read.
        batch_count: u32,
    },
    /// The grid is none.
    #[error(transparent)]
    Grid(#[from] GridError),
    /// The stream ends before its base mesh does.
    #[error("it ends before the base mesh does")]
    NoBase,
    /// The base is no closed surface.
    #[error("the base mesh is no surface: {0}")]
    Base(#[from] SurfaceDefect),
    /// A position lies off the grid.
    #[error("position {position} lies off the grid")]
    Place {
        /// The position, in the order of the stream.
        position: usize,
    },
    /// Positions have more vertices than so few bytes can tell.
    #[error("chunk {chunk} tells of more vertices than its bytes can")]
    Wedges {
        /// The chunk, from 0, which holds the base.
        chunk: usize,
    },
    /// A chunk's bytes are damaged.
    #[error("chunk {chunk} at byte {offset} is damaged: checksum {found:08x}, expected {expected:08x}")]
    Checksum {
        /// The chunk, from 0, which holds the base.
        chunk: usize,
        /// Where it begins in the stream.
        offset: u64,
        /// Checksum of the bytes.
        found: u32,
        /// Checksum that the head holds.
        expected: u32,
    },
    /// What was decoded is not what the head promises.
    #[error("it gives {found} {what}, but its head says {expected}")]
    Count {
        /// What is counted.
        what: &'static str,
        /// What came.
        found: u64,
        /// What was promised.
        expected: u64,
    },
    /// A step brings a triangle that has two corners at one position.
    #[error("step {step} brings a triangle without three different corners")]
    Step {
        /// The step, from 0.
        step: usize,
    },
    /// A batch splits nothing, so that the stream would never end.
    #[error("batch {batch} splits no vertex")]
    EmptyBatch {
        /// The batch, from 1.
        batch: u32,
    },
}
