//! Textures and samplers of images.

use striata_scene::drawn::{self, Wrap};
use striata_scene::textures::RgbaImage;
use wgpu::{
    AddressMode, Extent3d, FilterMode, MipmapFilterMode, Sampler, SamplerDescriptor, TextureDescriptor,
    TextureDimension, TextureFormat, TextureUsages, TextureView,
};

use crate::gpu::device::Gpu;
use crate::mips::{ImageMeaning, mip_levels};

/// Uploads an image with its mip levels. Images larger than the device allows lose their finest levels.
pub(crate) fn upload_image(gpu: &Gpu, image: &RgbaImage, meaning: ImageMeaning) -> TextureView {
    let levels = mip_levels(image, meaning, gpu.device.limits().max_texture_dimension_2d);
    let format = match meaning {
        ImageMeaning::Color { .. } => TextureFormat::Rgba8UnormSrgb,
        ImageMeaning::Linear | ImageMeaning::Normal => TextureFormat::Rgba8Unorm,
    };
    let levels: Vec<_> = levels.iter().map(|level| ([level.width, level.height], &level.rgba[..])).collect();
    upload(gpu, format, &levels)
}

/// Uploads a table of numbers as half floats, with `[width, height]` entries.
pub(crate) fn upload_table(gpu: &Gpu, format: TextureFormat, size: [u32; 2], numbers: &[f32]) -> TextureView {
    let bits: Vec<u16> = numbers.iter().map(|&x| half::f16::from_f32(x).to_bits()).collect();
    upload(gpu, format, &[(size, bytemuck::cast_slice(&bits))])
}

/// Uploads levels of a texture, each with its size and bytes, the largest first.
fn upload(gpu: &Gpu, format: TextureFormat, levels: &[([u32; 2], &[u8])]) -> TextureView {
    let size = |[width, height]: [u32; 2]| Extent3d { width, height, depth_or_array_layers: 1 };
    let texture = gpu.device.create_texture(&TextureDescriptor {
        label: None,
        size: size(levels.first().map_or([1; 2], |level| level.0)),
        mip_level_count: levels.len().max(1) as u32,
        sample_count: 1,
        dimension: TextureDimension::D2,
        format,
        usage: TextureUsages::TEXTURE_BINDING | TextureUsages::COPY_DST,
        view_formats: &[],
    });
    for (mip_level, &(of_level, bytes)) in (0..).zip(levels) {
        let to = wgpu::TexelCopyTextureInfo { mip_level, ..texture.as_image_copy() };
        let bytes_per_row = Some(bytes.len() as u32 / of_level[1].max(1));
        let layout = wgpu::TexelCopyBufferLayout { offset: 0, bytes_per_row, rows_per_image: None };
        gpu.queue.write_texture(to, bytes, layout, size(of_level));
    }
    texture.create_view(&Default::default())
}

/// Creates a sampler; anisotropic only if all its filters are linear.
pub(crate) fn create_sampler(gpu: &Gpu, sampler: drawn::Sampler) -> Sampler {
    let [u, v] = sampler.wrap.map(|wrap| match wrap {
        Wrap::Repeat => AddressMode::Repeat,
        Wrap::MirroredRepeat => AddressMode::MirrorRepeat,
        Wrap::ClampToEdge => AddressMode::ClampToEdge,
    });
    gpu.device.create_sampler(&SamplerDescriptor {
        label: Some("image"),
        address_mode_u: u,
        address_mode_v: v,
        mag_filter: if sampler.is_smooth { FilterMode::Linear } else { FilterMode::Nearest },
        min_filter: FilterMode::Linear,
        mipmap_filter: if sampler.has_mip_maps {
            MipmapFilterMode::Linear
        } else {
            MipmapFilterMode::Nearest
        },
        // Without mip levels only the full image is used. A clamp of 0 would always choose the filter for
        // magnified images.
        lod_max_clamp: if sampler.has_mip_maps { 32.0 } else { 0.25 },
        anisotropy_clamp: if sampler.is_smooth && sampler.has_mip_maps { 16 } else { 1 },
        ..Default::default()
    })
}
