//! Pipelines of lit surfaces, created when they are first needed.

use wgpu::{
    BlendState, CompareFunction, Face, FrontFace, PipelineLayout, RenderPipeline, ShaderModule,
    TextureFormat, VertexAttribute, VertexBufferLayout, VertexFormat, VertexStepMode,
};

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
    pub(crate) attributes: u8,
    pub(crate) sides: Sides,
    /// Whether the transform mirrors the mesh, so that front faces are clockwise.
    pub(crate) is_mirrored: bool,
    pub(crate) is_blended: bool,
}

/// What all pipelines of a painter share.
#[derive(Debug)]
pub(crate) struct PipelineParts {
    pub(crate) module: ShaderModule,
    pub(crate) layout: PipelineLayout,
    pub(crate) format: TextureFormat,
    pub(crate) samples: u32,
}

/// Attributes of each vertex buffer: size of a vertex in bytes, then location, offset and format.
const ATTRIBUTES: [(u64, &[(u32, u64, VertexFormat)]); BUFFER_COUNT] = [
    (12, &[(0, 0, VertexFormat::Float32x3)]),
    (12, &[(1, 0, VertexFormat::Float32x3)]),
    (16, &[(2, 0, VertexFormat::Float32x4)]),
    (8, &[(3, 0, VertexFormat::Float32x2)]),
    (8, &[(4, 0, VertexFormat::Float32x2)]),
    (16, &[(5, 0, VertexFormat::Float32x4)]),
    (24, &[(6, 0, VertexFormat::Uint16x4), (7, 8, VertexFormat::Float32x4)]),
    (24, &[(8, 0, VertexFormat::Uint16x4), (9, 8, VertexFormat::Float32x4)]),
];

impl PipelineParts {
    pub(crate) fn pipeline(&self, gpu: &Gpu, key: PipelineKey) -> RenderPipeline {
        let attributes =
            ATTRIBUTES.map(|(_, attributes)| -> Vec<VertexAttribute> {
                let attribute = |&(shader_location, offset, format): &(u32, u64, VertexFormat)| {
                    VertexAttribute { format, offset, shader_location }
                };
                attributes.iter().map(attribute).collect()
            });
        let buffers: [Option<VertexBufferLayout<'_>>; BUFFER_COUNT] = std::array::from_fn(|slot| {
            // All vertices share one value of an attribute that the mesh lacks.
            let is_present = key.attributes >> slot & 1 == 1;
            let step_mode = if is_present { VertexStepMode::Vertex } else { VertexStepMode::Instance };
            let attributes = &attributes[slot];
            Some(VertexBufferLayout { array_stride: ATTRIBUTES[slot].0, step_mode, attributes })
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
                front_face: if key.is_mirrored { FrontFace::Cw } else { FrontFace::Ccw },
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
                    format: self.format,
                    blend: key.is_blended.then_some(BlendState::ALPHA_BLENDING),
                    write_mask: wgpu::ColorWrites::ALL,
                })],
            }),
            multiview_mask: None,
            cache: None,
        })
    }
}
