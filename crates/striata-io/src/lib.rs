//! Mesh files in and out: PLY, OBJ, STL, OFF and glTF, plain or inside gzip and zstd.
//!
//! ```no_run
//! let mesh = striata_io::read("bunny.ply")?;
//! striata_io::write("bunny.glb", &mesh, &striata_io::WriteOptions::default())?;
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! Readers take any bytes: they answer with a mesh or with the place and the reason, and allocate no more
//! than the bytes justify. Coordinates are read as they stand, NaN included:
//! [`IndexedMesh::check`](striata::mesh::IndexedMesh::check) judges them. Texture coordinates are
//! glTF's (`v` grows downwards) in meshes; OBJ is turned around on the way in and out.
//!
//! In reading order: `format`, `source` and `write_options` say what is asked, `error` what may go wrong; `read` and `write` choose
//! among `ply`, `obj`, `stl`, `off` and `gltf`, with `text` and `normals` below them; `compressed` and `atomic` are around a file;
//! `blocks` takes files that do not fit into memory.
//!
//! On wasm there are no files: what takes a path is left out, [`read_bytes`] and [`to_bytes`] are there.

#![cfg_attr(
    not(all(feature = "ply", feature = "obj", feature = "stl", feature = "off", feature = "gltf")),
    allow(unused, unreachable_code, reason = "shared by formats that may all be left out")
)]

#[cfg(not(target_family = "wasm"))]
mod atomic;
#[cfg(all(feature = "blocks", not(target_family = "wasm")))]
mod blocks;
mod compressed;
mod error;
mod format;
#[cfg(feature = "gltf")]
mod gltf;
#[cfg(not(target_family = "wasm"))]
mod lod;
mod normals;
#[cfg(feature = "obj")]
mod obj;
#[cfg(feature = "off")]
mod off;
#[cfg(feature = "ply")]
mod ply;
mod read;
mod source;
#[cfg(feature = "stl")]
mod stl;
mod text;
mod write;
mod write_options;

#[cfg(not(target_family = "wasm"))]
pub use atomic::{FileBatch, write_atomically};
#[cfg(all(feature = "blocks", not(target_family = "wasm")))]
pub use blocks::{StripSpool, TriangleBlocks};
pub use compressed::decompressed;
pub use error::{Place, ReadError, WriteError};
pub use format::Format;
#[cfg(not(target_family = "wasm"))]
pub use lod::{open, save};
#[cfg(not(target_family = "wasm"))]
pub use read::read;
pub use read::read_bytes;
pub use source::Source;
pub use write::to_bytes;
#[cfg(not(target_family = "wasm"))]
pub use write::{to_file_bytes, write};
pub use write_options::WriteOptions;

/// The readme's example, compiled with the documentation's tests.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
