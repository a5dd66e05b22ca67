//! Shows models to people: [`picture`] draws PNGs with a GPU or without one, [`window`] follows a camera in a window of its
//! own, and [`serve`] gives a folder of models and the web viewer to a browser.
//!
//! In reading order: [`picture`] knows shots, cameras and who draws them; [`viewer_page`] is the web viewer with a model inside;
//! [`serve`] needs both; [`window`] stands for itself.

#[cfg(all(feature = "serve", not(feature = "window")))]
mod browser_args;
pub mod picture;
#[cfg(feature = "serve")]
pub mod serve;
pub mod viewer_page;
#[cfg(feature = "window")]
pub mod window;

#[cfg(all(feature = "serve", not(feature = "window")))]
pub use browser_args::BrowserArgs;

/// The readme's example, compiled with the documentation's tests.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
