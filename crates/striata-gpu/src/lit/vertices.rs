//! Vertex buffers with all attributes that materials and poses need: uploaded once, used by every level.

use bytemuck::{Pod, Zeroable, cast_slice};
use striata::mesh::{AttributeLayer, IndexedMesh, LayerData, Semantic};
use wgpu::{BindGroup, Buffer, BufferUsages};

use crate::gpu::Gpu;
use crate::gpu_error::GpuError;
use crate::lit::morph_targets::MorphTargets;
use crate::lit::painter::LitPainter;

/// Number of vertex buffers: position, normal, tangent, two sets of texture coordinates, color, and two sets
/// of joints with their weights.
pub(crate) const BUFFER_COUNT: usize = 8;

/// Vertices of a mesh on the GPU, with the attributes that it has.
///
/// Positions are stored relative to the center of the bounds, so that a mesh far from zero keeps its shape in
/// 32 bits. Attributes that the mesh lacks take no memory. A position takes 12 bytes, a normal 12, a tangent
/// 16, a pair of texture coordinates 8, a color 16, a set of joints 24, a morph target 16 to 48.
#[derive(Debug)]
pub struct LitVertices {
    /// [`None`] for attributes that the mesh lacks.
    pub(crate) buffers: [Option<Buffer>; BUFFER_COUNT],
    /// Values of the attributes that the mesh lacks.
    pub(crate) absent: Buffer,
    pub(crate) morph_targets: MorphTargets,
    pub(crate) morph_bindings: BindGroup,
    pub(crate) origin: [f32; 3],
    vertex_count: usize,
}

/// A set of joints of a vertex with their weights.
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
#[repr(C)]
struct JointSet {
    joints: [u16; 4],
    weights: [f32; 4],
}

/// Offsets of the values for absent attributes in their buffer, bytes: zeros, then ones.
pub(crate) const ABSENT_ZEROS: u64 = 0;
pub(crate) const ABSENT_ONES: u64 = 32;

impl LitVertices {
    /// Uploads the vertices of a mesh.
    ///
    /// Layers that are used: normal, tangent, texture coordinates 0 and 1, color 0, joints and
    /// weights 0 and 1, and the displacements of morph targets. Without normals, the picture has flat ones.
    ///
    /// # Errors
    /// [`GpuError::Mesh`] if the mesh is inconsistent, [`GpuError::TooLarge`] if a buffer or the morph
    /// targets exceed the device's limit.
    pub fn upload(gpu: &Gpu, painter: &LitPainter, mesh: &IndexedMesh) -> Result<Self, GpuError> {
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
        let joints = [0, 1].map(|set| joint_sets(mesh, set));
        let buffers = [
            upload("positions", Some(cast_slice(&positions)))?,
            upload("normals", normals.as_deref().map(cast_slice))?,
            upload("tangents", tangents.as_deref().map(cast_slice))?,
            upload("texture coordinates", uv[0].as_deref().map(cast_slice))?,
            upload("second texture coordinates", uv[1].as_deref().map(cast_slice))?,
            upload("colors", mesh.linear_colors().as_deref().map(cast_slice))?,
            upload("joints", joints[0].as_deref().map(cast_slice))?,
            upload("second joints", joints[1].as_deref().map(cast_slice))?,
        ];
        let absent: [[f32; 4]; 3] = [[0.0; 4], [0.0; 4], [1.0; 4]];
        let morph_targets = MorphTargets::upload(gpu, mesh)?;
        Ok(Self {
            buffers,
            absent: gpu.buffer_of("absent attributes", cast_slice(&absent), BufferUsages::VERTEX)?,
            morph_bindings: painter.morph_bindings(gpu, &morph_targets),
            morph_targets,
            origin,
            vertex_count: mesh.vertex_count(),
        })
    }

    /// Number of vertices.
    pub fn vertex_count(&self) -> usize {
        self.vertex_count
    }

    /// Whether the vertices belong to joints.
    pub fn has_joints(&self) -> bool {
        self.buffers[6].is_some() || self.buffers[7].is_some()
    }

    /// Whether the vertices have normals.
    pub(crate) fn has_normals(&self) -> bool {
        self.buffers[1].is_some()
    }

    /// Whether the vertices have tangents.
    pub(crate) fn has_tangents(&self) -> bool {
        self.buffers[2].is_some()
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

fn joint_sets(mesh: &IndexedMesh, set: u8) -> Option<Vec<JointSet>> {
    let (joints, weights) = (mesh.layer(&Semantic::Joints(set))?, mesh.layer(&Semantic::Weights(set))?);
    let width = usize::from(joints.component_count.min(weights.component_count)).min(4);
    let joint_set = |vertex| {
        let mut of_vertex = JointSet { joints: [0; 4], weights: [0.0; 4] };
        for slot in 0..width {
            of_vertex.joints[slot] = joint(joints, vertex, slot);
            of_vertex.weights[slot] = weights.get(vertex, slot);
        }
        of_vertex
    };
    Some((0..mesh.vertex_count()).map(joint_set).collect())
}

/// Returns a joint of a vertex; joints beyond 16 bits do not exist, like the last one.
fn joint(layer: &AttributeLayer, vertex: usize, slot: usize) -> u16 {
    let at = vertex * usize::from(layer.component_count) + slot;
    match &layer.data {
        LayerData::U8(data) => u16::from(data[at]),
        LayerData::U16(data) => data[at],
        // The conversion saturates.
        data => data.number(at) as u16,
    }
}
