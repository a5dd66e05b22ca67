//! Continuous level of detail for triangle meshes: one mesh in, every level of detail out, over one vertex buffer.
//!
//! Vertices are removed one by one, the cheapest first, and the order is kept. So every level uses the first vertices of one
//! buffer, a level for a camera is as easy as a uniform one, and each level knows its distance from the original.
//!
//! ```
//! use striata::mesh::shapes;
//! use striata::view::Camera;
//! use striata::{Lod, LodOptions, Target};
//!
//! let mesh = shapes::torus(64, 32, 1.0, 0.4); // or striata_io::read("bunny.ply")?
//! let lod = Lod::build(&mesh, &LodOptions::default())?; // every level, one vertex buffer
//!
//! let level = lod.level(Target::Triangles(500)); // any level
//! upload(lod.positions(), level.indices()); // a triangle list; level.strips() for strips with restarts
//!
//! let mut view = lod.view(); // one instance that follows a camera
//! let camera = Camera::new([0.0, 1.0, 3.0], [0.0; 3], [0.0, 1.0, 0.0], 0.577, [1920, 1080])?;
//! view.update(&camera, 1.0); // to an error of one pixel
//! upload(lod.positions(), view.indices());
//!
//! let bytes = lod.to_striata(&Default::default())?; // one file; striata_io::save writes it, striata_io::open reads it
//! # assert!(!bytes.is_empty());
//! # fn upload(_: &[[f32; 3]], _: &[u32]) {}
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Which model do I want?
//!
//! [`Lod`] draws triangle lists by progressive fans. Four models are in [`model`]; all show the same triangles.
//!
//! | model | drawn as | stored, bytes a vertex | an instance, bytes a vertex | best for |
//! | --- | --- | --- | --- | --- |
//! | [`Fans`](model::Fans) | triangle list, fans or strips | 31 (23 without views) | 0.13, or 12 to follow a camera quickly | views; many instances; compute shaders |
//! | [`LodStrips`](model::LodStrips) | strips, edited in place | 23 | 10 | uniform levels that change a little each frame |
//! | [`Mts`](model::Mts) | strips, walked anew if they change | 21 | 17 | uniform levels in the smallest memory |
//! | [`Patterns`](model::Patterns) | triangle list | 21 (13 without views) | its triangles | views of any order of removal, with guaranteed errors |
//!
//! These are figures of the Stanford bunny.
//! `striata info --models` reports them for a mesh of yours.
//!
//! # Where things are
//!
//! [`mesh`] is what goes in; [`simplify`] makes the sequence of collapses; [`strip`] makes triangle strips; [`model`] turns a
//! sequence into levels; [`view`] says what a camera needs; [`mod@file`] is the `.striata` format. Arrows point one way (right uses
//! left): `mesh <- simplify`; `mesh <- strip <- model <- file`; `mesh <- view <- model`.
//!
//! Other crates: `striata-io` reads and writes mesh files, `striata-stream` compresses a mesh into a stream that can be drawn from its
//! first bytes, `striata-strip` searches for better strips, `striata-gpu` draws with wgpu.
//!
//! # Features
//!
//! * `parallel` (default): spreads work over threads with rayon. Results are the same without it.

pub mod file;
pub mod lod;
pub mod mesh;
pub mod model;
mod progress;
mod setters;
pub mod simplify;
pub mod strip;
pub mod view;

pub use lod::{Level, Lod, LodOptions, View};
pub use progress::{Cancelled, Progress, ProgressFn, ignore_progress};
pub use simplify::Target;

/// The readme's example, compiled with the documentation's tests.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
