//! Draws pictures of meshes and scenes, with a GPU or without one, and arranges them with text into PNG files.
//!
//! A [`Shot`] describes what is visible: triangles over the vertices of a mesh, their paint, and lines; a
//! [`SceneLook`] contains its materials and lights. [`rasterize`] draws it from a [`Camera`] on the CPU, and
//! `gpu::GpuRenderer` (feature `gpu`) the same with wgpu, whose parts are also the library for programs that
//! draw levels of detail themselves. A [`Sheet`] arranges panels and labels them. All pictures are in linear
//! light with opacity until they are encoded as bytes.
//!
//! In reading order: `camera`, `shot` and `scene_look` say what is drawn; `environment`, `environment_table`,
//! `reflectance_table`, `material_images`, `mips` and `srgb` are shared by both renderers; `cpu` and `gpu` are
//! the renderers; `canvas`, `text` and `sheet` make pictures of what they drew. Lines are triangles that face
//! the camera, so that surfaces hide them.

mod camera;
mod canvas;
mod cpu;
mod distance_map;
mod environment;
mod environment_table;
mod frustum;
#[cfg(feature = "gpu")]
pub mod gpu;
mod material_images;
mod mips;
mod normals;
mod paint;
mod reflectance_table;
mod scene_look;
mod sheet;
mod shot;
mod srgb;
mod text;
mod thumbnail;

pub use camera::{Camera, ViewAngles};
pub use canvas::{Canvas, Drawn, Rgba};
pub use cpu::rasterize;
pub use distance_map::DistanceMap;
pub use environment::{Environment, EnvironmentLobe};
pub use frustum::Frustum;
pub use normals::{with_all_normals, with_normals};
pub use paint::{ColoredTriangles, fan_colors, fragment_colors, group_colors, strip_colors, triangle_colors};
pub use scene_look::SceneLook;
pub use sheet::{ColorBar, Panel, Sheet, Theme, significant};
pub use shot::{Line, Paint, Shot, Style};
pub use srgb::to_srgb;
pub use thumbnail::{placeholder, portrait};

pub use glam;
pub use striata_scene::drawn::{
    AlphaMode, Light, LightKind, Material, Sampler, TextureUse, UvTransform, Wrap,
};
pub use striata_scene::textures::RgbaImage;

/// Compiles the readme's example with the documentation tests.
#[cfg(all(doctest, feature = "gpu"))]
#[doc = include_str!("../README.md")]
struct Readme;
