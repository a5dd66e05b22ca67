//! Levels of detail of whole scenes.
//!
//! | module | what it does |
//! | --- | --- |
//! | `levels` | distributes a target over all meshes of a scene by one priority |
//! | `lod_scene` | a scene with a [`Lod`](striata::Lod) for each mesh; `single_mesh` makes one from a `Lod` |
//! | `deformation` | simplification that respects the poses of skins and morph targets; `mesh_simplifier` applies it to every mesh, by `mesh_jobs` on several threads |
//! | `pose` | where skins and morph targets put the vertices at a time of an animation |
//! | [`drawn`] | what renderers need: materials, images, posed instances, lights and cameras |
//! | [`mod@file`] | `.striata` files of scenes |
//! | [`glb_stream`] | GLB files that open everywhere and contain all levels |
//! | [`mod@lod_chain`] | glTF files with several levels that engines switch between |
//! | [`clustered`] | clusters of all levels, for engines that draw meshlets; glTF files that carry them |
//! | [`ordered`] | vertices in refinement order, with a table of levels and index ranges; glTF files that carry both |
//! | [`godot`] | scenes and meshes with levels as text files of Godot |
//! | `view` | levels of a scene for a camera; `place` says how large errors of an instance appear |
//! | `scene_view` | triangles for renderers, frame after frame |
//! | [`stream`] | a scene as one progressive stream |
//! | [`textures`] | previews and re-encoding of images |

pub mod clustered;
mod copies;
mod deformation;
mod document;
pub mod drawn;
mod error;
mod extended_glb;
pub mod file;
pub mod glb_stream;
pub mod godot;
mod level_walk;
mod levels;
pub mod lod_chain;
mod lod_scene;
mod mesh_jobs;
mod mesh_simplifier;
pub mod ordered;
mod place;
mod pose;
mod scene_view;
mod single_mesh;
pub mod stream;
pub mod textures;
mod view;

pub use clustered::{ClusteredGlb, ClusteredScene};
pub use deformation::{Deformation, ScenePoses};
pub use error::{BuildError, SceneMismatch};
#[cfg(not(target_family = "wasm"))]
pub use file::{open, save};
pub use glb_stream::{GlbStreamOptions, read_glb_with_stream, read_glb_with_stream_and_progress};
pub use levels::{MeshWeight, SceneLevel, SceneLevels};
pub use lod_chain::{LodChainOptions, lod_chain};
pub use lod_scene::{FittedMeshes, Fitting, LodScene};
pub use ordered::{OrderedGlb, OrderedMesh};
pub use pose::{Pose, Poser};
pub use scene_view::{SceneView, ShownIndices};
pub use single_mesh::scene_around;

/// The README's example, compiled with the documentation tests.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
