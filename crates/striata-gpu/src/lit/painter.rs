//! Resources that all lit pictures share: the shader, its bindings and pipelines, and the reflectance table.

use std::collections::BTreeMap;
use std::sync::{Mutex, PoisonError};

use bytemuck::cast_slice;
use wgpu::{
    BindGroupLayout, BindGroupLayoutEntry, BindingType, BufferBindingType, Extent3d, RenderPipeline,
    SamplerBindingType, ShaderStages, TextureDescriptor, TextureDimension, TextureFormat, TextureSampleType,
    TextureUsages, TextureView, TextureViewDimension,
};

use crate::gpu::Gpu;
use crate::lit::pipelines::{PipelineKey, PipelineParts};
use crate::lit::reflectance_table::{SIDE, reflectance_table};

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
    parts: PipelineParts,
    pipelines: Mutex<BTreeMap<PipelineKey, RenderPipeline>>,
}

impl LitPainter {
    /// Compiles the shader for pictures with this number of samples per pixel.
    pub fn new(gpu: &Gpu, samples: u32) -> Self {
        let frame_layout = layout(
            gpu,
            "frame",
            &[
                (ShaderStages::VERTEX_FRAGMENT, uniform()),
                (ShaderStages::FRAGMENT, texture()),
                (ShaderStages::FRAGMENT, texture()),
                (ShaderStages::FRAGMENT, BindingType::Sampler(SamplerBindingType::Filtering)),
            ],
        );
        let mut of_material = vec![(ShaderStages::FRAGMENT, uniform())];
        of_material.extend([(ShaderStages::FRAGMENT, texture()); 5]);
        let filtering = BindingType::Sampler(SamplerBindingType::Filtering);
        of_material.extend([(ShaderStages::FRAGMENT, filtering); 5]);
        let material_layout = layout(gpu, "material", &of_material);
        let object_layout = layout(gpu, "object", &[(ShaderStages::VERTEX, uniform())]);
        let pipeline_layout = gpu.device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
            label: Some("lit surface"),
            bind_group_layouts: &[Some(&frame_layout), Some(&material_layout), Some(&object_layout)],
            ..Default::default()
        });
        let module = gpu.device.create_shader_module(wgpu::ShaderModuleDescriptor {
            label: Some("lit surface"),
            source: wgpu::ShaderSource::Wgsl(CODE.into()),
        });
        let table = reflectance_table();
        let side = SIDE as u32;
        let reflectance =
            upload_table(gpu, TextureFormat::Rg16Float, [side, side], bytes_of_halves(table.as_flattened()));
        Self {
            frame_layout,
            material_layout,
            object_layout,
            reflectance,
            parts: PipelineParts { module, layout: pipeline_layout, samples },
            pipelines: Mutex::default(),
        }
    }

    /// Returns a pipeline, and creates it if it is the first of its kind.
    pub(crate) fn pipeline(&self, gpu: &Gpu, key: PipelineKey) -> RenderPipeline {
        let mut pipelines = self.pipelines.lock().unwrap_or_else(PoisonError::into_inner);
        pipelines.entry(key).or_insert_with(|| self.parts.pipeline(gpu, key)).clone()
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

/// The bytes of half floats.
pub(crate) fn bytes_of_halves(halves: &[half::f16]) -> Vec<u8> {
    let bits: Vec<u16> = halves.iter().map(|half| half.to_bits()).collect();
    cast_slice(&bits).to_vec()
}

fn uniform() -> BindingType {
    let ty = BufferBindingType::Uniform;
    BindingType::Buffer { ty, has_dynamic_offset: false, min_binding_size: None }
}

fn texture() -> BindingType {
    BindingType::Texture {
        sample_type: TextureSampleType::Float { filterable: true },
        view_dimension: TextureViewDimension::D2,
        multisampled: false,
    }
}

fn layout(gpu: &Gpu, label: &str, bindings: &[(ShaderStages, BindingType)]) -> BindGroupLayout {
    let entry = |(binding, &(visibility, ty))| BindGroupLayoutEntry { binding, visibility, ty, count: None };
    let entries: Vec<BindGroupLayoutEntry> = (0..).zip(bindings).map(entry).collect();
    let descriptor = wgpu::BindGroupLayoutDescriptor { label: Some(label), entries: &entries };
    gpu.device.create_bind_group_layout(&descriptor)
}
