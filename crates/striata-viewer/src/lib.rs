//! Shows models to people: [`picture`] draws PNGs with or without a GPU, and [`serve`] serves a folder of models
//! and the web viewer to browsers.
//!
//! In reading order: [`picture`] contains shots, cameras and renderers; [`viewer_page`] is the web viewer
//! with an embedded model; [`serve`] uses both.

#[cfg(feature = "gpu")]
mod lit;
pub mod picture;
#[cfg(feature = "serve")]
pub mod serve;
pub mod viewer_page;

/// Compiles the readme's example with the documentation tests.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
