//! Render pipelines into a canvas, and the layouts of what their shaders read.

use wgpu::{
    BindGroup, BindGroupLayout, BindGroupLayoutEntry, BindingResource, BindingType, BlendState,
    BufferBindingType, CompareFunction, Face, IndexFormat, PipelineLayout, PrimitiveTopology, RenderPipeline,
    SamplerBindingType, ShaderModule, ShaderStages, TextureFormat, TextureSampleType, TextureViewDimension,
    VertexAttribute, VertexBufferLayout, VertexStepMode, vertex_attr_array,
};

use crate::gpu::device::Gpu;
use crate::gpu::vertices::BUFFER_COUNT;

/// Color format of all pipelines.
pub(crate) const COLOR_FORMAT: TextureFormat = TextureFormat::Rgba8UnormSrgb;

/// Depth format of all pipelines. Depth is reversed: near is 1, infinitely far is 0.
pub(crate) const DEPTH_FORMAT: TextureFormat = TextureFormat::Depth32Float;

/// A shader with the entry points `vertex` and `fragment`, and the layout of its bindings.
#[derive(Debug)]
pub(crate) struct Program {
    label: &'static str,
    module: ShaderModule,
    layout: PipelineLayout,
}

/// One way to draw with a program.
#[derive(Clone, Copy, Default)]
pub(crate) struct Variant<'a> {
    pub is_strips: bool,
    /// The sides that are not drawn.
    pub culled: Option<Face>,
    /// Whether surfaces are blended over what is behind them.
    pub is_blended: bool,
    /// Whether the mesh has each of the attributes that the program reads.
    pub present: &'a [bool],
}

/// Size of a vertex in each vertex buffer, bytes, and its attribute.
const ATTRIBUTES: [(u64, &[VertexAttribute]); BUFFER_COUNT] = [
    (12, &vertex_attr_array![0 => Float32x3]),
    (12, &vertex_attr_array![1 => Float32x3]),
    (8, &vertex_attr_array![2 => Float16x4]),
    (16, &vertex_attr_array![3 => Float32x4]),
    (8, &vertex_attr_array![4 => Float32x2]),
    (8, &vertex_attr_array![5 => Float32x2]),
];

impl Program {
    pub(crate) fn new(gpu: &Gpu, label: &'static str, code: &str, groups: &[&BindGroupLayout]) -> Self {
        let source = wgpu::ShaderSource::Wgsl(code.into());
        let descriptor = wgpu::ShaderModuleDescriptor { label: Some(label), source };
        let module = gpu.device.create_shader_module(descriptor);
        let groups: Vec<Option<&BindGroupLayout>> = groups.iter().copied().map(Some).collect();
        let layout = gpu.device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
            label: Some(label),
            bind_group_layouts: &groups,
            ..Default::default()
        });
        Self { label, module, layout }
    }

    /// Creates a pipeline for a number of samples per pixel.
    pub(crate) fn pipeline(&self, gpu: &Gpu, samples: u32, variant: &Variant<'_>) -> RenderPipeline {
        let buffer = |(&(array_stride, attributes), &is_present)| {
            // All vertices share one value of an attribute that the mesh lacks.
            let step_mode = if is_present { VertexStepMode::Vertex } else { VertexStepMode::Instance };
            Some(VertexBufferLayout { array_stride, step_mode, attributes })
        };
        let buffers: Vec<_> = ATTRIBUTES.iter().zip(variant.present).map(buffer).collect();
        let (topology, strip_index_format) = if variant.is_strips {
            (PrimitiveTopology::TriangleStrip, Some(IndexFormat::Uint32))
        } else {
            (PrimitiveTopology::TriangleList, None)
        };
        // What is blended may lie on an opaque surface.
        let depth_compare =
            if variant.is_blended { CompareFunction::GreaterEqual } else { CompareFunction::Greater };
        gpu.device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
            label: Some(self.label),
            layout: Some(&self.layout),
            vertex: wgpu::VertexState {
                module: &self.module,
                entry_point: Some("vertex"),
                compilation_options: Default::default(),
                buffers: &buffers,
            },
            primitive: wgpu::PrimitiveState {
                topology,
                strip_index_format,
                cull_mode: variant.culled,
                ..Default::default()
            },
            depth_stencil: Some(wgpu::DepthStencilState {
                format: DEPTH_FORMAT,
                depth_write_enabled: Some(!variant.is_blended),
                depth_compare: Some(depth_compare),
                stencil: Default::default(),
                bias: Default::default(),
            }),
            multisample: wgpu::MultisampleState { count: samples, ..Default::default() },
            fragment: Some(wgpu::FragmentState {
                module: &self.module,
                entry_point: Some("fragment"),
                compilation_options: Default::default(),
                targets: &[Some(wgpu::ColorTargetState {
                    format: COLOR_FORMAT,
                    blend: variant.is_blended.then_some(BlendState::ALPHA_BLENDING),
                    write_mask: wgpu::ColorWrites::ALL,
                })],
            }),
            multiview_mask: None,
            cache: None,
        })
    }
}

/// Creates a group of bindings, in order.
pub(crate) fn bind<'a>(
    gpu: &Gpu,
    layout: &BindGroupLayout,
    resources: impl IntoIterator<Item = BindingResource<'a>>,
) -> BindGroup {
    let entries: Vec<wgpu::BindGroupEntry<'_>> =
        (0..).zip(resources).map(|(binding, resource)| wgpu::BindGroupEntry { binding, resource }).collect();
    gpu.device.create_bind_group(&wgpu::BindGroupDescriptor { label: None, layout, entries: &entries })
}

/// Layout of a group of bindings, in order.
pub(crate) fn bindings_layout(
    gpu: &Gpu,
    label: &str,
    bindings: &[(ShaderStages, BindingType)],
) -> BindGroupLayout {
    let entry = |(binding, &(visibility, ty))| BindGroupLayoutEntry { binding, visibility, ty, count: None };
    let entries: Vec<BindGroupLayoutEntry> = (0..).zip(bindings).map(entry).collect();
    let descriptor = wgpu::BindGroupLayoutDescriptor { label: Some(label), entries: &entries };
    gpu.device.create_bind_group_layout(&descriptor)
}

pub(crate) fn uniform() -> BindingType {
    let ty = BufferBindingType::Uniform;
    BindingType::Buffer { ty, has_dynamic_offset: false, min_binding_size: None }
}

pub(crate) fn storage() -> BindingType {
    let ty = BufferBindingType::Storage { read_only: true };
    BindingType::Buffer { ty, has_dynamic_offset: false, min_binding_size: None }
}

pub(crate) fn texture() -> BindingType {
    BindingType::Texture {
        sample_type: TextureSampleType::Float { filterable: true },
        view_dimension: TextureViewDimension::D2,
        multisampled: false,
    }
}

pub(crate) fn sampler() -> BindingType {
    BindingType::Sampler(SamplerBindingType::Filtering)
}
