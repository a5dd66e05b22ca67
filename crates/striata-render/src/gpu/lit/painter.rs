//! Resources that all lit pictures share: the shader, its bindings and pipelines, and the reflectance table.

use std::collections::BTreeMap;
use std::sync::{Mutex, PoisonError};

use bytemuck::cast_slice;
use wgpu::{
    BindGroupLayout, Extent3d, RenderPipeline, ShaderStages, TextureDescriptor, TextureDimension,
    TextureFormat, TextureUsages, TextureView,
};

use crate::gpu::device::Gpu;
use crate::gpu::lit::pipeline_key::PipelineKey;
use crate::gpu::pipelines::{Program, bindings_layout, sampler, texture, uniform};
use crate::reflectance_table::{REFLECTANCE_TABLE, SIDE};

const CODE: &str = concat!(
    include_str!("shaders/frame.wgsl"),
    include_str!("shaders/vertex.wgsl"),
    include_str!("shaders/material.wgsl"),
    include_str!("shaders/reflection.wgsl"),
    include_str!("shaders/surface.wgsl"),
);

/// Draws surfaces with materials, for one number of samples per pixel.
///
/// Pipelines are created when a frame first needs them, so the first picture of a kind of mesh takes longer.
#[derive(Debug)]
pub struct LitPainter {
    pub(crate) frame_layout: BindGroupLayout,
    pub(crate) material_layout: BindGroupLayout,
    pub(crate) object_layout: BindGroupLayout,
    pub(crate) reflectance: TextureView,
    program: Program,
    samples: u32,
    pipelines: Mutex<BTreeMap<PipelineKey, RenderPipeline>>,
}

impl LitPainter {
    /// Compiles the shader for pictures with this number of samples per pixel.
    pub fn new(gpu: &Gpu, samples: u32) -> Self {
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
        let side = SIDE as u32;
        let reflectance = upload_table(
            gpu,
            TextureFormat::Rg16Float,
            [side, side],
            bytes_of_halves(REFLECTANCE_TABLE.as_flattened()),
        );
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
        let create = || key.pipeline(gpu, &self.program, self.samples);
        pipelines.entry(key).or_insert_with(create).clone()
    }
}

/// Uploads a table of half floats of `[width, height]` entries.
pub(crate) fn upload_table(
    gpu: &Gpu,
    format: TextureFormat,
    [width, height]: [u32; 2],
    bytes: Vec<u8>,
) -> TextureView {
    let size = Extent3d { width, height, depth_or_array_layers: 1 };
    let texture = gpu.device.create_texture(&TextureDescriptor {
        label: Some("table"),
        size,
        mip_level_count: 1,
        sample_count: 1,
        dimension: TextureDimension::D2,
        format,
        usage: TextureUsages::TEXTURE_BINDING | TextureUsages::COPY_DST,
        view_formats: &[],
    });
    let layout = wgpu::TexelCopyBufferLayout {
        offset: 0,
        bytes_per_row: Some(bytes.len() as u32 / height.max(1)),
        rows_per_image: None,
    };
    gpu.queue.write_texture(texture.as_image_copy(), &bytes, layout, size);
    texture.create_view(&Default::default())
}

/// The bytes of numbers as half floats.
pub(crate) fn bytes_of_halves(numbers: &[f32]) -> Vec<u8> {
    let bits: Vec<u16> = numbers.iter().map(|&x| half::f16::from_f32(x).to_bits()).collect();
    cast_slice(&bits).to_vec()
}
