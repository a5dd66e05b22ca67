//! The trait that every way of drawing a level implements.

use striata_render::gpu::wgpu::CommandEncoder;
use striata_render::gpu::{Drawing, Gpu};

use striata_command::failure::Failure;

/// A way of drawing a level.
pub(in crate::bench_gpu) trait Way {
    /// Moves the model to a level: what the papers call recovery or extraction.
    fn move_to(&mut self, split_count: usize);

    /// Does all other CPU work that is needed before the level can be drawn: writes its indices and hands
    /// them over.
    ///
    /// # Errors
    /// If the GPU is out of memory.
    fn send(&mut self, gpu: &Gpu) -> Result<(), Failure>;

    /// Records the GPU work that precedes the draw.
    fn extract(&self, _: &mut CommandEncoder) {}

    /// The draw of the current level.
    fn drawing(&self) -> Drawing<'_>;

    /// Number of indices drawn, including restarts.
    fn index_count(&self) -> usize;

    /// Total bytes uploaded so far.
    fn uploaded_bytes(&self) -> u64;

    /// Bytes kept on the GPU, without the vertices.
    fn gpu_bytes(&self) -> usize;
}

/// Range of a whole index buffer, as one group.
pub(super) fn whole(index_count: usize) -> std::ops::Range<u32> {
    0..index_count as u32
}
