//! What can be wrong with a file, and with what is to become one.

use super::SectionKind;
use crate::mesh::{MeshError, SequenceError};
use crate::model::{ModelError, ModelKind};
use crate::strip::StripSetError;

/// Why bytes are not a `.striata` file, or not a sound one.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum DecodeError {
    /// The file does not begin with the format's magic bytes.
    #[error("not a .striata file: it begins with {found:02x?}")]
    Magic {
        /// The first bytes, at most 8.
        found: Vec<u8>,
    },
    /// The file is of a version that this reader does not know.
    #[error("format version {found}, but this reader knows up to {supported}")]
    Version {
        /// The file's version.
        found: u32,
        /// The latest known version.
        supported: u32,
    },
    /// The file is shorter or longer than it says, or than its header needs.
    #[error("the file has {found} bytes, expected {expected}")]
    FileLength {
        /// Bytes that are there.
        found: u64,
        /// Bytes that should be.
        expected: u64,
    },
    /// The header or its table is damaged.
    #[error("the header is damaged: checksum {found:08x}, expected {expected:08x}")]
    HeaderChecksum {
        /// Checksum of the bytes.
        found: u32,
        /// Checksum that the header holds.
        expected: u32,
    },
    /// A section's bytes are damaged.
    #[error("section {kind} at byte {offset} is damaged: checksum {found:08x}, expected {expected:08x}")]
    Checksum {
        /// The section.
        kind: SectionKind,
        /// Where it begins.
        offset: u64,
        /// Checksum of the bytes.
        found: u32,
        /// Checksum that the table holds.
        expected: u32,
    },
    /// A section lies outside the file, over another one, or unaligned.
    #[error("section {kind} has no sound place: {length} bytes at byte {offset} of {file_length}")]
    SectionPlace {
        /// The section.
        kind: SectionKind,
        /// Where it should begin.
        offset: u64,
        /// Its bytes.
        length: u64,
        /// Bytes of the file.
        file_length: u64,
    },
    /// A section that has to be understood is of a kind that this reader does not know.
    #[error("section {kind} is required, but this reader does not know it")]
    UnknownSection {
        /// The section.
        kind: SectionKind,
    },
    /// A section is missing, or there more than once.
    #[error("section {kind} is there {found} times, expected once")]
    SectionCount {
        /// The section.
        kind: SectionKind,
        /// How many there are.
        found: usize,
    },
    /// A section's content makes no sense.
    #[error("section {kind}, byte {offset}: {reason}")]
    Malformed {
        /// The section.
        kind: SectionKind,
        /// Where in the section.
        offset: usize,
        /// What is wrong.
        reason: &'static str,
    },
    /// Two parts of the file disagree on a number.
    #[error("section {kind} holds {found} {what}, expected {expected}")]
    Count {
        /// The section.
        kind: SectionKind,
        /// What is counted.
        what: &'static str,
        /// What the section holds.
        found: u64,
        /// What the rest of the file needs.
        expected: u64,
    },
    /// A level was asked for that the file does not have.
    #[error("split count {split_count} asked for, but the file has {step_count} steps")]
    SplitCount {
        /// The level.
        split_count: usize,
        /// Steps of the file.
        step_count: usize,
    },
    /// The file has fragments, and something was asked for that only collapses tell.
    #[error("the file was made by removing vertices, not by collapses: only its patterns know its levels")]
    NoCollapses,
    /// A progressive stream is unsound.
    #[error("the stream is damaged: {0}")]
    Stream(String),
    /// The mesh is in a stream, and no [`StreamCodec`](super::StreamCodec) was given.
    #[error("the mesh is in a progressive stream, which needs the striata-stream crate")]
    NoStreamCodec,
    /// The mesh is unsound.
    #[error(transparent)]
    Mesh(#[from] MeshError),
    /// The sequence is unsound.
    #[error(transparent)]
    Sequence(#[from] SequenceError),
    /// A model is unsound.
    #[error("{model}: {reason}")]
    Model {
        /// The model.
        model: ModelKind,
        /// What is wrong with it.
        reason: ModelError,
    },
    /// The strips of the full mesh are unsound.
    #[error(transparent)]
    Strips(#[from] StripSetError),
}

/// Why a mesh and its models cannot be written.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum EncodeError {
    /// The writer failed.
    #[error(transparent)]
    Io(#[from] std::io::Error),
    /// The mesh is unsound.
    #[error(transparent)]
    Mesh(#[from] MeshError),
    /// A model was built from another mesh.
    #[error("the {model} model has {found} {what}, the mesh has {expected}")]
    Model {
        /// The model.
        model: ModelKind,
        /// What is counted.
        what: &'static str,
        /// The model's number.
        found: usize,
        /// The mesh's number.
        expected: usize,
    },
    /// Two models start from different strips; a file holds the strips once.
    #[error("the {model} model starts from other strips than the model before it")]
    OtherStrips {
        /// The later model.
        model: ModelKind,
    },
    /// A file cannot hold the model, since no reader could tell it from one that is meant to fill its memory.
    #[error("{model}: {reason}")]
    Unstorable {
        /// The model.
        model: ModelKind,
        /// What is too much of it.
        reason: ModelError,
    },
    /// The same model was given twice.
    #[error("the {model} model is given more than once")]
    RepeatedModel {
        /// The model.
        model: ModelKind,
    },
    /// A text or image is too large for the format.
    #[error("{what} has {length} bytes, at most 4 GiB can be stored")]
    TooLong {
        /// What it is.
        what: &'static str,
        /// Its bytes.
        length: usize,
    },
}
