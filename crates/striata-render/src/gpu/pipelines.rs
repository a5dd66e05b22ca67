//! Render pipelines into a canvas, and the layouts of what their shaders read.

use wgpu::{
    BindGroupLayout, BindGroupLayoutEntry, BindingType, BlendState, BufferBindingType, CompareFunction, Face,
    IndexFormat, PipelineLayout, PrimitiveTopology, RenderPipeline, SamplerBindingType, ShaderModule,
    ShaderStages, TextureFormat, TextureSampleType, TextureViewDimension, VertexBufferLayout,
};

use crate::gpu::device::Gpu;

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
pub(crate) struct Variant<'a> {
    pub is_strips: bool,
    pub cull_mode: Option<Face>,
    /// Whether surfaces are blended over what is behind them.
    pub is_blended: bool,
    pub buffers: &'a [Option<VertexBufferLayout<'a>>],
    /// Samples per pixel.
    pub samples: u32,
}

impl Variant<'_> {
    /// Opaque triangles without vertex buffers, seen from both sides.
    pub(crate) fn new(samples: u32) -> Self {
        Self { is_strips: false, cull_mode: None, is_blended: false, buffers: &[], samples }
    }
}

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

    pub(crate) fn pipeline(&self, gpu: &Gpu, variant: &Variant<'_>) -> RenderPipeline {
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
                buffers: variant.buffers,
            },
            primitive: wgpu::PrimitiveState {
                topology,
                strip_index_format,
                cull_mode: variant.cull_mode,
                ..Default::default()
            },
            depth_stencil: Some(wgpu::DepthStencilState {
                format: DEPTH_FORMAT,
                depth_write_enabled: Some(!variant.is_blended),
                depth_compare: Some(depth_compare),
                stencil: Default::default(),
                bias: Default::default(),
            }),
            multisample: wgpu::MultisampleState { count: variant.samples, ..Default::default() },
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
