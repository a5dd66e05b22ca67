//! The wasm face of striata: a model that grows as its bytes come in, and shows any level of itself.
//!
//! There is one class, [`Model`]. It takes the bytes of a stream and gives what has come after each of them; or it takes
//! a whole file of any kind that striata knows. What it shows is wished for by detail, by triangles, by an error or by a
//! camera, and handed over as indices over one vertex buffer that only grows. Nothing here knows a page, a worker or
//! three.js: that is the package's business (`web/src`).
//!
//! In reading order: `model` is the class; it holds what is `streaming`, `stored` or `built`, which all answer with `shown`. `head`, `limits`
//! and `failure` judge bytes, `camera` and `coloring` what is wished for, `vertices` and `normals` what is handed over, `progress` how far
//! it is.
//!
//! Cost: a level of a stream takes a pass over the vertices that have arrived and one over its triangles; a view also asks about
//! the steps that it shows. Levels and views of other files take what they show.
//!
//! Bytes are a stranger's: whatever they hold, a method answers or fails with a [`Failure`]. What would not fit into a
//! page's memory is refused before it is begun.

mod built;
mod camera;
mod coloring;
mod failure;
mod head;
mod limits;
mod model;
mod normals;
mod progress;
mod shown;
mod stored;
mod streaming;
mod vertices;

pub use camera::View;
pub use failure::Failure;
pub use head::StreamPlace;
pub use model::Model;
pub use progress::Sink;
pub use vertices::Vertices;

/// The readme's example, compiled with the documentation's tests.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
