//! Levels of detail of whole scenes.
//!
//! | module | what it does |
//! | --- | --- |
//! | `levels` | distributes a target over all meshes of a scene by one priority |
//! | `lod_scene` | a scene with a [`Lod`](striata::Lod) for each mesh; `single_mesh` makes one from a `Lod` |
//! | [`mod@file`] | `.striata` files of scenes |
//! | [`glb_stream`] | GLB files that open everywhere and contain all levels |
//! | [`mod@lod_chain`] | glTF files with several levels that engines switch between |

mod document;
mod error;
pub mod file;
pub mod glb_stream;
mod levels;
pub mod lod_chain;
mod lod_scene;
mod single_mesh;

pub use error::{BuildError, SceneMismatch};
#[cfg(not(target_family = "wasm"))]
pub use file::{open, save};
pub use glb_stream::{GlbStreamOptions, read_glb_with_stream};
pub use levels::{MeshWeight, SceneLevel, SceneLevels};
pub use lod_chain::{LodChainOptions, lod_chain};
pub use lod_scene::LodScene;

/// The README's example, compiled with the documentation tests.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
