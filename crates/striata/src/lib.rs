//! Continuous level of detail for triangle meshes: every level of a mesh, over a single vertex buffer.
//!
//! Vertices are removed one at a time, cheapest first, and the order is recorded. Every level of detail
//! therefore uses a prefix of a single vertex buffer, a level refined for a camera is as easy to get as a
//! uniform one, and the error of every level is known.
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
//! let bytes = lod.to_striata(&Default::default())?; // one file: see striata_io::save and striata_io::open
//! # assert!(!bytes.is_empty());
//! # fn upload(_: &[[f32; 3]], _: &[u32]) {}
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Which model do I want?
//!
//! [`Lod`] draws triangle lists with progressive fans. Engines that need more control can choose one of the
//! four models in [`model`]. Built from the same sequence, all four show the same triangles at a given level.
//!
//! | model | drawn as | stored | instance | best for |
//! | --- | --- | --- | --- | --- |
//! | [`Fans`](model::Fans) | triangles, fans or strips | 31 (23) | 0.13 (12) | views, instancing, compute |
//! | [`LodStrips`](model::LodStrips) | strips, edited in place | 23 | 10 | uniform levels, small changes |
//! | [`Mts`](model::Mts) | strips, rebuilt on change | 21 | 17 | uniform levels, compact storage |
//! | [`Patterns`](model::Patterns) | triangles | 21 (13) | its triangles | views with guaranteed errors |
//!
//! Sizes are bytes per vertex, measured on the Stanford bunny. In parentheses: the stored size without
//! support for views and, for `Fans`, the instance size of [`FanFront`](model::FanFront), which follows a
//! camera quickly. Run `striata info --models` to get these figures for your own mesh.
//!
//! # Modules
//!
//! * [`lod`]: [`Lod`] and its levels and views, the simplest way to use the library
//! * [`levels`]: one interface to the levels of meshes, files, streams, pages and scenes
//! * [`mesh`]: meshes, attributes, validation, measurement, and the collapse sequence
//! * [`simplify`]: builds the collapse sequence of a mesh
//! * [`strip`]: triangle strips
//! * [`model`]: multiresolution models, which turn a sequence into levels
//! * [`clusters`]: a hierarchy of clusters of triangles, for engines that draw meshlets
//! * [`view`]: cameras and other criteria for view-dependent refinement
//! * [`mod@file`]: the `.striata` file format
//!
//! Dependencies between the modules go one way (right uses left): `mesh <- simplify`;
//! `mesh <- strip <- model <- file`; `mesh <- view <- model`.
//!
//! Related crates: `striata-io` reads and writes mesh files, `striata-stream` compresses a mesh into a
//! stream that can be drawn from its first bytes, `striata-strip` searches for better strips, and
//! `striata-render` draws with wgpu.
//!
//! # Features
//!
//! * `parallel` (default): spreads work over threads with rayon. Results are the same without it.

pub mod clusters;
pub mod file;
pub mod levels;
pub mod lod;
pub mod mesh;
pub mod model;
mod parallel;
mod progress;
mod setters;
pub mod simplify;
pub mod strip;
pub mod view;

pub use levels::Levels;
pub use lod::{Level, Lod, LodOptions, StripLevel, View};
pub use progress::{Cancelled, Progress, ProgressFn, ignore_progress};
pub use simplify::Target;

/// Compiles the example of the README as a documentation test.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
