//! Errors of reading and writing `.striata` files.

use super::section_kind::SectionKind;
use crate::mesh::{MeshError, SequenceError};
use crate::model::{ModelError, ModelKind};
use crate::strip::StripSetError;

/// Why bytes are not a valid `.striata` file.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum DecodeError {
    /// The file does not start with the magic bytes of the format.
    #[error("not a .striata file: it begins with {found:02x?}")]
    Magic {
        /// The first bytes, at most 8.
        found: Vec<u8>,
    },
    /// The file has a format version that this reader does not support.
    #[error(
        "the file has format version {found}, but this reader supports only version {supported}{}",
        if .found < .supported {
            "; an older version of striata made it, so it must be built or encoded again"
        } else {
            ""
        }
    )]
    Version {
        /// Version of the file.
        found: u32,
        /// Supported version.
        supported: u32,
    },
    /// The length of the file differs from what its header says or requires.
    #[error("the file has {found} bytes, expected {expected}")]
    FileLength {
        /// Length of the file, in bytes.
        found: u64,
        /// Expected length, in bytes.
        expected: u64,
    },
    /// The file is a stream that ends before its first mesh does: more of it has to arrive.
    #[error("not complete yet: a first mesh needs at least {needed} bytes, and {found} are there")]
    Incomplete {
        /// Length of the file, in bytes.
        found: u64,
        /// Length of the prefix that has the first mesh, in bytes; of the header, while that is not known.
        needed: u64,
    },
    /// The header or the section table is damaged.
    #[error("the header is damaged: checksum {found:08x}, expected {expected:08x}")]
    HeaderChecksum {
        /// Checksum computed from the bytes.
        found: u32,
        /// Checksum stored in the header.
        expected: u32,
    },
    /// The contents of a section are damaged.
    #[error("section {kind} at byte {offset} is damaged: checksum {found:08x}, expected {expected:08x}")]
    Checksum {
        /// Kind of the section.
        kind: SectionKind,
        /// Offset of the section in the file.
        offset: u64,
        /// Checksum computed from the bytes.
        found: u32,
        /// Checksum stored in the section table.
        expected: u32,
    },
    /// A section lies outside the file, overlaps another one, or is not aligned.
    #[error("section {kind} has an invalid location: {length} bytes at byte {offset} of {file_length}")]
    SectionLocation {
        /// Kind of the section.
        kind: SectionKind,
        /// Offset given for the section.
        offset: u64,
        /// Length given for the section, in bytes.
        length: u64,
        /// Length of the file, in bytes.
        file_length: u64,
    },
    /// A required section has a kind that this reader does not know.
    #[error("section {kind} is required, but this reader does not know it")]
    UnknownSection {
        /// Kind of the section.
        kind: SectionKind,
    },
    /// A section is missing, or occurs more than once.
    #[error("section {kind} occurs {found} times, expected once")]
    SectionCount {
        /// Kind of the section.
        kind: SectionKind,
        /// Number of sections of this kind.
        found: usize,
    },
    /// The contents of a section are invalid.
    #[error("section {kind}, byte {offset}: {reason}")]
    Malformed {
        /// Kind of the section.
        kind: SectionKind,
        /// Offset within the section, in bytes.
        offset: usize,
        /// Description of the problem.
        reason: &'static str,
    },
    /// Two parts of the file disagree about a count.
    #[error("section {kind} has {found} {what}, expected {expected}")]
    Count {
        /// Kind of the section.
        kind: SectionKind,
        /// Name of the counted elements.
        what: &'static str,
        /// Count found in the section.
        found: u64,
        /// Count that the rest of the file implies.
        expected: u64,
    },
    /// The requested level does not exist in the file.
    #[error("split count {split_count} is out of range: the file has {step_count} steps")]
    SplitCount {
        /// Requested split count.
        split_count: usize,
        /// Number of steps in the file.
        step_count: usize,
    },
    /// The file has fragments instead of collapses, and the request requires collapses.
    #[error(
        "the file was made by vertex removals instead of collapses; its levels are only available as fans or \
         patterns"
    )]
    NoCollapses,
    /// The file contains a scene, but a single mesh was requested.
    #[error("the file contains a scene of several meshes instead of one mesh; striata_scene::open reads it")]
    Scene,
    /// The progressive stream is invalid.
    #[error("the stream is damaged: {0}")]
    Stream(String),
    /// The mesh is only in a stream, and no [`StreamCodec`](super::StreamCodec) was given.
    #[error("the mesh is in a progressive stream, which needs the striata-stream crate")]
    NoStreamCodec,
    /// The mesh is inconsistent.
    #[error(transparent)]
    Mesh(#[from] MeshError),
    /// The sequence is inconsistent.
    #[error(transparent)]
    Sequence(#[from] SequenceError),
    /// A model is invalid.
    #[error("{model}: {reason}")]
    Model {
        /// Kind of the model.
        model: ModelKind,
        /// Description of the problem.
        reason: ModelError,
    },
    /// The strips of the full mesh are inconsistent.
    #[error(transparent)]
    Strips(#[from] StripSetError),
}

/// Why a mesh and its models cannot be written.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum EncodeError {
    /// Writing the output failed.
    #[error(transparent)]
    Io(#[from] std::io::Error),
    /// The mesh is inconsistent.
    #[error(transparent)]
    Mesh(#[from] MeshError),
    /// A model was built from a different mesh.
    #[error("the {model} model has {found} {what}, but the mesh has {expected}")]
    Model {
        /// Kind of the model.
        model: ModelKind,
        /// Name of the counted elements.
        what: &'static str,
        /// Count in the model.
        found: usize,
        /// Count in the mesh.
        expected: usize,
    },
    /// Two models use different strips, but a file contains only one set of strips.
    #[error("the {model} model uses different strips than the model before it")]
    OtherStrips {
        /// Kind of the later model.
        model: ModelKind,
    },
    /// The model exceeds a limit of the format. Readers enforce these limits against files made to exhaust
    /// memory.
    #[error("{model}: {reason}")]
    Unstorable {
        /// Kind of the model.
        model: ModelKind,
        /// The limit that is exceeded.
        reason: ModelError,
    },
    /// Two models of the same kind were given.
    #[error("the {model} model is given more than once")]
    RepeatedModel {
        /// Kind of the model.
        model: ModelKind,
    },
    /// A model needs collapses, but the mesh has fragments of any kind.
    #[error("the {model} model needs collapses, but the mesh was simplified by vertex removals")]
    NeedsCollapses {
        /// Kind of the model.
        model: ModelKind,
    },
    /// A mesh with fragments has levels only in a model, and none was given.
    #[error("a mesh that was simplified by vertex removals needs fans or patterns")]
    NoModel,
    /// There are more sections than a file can have.
    #[error("the file would have {found} sections, but at most {limit} can be stored")]
    TooManySections {
        /// Number of sections.
        found: usize,
        /// Largest number of sections.
        limit: usize,
    },
    /// A text or image is too large for the format.
    #[error("{what} has {length} bytes, but at most 4 GiB can be stored")]
    TooLong {
        /// Description of the text or image.
        what: &'static str,
        /// Its length, in bytes.
        length: usize,
    },
}
