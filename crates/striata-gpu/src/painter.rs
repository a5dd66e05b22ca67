//! Render pipelines, and the uniform scene data that their shaders read.

use bytemuck::{Pod, Zeroable};
use wgpu::{
    BindGroup, BindGroupLayout, Buffer, BufferUsages, RenderPass, RenderPipeline, ShaderStages,
    TextureFormat, VertexAttribute, VertexBufferLayout,
};

use crate::canvas::Canvas;
use crate::drawing::Drawing;
use crate::gpu::Gpu;
use crate::gpu_error::GpuError;
use crate::look::{Look, Shading};
use crate::vertices::GpuVertices;
use crate::viewpoint::Viewpoint;

/// Depth format of all pipelines. Depth is reversed: near is 1, infinitely far is 0.
pub const DEPTH_FORMAT: TextureFormat = TextureFormat::Depth32Float;

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

/// A look and a viewpoint on the GPU. One pass can draw several scenes.
#[derive(Debug)]
pub struct Scene {
    buffer: Buffer,
    pub(crate) bindings: BindGroup,
    pub(crate) hides_back: bool,
}

impl Painter {
    /// Compiles the shaders and creates all pipelines.
    pub fn new(gpu: &Gpu, samples: u32) -> Self {
        let scene_layout = layout(gpu, "scene", &[wgpu::BufferBindingType::Uniform]);
        let storage = wgpu::BufferBindingType::Storage { read_only: true };
        let triangles_layout = layout(gpu, "triangles", &[storage; 5]);
        let builder = PipelineBuilder { gpu, samples };
        let surface_code = concat!(include_str!("shaders/light.wgsl"), include_str!("shaders/surface.wgsl"));
        let surface_module = builder.module("surface", surface_code);
        let code = concat!(include_str!("shaders/light.wgsl"), include_str!("shaders/inspection.wgsl"));
        let inspection_module = builder.module("inspection", code);
        let sides = [false, true];
        let surface = sides.map(|is_strips| {
            sides.map(|hides_back| {
                let variant = PipelineVariant { is_strips, hides_back, buffers: &VERTEX_BUFFERS };
                builder.pipeline(&surface_module, &[&scene_layout], &variant)
            })
        });
        let inspection = sides.map(|hides_back| {
            let variant = PipelineVariant { is_strips: false, hides_back, buffers: &[] };
            builder.pipeline(&inspection_module, &[&scene_layout, &triangles_layout], &variant)
        });
        Self { scene_layout, triangles_layout, surface, inspection }
    }

    /// Creates a scene for later passes: `vertices` seen from a viewpoint in a picture of `[width,
    /// height]` pixels.
    ///
    /// # Errors
    /// [`GpuError::TooLarge`], which does not happen on real devices.
    pub fn scene(
        &self,
        gpu: &Gpu,
        vertices: &GpuVertices,
        view: (&Viewpoint, [u32; 2]),
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
    /// Changes the viewpoint and the look.
    pub fn update(
        &mut self,
        gpu: &Gpu,
        vertices: &GpuVertices,
        (viewpoint, [width, height]): (&Viewpoint, [u32; 2]),
        look: &Look,
    ) {
        let aspect = width.max(1) as f32 / height.max(1) as f32;
        let clip_from_model = viewpoint.clip_from_model(vertices.origin(), vertices.radius(), aspect);
        let [right, up, back] = viewpoint.axes();
        // The lights follow the camera: the key light from the upper left, a weak fill light from the right.
        let towards = |x: f32, y: f32, z: f32| {
            let to: [f32; 3] = std::array::from_fn(|k| x * right[k] + y * up[k] + z * back[k]);
            let length = (x * x + y * y + z * z).sqrt();
            to.map(|a| a / length)
        };
        let with = |[x, y, z]: [f32; 3], w: f32| [x, y, z, w];
        let data = SceneData {
            clip_from_model: clip_from_model.to_cols_array_2d(),
            eye: with(viewpoint.eye_in_model(vertices.origin()), look.light),
            key: with(towards(-0.55, 0.65, 0.75), 0.78),
            fill: with(towards(0.9, 0.1, 0.35), 0.16),
            up: with(up, 0.0),
            base: with(look.base, 1.0),
            edges: look.edges,
            flags: [
                u32::from(look.shading == Shading::Flat),
                u32::from(look.shows_vertex_colors && vertices.has_colors()),
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

struct PipelineVariant<'a> {
    is_strips: bool,
    hides_back: bool,
    buffers: &'a [Option<VertexBufferLayout<'a>>],
}

struct PipelineBuilder<'a> {
    gpu: &'a Gpu,
    samples: u32,
}

impl PipelineBuilder<'_> {
    fn module(&self, label: &str, code: &str) -> wgpu::ShaderModule {
        let source = wgpu::ShaderSource::Wgsl(code.into());
        self.gpu.device.create_shader_module(wgpu::ShaderModuleDescriptor { label: Some(label), source })
    }

    fn pipeline(
        &self,
        module: &wgpu::ShaderModule,
        groups: &[&BindGroupLayout],
        variant: &PipelineVariant<'_>,
    ) -> RenderPipeline {
        let groups: Vec<Option<&BindGroupLayout>> = groups.iter().copied().map(Some).collect();
        let layout = self.gpu.device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
            bind_group_layouts: &groups,
            ..Default::default()
        });
        let (topology, strip_index_format) = if variant.is_strips {
            (wgpu::PrimitiveTopology::TriangleStrip, Some(wgpu::IndexFormat::Uint32))
        } else {
            (wgpu::PrimitiveTopology::TriangleList, None)
        };
        self.gpu.device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
            label: None,
            layout: Some(&layout),
            vertex: wgpu::VertexState {
                module,
                entry_point: Some("vertex"),
                compilation_options: Default::default(),
                buffers: variant.buffers,
            },
            primitive: wgpu::PrimitiveState {
                topology,
                strip_index_format,
                cull_mode: variant.hides_back.then_some(wgpu::Face::Back),
                ..Default::default()
            },
            depth_stencil: Some(wgpu::DepthStencilState {
                format: DEPTH_FORMAT,
                depth_write_enabled: Some(true),
                depth_compare: Some(wgpu::CompareFunction::Greater),
                stencil: Default::default(),
                bias: Default::default(),
            }),
            multisample: wgpu::MultisampleState { count: self.samples, ..Default::default() },
            fragment: Some(wgpu::FragmentState {
                module,
                entry_point: Some("fragment"),
                compilation_options: Default::default(),
                targets: &[Some(Canvas::FORMAT.into())],
            }),
            multiview_mask: None,
            cache: None,
        })
    }
}

/// Bind group layout of buffers that vertex and fragment shaders may read.
fn layout(gpu: &Gpu, label: &str, kinds: &[wgpu::BufferBindingType]) -> BindGroupLayout {
    let entries: Vec<wgpu::BindGroupLayoutEntry> = (0..)
        .zip(kinds)
        .map(|(binding, &ty)| wgpu::BindGroupLayoutEntry {
            binding,
            visibility: ShaderStages::VERTEX_FRAGMENT,
            ty: wgpu::BindingType::Buffer { ty, has_dynamic_offset: false, min_binding_size: None },
            count: None,
        })
        .collect();
    let descriptor = wgpu::BindGroupLayoutDescriptor { label: Some(label), entries: &entries };
    gpu.device.create_bind_group_layout(&descriptor)
}

/// Creates a bind group of whole buffers, in order.
pub(crate) fn bind(gpu: &Gpu, layout: &BindGroupLayout, buffers: &[&Buffer]) -> BindGroup {
    let entries: Vec<wgpu::BindGroupEntry<'_>> = (0..)
        .zip(buffers)
        .map(|(binding, buffer)| wgpu::BindGroupEntry { binding, resource: buffer.as_entire_binding() })
        .collect();
    gpu.device.create_bind_group(&wgpu::BindGroupDescriptor { label: None, layout, entries: &entries })
}
