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

mod attributes;
mod base;
mod base_coder;
mod base_hood;
mod byte_reader;
mod chunks;
mod connectivity;
mod cutting;
mod decode;
mod descent;
mod direction_model;
mod directions;
mod encode;
mod entropy;
mod error;
mod facts;
mod files;
mod form;
mod general;
mod general_order;
mod general_stage;
mod grid;
pub mod growing;
mod growth;
mod head;
mod hidden_wedges;
mod hood;
mod layer_history;
mod layer_hood;
mod layer_model;
mod layers;
mod least_squares;
mod mixed_number;
mod number_model;
mod order;
mod positions;
mod prefix;
mod quick;
mod quick_cuts;
mod refiner;
mod residuals;
mod ring_fit;
mod rings;
mod source;
mod surface;
mod surface_stage;
mod tangents;
mod truth;
mod walk;
mod wedges;

pub use chunks::BatchDefect;
pub use decode::{StreamDecoder, StreamUpdate};
pub use encode::{
    EncodedStream, Precision, SHAPE_STEPS, StreamError, StreamOptions, StreamSizes, encode_stream,
};
pub use error::{DecodeError, StreamDefect};
pub use facts::StreamFacts;
pub use files::{file_model, open, open_cut, open_stream, open_with};
pub use form::{Effort, StreamVersion};
pub use grid::GridError;
pub use growing::{CutUpdate, GrowingHierarchy, HierarchyCut};
pub use layers::{LayerBitsError, LayerOptions};
pub use prefix::PrefixMesh;
pub use striata::file::STREAM_MAGIC;
pub use surface::SurfaceDefect;
pub use surface_stage::StepDefect;

/// The examples of both readmes, compiled with the documentation's tests.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
