//! Static tables of all meshes of a crowd, one after the other in one set of buffers.

use bytemuck::{Pod, Zeroable, cast_slice};
use striata::model::{FanBoxes, Fans};
use striata::view::{BoxGrid, StepBox};
use wgpu::{Buffer, BufferUsages};

use crate::gpu::device::Gpu;
use crate::gpu::gpu_error::GpuError;
use crate::gpu::gpu_fan_words::FanWords;

/// A mesh of a crowd: its table of fans and the boxes of its steps.
#[derive(Clone, Copy, Debug)]
pub struct CrowdMesh<'a> {
    /// The table.
    pub fans: &'a Fans,
    /// The boxes of this table.
    pub boxes: &'a FanBoxes,
}

/// Place of a mesh in the tables, laid out as in `crowd.wgsl`.
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
#[repr(C)]
pub(crate) struct MeshPlace {
    pub first_step: u32,
    pub step_count: u32,
    pub first_range: u32,
    pub range_count: u32,
    pub first_block: u32,
    pub block_count: u32,
    pub base_vertex: u32,
    pub base_triangles: u32,
    whole: StepBox,
}

/// Tables of all meshes on the GPU.
#[derive(Debug)]
pub(crate) struct CrowdMeshes {
    pub fans: Buffer,
    pub words: Buffer,
    pub blocks: Buffer,
    pub boxes: Buffer,
    pub range_errors: Buffer,
    pub places_buffer: Buffer,
    pub places: Vec<MeshPlace>,
    pub grids: Vec<BoxGrid>,
    pub bytes: u64,
}

impl CrowdMeshes {
    /// Uploads the tables.
    ///
    /// # Errors
    /// [`GpuError::TooLarge`] if a buffer exceeds the device's limit.
    pub(crate) fn upload(gpu: &Gpu, meshes: &[CrowdMesh<'_>]) -> Result<Self, GpuError> {
        let mut all = FanWords::default();
        let (mut boxes, mut range_errors) = (Vec::new(), Vec::new());
        let (mut places, mut base_vertex) = (Vec::new(), 0);
        for mesh in meshes {
            let table = FanWords::new(mesh.fans);
            places.push(MeshPlace {
                first_step: boxes.len() as u32,
                step_count: mesh.boxes.boxes().len() as u32,
                first_range: range_errors.len() as u32,
                range_count: mesh.boxes.range_errors().len() as u32,
                first_block: all.blocks.len() as u32,
                block_count: table.blocks.len() as u32,
                base_vertex,
                base_triangles: mesh.fans.base_triangle_count() as u32,
                whole: mesh.boxes.whole(),
            });
            boxes.extend_from_slice(mesh.boxes.boxes());
            range_errors.extend_from_slice(mesh.boxes.range_errors());
            base_vertex += mesh.fans.vertex_count() as u32;
            all.append(table);
        }
        let bytes = all.bytes() + size_of_val(&boxes[..]) + size_of_val(&range_errors[..]);
        // Bindings must not be smaller than an element.
        let padded = |data: &[u8], least: usize| [data, &vec![0; least.saturating_sub(data.len())]].concat();
        let storage =
            |what, data: &[u8], least| gpu.buffer_of(what, &padded(data, least), BufferUsages::STORAGE);
        Ok(Self {
            fans: storage("crowd fans", cast_slice(&all.fans), 16)?,
            words: storage("crowd fan words", cast_slice(&all.words), 4)?,
            blocks: storage("crowd fan blocks", cast_slice(&all.blocks), 8)?,
            boxes: storage("crowd step boxes", cast_slice(&boxes), size_of::<StepBox>())?,
            range_errors: storage("crowd range errors", cast_slice(&range_errors), 4)?,
            places_buffer: storage("crowd meshes", cast_slice(&places), size_of::<MeshPlace>())?,
            grids: meshes.iter().map(|mesh| *mesh.boxes.grid()).collect(),
            bytes: (bytes + size_of_val(&places[..])) as u64,
            places,
        })
    }
}
