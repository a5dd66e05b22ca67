//! Continuous level of detail for triangle meshes.
//!
//! The stages of the pipeline are folders, and arrows point one way (right uses left):
//! `mesh <- simplify`; `mesh <- strip <- model <- file`; `mesh <- view <- model`.

pub mod file;
pub mod mesh;
pub mod model;
mod progress;
mod setters;
pub mod simplify;
pub mod strip;
pub mod view;

pub use progress::{Cancelled, Progress, ProgressFn, ignore_progress};

/// The readme's example, compiled with the documentation's tests.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
