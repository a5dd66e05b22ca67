//! Textures of numbers that the vertex stage reads by index; storage buffers are not available there on every
//! adapter.

use bytemuck::cast_slice;
use wgpu::{Extent3d, Texture, TextureDescriptor, TextureDimension, TextureFormat, TextureUsages};

use crate::gpu::Gpu;
use crate::gpu_error::GpuError;

/// Widest row, in texels.
const MAX_WIDTH: u32 = 4096;

/// Bytes of a texel: four 32-bit floats.
const TEXEL_BYTES: u64 = 16;

/// Texels in rows of equal length.
#[derive(Debug)]
pub(crate) struct DataTexture {
    pub texture: Texture,
}

impl DataTexture {
    /// Creates a texture of at least `texel_count` texels.
    ///
    /// # Errors
    /// [`GpuError::TooLarge`] if the texels do not fit into a texture.
    pub(crate) fn new(gpu: &Gpu, label: &'static str, texel_count: u64) -> Result<Self, GpuError> {
        let limit = gpu.device.limits().max_texture_dimension_2d;
        let width = MAX_WIDTH.min(limit);
        let height = texel_count.div_ceil(u64::from(width)).max(1);
        if height > u64::from(limit) {
            let limit_bytes = TEXEL_BYTES * u64::from(width) * u64::from(limit);
            let (needed_bytes, adapter) = (TEXEL_BYTES * texel_count, gpu.info().name.clone());
            return Err(GpuError::TooLarge { what: label, needed_bytes, limit_bytes, adapter });
        }
        // Short lists need no full row.
        let width = if height == 1 { (texel_count as u32).clamp(1, width) } else { width };
        let texture = gpu.device.create_texture(&TextureDescriptor {
            label: Some(label),
            size: Extent3d { width, height: height as u32, depth_or_array_layers: 1 },
            mip_level_count: 1,
            sample_count: 1,
            dimension: TextureDimension::D2,
            format: TextureFormat::Rgba32Float,
            usage: TextureUsages::TEXTURE_BINDING | TextureUsages::COPY_DST,
            view_formats: &[],
        });
        Ok(Self { texture })
    }

    /// Number of texels that fit.
    pub(crate) fn capacity(&self) -> usize {
        (self.texture.width() as usize) * (self.texture.height() as usize)
    }

    /// Writes texels from the first one on; those that do not fit are left out.
    pub(crate) fn write(&self, gpu: &Gpu, texels: &[[f32; 4]]) {
        let width = self.texture.width() as usize;
        let texels = &texels[..texels.len().min(self.capacity())];
        let (rows, rest) = texels.split_at(texels.len() / width * width);
        let row_count = (rows.len() / width) as u32;
        for (first_row, part, [columns, count]) in
            [(0, rows, [width as u32, row_count]), (row_count, rest, [rest.len() as u32, 1])]
        {
            if part.is_empty() {
                continue;
            }
            let mut to = self.texture.as_image_copy();
            to.origin.y = first_row;
            let layout = wgpu::TexelCopyBufferLayout {
                offset: 0,
                bytes_per_row: Some(TEXEL_BYTES as u32 * columns),
                rows_per_image: None,
            };
            let size = Extent3d { width: columns, height: count, depth_or_array_layers: 1 };
            gpu.queue.write_texture(to, cast_slice(part), layout, size);
        }
    }
}
