//! Lit surfaces: materials with textures, under an environment and lights.
//!
//! Materials ([`LitMaterials`]) are uploaded once. A [`LitScene`] says what to show: objects with the indices of
//! any level, and the camera. [`LitFrame`] turns it into draw calls and draws them.
//!
//! In reading order: `program` holds the shader; `textures` and `materials` upload images; `frame_data` and
//! `frame` describe and draw a scene.
//!
//! Positions are relative to the eye, computed in 64 bits. The shading is that of glTF's metallic-roughness
//! materials; an [`Environment`](crate::Environment) is a gradient with a few soft lights, for which prefiltered
//! light has a closed form.

mod frame;
mod frame_data;
mod materials;
mod program;
mod textures;

pub use frame::{LitFrame, LitObject, LitPart, LitScene};
pub use materials::LitMaterials;
pub(crate) use program::LitProgram;
