//! Vertex buffers: uploaded once, used by every level.

use bytemuck::cast_slice;
use striata::mesh::{IndexedMesh, Semantic};
use wgpu::{Buffer, BufferUsages};

use crate::gpu::device::Gpu;
use crate::gpu::gpu_error::GpuError;
use crate::normals::vertex_normals;
use crate::srgb::to_srgb;

/// Positions, normals and colors of a mesh on the GPU.
///
/// Positions are stored relative to the center of the bounds ([`origin`](Self::origin)), so that a mesh far
/// from zero keeps its shape in 32 bits. Normals come from the mesh or are computed from its triangles,
/// weighted by area; they serve every level, since vertices never move. Takes 28 bytes per vertex.
#[derive(Debug)]
pub struct GpuVertices {
    pub(crate) positions: Buffer,
    pub(crate) normals: Buffer,
    /// sRGB bytes.
    pub(crate) colors: Buffer,
    has_colors: bool,
    origin: [f32; 3],
    radius: f32,
    vertex_count: usize,
}

impl GpuVertices {
    /// Uploads the vertices of a mesh.
    ///
    /// # Errors
    /// [`GpuError::TooLarge`] if a buffer exceeds the device's limit.
    pub fn upload(gpu: &Gpu, mesh: &IndexedMesh) -> Result<Self, GpuError> {
        let bounds = mesh.bounds();
        let origin = bounds.map_or([0.0; 3], |b| std::array::from_fn(|k| (b.min[k] + b.max[k]) / 2.0));
        let positions: Vec<[f32; 3]> =
            mesh.positions.iter().map(|p| std::array::from_fn(|k| p[k] - origin[k])).collect();
        let colors = vertex_colors(mesh);
        let usage = BufferUsages::VERTEX | BufferUsages::STORAGE;
        let white = vec![[255u8; 4]; if colors.is_some() { 0 } else { mesh.vertex_count() }];
        Ok(Self {
            positions: gpu.buffer_of("positions", cast_slice(&positions), usage)?,
            normals: gpu.buffer_of("normals", cast_slice(&normals_of(mesh)), usage)?,
            colors: gpu.buffer_of("colors", cast_slice(colors.as_ref().unwrap_or(&white)), usage)?,
            has_colors: colors.is_some(),
            origin,
            radius: bounds.map_or(1.0, |b| b.diagonal() as f32 / 2.0),
            vertex_count: mesh.vertex_count(),
        })
    }

    /// Replaces the vertex colors, one per vertex, linear light as bytes; for example to visualize an error.
    ///
    /// # Panics
    /// If the numbers of colors and vertices differ.
    pub fn set_colors(&mut self, gpu: &Gpu, colors: &[[u8; 4]]) {
        assert_eq!(colors.len(), self.vertex_count, "one color per vertex is required");
        let byte = |light: u8| to_srgb(f32::from(light) / 255.0);
        let colors: Vec<_> = colors.iter().map(|&[r, g, b, a]| [byte(r), byte(g), byte(b), a]).collect();
        gpu.queue.write_buffer(&self.colors, 0, cast_slice(&colors));
        self.has_colors = true;
    }

    /// Offset that was subtracted from all positions.
    pub fn origin(&self) -> [f32; 3] {
        self.origin
    }

    /// Half the diagonal of the bounds.
    pub fn radius(&self) -> f32 {
        self.radius
    }

    /// Number of vertices.
    pub fn vertex_count(&self) -> usize {
        self.vertex_count
    }

    /// Whether the vertices have colors.
    pub fn has_colors(&self) -> bool {
        self.has_colors
    }
}

/// Returns the mesh's normals, or area-weighted means of its triangles' normals if it has none.
fn normals_of(mesh: &IndexedMesh) -> Vec<[f32; 3]> {
    if let Some(layer) = mesh.layer(&Semantic::Normal).filter(|l| l.component_count >= 3) {
        return (0..mesh.vertex_count()).map(|v| std::array::from_fn(|k| layer.get(v, k))).collect();
    }
    vertex_normals(mesh)
}

/// Returns the mesh's colors as sRGB bytes, which keep dark ones apart, if it has any.
fn vertex_colors(mesh: &IndexedMesh) -> Option<Vec<[u8; 4]>> {
    let colors = mesh.linear_colors()?.into_iter();
    Some(colors.map(|[r, g, b, _]| [to_srgb(r), to_srgb(g), to_srgb(b), 255]).collect())
}
