//! Render pipelines, and the uniform scene data that their shaders read.

use bytemuck::{Pod, Zeroable};
use glam::{DVec3, Vec3};
use wgpu::{
    BindGroup, BindGroupLayout, Buffer, BufferUsages, RenderPass, RenderPipeline, ShaderStages,
    VertexAttribute, VertexBufferLayout,
};

use crate::camera::Camera;
use crate::gpu::device::Gpu;
use crate::gpu::drawing::Drawing;
use crate::gpu::gpu_error::GpuError;
use crate::gpu::look::{Look, Shading};
use crate::gpu::pipelines::{Program, Variant, bindings_layout, storage, uniform};
use crate::gpu::vertices::GpuVertices;

/// Render pipelines for one number of samples per pixel.
#[derive(Debug)]
pub struct Painter {
    pub(crate) scene_layout: BindGroupLayout,
    pub(crate) triangles_layout: BindGroupLayout,
    /// Indexed by whether strips are drawn, then by whether back faces are culled.
    surface: [[RenderPipeline; 2]; 2],
    pub(crate) inspection: [RenderPipeline; 2],
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
    edge_settings: [f32; 4],
}

/// A look and a camera on the GPU. One pass can draw several scenes.
#[derive(Debug)]
pub struct Scene {
    buffer: Buffer,
    pub(crate) bindings: BindGroup,
    pub(crate) hides_back: bool,
}

impl Painter {
    /// Compiles the shaders and creates all pipelines.
    pub fn new(gpu: &Gpu, samples: u32) -> Self {
        let stages = ShaderStages::VERTEX_FRAGMENT;
        let scene_layout = bindings_layout(gpu, "scene", &[(stages, uniform())]);
        let triangles_layout = bindings_layout(gpu, "triangles", &[(stages, storage()); 5]);
        let sides = [false, true];
        let cull_mode = |hides_back: bool| hides_back.then_some(wgpu::Face::Back);
        let code = concat!(include_str!("shaders/light.wgsl"), include_str!("shaders/surface.wgsl"));
        let program = Program::new(gpu, "surface", code, &[&scene_layout]);
        let surface = sides.map(|is_strips| {
            sides.map(|hides_back| {
                let cull_mode = cull_mode(hides_back);
                let variant =
                    Variant { is_strips, cull_mode, buffers: &VERTEX_BUFFERS, ..Variant::new(samples) };
                program.pipeline(gpu, &variant)
            })
        });
        let code = concat!(include_str!("shaders/light.wgsl"), include_str!("shaders/inspection.wgsl"));
        let program = Program::new(gpu, "inspection", code, &[&scene_layout, &triangles_layout]);
        let inspection = sides.map(|hides_back| {
            program.pipeline(gpu, &Variant { cull_mode: cull_mode(hides_back), ..Variant::new(samples) })
        });
        Self { scene_layout, triangles_layout, surface, inspection }
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
        let bindings = bind(gpu, &self.scene_layout, &[&buffer]);
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
        for (slot, buffer) in
            [&vertices.positions, &vertices.normals, &vertices.colors].into_iter().enumerate()
        {
            pass.set_vertex_buffer(slot as u32, buffer.slice(..));
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
        (camera, [width, height]): (&Camera, [u32; 2]),
        look: &Look,
    ) {
        let aspect = f64::from(width.max(1)) / f64::from(height.max(1));
        let origin = DVec3::from(vertices.origin().map(f64::from));
        let eye = camera.eye_64() - origin;
        let near = camera.near_plane(origin, f64::from(vertices.radius()));
        let clip_from_model = camera.clip_from(origin, near, aspect);
        let [right, up, back] = camera.axes().map(|axis| axis.as_vec3());
        // The lights follow the camera: the key light from the upper left, a weak fill light from the right.
        let towards = |x: f32, y: f32, z: f32| (x * right + y * up + z * back) / Vec3::new(x, y, z).length();
        let with = |v: Vec3, w: f32| v.extend(w).to_array();
        let data = SceneData {
            clip_from_model: clip_from_model.to_cols_array_2d(),
            eye: with(eye.as_vec3(), look.light),
            key: with(towards(-0.55, 0.65, 0.75), 0.78),
            fill: with(towards(0.9, 0.1, 0.35), 0.16),
            up: with(up, 0.0),
            base: with(look.base.into(), 1.0),
            edges: look.edges,
            flags: [
                u32::from(look.shading == Shading::Flat),
                u32::from(vertices.has_colors()),
                u32::from(look.shows_groups),
                1,
            ],
            edge_settings: [look.edge_width_px, 0.0, 0.0, 0.0],
        };
        gpu.queue.write_buffer(&self.buffer, 0, bytemuck::bytes_of(&data));
        self.hides_back = look.hides_back;
    }
}

const fn attribute(location: u32, format: wgpu::VertexFormat) -> [VertexAttribute; 1] {
    [VertexAttribute { format, offset: 0, shader_location: location }]
}

const fn vertex_buffer(stride: u64, attributes: &[VertexAttribute]) -> VertexBufferLayout<'_> {
    VertexBufferLayout { array_stride: stride, step_mode: wgpu::VertexStepMode::Vertex, attributes }
}

const VERTEX_BUFFERS: [Option<VertexBufferLayout<'static>>; 3] = [
    Some(vertex_buffer(12, &attribute(0, wgpu::VertexFormat::Float32x3))),
    Some(vertex_buffer(12, &attribute(1, wgpu::VertexFormat::Float32x3))),
    Some(vertex_buffer(4, &attribute(2, wgpu::VertexFormat::Unorm8x4))),
];

/// Creates a bind group of whole buffers, in order.
pub(crate) fn bind(gpu: &Gpu, layout: &BindGroupLayout, buffers: &[&Buffer]) -> BindGroup {
    let entries: Vec<wgpu::BindGroupEntry<'_>> = (0..)
        .zip(buffers)
        .map(|(binding, buffer)| wgpu::BindGroupEntry { binding, resource: buffer.as_entire_binding() })
        .collect();
    gpu.device.create_bind_group(&wgpu::BindGroupDescriptor { label: None, layout, entries: &entries })
}
