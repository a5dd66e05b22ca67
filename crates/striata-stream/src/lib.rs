//! The progressive stream: one compressed bitstream, coarse to fine, whose every prefix is a mesh.
//!
//! A base mesh is followed by vertex splits in batches. In each batch both sides walk the surface; a flag says whether a
//! vertex splits, a cut which of its triangles go to the new vertex; then the new vertices' places and attributes
//! are told relative to what is around them. The idea of sending fragments coarse to fine is that of \[KG98\] (3.1), with
//! the batches of \[PR00\]; connectivity is not stored by rules but predicted from the geometry that is there.
//!
//! [`encode_stream`] writes a stream and [`StreamDecoder`] reads it in pieces of any size. [`GrowingHierarchy`] shows views of what
//! has come. [`open`] reads `.striata` files whose mesh is a stream, and [`file_model`] stores a stream in such a file.
//!
//! # Reading order
//!
//! The folders follow what happens to a mesh.
//!
//! | folder | what it does |
//! | --- | --- |
//! | `format` | what a stream is made of: versions, head, grid, errors, files |
//! | `entropy` | bits: the range coder and the models that learn |
//! | `topology` | closed surfaces, and any triangles cut into one |
//! | `writer` | the way down from the full mesh, and the stream that is written on the way up |
//! | `reader` | a stream that comes in pieces, and the mesh that each prefix is |
//! | `refine` | the loop that both of them run, over a base and batches of splits |
//! | `base` | the mesh that the splits begin with |
//! | `connectivity` | which vertices split, and which triangles go to the new ones |
//! | `positions` | where new vertices are |
//! | `wedges` | which vertices the corners of new triangles show |
//! | `layers` | the attributes of new vertices |
//! | `general` | batches of steps that are no splits of a surface |
//! | `growing` | views of what has come so far |
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
pub use format::facts::StreamFacts;
pub use format::files::{file_model, open, open_cut, open_stream, open_with};
pub use format::form::{Effort, StreamVersion};
pub use format::grid::GridError;
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

/// The examples of both readmes, compiled with the documentation's tests.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
