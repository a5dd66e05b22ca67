//! Progressive fans on the GPU: the table once, and a bit a step for each instance.
//!
//! What an instance shows is told by the table and its bits alone, and each fan can say by itself which of its triangles are
//! there. So a frame sends the bits that have changed, three small shaders make an index buffer and the draws of it, and
//! nothing comes back:
//!
//! ```text
//! bits --write--> count: arcs that are there, and how many in each block of 256 fans
//!                 place: what comes before each block; the draw of each group
//!                 write: triangles, each to its own place
//! ```
//!
//! Places come from sums over all fans before, so the indices are those of
//! [`FanInstance::indices_into`](striata::model::FanInstance::indices_into), in its order, on every device. No level has more
//! triangles than the full mesh: a buffer for that many is enough.
//!
//! Cost: table as [`GpuFans::bytes_per_vertex`] says; an instance takes 4 bytes a fan and the index buffer of the full mesh beside its
//! bits; a frame reads 16 bytes of every fan, and of those that are there all they have.

use bytemuck::cast_slice;
use striata::model::{Fans, LodModel};
use wgpu::{Buffer, BufferUsages};

use crate::gpu::Gpu;
use crate::gpu_error::GpuError;
use crate::gpu_fan_words::FanWords;

/// The static half of the model on the GPU: the table of fans as words that all threads read side by side.
#[derive(Debug)]
pub struct GpuFans {
    pub(crate) fans: Buffer,
    pub(crate) words: Buffer,
    pub(crate) blocks: Buffer,
    pub(crate) group_blocks: Buffer,
    pub(crate) block_count: u32,
    pub(crate) group_count: u32,
    pub(crate) fan_count: usize,
    pub(crate) step_count: usize,
    vertex_count: usize,
    pub(crate) triangle_count: usize,
    bytes: usize,
}

impl GpuFans {
    /// Uploads a table.
    ///
    /// # Errors
    /// [`GpuError::TooLarge`].
    pub fn upload(gpu: &Gpu, fans: &Fans) -> Result<Self, GpuError> {
        let mut table = FanWords::new(fans);
        let (fan_count, bytes) = (table.fans.len(), table.bytes());
        let (block_count, group_count) = (table.blocks.len() as u32, fans.group_count() as u32);
        // A binding is never empty.
        table.fans.resize(fan_count.max(1), [0; 4]);
        table.blocks.resize(table.blocks.len().max(1), [0; 2]);
        let storage = |what, data| gpu.buffer_of(what, data, BufferUsages::STORAGE);
        Ok(Self {
            fans: storage("fans", cast_slice(&table.fans))?,
            words: storage("words of fans", cast_slice(&table.words))?,
            blocks: storage("blocks of fans", cast_slice(&table.blocks))?,
            group_blocks: storage("groups of fans", cast_slice(&table.group_blocks))?,
            block_count,
            group_count,
            fan_count,
            step_count: fans.step_count(),
            vertex_count: fans.vertex_count(),
            triangle_count: fans.draw_counts(&fans.new_state()).index_count / 3,
            bytes,
        })
    }

    /// Bytes of the table on the GPU.
    pub fn bytes(&self) -> usize {
        self.bytes
    }

    /// The same for each vertex of the full mesh.
    pub fn bytes_per_vertex(&self) -> f64 {
        self.bytes as f64 / self.vertex_count.max(1) as f64
    }
}
