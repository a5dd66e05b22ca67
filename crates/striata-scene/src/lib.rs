//! Levels of detail of whole scenes.
//!
//! | module | what it does |
//! | --- | --- |
//! | `levels` | distributes a target over all meshes of a scene by one priority |
//! | `lod_scene` | a scene with a [`Lod`](striata::Lod) for each mesh |
//! | [`stream`] | a scene as one progressive stream |
//! | [`textures`] | previews and re-encoding of images |

pub mod stream;
pub mod textures;
