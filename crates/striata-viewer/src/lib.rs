//! Shows models to people: [`serve`] serves a folder of models and the web viewer to browsers, and
//! [`PictureRenderer`] chooses what draws pictures.
//!
//! In reading order: `picture_renderer` draws with a GPU or without one; [`viewer_page`] is the web viewer
//! with an embedded model; [`serve`] uses it.

mod picture_renderer;
#[cfg(feature = "serve")]
pub mod serve;
pub mod viewer_page;

pub use picture_renderer::PictureRenderer;

/// Compiles the readme's example with the documentation tests.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
