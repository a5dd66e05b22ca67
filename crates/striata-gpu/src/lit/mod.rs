//! Lit surfaces: materials with textures, under an environment and lights.
//!
//! [`LitPainter`] holds the shader. Meshes ([`LitVertices`]) and materials ([`LitMaterials`]) are uploaded
//! once. A [`LitScene`] says what to show: objects with the indices of any level, and the camera. [`LitFrame`]
//! turns it into draw calls and draws them.
//!
//! In reading order: `material`, `texture_use`, `image` and `light` are plain data; `environment`,
//! `environment_table` and `reflectance_table` contain the light from all around; `mips`, `textures` and
//! `materials` upload images; `vertices` uploads meshes; `object` describes a scene; `pipelines`, `painter`,
//! `frame_data` and `frame` draw it.
//!
//! Positions are relative to the eye, computed in 64 bits. The shading is that of glTF's metallic-roughness materials; an [`Environment`] is a
//! gradient with a few soft lights, for which prefiltered light has a closed form.

mod environment;
mod environment_table;
mod frame;
mod frame_data;
mod image;
mod light;
mod material;
mod materials;
mod mips;
mod object;
mod painter;
mod pipelines;
mod reflectance_table;
mod texture_use;
mod textures;
mod vertices;

pub use environment::{Environment, EnvironmentLobe};
pub use frame::LitFrame;
pub use image::LitImage;
pub use light::{LitLight, LitLightKind};
pub use material::{AlphaMode, LitMaterial};
pub use materials::LitMaterials;
pub use object::{LitCamera, LitObject, LitPart, LitScene};
pub use painter::LitPainter;
pub use texture_use::{TextureFilter, TextureSampler, TextureUse, TextureWrap};
pub use vertices::LitVertices;
