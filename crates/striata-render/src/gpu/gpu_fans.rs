//! Progressive fans on the GPU: one shared table, and one bit per step for each instance.
//!
//! The table and an instance's bits determine what the instance shows, and the active triangles of each fan
//! can be found independently. So a frame uploads only the bits that have changed, and three small compute
//! passes build the index buffer and its draw commands; nothing is read back:
//!
//! ```text
//! bits --upload--> count:    active arcs of each fan, and their number in each block of 256 fans
//!                  allocate: prefix sum over the blocks; draw command of each group
//!                  write:    triangles, each to its own slot
//! ```
//!
//! Slots come from prefix sums over all fans, so every device produces the same indices in the same order
//! as [`FanInstance::indices_into`](striata::model::FanInstance::indices_into). No level has more triangles
//! than the full mesh, so a buffer of that size is enough.
//!
//! Cost: the table takes [`GpuFans::bytes_per_vertex`]. Besides its bits, an instance takes 4 bytes per fan
//! and the index buffer of the full mesh. A frame reads 16 bytes of every fan, and all words of the fans
//! that may be active.

use bytemuck::cast_slice;
use striata::model::{Fans, LodModel};
use wgpu::{Buffer, BufferUsages};

use crate::gpu::device::Gpu;
use crate::gpu::gpu_error::GpuError;
use crate::gpu::gpu_fan_words::FanWords;

/// Static half of the model on the GPU: the table of fans, packed so that threads read it coalesced.
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
    /// Uploads a table of fans.
    ///
    /// # Errors
    /// [`GpuError::TooLarge`] if a buffer exceeds the device's limit.
    pub fn upload(gpu: &Gpu, fans: &Fans) -> Result<Self, GpuError> {
        let mut table = FanWords::new(fans);
        let (fan_count, bytes) = (table.fans.len(), table.bytes());
        let (block_count, group_count) = (table.blocks.len() as u32, fans.group_count() as u32);
        // Bindings must not be empty.
        table.fans.resize(fan_count.max(1), [0; 4]);
        table.blocks.resize(table.blocks.len().max(1), [0; 2]);
        let storage = |what, data| gpu.buffer_of(what, data, BufferUsages::STORAGE);
        Ok(Self {
            fans: storage("fans", cast_slice(&table.fans))?,
            words: storage("fan words", cast_slice(&table.words))?,
            blocks: storage("fan blocks", cast_slice(&table.blocks))?,
            group_blocks: storage("fan groups", cast_slice(&table.group_blocks))?,
            block_count,
            group_count,
            fan_count,
            step_count: fans.step_count(),
            vertex_count: fans.vertex_count(),
            triangle_count: fans.draw_counts(&fans.new_state()).index_count / 3,
            bytes,
        })
    }

    /// Size of the table on the GPU, bytes.
    pub fn bytes(&self) -> usize {
        self.bytes
    }

    /// Size of the table divided by the vertex count of the full mesh, bytes.
    pub fn bytes_per_vertex(&self) -> f64 {
        self.bytes as f64 / self.vertex_count.max(1) as f64
    }
}
