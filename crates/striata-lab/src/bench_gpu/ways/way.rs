//! What all ways to get a level onto the screen can do.

use striata_gpu::wgpu::CommandEncoder;
use striata_gpu::{Drawing, Gpu};

use striata_command::failure::Failure;

/// A way to get a level onto the screen.
pub(in crate::bench_gpu) trait Way {
    /// Does all that the processor does until the level can be drawn.
    ///
    /// # Errors
    /// Where the GPU has no room.
    fn move_to(&mut self, gpu: &Gpu, split_count: usize) -> Result<(), Failure>;

    /// Records what the GPU does before it draws.
    fn extract(&self, _: &mut CommandEncoder) {}

    /// What is drawn.
    fn drawing(&self) -> Drawing<'_>;

    /// Indices that are drawn, restarts among them.
    fn index_count(&self) -> usize;

    /// Bytes sent so far.
    fn uploaded_bytes(&self) -> u64;

    /// Bytes that it keeps on the GPU, without the vertices.
    fn gpu_bytes(&self) -> usize;
}

/// All of an index buffer as one group.
pub(super) fn whole(index_count: usize) -> std::ops::Range<u32> {
    0..index_count as u32
}
