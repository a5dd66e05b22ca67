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

#![cfg_attr(
    not(all(feature = "ply", feature = "obj", feature = "stl", feature = "off", feature = "gltf")),
    allow(unused, unreachable_code, reason = "shared by formats that may all be left out")
)]

mod atomic;
#[cfg(feature = "ply")]
mod blocks;
mod compressed;
mod error;
mod format;
#[cfg(feature = "gltf")]
mod gltf;
mod normals;
#[cfg(feature = "obj")]
mod obj;
#[cfg(feature = "off")]
mod off;
#[cfg(feature = "ply")]
mod ply;
mod read;
#[cfg(feature = "stl")]
mod stl;
mod text;
mod write;

pub use atomic::write_atomically;
#[cfg(feature = "ply")]
pub use blocks::{StripSpool, TriangleBlocks};
pub use compressed::decompressed;
pub use error::{Place, ReadError, WriteError};
pub use format::Format;
pub use read::{Source, read, read_bytes};
pub use write::{WriteOptions, to_bytes, write};
