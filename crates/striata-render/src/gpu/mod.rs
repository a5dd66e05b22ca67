//! Draws striata's levels of detail with wgpu into a render target, for example an offscreen picture.
//!
//! A mesh's vertices are uploaded once ([`GpuVertices`]). Each level is only another set of indices over
//! them, drawn as a triangle list, as strips with primitive restart, or by many indirect draws ([`Drawing`]).
//! [`Painter`] owns the pipelines, and [`Canvas`] is an offscreen render target. [`GpuRenderer`] draws whole
//! [`Shot`](crate::Shot)s with all of it.
//! [`Inspection`] draws individual triangles, colored by strip or fan, with their edges.
//!
//! A [`LitFrame`] shows the same vertices with materials instead of one look: metallic-roughness materials as in
//! glTF, with textures, under an [`Environment`](crate::Environment) and punctual lights. The readme has an example.
//!
//! Positions are stored relative to the middle of the bounds, so that a mesh far from the origin keeps its
//! shape in 32 bits. Depth is reversed, from 1 at the near plane to 0 at infinity. The instance index tells
//! shaders the group, so each group is one draw without a change of bindings. One buffer write costs as much
//! as some 8,192 indices, so changed ranges that are closer than that are joined.
//!
//! Every wgpu backend works, including OpenGL and CPU adapters. [`Gpu::new`] draws a small test triangle on
//! each adapter before it accepts one, and reports why each other adapter was rejected.
//!
//! In reading order: `gpu_error`, `device` and `adapters` find the device; `copy_back`,
//! `vertices`, `indices`, `drawing` and `gpu_lod_strips` contain what is drawn; `projection`, `look`,
//! `painter` and `inspection` draw it; `lit` draws it with materials; `renderer` draws shots; `canvas` and
//! `frame_clock` are the target and the timing; `gpu_fan_words`, `gpu_fans`, `fan_extractor` and
//! `gpu_fan_instance` extract triangles from fans; `crowd_meshes`, `crowd_passes` and `gpu_crowd` refine many
//! instances without any history; `probe` tries all of it on an adapter except `lit`.
//!
//! ```no_run
//! use striata::model::{FanInstance, Fans};
//! use striata::simplify::build_sequence;
//! use striata_render::gpu::{Canvas, FanExtractor, Gpu, GpuFanInstance, GpuFans, GpuVertices};
//! use striata_render::Camera;
//! use striata_render::gpu::{Look, Painter};
//!
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! let mesh = striata::mesh::shapes::icosphere(6, 1.0);
//! let refinable = build_sequence(&mesh, &Default::default())?.refinable;
//! let fans = Fans::build(&refinable);
//!
//! let gpu = Gpu::new(&Default::default())?;
//! let (canvas, painter) = (Canvas::new(&gpu, [800, 600], 4)?, Painter::new(&gpu, 4));
//! let vertices = GpuVertices::upload(&gpu, &refinable.mesh)?; // once, for all levels
//! let (table, extractor) = (GpuFans::upload(&gpu, &fans)?, FanExtractor::new(&gpu));
//! let mut instance = GpuFanInstance::new(&gpu, &extractor, &table)?;
//!
//! let view = Camera::portrait(&mesh.bounds().ok_or("no vertices")?, 0.5, 0.3, 0.6);
//! let scene = painter.scene(&gpu, &vertices, (&view, [800, 600]), &Look::default())?;
//! let split_count = refinable.sequence.step_count() / 10;
//! instance.write(&gpu, &FanInstance::uniform(&fans, split_count)); // one bit per step
//! let mut encoder = gpu.device().create_command_encoder(&Default::default());
//! extractor.extract(&mut encoder, &instance); // makes its triangles on the GPU
//! gpu.queue().submit([encoder.finish()]);
//! let picture = canvas.paint(&gpu, Look::default().background, |pass| {
//!     painter.draw(pass, &scene, &vertices, instance.drawing());
//! })?;
//! assert_eq!(picture.rgba.len(), 800 * 600 * 4);
//! # Ok(())
//! # }
//! ```

mod adapters;
mod canvas;
mod copy_back;
mod crowd_meshes;
mod crowd_passes;
mod device;
mod drawing;
mod fan_extractor;
mod frame_clock;
mod gl_restart;
mod gpu_crowd;
mod gpu_error;
mod gpu_fan_instance;
mod gpu_fan_words;
mod gpu_fans;
mod gpu_lod_strips;
mod indices;
mod inspection;
mod lit;
mod look;
mod painter;
mod pipelines;
mod probe;
mod projection;
mod renderer;
mod vertices;

pub use adapters::{AdapterKind, ChosenAdapter, GpuOptions, choose_adapter};
pub use canvas::{Canvas, Picture};
pub use crowd_meshes::CrowdMesh;
pub use device::Gpu;
pub use drawing::Drawing;
pub use fan_extractor::FanExtractor;
pub use frame_clock::FrameClock;
pub use gpu_crowd::{CrowdCounts, CrowdInstance, GpuCrowd};
pub use gpu_error::{GpuError, RejectedAdapter};
pub use gpu_fan_instance::GpuFanInstance;
pub use gpu_fans::GpuFans;
pub use gpu_lod_strips::GpuLodStrips;
pub use indices::{GpuIndices, GpuMultiDraw};
pub use inspection::Inspection;
pub use lit::{LitFrame, LitMaterials, LitObject, LitPart, LitScene};
pub use look::{Look, palette_color};
pub use painter::{Painter, Scene};
pub use renderer::GpuRenderer;
pub use vertices::GpuVertices;
pub use wgpu;
