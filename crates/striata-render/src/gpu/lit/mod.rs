//! Lit surfaces: materials with textures, under an environment and lights.
//!
//! [`LitPainter`] holds the shader. Meshes ([`LitVertices`]) and materials ([`LitMaterials`]) are uploaded
//! once. A [`LitScene`] says what to show: objects with the indices of any level, and the camera. [`LitFrame`]
//! turns it into draw calls and draws them.
//!
//! In reading order: `textures` and
//! `materials` upload images; `vertices` uploads meshes; `object` describes a scene; `pipeline_key`, `painter`,
//! `frame_data` and `frame` draw it.
//!
//! Positions are relative to the eye, computed in 64 bits. The shading is that of glTF's metallic-roughness materials; an [`Environment`] is a
//! gradient with a few soft lights, for which prefiltered light has a closed form.

mod frame;
mod frame_data;
mod materials;
mod object;
mod painter;
mod pipeline_key;
mod textures;
mod vertices;

pub use frame::LitFrame;
pub use materials::LitMaterials;
pub use object::{LitObject, LitPart, LitScene};
pub use painter::LitPainter;
pub use vertices::LitVertices;
