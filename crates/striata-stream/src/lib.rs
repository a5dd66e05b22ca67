//! Progressive mesh streams: one compressed bitstream, ordered coarse to fine; every prefix decodes to a
//! mesh.
//!
//! A stream begins with a base mesh, followed by batches of vertex splits. In each batch, writer and reader
//! traverse the surface in the same order. A flag per vertex says whether it splits; if it does, a *cut*
//! says which of its triangles move to the new vertex. The positions and attributes of the new vertices are
//! then coded as differences from a prediction by their neighborhood. Sending fragments coarse to fine is
//! the idea of \[KG98\] (3.1), the batches follow \[PR00\]; connectivity is not stored as rules but
//! predicted from the geometry decoded so far.
//!
//! [`encode_stream`] writes a stream and [`StreamDecoder`] reads it in pieces of any size.
//! [`GrowingHierarchy`] makes view-dependent cuts of what has been decoded so far. [`open`] reads `.striata`
//! files whose mesh is a stream, and [`file_model`] prepares a stream for storage in such a file.
//!
//! # Reading order
//!
//! The folders, in the order in which a mesh passes through them:
//!
//! | folder | what it does |
//! | --- | --- |
//! | `format` | the container: header, position grid, errors, `.striata` files |
//! | `entropy` | the range coder and its adaptive models |
//! | `topology` | closed surfaces, and cutting arbitrary triangles into one |
//! | `writer` | coarsens the full mesh to the base, then writes the stream while refining it again |
//! | `reader` | decodes a stream that arrives in pieces, and exposes the mesh of each prefix |
//! | `refine` | the loop that writer and reader share: a base mesh, then batches of splits |
//! | `base` | the base mesh that the splits refine |
//! | `connectivity` | which vertices split, and which triangles move to the new vertices |
//! | `positions` | positions of new vertices |
//! | `wedges` | which wedge each corner of the changed triangles uses |
//! | `layers` | attributes of new vertices |
//! | `general` | batches of steps that are not splits of a surface |
//! | `growing` | view-dependent cuts of what has been decoded so far |
//!
//! # How it works
//!
//! One generic loop, `refine/refiner.rs`, runs on both sides over a `Coder`: the writer's decisions come
//! from the reference mesh, the reader's from the bytes. Models use integers only, so a stream has the same
//! bits on every machine.
//!
//! **Batches of splits.** No two removed positions of a batch are neighbors, and no two have the same
//! target, so all splits can be read off the coarse surface in any order. Each batch removes positions from
//! the cheapest 35 % only, which costs 1 to 10 % of RMS from a quarter of the triangles down on most meshes,
//! and makes the coder visit each vertex about six times.
//!
//! **General batches.** If parts vanish, sheets touch, or more than two triangles share an edge, a step is
//! not a split of a surface. Such steps wait until they are worth a batch of their own and are coded one
//! after another. Then writer and reader cut their triangles into a surface again. A mesh without such steps
//! pays for one flag in the header.
//!
//! **Damage.** Every chunk has a checksum. A truncated last chunk has none to compare, so every step must be
//! valid whatever the bits are: a split of any closed surface gives a closed surface. Work is bounded by
//! counts that bytes pay for.
//!
//! # Example
//! ```
//! use striata::mesh::shapes;
//! use striata::simplify::{BatchOptions, build_batches};
//! use striata_stream::{StreamDecoder, StreamOptions, encode_stream};
//!
//! let mesh = shapes::torus(32, 16, 1.0, 0.4);
//! let built = build_batches(&mesh, &BatchOptions::default())?;
//! let stream = encode_stream(&built.built.refinable, &built.batches, &StreamOptions::default())?;
//!
//! let mut decoder = StreamDecoder::new();
//! for piece in stream.bytes.chunks(100) {
//!     let update = decoder.push(piece)?;
//!     println!("{} more vertices, {} more triangles", update.vertices.len(), update.triangles.len());
//! }
//! assert!(decoder.is_complete());
//! assert_eq!(decoder.triangles().len(), mesh.triangle_count());
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod base;
mod connectivity;
#[doc(hidden)]
pub mod entropy;
mod format;
mod fragments;
mod general;
pub mod growing;
mod layers;
mod positions;
mod reader;
mod refine;
mod topology;
mod wedges;
mod writer;

pub use format::effort::Effort;
pub use format::error::{DecodeError, StreamDefect};
pub use format::files::{file_model, open, open_stream, open_truncated, open_with};
pub use format::grid::GridError;
pub use format::info::{ChunkInfo, StreamInfo};
pub use growing::{CutUpdate, GrowingHierarchy, HierarchyCut};
pub use layers::options::{LayerBitsError, LayerOptions};
pub use reader::decode::{StreamDecoder, StreamUpdate};
pub use reader::levels::StreamLevels;
pub use reader::prefix::PrefixMesh;
pub use striata::file::STREAM_MAGIC;
pub use topology::surface::SurfaceDefect;
pub use writer::defect::{BatchDefect, StreamError};
pub use writer::encode::{
    EncodedStream, Precision, SHAPE_STEPS, StreamOptions, StreamSizes, encode_stream,
    encode_stream_with_progress,
};
pub use writer::fragments::{encode_fragments, encode_fragments_with_progress};

/// Compiles the README's example with the documentation tests.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
