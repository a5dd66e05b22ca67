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
//! [`GrowingHierarchy`] makes view-dependent cuts of what has been decoded so far. [`open`] reads
//! `.striata` files whose mesh is a stream, and [`file_model`] prepares a stream for storage in such a
//! file.
//!
//! # Reading order
//!
//! The folders, in the order in which a mesh passes through them:
//!
//! | folder | what it does |
//! | --- | --- |
//! | `format` | the container: versions, header, position grid, errors, `.striata` files |
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
mod entropy;
mod format;
mod general;
pub mod growing;
mod layers;
mod positions;
mod reader;
mod refine;
mod topology;
mod wedges;
mod writer;

pub use format::error::{DecodeError, StreamDefect};
pub use format::files::{file_model, open, open_stream, open_truncated, open_with};
pub use format::grid::GridError;
pub use format::info::StreamInfo;
pub use format::version::{Effort, StreamVersion};
pub use growing::{CutUpdate, GrowingHierarchy, HierarchyCut};
pub use layers::options::{LayerBitsError, LayerOptions};
pub use reader::decode::{StreamDecoder, StreamUpdate};
pub use reader::prefix::PrefixMesh;
pub use striata::file::STREAM_MAGIC;
pub use topology::surface::SurfaceDefect;
pub use writer::defect::{BatchDefect, StepDefect};
pub use writer::encode::{
    EncodedStream, Precision, SHAPE_STEPS, StreamError, StreamOptions, StreamSizes, encode_stream,
};

/// Compiles the README's example with the documentation tests.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
