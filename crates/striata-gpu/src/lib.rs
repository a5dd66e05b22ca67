//! Draws striata's levels of detail with wgpu, in a window or into a picture.
//!
//! A mesh's vertices go to the GPU once ([`GpuVertices`]); every level is then only another set of indices over them, drawn
//! as a triangle list, as strips with primitive restart or by many indirect draws ([`Drawing`]). [`Painter`] holds the
//! pipelines, [`Canvas`] is a picture in memory, [`Viewpoint`] where one looks from. [`Inspection`] draws single triangles:
//! coloured by strip or fan, with their edges.
//!
//! Any backend of wgpu does, a processor's among them; [`Gpu::new`] says clearly where there is none.

mod canvas;
mod drawing;
mod fan_extractor;
mod frame_clock;
mod gpu;
mod gpu_fan_words;
mod gpu_fans;
mod gpu_lod_strips;
mod gpu_morph;
mod indices;
mod inspection;
mod look;
mod painter;
mod vertices;
mod viewpoint;

pub use canvas::{Canvas, Picture};
pub use drawing::Drawing;
pub use fan_extractor::FanExtractor;
pub use frame_clock::FrameClock;
pub use gpu::{Gpu, GpuError, GpuOptions};
pub use gpu_fans::{GpuFanInstance, GpuFans};
pub use gpu_lod_strips::GpuLodStrips;
pub use gpu_morph::GpuMorph;
pub use indices::{GpuIndices, GpuMultiDraw};
pub use inspection::Inspection;
pub use look::{Look, Shading, linear_to_srgb, palette_colour};
pub use painter::{DEPTH_FORMAT, Painter, Scene};
pub use vertices::GpuVertices;
pub use viewpoint::Viewpoint;

pub use wgpu;
