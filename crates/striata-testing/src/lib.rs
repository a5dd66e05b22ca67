//! Shared test support for all crates: test meshes, random collapse sequences, and oracles that check models.

#![expect(missing_docs, reason = "only used by tests, and the names describe the meshes")]

mod extent;
pub mod gltf_check;
pub mod levels;
pub mod meshes;
pub mod scenes;
#[cfg(all(unix, feature = "server"))]
pub mod server;
pub mod simplifier;
pub mod strange;
pub mod support;

pub use extent::{cases, large};

/// The examples of the repository's README, compiled as doc tests.
#[cfg(doctest)]
#[doc = include_str!("../../../README.md")]
struct Readme;

/// The example of the guide to views, compiled as a doc test.
#[cfg(doctest)]
#[doc = include_str!("../../../docs/guide/views.md")]
struct GuideToViews;

/// The example of the guide to strips, compiled as a doc test.
#[cfg(doctest)]
#[doc = include_str!("../../../docs/guide/strips.md")]
struct GuideToStrips;
