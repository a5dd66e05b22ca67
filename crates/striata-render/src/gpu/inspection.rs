//! Draws individual triangles with their own colors and visible edges.

use bytemuck::cast_slice;
use wgpu::{BindGroup, BufferUsages, RenderPass};

use crate::gpu::device::Gpu;
use crate::gpu::gpu_error::GpuError;
use crate::gpu::indices::GpuIndices;
use crate::gpu::painter::{Painter, Scene};
use crate::gpu::pipelines::bind;
use crate::gpu::vertices::GpuVertices;

/// A level as individual triangles, colored for example by strip or fan, with their edges.
///
/// Shaders fetch the vertices themselves, so vertices are not duplicated per triangle. Takes 16 bytes per
/// triangle.
#[derive(Debug)]
pub struct Inspection {
    bindings: BindGroup,
    triangle_count: u32,
}

impl Inspection {
    /// Uploads triangles and a color for each, linear light as bytes; opacity blends it over the
    /// surface's own color.
    ///
    /// # Panics
    /// If the numbers of colors and triangles differ.
    ///
    /// # Errors
    /// [`GpuError::TooLarge`] if a buffer exceeds the device's limit.
    pub fn new(
        gpu: &Gpu,
        painter: &Painter,
        vertices: &GpuVertices,
        triangles: &[[u32; 3]],
        colors: &[[u8; 4]],
    ) -> Result<Self, GpuError> {
        assert_eq!(colors.len(), triangles.len(), "one color per triangle is required");
        let indices = GpuIndices::upload(gpu, cast_slice(triangles))?;
        let colors = gpu.buffer_of("triangle colors", cast_slice(colors), BufferUsages::STORAGE)?;
        let buffers = [vertices.buffer(0), vertices.buffer(1), vertices.buffer(2), &indices.buffer, &colors];
        let bindings = bind(gpu, &painter.triangles_layout, buffers.map(wgpu::Buffer::as_entire_binding));
        Ok(Self { bindings, triangle_count: triangles.len() as u32 })
    }

    /// Number of triangles.
    pub fn triangle_count(&self) -> u32 {
        self.triangle_count
    }
}

impl Painter {
    /// Draws individual triangles with their colors and edges.
    pub fn inspect(&self, pass: &mut RenderPass<'_>, scene: &Scene, inspection: &Inspection) {
        if inspection.triangle_count() == 0 {
            return;
        }
        pass.set_pipeline(&self.inspection[usize::from(scene.hides_back)]);
        pass.set_bind_group(0, &scene.bindings, &[]);
        pass.set_bind_group(1, &inspection.bindings, &[]);
        pass.draw(0..3 * inspection.triangle_count(), 0..1);
    }
}
