//! Copies a canvas into an sRGB-encoded texture that a window can sample without conversion.
//!
//! A view of the canvas in another format would do this without a copy, but OpenGL does not support such
//! views.

use wgpu::{CommandEncoder, TextureFormat, TextureUsages, TextureView};

use crate::canvas::Canvas;
use crate::gpu::Gpu;

/// Format of the copy: encoded bytes, ready to show.
const ENCODED: TextureFormat = TextureFormat::Rgba8Unorm;

/// sRGB-encoded copy of a [`Canvas`], for user interfaces that blend encoded colors.
#[derive(Debug)]
pub struct ScreenCopy {
    pipeline: wgpu::RenderPipeline,
    bindings: wgpu::BindGroup,
    view: TextureView,
}

impl ScreenCopy {
    /// Creates a copy of a canvas. It is blank until the first [`update`](Self::update).
    pub fn new(gpu: &Gpu, canvas: &Canvas) -> Self {
        let device = gpu.device();
        let module = device.create_shader_module(wgpu::include_wgsl!("shaders/screen_copy.wgsl"));
        let stage = |entry| (Some(entry), wgpu::PipelineCompilationOptions::default());
        let ((vertex, vertex_options), (fragment, fragment_options)) = (stage("vertex"), stage("fragment"));
        let pipeline = device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
            label: Some("screen copy"),
            layout: None,
            vertex: wgpu::VertexState {
                module: &module,
                entry_point: vertex,
                compilation_options: vertex_options,
                buffers: &[],
            },
            primitive: Default::default(),
            depth_stencil: None,
            multisample: Default::default(),
            fragment: Some(wgpu::FragmentState {
                module: &module,
                entry_point: fragment,
                compilation_options: fragment_options,
                targets: &[Some(ENCODED.into())],
            }),
            multiview_mask: None,
            cache: None,
        });
        let bindings = device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some("screen copy"),
            layout: &pipeline.get_bind_group_layout(0),
            entries: &[wgpu::BindGroupEntry {
                binding: 0,
                resource: wgpu::BindingResource::TextureView(&canvas.view()),
            }],
        });
        let texture = device.create_texture(&wgpu::TextureDescriptor {
            label: Some("screen copy"),
            size: canvas.extent(),
            mip_level_count: 1,
            sample_count: 1,
            dimension: wgpu::TextureDimension::D2,
            format: ENCODED,
            usage: TextureUsages::RENDER_ATTACHMENT
                | TextureUsages::TEXTURE_BINDING
                | TextureUsages::COPY_SRC,
            view_formats: &[],
        });
        Self { pipeline, bindings, view: texture.create_view(&Default::default()) }
    }

    /// The texture to sample.
    pub fn view(&self) -> &TextureView {
        &self.view
    }

    /// Records a copy of the canvas as it is at that point of the encoder.
    pub fn update(&self, encoder: &mut CommandEncoder) {
        let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some("screen copy"),
            color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                view: &self.view,
                depth_slice: None,
                resolve_target: None,
                ops: wgpu::Operations {
                    load: wgpu::LoadOp::Clear(wgpu::Color::TRANSPARENT),
                    store: wgpu::StoreOp::Store,
                },
            })],
            ..Default::default()
        });
        pass.set_pipeline(&self.pipeline);
        pass.set_bind_group(0, &self.bindings, &[]);
        pass.draw(0..3, 0..1);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::canvas::Picture;
    use crate::gpu_options::GpuOptions;

    #[test]
    fn the_copy_has_the_same_bytes_as_the_canvas() {
        let gpu = Gpu::new(&GpuOptions::default()).expect("an adapter");
        let canvas = Canvas::new(&gpu, [8, 4], 4).unwrap();
        let copy = ScreenCopy::new(&gpu, &canvas);
        for background in [[0.0, 0.001, 0.2, 1.0], [1.0, 0.5, 0.021, 0.25]] {
            let mut encoder = gpu.device().create_command_encoder(&Default::default());
            drop(canvas.begin(&mut encoder, background));
            copy.update(&mut encoder);
            gpu.queue().submit([encoder.finish()]);
            let canvas = canvas.read(&gpu).unwrap();
            let copied = Picture::read(&gpu, copy.view().texture()).unwrap();
            assert_eq!((canvas.width, canvas.height), (copied.width, copied.height));
            let far = canvas.rgba.iter().zip(&copied.rgba).filter(|(a, b)| a.abs_diff(**b) > 1).count();
            assert_eq!(far, 0, "{background:?}: {:?} became {:?}", &canvas.rgba[..4], &copied.rgba[..4]);
        }
    }
}
