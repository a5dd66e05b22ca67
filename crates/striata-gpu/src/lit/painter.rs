//! Resources that all lit pictures share: the shader, its bindings and pipelines, and the reflectance table.

use std::collections::BTreeMap;
use std::sync::{Mutex, PoisonError};

use bytemuck::cast_slice;
use wgpu::{
    BindGroup, BindGroupEntry, BindGroupLayout, BindGroupLayoutEntry, BindingResource, BindingType,
    BufferBindingType, Extent3d, RenderPipeline, SamplerBindingType, ShaderStages, TextureDescriptor,
    TextureDimension, TextureFormat, TextureSampleType, TextureUsages, TextureView, TextureViewDimension,
};

use crate::gpu::Gpu;
use crate::lit::data_texture::DataTexture;
use crate::lit::frame_data::FRAME_BYTES;
use crate::lit::instance_data::INSTANCE_BYTES;
use crate::lit::morph_targets::MorphTargets;
use crate::lit::pipelines::{PipelineKey, PipelineParts};
use crate::lit::reflectance_table::{SIDE, reflectance_table};

const CODE: &str = concat!(
    include_str!("shaders/frame.wgsl"),
    include_str!("shaders/pose.wgsl"),
    include_str!("shaders/material.wgsl"),
    include_str!("shaders/reflection.wgsl"),
    include_str!("shaders/surface.wgsl"),
);

/// Draws surfaces with materials, for one color format and sample count.
///
/// Pipelines are created when a frame first needs them, so the first picture of a kind of mesh takes longer.
#[derive(Debug)]
pub struct LitPainter {
    pub(crate) frame_layout: BindGroupLayout,
    pub(crate) material_layout: BindGroupLayout,
    pub(crate) instance_layout: BindGroupLayout,
    morph_layout: BindGroupLayout,
    pub(crate) reflectance: TextureView,
    pub(crate) anisotropy: u16,
    parts: PipelineParts,
    pipelines: Mutex<BTreeMap<PipelineKey, RenderPipeline>>,
}

impl LitPainter {
    /// Compiles the shader for a render target. If its format is not sRGB, the shader encodes the colors.
    pub fn new(gpu: &Gpu, format: TextureFormat, samples: u32) -> Self {
        let frame_layout = layout(
            gpu,
            "frame",
            &[
                (ShaderStages::VERTEX_FRAGMENT, uniform(FRAME_BYTES, false)),
                (ShaderStages::FRAGMENT, texture(true)),
                (ShaderStages::FRAGMENT, texture(true)),
                (ShaderStages::FRAGMENT, BindingType::Sampler(SamplerBindingType::Filtering)),
            ],
        );
        let mut of_material = vec![(ShaderStages::FRAGMENT, uniform(0, false))];
        of_material.extend([(ShaderStages::FRAGMENT, texture(true)); 5]);
        let filtering = BindingType::Sampler(SamplerBindingType::Filtering);
        of_material.extend([(ShaderStages::FRAGMENT, filtering); 5]);
        let material_layout = layout(gpu, "material", &of_material);
        let of_instance =
            [(ShaderStages::VERTEX, uniform(INSTANCE_BYTES, true)), (ShaderStages::VERTEX, texture(false))];
        let instance_layout = layout(gpu, "instance", &of_instance);
        let morph_layout = layout(gpu, "morph targets", &[(ShaderStages::VERTEX, texture(false))]);
        let pipeline_layout = gpu.device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
            label: Some("lit surface"),
            bind_group_layouts: &[
                Some(&frame_layout),
                Some(&material_layout),
                Some(&instance_layout),
                Some(&morph_layout),
            ],
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
            instance_layout,
            morph_layout,
            reflectance,
            anisotropy: 16,
            parts: PipelineParts { module, layout: pipeline_layout, format, samples },
            pipelines: Mutex::default(),
        }
    }

    /// Sets the largest anisotropy of textures that are uploaded later, 1 to 16. Default: 16.
    #[must_use]
    pub fn with_anisotropy(mut self, anisotropy: u16) -> Self {
        self.anisotropy = anisotropy.clamp(1, 16);
        self
    }

    /// Color format of the render target.
    pub fn format(&self) -> TextureFormat {
        self.parts.format
    }

    /// Samples per pixel.
    pub fn samples(&self) -> u32 {
        self.parts.samples
    }

    /// Returns a pipeline, and creates it if it is the first of its kind.
    pub(crate) fn pipeline(&self, gpu: &Gpu, key: PipelineKey) -> RenderPipeline {
        let mut pipelines = self.pipelines.lock().unwrap_or_else(PoisonError::into_inner);
        pipelines.entry(key).or_insert_with(|| self.parts.pipeline(gpu, key)).clone()
    }

    /// Binds the displacements of a mesh.
    pub(crate) fn morph_bindings(&self, gpu: &Gpu, targets: &MorphTargets) -> BindGroup {
        let view = data_view(&targets.texture);
        gpu.device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some("morph targets"),
            layout: &self.morph_layout,
            entries: &[BindGroupEntry { binding: 0, resource: BindingResource::TextureView(&view) }],
        })
    }
}

/// View of a whole data texture.
pub(crate) fn data_view(texture: &DataTexture) -> TextureView {
    texture.texture.create_view(&Default::default())
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

fn uniform(bytes: u64, has_dynamic_offset: bool) -> BindingType {
    let min_binding_size = std::num::NonZeroU64::new(bytes);
    BindingType::Buffer { ty: BufferBindingType::Uniform, has_dynamic_offset, min_binding_size }
}

fn texture(filterable: bool) -> BindingType {
    BindingType::Texture {
        sample_type: TextureSampleType::Float { filterable },
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
