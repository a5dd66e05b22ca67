//! WebAssembly bindings of striata: a model that grows as its bytes arrive and can show any of its levels
//! of detail.
//!
//! There is one main class, [`Model`]. Push the bytes of a stream into it and show what has arrived after
//! each push. Levels are requested by detail, triangle count, error or camera, and returned as indices over a
//! single vertex buffer that only grows. The models of a [`SceneModel`] grow together; those of a
//! [`StoredFile`] are complete. This crate knows nothing about pages, workers or three.js; the npm package
//! (`web/src`) does.
//!
//! In reading order: `model` is the class; it contains a `streamed_model`, or a `prefix_model` of a file or of
//! arrays that another module has built, or a `fan_model` of a file whose steps are no collapses. All return a
//! `shown_level`. `paged_model` is a file of pages, which are fetched when a level needs them. `stream_place`,
//! `limits` and `failure` check bytes, `view` and `coloring` handle requests, `vertices` and `normals` are the
//! results, and `progress` reports progress.
//!
//! Cost: a level of a stream takes one pass over the vertices that have arrived and one over the level's
//! triangles; a view also evaluates the steps that it shows. Levels and views of other files take time
//! proportional to what they show.
//!
//! Bytes are untrusted: for any input, a method succeeds or fails with a [`Failure`]. Inputs that would not
//! fit into a page's memory are rejected before they are decoded.

#[cfg(feature = "build")]
mod built_arrays;
#[cfg(any(feature = "stream", feature = "files"))]
mod coloring;
#[cfg(feature = "encode")]
mod encoder;
mod failure;
#[cfg(feature = "files")]
mod fan_model;
#[cfg(feature = "encode")]
mod inspect;
#[cfg(any(feature = "stream", feature = "build"))]
mod layer_name;
#[cfg(any(feature = "stream", feature = "files"))]
mod leveled;
mod limits;
#[cfg(feature = "build")]
mod mesh_builder;
#[cfg(any(feature = "stream", feature = "files"))]
mod model;
#[cfg(any(feature = "stream", feature = "files"))]
mod normals;
#[cfg(feature = "files")]
mod paged_model;
#[cfg(any(feature = "stream", feature = "files"))]
mod prefix_model;
#[cfg(feature = "stream")]
mod prefix_parts;
#[cfg(feature = "build")]
mod progress;
#[cfg(any(feature = "stream", feature = "files"))]
mod scene_document;
#[cfg(feature = "stream")]
mod scene_model;
#[cfg(feature = "stream")]
mod scene_parts;
#[cfg(any(feature = "stream", feature = "files"))]
mod shown_level;
#[cfg(any(feature = "build", feature = "files"))]
mod step_order;
#[cfg(feature = "files")]
mod stored_file;
#[cfg(any(feature = "stream", feature = "files"))]
mod stream_place;
#[cfg(feature = "stream")]
mod stream_source;
#[cfg(feature = "stream")]
mod streamed_model;
mod vertices;
#[cfg(any(feature = "stream", feature = "files"))]
mod view;

#[cfg(feature = "build")]
pub use built_arrays::BuiltArrays;
#[cfg(feature = "encode")]
pub use encoder::encode_file;
pub use failure::Failure;
#[cfg(feature = "encode")]
pub use inspect::{InspectedLevel, InspectedMesh};
#[cfg(feature = "build")]
pub use mesh_builder::MeshBuilder;
#[cfg(any(feature = "stream", feature = "files"))]
pub use model::Model;
#[cfg(feature = "files")]
pub use paged_model::{PagedModel, PagedWant};
#[cfg(feature = "stream")]
pub use prefix_parts::PrefixParts;
#[cfg(feature = "build")]
pub use progress::Sink;
#[cfg(any(feature = "stream", feature = "files"))]
pub use scene_document::{SceneDocument, SceneImage};
#[cfg(feature = "stream")]
pub use scene_model::SceneModel;
#[cfg(feature = "files")]
pub use stored_file::StoredFile;
#[cfg(any(feature = "stream", feature = "files"))]
pub use stream_place::StreamPlace;
pub use vertices::{VertexLayer, Vertices};
#[cfg(any(feature = "stream", feature = "files"))]
pub use view::View;

/// Compiles the readme's example with the documentation tests.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
