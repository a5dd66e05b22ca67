//! Pipelines of lit surfaces, created when they are first needed.

use wgpu::{
    BlendState, CompareFunction, Face, PipelineLayout, RenderPipeline, ShaderModule, VertexAttribute,
    VertexBufferLayout, VertexStepMode, vertex_attr_array,
};

use crate::canvas::Canvas;
use crate::gpu::Gpu;
use crate::lit::vertices::BUFFER_COUNT;
use crate::painter::DEPTH_FORMAT;

/// Which sides of a surface are drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Sides {
    Front,
    Back,
    Both,
}

/// Properties that need a pipeline of their own.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct PipelineKey {
    /// One bit per vertex buffer that the mesh has; see [`BUFFER_COUNT`].
    pub attributes: u8,
    pub sides: Sides,
    pub is_blended: bool,
}

/// Parts that all pipelines of a painter share: the shader, the layout, and the number of samples.
#[derive(Debug)]
pub(crate) struct PipelineParts {
    pub module: ShaderModule,
    pub layout: PipelineLayout,
    pub samples: u32,
}

/// Size of a vertex in each vertex buffer, bytes, and its attributes.
const ATTRIBUTES: [(u64, &[VertexAttribute]); BUFFER_COUNT] = [
    (12, &vertex_attr_array![0 => Float32x3]),
    (12, &vertex_attr_array![1 => Float32x3]),
    (16, &vertex_attr_array![2 => Float32x4]),
    (8, &vertex_attr_array![3 => Float32x2]),
    (8, &vertex_attr_array![4 => Float32x2]),
    (16, &vertex_attr_array![5 => Float32x4]),
];

impl PipelineParts {
    pub(crate) fn pipeline(&self, gpu: &Gpu, key: PipelineKey) -> RenderPipeline {
        let buffers: [Option<VertexBufferLayout<'_>>; BUFFER_COUNT] = std::array::from_fn(|slot| {
            // All vertices share one value of an attribute that the mesh lacks.
            let is_present = key.attributes >> slot & 1 == 1;
            let step_mode = if is_present { VertexStepMode::Vertex } else { VertexStepMode::Instance };
            let (array_stride, attributes) = ATTRIBUTES[slot];
            Some(VertexBufferLayout { array_stride, step_mode, attributes })
        });
        gpu.device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
            label: Some("lit surface"),
            layout: Some(&self.layout),
            vertex: wgpu::VertexState {
                module: &self.module,
                entry_point: Some("vertex"),
                compilation_options: Default::default(),
                buffers: &buffers,
            },
            primitive: wgpu::PrimitiveState {
                cull_mode: match key.sides {
                    Sides::Front => Some(Face::Back),
                    Sides::Back => Some(Face::Front),
                    Sides::Both => None,
                },
                ..Default::default()
            },
            depth_stencil: Some(wgpu::DepthStencilState {
                format: DEPTH_FORMAT,
                depth_write_enabled: Some(!key.is_blended),
                depth_compare: Some(CompareFunction::GreaterEqual),
                stencil: Default::default(),
                bias: Default::default(),
            }),
            multisample: wgpu::MultisampleState { count: self.samples, ..Default::default() },
            fragment: Some(wgpu::FragmentState {
                module: &self.module,
                entry_point: Some("fragment"),
                compilation_options: Default::default(),
                targets: &[Some(wgpu::ColorTargetState {
                    format: Canvas::FORMAT,
                    blend: key.is_blended.then_some(BlendState::ALPHA_BLENDING),
                    write_mask: wgpu::ColorWrites::ALL,
                })],
            }),
            multiview_mask: None,
            cache: None,
        })
    }
}
