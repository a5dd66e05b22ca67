//! Vertex buffers: uploaded once, used by every level and by every painter.

use bytemuck::cast_slice;
use half::f16;
use striata::mesh::{Bounds, IndexedMesh, Semantic};
use wgpu::{Buffer, BufferUsages};

use crate::camera::{Camera, to_f64};
use crate::gpu::device::Gpu;
use crate::gpu::gpu_error::GpuError;

/// Number of vertex buffers: position, normal, color, tangent, and two sets of texture coordinates.
pub(crate) const BUFFER_COUNT: usize = 6;

/// The buffers that every mesh has: position, normal and color.
pub(crate) const PLAIN_COUNT: usize = 3;

/// Vertices of a mesh on the GPU.
///
/// Positions are stored relative to the center of the bounds ([`origin`](Self::origin)), so that a mesh far
/// from zero keeps its shape in 32 bits. Surfaces without normals are flat. A vertex takes 32 bytes, and more if
/// it has a tangent (16) or texture coordinates (8 each).
#[derive(Debug)]
pub struct GpuVertices {
    /// [`None`] for attributes that the mesh lacks; never for the first three.
    buffers: [Option<Buffer>; BUFFER_COUNT],
    /// Zeros, for attributes that the mesh lacks.
    absent: Buffer,
    has_colors: bool,
    origin: [f32; 3],
    radius: f32,
    vertex_count: usize,
}

impl GpuVertices {
    /// Uploads the vertices of a mesh.
    ///
    /// Layers that are used: normal, tangent, texture coordinates 0 and 1, and color 0.
    ///
    /// # Errors
    /// [`GpuError::Mesh`] if the mesh is inconsistent, [`GpuError::TooLarge`] if a buffer exceeds the device's
    /// limit.
    pub fn upload(gpu: &Gpu, mesh: &IndexedMesh) -> Result<Self, GpuError> {
        Self::with_more(gpu, mesh, &[], false)
    }

    /// Uploads the vertices of a mesh, without their normals if they are flat, and more positions after them.
    pub(crate) fn with_more(
        gpu: &Gpu,
        mesh: &IndexedMesh,
        more: &[[f32; 3]],
        is_flat: bool,
    ) -> Result<Self, GpuError> {
        mesh.check()?;
        let vertex_count = mesh.vertex_count() + more.len();
        let mut positions = [&mesh.positions[..], more].concat();
        let bounds = Bounds::of(&positions);
        let origin = bounds.map_or([0.0; 3], |b| std::array::from_fn(|k| b.min[k] / 2.0 + b.max[k] / 2.0));
        positions.iter_mut().for_each(|p| *p = std::array::from_fn(|k| p[k] - origin[k]));
        let normals = floats::<3>(mesh, &Semantic::Normal, vertex_count).filter(|_| !is_flat);
        // Tangents mean nothing without normals.
        let tangents = normals.as_ref().and_then(|_| floats::<4>(mesh, &Semantic::Tangent, vertex_count));
        let with_hand = |[x, y, z, w]: [f32; 4]| [x, y, z, if w < 0.0 { -1.0 } else { 1.0 }];
        let tangents: Option<Vec<_>> = tangents.map(|all| all.into_iter().map(with_hand).collect());
        let uv = [0, 1].map(|set| floats::<2>(mesh, &Semantic::TexCoord(set), vertex_count));
        let colors = mesh.linear_colors();
        let has_colors = colors.is_some();
        let mut colors: Vec<_> = colors.into_iter().flatten().map(halves).collect();
        colors.resize(vertex_count, halves([1.0; 4]));
        let upload = |label, bytes: Option<&[u8]>| -> Result<Option<Buffer>, GpuError> {
            let usage = BufferUsages::VERTEX | BufferUsages::STORAGE;
            bytes.map(|bytes| gpu.buffer_of(label, bytes, usage)).transpose()
        };
        let buffers = [
            upload("positions", Some(cast_slice(&positions)))?,
            upload("normals", Some(cast_slice(&normals.unwrap_or_else(|| vec![[0.0; 3]; vertex_count]))))?,
            upload("colors", Some(cast_slice(&colors)))?,
            upload("tangents", tangents.as_deref().map(cast_slice))?,
            upload("texture coordinates", uv[0].as_deref().map(cast_slice))?,
            upload("second texture coordinates", uv[1].as_deref().map(cast_slice))?,
        ];
        Ok(Self {
            buffers,
            absent: gpu.buffer_of("absent attributes", &[0; 16], BufferUsages::VERTEX)?,
            has_colors,
            origin,
            radius: bounds.map_or(1.0, |b| b.diagonal() as f32 / 2.0),
            vertex_count,
        })
    }

    /// Replaces the colors of the first vertices, linear light as bytes; for example to visualize an error.
    ///
    /// # Panics
    /// If there are more colors than vertices.
    pub fn set_colors(&mut self, gpu: &Gpu, colors: &[[u8; 4]]) {
        assert!(colors.len() <= self.vertex_count, "more colors than vertices");
        let colors: Vec<_> = colors.iter().map(|c| halves(c.map(|byte| f32::from(byte) / 255.0))).collect();
        gpu.queue.write_buffer(self.buffer(2), 0, cast_slice(&colors));
        self.has_colors = true;
    }

    /// The buffer of an attribute; that of absent ones contains zeros for one vertex.
    pub(crate) fn buffer(&self, slot: usize) -> &Buffer {
        self.buffers[slot].as_ref().unwrap_or(&self.absent)
    }

    /// Whether each buffer has a value for each vertex.
    pub(crate) fn present(&self) -> [bool; BUFFER_COUNT] {
        self.buffers.each_ref().map(Option::is_some)
    }

    /// Distance of the near plane of a camera.
    pub(crate) fn near_plane(&self, camera: &Camera) -> f64 {
        camera.near_plane(to_f64(self.origin), f64::from(self.radius))
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

/// A color, linear light, as half floats.
fn halves(color: [f32; 4]) -> [u16; 4] {
    color.map(|x| f16::from_f32(x).to_bits())
}

/// Returns the first N components of a layer, and zeros up to `count`; none if the mesh has no such layer.
fn floats<const N: usize>(mesh: &IndexedMesh, semantic: &Semantic, count: usize) -> Option<Vec<[f32; N]>> {
    let layer = mesh.layer(semantic).filter(|layer| usize::from(layer.component_count) >= N)?;
    let of_mesh = (0..mesh.vertex_count()).map(|v| std::array::from_fn(|k| layer.get(v, k)));
    let mut all = Vec::with_capacity(count);
    all.extend(of_mesh);
    all.resize(count, [0.0; N]);
    Some(all)
}
