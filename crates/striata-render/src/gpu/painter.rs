//! Draws vertices in one look: the pipelines, and the uniform scene data that their shaders read.

use std::sync::OnceLock;

use bytemuck::{Pod, Zeroable};
use glam::Vec3;
use wgpu::{
    BindGroup, BindGroupLayout, Buffer, BufferUsages, Face, RenderPass, RenderPipeline, ShaderStages,
};

use crate::camera::{Camera, to_f64};
use crate::gpu::device::Gpu;
use crate::gpu::drawing::Drawing;
use crate::gpu::gpu_error::GpuError;
use crate::gpu::lit::LitProgram;
use crate::gpu::look::Look;
use crate::gpu::pipelines::{Program, Variant, bind, bindings_layout, storage, uniform};
use crate::gpu::vertices::{GpuVertices, PLAIN_COUNT};

/// Render pipelines for one number of samples per pixel.
#[derive(Debug)]
pub struct Painter {
    pub(crate) scene_layout: BindGroupLayout,
    pub(crate) triangles_layout: BindGroupLayout,
    /// Indexed by whether strips are drawn, then by whether back faces are culled.
    surface: [[RenderPipeline; 2]; 2],
    pub(crate) inspection: [RenderPipeline; 2],
    samples: u32,
    /// Created when materials are drawn for the first time.
    lit: OnceLock<LitProgram>,
}

/// Uniform data of a scene, laid out as in `light.wgsl`.
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
#[repr(C)]
struct SceneData {
    clip_from_model: [[f32; 4]; 4],
    eye: [f32; 4],
    key: [f32; 4],
    fill: [f32; 4],
    up: [f32; 4],
    base: [f32; 4],
    edges: [f32; 4],
    flags: [u32; 4],
}

/// A look and a camera on the GPU. One pass can draw several scenes.
#[derive(Debug)]
pub struct Scene {
    buffer: Buffer,
    pub(crate) bindings: BindGroup,
    pub(crate) hides_back: bool,
}

impl Painter {
    /// Compiles the shaders and creates all pipelines, except for those of materials, which are created when they
    /// are first needed.
    pub fn new(gpu: &Gpu, samples: u32) -> Self {
        let stages = ShaderStages::VERTEX_FRAGMENT;
        let scene_layout = bindings_layout(gpu, "scene", &[(stages, uniform())]);
        let triangles_layout = bindings_layout(gpu, "triangles", &[(stages, storage()); 5]);
        let sides = [None, Some(Face::Back)];
        let code = concat!(include_str!("shaders/light.wgsl"), include_str!("shaders/surface.wgsl"));
        let program = Program::new(gpu, "surface", code, &[&scene_layout]);
        let present = &[true; PLAIN_COUNT][..];
        let surface = [false, true].map(|is_strips| {
            sides.map(|culled| {
                program.pipeline(gpu, samples, &Variant { is_strips, culled, present, ..Variant::default() })
            })
        });
        let code = concat!(include_str!("shaders/light.wgsl"), include_str!("shaders/inspection.wgsl"));
        let program = Program::new(gpu, "inspection", code, &[&scene_layout, &triangles_layout]);
        let inspection =
            sides.map(|culled| program.pipeline(gpu, samples, &Variant { culled, ..Variant::default() }));
        Self { scene_layout, triangles_layout, surface, inspection, samples, lit: OnceLock::new() }
    }

    /// The program of materials.
    pub(crate) fn lit(&self, gpu: &Gpu) -> &LitProgram {
        self.lit.get_or_init(|| LitProgram::new(gpu, self.samples))
    }

    /// Creates a scene for later passes: `vertices` seen from a camera in a picture of `[width,
    /// height]` pixels.
    ///
    /// # Errors
    /// [`GpuError::TooLarge`], which does not happen on real devices.
    pub fn scene(
        &self,
        gpu: &Gpu,
        vertices: &GpuVertices,
        view: (&Camera, [u32; 2]),
        look: &Look,
    ) -> Result<Scene, GpuError> {
        let usage = BufferUsages::UNIFORM | BufferUsages::COPY_DST;
        let buffer = gpu.empty_buffer("scene", size_of::<SceneData>() as u64, usage)?;
        let bindings = bind(gpu, &self.scene_layout, [buffer.as_entire_binding()]);
        let mut scene = Scene { buffer, bindings, hides_back: look.hides_back };
        scene.update(gpu, vertices, view, look);
        Ok(scene)
    }

    /// Draws vertices by indices.
    pub fn draw(
        &self,
        pass: &mut RenderPass<'_>,
        scene: &Scene,
        vertices: &GpuVertices,
        drawing: Drawing<'_>,
    ) {
        pass.set_pipeline(&self.surface[usize::from(drawing.is_strips())][usize::from(scene.hides_back)]);
        pass.set_bind_group(0, &scene.bindings, &[]);
        for slot in 0..PLAIN_COUNT {
            pass.set_vertex_buffer(slot as u32, vertices.buffer(slot).slice(..));
        }
        pass.set_index_buffer(drawing.index_buffer().slice(..), wgpu::IndexFormat::Uint32);
        drawing.issue(pass);
    }
}

impl Scene {
    /// Changes the camera and the look.
    pub fn update(
        &mut self,
        gpu: &Gpu,
        vertices: &GpuVertices,
        (camera, size): (&Camera, [u32; 2]),
        look: &Look,
    ) {
        let origin = to_f64(vertices.origin());
        let [right, up, back] = camera.axes().map(|axis| axis.as_vec3());
        // The lights follow the camera: the key light from the upper left, a weak fill light from the right.
        let towards = |x: f32, y: f32, z: f32| (x * right + y * up + z * back) / Vec3::new(x, y, z).length();
        let with = |v: Vec3, w: f32| v.extend(w).to_array();
        let data = SceneData {
            clip_from_model: camera.clip_from(origin, vertices.near_plane(camera), size).to_cols_array_2d(),
            eye: with((camera.eye_64() - origin).as_vec3(), look.light),
            key: with(towards(-0.55, 0.65, 0.75), 0.78),
            fill: with(towards(0.9, 0.1, 0.35), 0.16),
            up: with(up, look.edge_width_px),
            base: with(look.base.into(), 1.0),
            edges: look.edges,
            flags: [u32::from(vertices.has_colors()), u32::from(look.shows_groups), 0, 0],
        };
        gpu.queue.write_buffer(&self.buffer, 0, bytemuck::bytes_of(&data));
        self.hides_back = look.hides_back;
    }
}
