//! `.striata` files of scenes: the document, its data and images, and a complete file for each mesh.
//!
//! The layout is specified in `docs/format.md`. The file of a mesh can contain any models; it is aligned
//! within the file of the scene, so that its arrays can be used in place.
//!
//! ```
//! use striata::LodOptions;
//! use striata::mesh::shapes;
//! use striata_scene::LodScene;
//! use striata_scene::file::SceneFile;
//!
//! let scene = striata_io::Scene::from_mesh(shapes::torus(32, 16, 1.0, 0.4))?;
//! let lods = LodScene::build(&scene, &LodOptions::default())?;
//! let bytes = lods.to_striata(&Default::default())?;
//! let file = SceneFile::parse(&bytes)?; // borrows the meshes from the bytes
//! assert_eq!(file.lod_scene()?.triangle_count(), scene.triangle_count());
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod error;
mod image;
#[cfg(not(target_family = "wasm"))]
mod path;
mod read;
mod write;

pub use error::{SceneDecodeError, SceneEncodeError};
#[cfg(not(target_family = "wasm"))]
pub use path::{open, save};
pub use read::{SceneFile, is_scene_file};
pub use write::write_scene_file;
