//! Bytes: the `.striata` container and its sections, as `docs/format.md` lays them out.
//!
//! A file is a table of sections; the big arrays lie in it as they lie in memory, aligned, so that a mapped
//! file is read without copying. Everything is bounded by the file's length and checked before it is
//! trusted; sections of kinds that a reader does not know are skipped unless they are flagged as required.

mod byte_reader;
mod container;
mod entropy;
mod error;
mod file_head;
mod mesh_sections;
pub mod progressive;
mod reader;
mod summary;
mod writer;

pub use container::{SectionInfo, SectionKind, VERSION as FORMAT_VERSION, Verify};
pub use error::{DecodeError, EncodeError};
pub use file_head::FileHead;
pub use reader::StriataFile;
pub use summary::Summary;
pub use writer::{FileModel, WriteOptions, to_striata, write_fragments, write_striata};

#[cfg(target_endian = "big")]
compile_error!("the arrays of a .striata file are little-endian and are read in place");
