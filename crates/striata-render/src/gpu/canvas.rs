//! Offscreen rendering: pictures drawn into a texture and read back.

use wgpu::{
    BufferUsages, CommandEncoder, Extent3d, RenderPass, Texture, TextureFormat, TextureUsages, TextureView,
};

use crate::gpu::copy_back::read_buffer;
use crate::gpu::device::Gpu;
use crate::gpu::gpu_error::GpuError;
use crate::gpu::pipelines::{COLOR_FORMAT, DEPTH_FORMAT};

/// Image in memory, stored row by row from the top with 4 bytes per pixel: red, green and blue in sRGB,
/// then opacity.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Picture {
    /// Width in pixels.
    pub width: u32,
    /// Height in pixels.
    pub height: u32,
    /// Pixel bytes, 4 per pixel.
    pub rgba: Vec<u8>,
}

/// Offscreen render target: color and depth textures, with multisampling if requested.
#[derive(Debug)]
pub struct Canvas {
    color: Texture,
    color_view: TextureView,
    /// Multisampled color target; none if there is one sample per pixel.
    samples_view: Option<TextureView>,
    depth_view: TextureView,
    samples: u32,
}

impl Canvas {
    /// Color format of every canvas.
    pub const FORMAT: TextureFormat = COLOR_FORMAT;

    /// Creates a canvas of `[width, height]` pixels with 1 or 4 samples per pixel.
    ///
    /// # Errors
    /// [`GpuError::PictureSize`] if a side is 0 or longer than the device allows.
    pub fn new(gpu: &Gpu, [width, height]: [u32; 2], samples: u32) -> Result<Self, GpuError> {
        let limit = gpu.device.limits().max_texture_dimension_2d;
        if width == 0 || height == 0 || width > limit || height > limit {
            return Err(GpuError::PictureSize { width, height, limit });
        }
        let make = |format, sample_count, usage| {
            gpu.device.create_texture(&wgpu::TextureDescriptor {
                label: Some("canvas"),
                size: Extent3d { width, height, depth_or_array_layers: 1 },
                mip_level_count: 1,
                sample_count,
                dimension: wgpu::TextureDimension::D2,
                format,
                usage,
                view_formats: &[],
            })
        };
        let drawn = TextureUsages::RENDER_ATTACHMENT;
        let color = make(Self::FORMAT, 1, drawn | TextureUsages::COPY_SRC);
        let view = |texture: &Texture| texture.create_view(&Default::default());
        Ok(Self {
            color_view: view(&color),
            samples_view: (samples > 1).then(|| view(&make(Self::FORMAT, samples, drawn))),
            depth_view: view(&make(DEPTH_FORMAT, samples, drawn)),
            color,
            samples,
        })
    }

    /// Samples per pixel.
    pub fn samples(&self) -> u32 {
        self.samples
    }

    /// Begins a render pass that clears the canvas to `background`, linear light and opacity.
    pub fn begin<'e>(&self, encoder: &'e mut CommandEncoder, background: [f32; 4]) -> RenderPass<'e> {
        let [r, g, b, a] = background.map(f64::from);
        let (view, resolve_target) = match &self.samples_view {
            Some(samples) => (samples, Some(&self.color_view)),
            None => (&self.color_view, None),
        };
        encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some("canvas"),
            color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                view,
                depth_slice: None,
                resolve_target,
                ops: wgpu::Operations {
                    load: wgpu::LoadOp::Clear(wgpu::Color { r, g, b, a }),
                    store: wgpu::StoreOp::Store,
                },
            })],
            depth_stencil_attachment: Some(wgpu::RenderPassDepthStencilAttachment {
                view: &self.depth_view,
                depth_ops: Some(wgpu::Operations {
                    load: wgpu::LoadOp::Clear(0.0),
                    store: wgpu::StoreOp::Discard,
                }),
                stencil_ops: None,
            }),
            ..Default::default()
        })
    }

    /// Draws one picture on a background, waits for it, and reads it back.
    ///
    /// # Errors
    /// [`GpuError::Failed`] if the device fails, [`GpuError::TooLarge`] if the picture does not fit into
    /// a buffer.
    pub fn paint(
        &self,
        gpu: &Gpu,
        background: [f32; 4],
        draw: impl FnOnce(&mut RenderPass<'_>),
    ) -> Result<Picture, GpuError> {
        let mut encoder = gpu.device.create_command_encoder(&Default::default());
        draw(&mut self.begin(&mut encoder, background));
        gpu.queue.submit([encoder.finish()]);
        self.read(gpu)
    }

    /// Reads back what was drawn last.
    ///
    /// # Errors
    /// [`GpuError::Failed`] if the device fails, [`GpuError::TooLarge`] if the picture does not fit into
    /// a buffer.
    pub fn read(&self, gpu: &Gpu) -> Result<Picture, GpuError> {
        let size = self.color.size();
        let row_bytes = 4 * size.width;
        let stride = row_bytes.next_multiple_of(wgpu::COPY_BYTES_PER_ROW_ALIGNMENT);
        let bytes = u64::from(stride) * u64::from(size.height);
        let buffer = gpu.empty_buffer("picture", bytes, BufferUsages::COPY_DST | BufferUsages::MAP_READ)?;
        let mut encoder = gpu.device.create_command_encoder(&Default::default());
        encoder.copy_texture_to_buffer(
            self.color.as_image_copy(),
            wgpu::TexelCopyBufferInfo {
                buffer: &buffer,
                layout: wgpu::TexelCopyBufferLayout {
                    offset: 0,
                    bytes_per_row: Some(stride),
                    rows_per_image: None,
                },
            },
            size,
        );
        gpu.queue.submit([encoder.finish()]);
        let mapped = read_buffer(gpu, &buffer)?;
        let rows = mapped.chunks_exact(stride as usize).take(size.height as usize);
        let rgba: Vec<u8> = rows.flat_map(|row| &row[..row_bytes as usize]).copied().collect();
        Ok(Picture { width: size.width, height: size.height, rgba })
    }
}
