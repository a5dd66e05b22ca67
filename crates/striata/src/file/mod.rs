//! The `.striata` file format: a container of sections, specified in `docs/format.md`.
//!
//! A file is a table of sections. Large arrays are stored as they are laid out in memory, and aligned, so
//! that a memory-mapped file can be used without copying. Every count is bounded by the file's length, and
//! everything is checked before it is trusted. Readers skip sections of unknown kinds unless these are
//! flagged as required.
//!
//! ```
//! use striata::file::StriataFile;
//! use striata::{Lod, LodOptions, mesh::shapes};
//!
//! let lod = Lod::build(&shapes::torus(32, 16, 1.0, 0.4), &LodOptions::default())?;
//! let bytes = lod.to_striata(&Default::default())?;
//! let file = StriataFile::parse(&bytes)?; // borrows its arrays from the bytes
//! println!("{} vertices in {} sections", file.positions()?.len(), file.sections().len());
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod byte_reader;
mod container;
mod error;
mod file_head;
mod mesh_sections;
mod reader;
mod section_kind;
mod stream;
mod summary;
mod writer;

pub use container::{Container, SectionInfo, VERSION as FORMAT_VERSION, Verify};
pub use error::{DecodeError, EncodeError};
pub use file_head::FileHead;
pub use mesh_sections::{
    SemanticCode, appearance_from_bytes, appearance_to_bytes, metadata_to_bytes, semantic_code, semantic_of,
};
pub use reader::StriataFile;
pub use section_kind::SectionKind;
pub use stream::{SCENE_STREAM_MAGIC, STREAM_MAGIC, StoredStream, StreamCodec, StreamHead, StreamMesh};
pub use summary::Summary;
pub use writer::{
    FileModel, Section, WriteOptions, to_striata, write_fragments, write_sections, write_striata,
};

/// Metadata key and value by which a file records that its errors are guaranteed bounds.
const GUARANTEED_ERRORS: (&str, &str) = ("errors", "guaranteed");

/// Whether metadata say that errors are guaranteed bounds rather than estimates.
pub fn metadata_has_guaranteed_errors(metadata: &[(String, String)]) -> bool {
    let (key, value) = GUARANTEED_ERRORS;
    metadata.iter().any(|(k, v)| k == key && v == value)
}

#[cfg(target_endian = "big")]
compile_error!("the arrays of a .striata file are little-endian and are used in place");
