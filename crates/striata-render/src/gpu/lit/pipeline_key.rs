//! Pipelines of lit surfaces, created when they are first needed.

use wgpu::{Face, RenderPipeline, VertexAttribute, VertexBufferLayout, VertexStepMode, vertex_attr_array};

use crate::gpu::device::Gpu;
use crate::gpu::lit::vertices::BUFFER_COUNT;
use crate::gpu::pipelines::{Program, Variant};

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

/// Size of a vertex in each vertex buffer, bytes, and its attributes.
const ATTRIBUTES: [(u64, &[VertexAttribute]); BUFFER_COUNT] = [
    (12, &vertex_attr_array![0 => Float32x3]),
    (12, &vertex_attr_array![1 => Float32x3]),
    (16, &vertex_attr_array![2 => Float32x4]),
    (8, &vertex_attr_array![3 => Float32x2]),
    (8, &vertex_attr_array![4 => Float32x2]),
    (16, &vertex_attr_array![5 => Float32x4]),
];

impl PipelineKey {
    pub(crate) fn pipeline(self, gpu: &Gpu, program: &Program, samples: u32) -> RenderPipeline {
        let buffers: [Option<VertexBufferLayout<'_>>; BUFFER_COUNT] = std::array::from_fn(|slot| {
            // All vertices share one value of an attribute that the mesh lacks.
            let is_present = self.attributes >> slot & 1 == 1;
            let step_mode = if is_present { VertexStepMode::Vertex } else { VertexStepMode::Instance };
            let (array_stride, attributes) = ATTRIBUTES[slot];
            Some(VertexBufferLayout { array_stride, step_mode, attributes })
        });
        let cull_mode = match self.sides {
            Sides::Front => Some(Face::Back),
            Sides::Back => Some(Face::Front),
            Sides::Both => None,
        };
        let is_blended = self.is_blended;
        let variant = Variant { cull_mode, is_blended, buffers: &buffers, ..Variant::new(samples) };
        program.pipeline(gpu, &variant)
    }
}
