//! Data for drawing: the materials, images, instances, lights and cameras of a scene as plain values.
//!
//! Renderers need numbers, not the JSON of a document. [`materials`] reads the materials of any
//! [`Scene`](striata_io::Scene), `decode_images` turns the images that they use into pixels,
//! [`Poser::instances`](crate::Poser::instances) says where each mesh is at a time of an animation, and
//! [`posed_mesh`] applies all of that to the vertices, for renderers that draw one mesh.
//!
//! | extension | effect |
//! | --- | --- |
//! | `KHR_materials_unlit` | [`Material::is_unlit`] |
//! | `KHR_materials_emissive_strength` | contained in [`Material::emissive`] |
//! | `KHR_materials_pbrSpecularGlossiness` | approximated by a rough dielectric, or a metal if it reflects like one |
//! | `KHR_texture_transform` | [`TextureUse::transform`] |
//! | `EXT_texture_webp` | decoded; other formats fall back to the image of core glTF |
//! | `KHR_lights_punctual` | [`lights`] |
//!
//! Broken references count as absent, as they do in most viewers: a picture of the rest is more useful than
//! none.

#[cfg(feature = "textures")]
mod base_color;
mod camera;
#[cfg(feature = "textures")]
mod image_store;
mod instances;
mod json;
mod light;
mod material;
mod posed_mesh;
mod shown_nodes;
mod specular_glossiness;
mod texture_use;

#[cfg(feature = "textures")]
pub use base_color::{base_colors, base_colors_of_mesh};
pub use camera::{DocumentCamera, Projection, cameras};
#[cfg(feature = "textures")]
pub use image_store::{DecodeResult, DecodedImages, ImageLimits, decode_images};
pub use instances::DrawnInstance;
pub use light::{Light, LightKind, lights};
pub use material::{AlphaMode, Material, materials};
pub use posed_mesh::{MAX_POSED_COUNT, posed_mesh};
pub use texture_use::{Sampler, TextureReader, TextureUse, UvTransform, Wrap};
