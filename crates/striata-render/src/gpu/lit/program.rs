//! Shared by all pictures with materials: the shader, its bindings and pipelines, and the reflectance table.

use std::collections::HashMap;
use std::sync::{Mutex, PoisonError};

use wgpu::{BindGroupLayout, Face, RenderPipeline, ShaderStages, TextureFormat, TextureView};

use crate::gpu::device::Gpu;
use crate::gpu::lit::textures::upload_table;
use crate::gpu::pipelines::{Program, Variant, bindings_layout, sampler, texture, uniform};
use crate::gpu::vertices::BUFFER_COUNT;
use crate::reflectance_table::{REFLECTANCE_TABLE, SIDE};

const CODE: &str = concat!(
    include_str!("shaders/frame.wgsl"),
    include_str!("shaders/vertex.wgsl"),
    include_str!("shaders/material.wgsl"),
    include_str!("shaders/reflection.wgsl"),
    include_str!("shaders/surface.wgsl"),
);

/// The program of surfaces with materials, for one number of samples per pixel.
///
/// Pipelines are created when a frame first needs them, so the first picture of a kind of mesh takes longer.
#[derive(Debug)]
pub(crate) struct LitProgram {
    pub frame_layout: BindGroupLayout,
    pub material_layout: BindGroupLayout,
    pub object_layout: BindGroupLayout,
    pub reflectance: TextureView,
    program: Program,
    samples: u32,
    pipelines: Mutex<HashMap<PipelineKey, RenderPipeline>>,
}

/// Properties that need a pipeline of their own.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) struct PipelineKey {
    /// Whether the mesh has each attribute.
    pub present: [bool; BUFFER_COUNT],
    /// The sides that are not drawn.
    pub culled: Option<Face>,
    pub is_blended: bool,
}

impl LitProgram {
    /// Compiles the shader for pictures with this number of samples per pixel.
    pub(crate) fn new(gpu: &Gpu, samples: u32) -> Self {
        let (vertex, fragment) = (ShaderStages::VERTEX, ShaderStages::FRAGMENT);
        let mut of_frame = vec![(vertex | fragment, uniform())];
        of_frame.extend([texture(), texture(), sampler()].map(|binding| (fragment, binding)));
        let frame_layout = bindings_layout(gpu, "frame", &of_frame);
        let mut of_material = vec![(fragment, uniform())];
        of_material.extend([(fragment, texture()); 5]);
        of_material.extend([(fragment, sampler()); 5]);
        let material_layout = bindings_layout(gpu, "material", &of_material);
        let object_layout = bindings_layout(gpu, "object", &[(vertex, uniform())]);
        let program =
            Program::new(gpu, "lit surface", CODE, &[&frame_layout, &material_layout, &object_layout]);
        let numbers = REFLECTANCE_TABLE.as_flattened();
        let reflectance = upload_table(gpu, TextureFormat::Rg16Float, [SIDE as u32; 2], numbers);
        Self {
            frame_layout,
            material_layout,
            object_layout,
            reflectance,
            program,
            samples,
            pipelines: Mutex::default(),
        }
    }

    /// Returns a pipeline, and creates it if it is the first of its kind.
    pub(crate) fn pipeline(&self, gpu: &Gpu, key: PipelineKey) -> RenderPipeline {
        let mut pipelines = self.pipelines.lock().unwrap_or_else(PoisonError::into_inner);
        let create = || {
            let PipelineKey { present, culled, is_blended } = key;
            let variant = Variant { is_strips: false, culled, is_blended, present: &present };
            self.program.pipeline(gpu, self.samples, &variant)
        };
        pipelines.entry(key).or_insert_with(create).clone()
    }
}
