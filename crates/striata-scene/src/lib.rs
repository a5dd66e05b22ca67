//! Levels of detail of whole scenes.
//!
//! | module | what it does |
//! | --- | --- |
//! | `levels` | distributes a target over all meshes of a scene by one priority |
//! | `lod_scene` | a scene with a [`Lod`](striata::Lod) for each mesh |

mod error;
mod levels;
mod lod_scene;

pub use error::{BuildError, SceneMismatch};
pub use levels::{MeshWeight, SceneLevel, SceneLevels};
pub use lod_scene::LodScene;
