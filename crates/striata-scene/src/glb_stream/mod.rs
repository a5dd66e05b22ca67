//! GLB files that open everywhere and contain all levels: the vendor extension `STRIATA_lod`.
//!
//! The primitives hold a coarse level, which any viewer shows. The extension of each mesh points to a buffer
//! view with a progressive stream of the full mesh. `docs/format.md` specifies the extension, and
//! `docs/STRIATA_lod.schema.json` its JSON.
//!
//! ```
//! use striata::LodOptions;
//! use striata::mesh::shapes;
//! use striata_io::Source;
//! use striata_scene::{GlbStreamOptions, LodScene, read_glb_with_stream};
//!
//! let scene = striata_io::Scene::from_mesh(shapes::torus(64, 32, 1.0, 0.4))?;
//! let lods = LodScene::build(&scene, &LodOptions::default())?;
//! let bytes = lods.to_glb_with_stream(&GlbStreamOptions::default())?;
//! let source = Source::new("torus.glb");
//! let coarse = striata_io::read_scene_bytes(&bytes, &source)?; // what other viewers show
//! assert!(coarse.triangle_count() <= 512);
//! let full = read_glb_with_stream(&bytes, &source)?.ok_or("no streams")?;
//! assert_eq!(full.triangle_count(), scene.triangle_count());
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod error;
mod options;
mod read;
mod write;

pub use error::{GlbStreamError, GlbStreamReadError};
pub use options::GlbStreamOptions;
pub use read::{read_glb_with_stream, read_glb_with_stream_and_progress};

/// Name of the extension.
pub const STREAM_EXTENSION: &str = "STRIATA_lod";

/// Version of the extension that is written, and the only one that can be read.
pub const STREAM_EXTENSION_VERSION: u64 = 1;
