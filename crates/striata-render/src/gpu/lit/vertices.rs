//! Vertex buffers with all attributes that materials need: uploaded once, used by every level.

use bytemuck::cast_slice;
use striata::mesh::{IndexedMesh, Semantic};
use wgpu::{Buffer, BufferUsages};

use crate::gpu::device::Gpu;
use crate::gpu::gpu_error::GpuError;

/// Number of vertex buffers: position, normal, tangent, two sets of texture coordinates, and color.
pub(crate) const BUFFER_COUNT: usize = 6;

/// Vertices of a mesh on the GPU, with the attributes that it has.
///
/// Positions are stored relative to the center of the bounds, so that a mesh far from zero keeps its shape in
/// 32 bits. Attributes that the mesh lacks take no memory. A position takes 12 bytes, a normal 12, a tangent
/// 16, a pair of texture coordinates 8, a color 16.
#[derive(Debug)]
pub struct LitVertices {
    /// [`None`] for attributes that the mesh lacks.
    pub(crate) buffers: [Option<Buffer>; BUFFER_COUNT],
    /// Values of the attributes that the mesh lacks.
    pub(crate) absent: Buffer,
    pub(crate) origin: [f32; 3],
}

/// Offsets of the values for absent attributes in their buffer, bytes: zeros, then ones.
pub(crate) const ABSENT_ZEROS: u64 = 0;
pub(crate) const ABSENT_ONES: u64 = 32;

impl LitVertices {
    /// Uploads the vertices of a mesh.
    ///
    /// Layers that are used: normal, tangent, texture coordinates 0 and 1, and color 0. Without normals, the picture has flat ones.
    ///
    /// # Errors
    /// [`GpuError::Mesh`] if the mesh is inconsistent, [`GpuError::TooLarge`] if a buffer exceeds the
    /// device's limit.
    pub fn upload(gpu: &Gpu, mesh: &IndexedMesh) -> Result<Self, GpuError> {
        mesh.check()?;
        let origin =
            mesh.bounds().map_or([0.0; 3], |b| std::array::from_fn(|k| b.min[k] / 2.0 + b.max[k] / 2.0));
        let positions: Vec<[f32; 3]> =
            mesh.positions.iter().map(|p| std::array::from_fn(|k| p[k] - origin[k])).collect();
        let normals = floats::<3>(mesh, &Semantic::Normal);
        // Tangents mean nothing without normals.
        let tangents = normals.as_ref().and_then(|_| floats::<4>(mesh, &Semantic::Tangent));
        let upload = |label, bytes: Option<&[u8]>| -> Result<Option<Buffer>, GpuError> {
            bytes.map(|bytes| gpu.buffer_of(label, bytes, BufferUsages::VERTEX)).transpose()
        };
        let uv = [0, 1].map(|set| floats::<2>(mesh, &Semantic::TexCoord(set)));
        let buffers = [
            upload("positions", Some(cast_slice(&positions)))?,
            upload("normals", normals.as_deref().map(cast_slice))?,
            upload("tangents", tangents.as_deref().map(cast_slice))?,
            upload("texture coordinates", uv[0].as_deref().map(cast_slice))?,
            upload("second texture coordinates", uv[1].as_deref().map(cast_slice))?,
            upload("colors", mesh.linear_colors().as_deref().map(cast_slice))?,
        ];
        let absent: [[f32; 4]; 3] = [[0.0; 4], [0.0; 4], [1.0; 4]];
        Ok(Self {
            buffers,
            absent: gpu.buffer_of("absent attributes", cast_slice(&absent), BufferUsages::VERTEX)?,
            origin,
        })
    }

    /// Whether the vertices have normals, and tangents.
    pub(crate) fn has_normals_and_tangents(&self) -> [bool; 2] {
        [self.buffers[1].is_some(), self.buffers[2].is_some()]
    }

    /// One bit per attribute that the mesh has.
    pub(crate) fn attributes(&self) -> u8 {
        (0..BUFFER_COUNT).filter(|&slot| self.buffers[slot].is_some()).map(|slot| 1 << slot).sum()
    }
}

/// Returns the first N components of a layer; none if the mesh has no such layer.
fn floats<const N: usize>(mesh: &IndexedMesh, semantic: &Semantic) -> Option<Vec<[f32; N]>> {
    let layer = mesh.layer(semantic).filter(|layer| usize::from(layer.component_count) >= N)?;
    Some((0..mesh.vertex_count()).map(|v| std::array::from_fn(|k| layer.get(v, k))).collect())
}
