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

use std::ops::Range;

use bytemuck::cast_slice;
use striata::model::{FanIndices, FanInstance, Fans, LodModel};
use wgpu::{BindGroup, Buffer, BufferUsages};

use crate::canvas::copy_back;
use crate::drawing::Drawing;
use crate::fan_extractor::{Bindings, FanExtractor};
use crate::gpu::{Gpu, GpuError};
use crate::gpu_fan_words::FanWords;
use crate::indices::COMMAND_BYTES;

/// Changed words of bits with fewer unchanged ones between them are uploaded as one range: a write costs as much as so many.
const JOIN_GAP: usize = 4096;

/// The static half of the model on the GPU: the table of fans as words that all threads read side by side.
#[derive(Debug)]
pub struct GpuFans {
    pub(crate) fans: Buffer,
    pub(crate) words: Buffer,
    pub(crate) blocks: Buffer,
    pub(crate) group_blocks: Buffer,
    pub(crate) block_count: u32,
    pub(crate) group_count: u32,
    fan_count: usize,
    step_count: usize,
    vertex_count: usize,
    triangle_count: usize,
    bytes: usize,
}

/// What one instance owns on the GPU: its bits, its indices, its draws.
#[derive(Debug)]
pub struct GpuFanInstance {
    bits: Buffer,
    indices: Buffer,
    commands: Buffer,
    passes: [BindGroup; 3],
    /// The bits that the GPU has.
    known: Vec<u64>,
    block_count: u32,
    group_count: u32,
    bytes: usize,
    uploaded_bytes: u64,
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

impl GpuFanInstance {
    /// An instance that shows the full mesh, once it is [`extracted`](FanExtractor::extract).
    ///
    /// # Errors
    /// [`GpuError::TooLarge`].
    pub fn new(gpu: &Gpu, extractor: &FanExtractor, table: &GpuFans) -> Result<Self, GpuError> {
        let known = vec![0; table.step_count.div_ceil(64)];
        let capacity = 3 * table.triangle_count;
        let (storage, read) = (BufferUsages::STORAGE, BufferUsages::COPY_SRC);
        let words = |what, count: usize, usage| gpu.empty_buffer(what, 4 * count as u64, storage | usage);
        let bits = words("bits of steps", 2 * known.len(), BufferUsages::COPY_DST)?;
        let arcs = words("arcs of fans", table.fan_count, BufferUsages::empty())?;
        let sums = words("sums of blocks", table.block_count as usize + 1, BufferUsages::empty())?;
        let indices = words("indices of fans", capacity, BufferUsages::INDEX | read)?;
        let command_words = COMMAND_BYTES as usize / 4 * table.group_count.max(1) as usize;
        let commands = words("draws of fans", command_words, BufferUsages::INDIRECT | read)?;
        let own = Bindings { bits: &bits, arcs: &arcs, sums: &sums, indices: &indices, commands: &commands };
        let passes = extractor.bind(gpu, table, &own, capacity as u32)?;
        let buffers = [&bits, &arcs, &sums, &indices, &commands];
        let bytes = buffers.map(Buffer::size).iter().sum::<u64>() as usize;
        Ok(Self {
            passes,
            bits,
            indices,
            commands,
            known,
            block_count: table.block_count,
            group_count: table.group_count,
            bytes,
            uploaded_bytes: 0,
        })
    }

    /// Uploads which steps are taken, where that has changed.
    ///
    /// # Panics
    /// If the instance is of another table.
    pub fn write(&mut self, gpu: &Gpu, instance: &FanInstance) {
        let words = instance.words();
        assert_eq!(words.len(), self.known.len(), "the instance is of another table");
        for Range { start, end } in changed_ranges(&self.known, words) {
            let changed = &words[start..end];
            gpu.queue.write_buffer(&self.bits, 8 * start as u64, cast_slice(changed));
            self.known[start..end].copy_from_slice(changed);
            self.uploaded_bytes += size_of_val(changed) as u64;
        }
    }

    /// What to draw, once it is extracted. Its groups are told to the shader only where the device lets indirect draws do
    /// that ([`Gpu::optional_features`]).
    pub fn drawing(&self) -> Drawing<'_> {
        Drawing::Extracted {
            indices: &self.indices,
            commands: &self.commands,
            command_count: self.group_count,
        }
    }

    /// Bytes of bits written so far.
    pub fn uploaded_bytes(&self) -> u64 {
        self.uploaded_bytes
    }

    /// Bytes that it owns on the GPU.
    pub fn bytes(&self) -> usize {
        self.bytes
    }

    /// What was extracted last, waited for and copied back: to look at it, not to draw it.
    ///
    /// # Errors
    /// [`GpuError::Failed`], [`GpuError::TooLarge`].
    pub fn read(&self, gpu: &Gpu) -> Result<FanIndices, GpuError> {
        let mut out = FanIndices::default();
        if self.block_count == 0 {
            out.group_ranges.resize(self.group_count as usize, 0..0);
            return Ok(out);
        }
        let commands: Vec<u32> = copy_back(gpu, &self.commands)?;
        let (commands, _) = commands.as_chunks::<5>();
        out.group_ranges = commands.iter().map(|&[count, _, first, ..]| first..first + count).collect();
        out.indices = copy_back(gpu, &self.indices)?;
        out.indices.truncate(out.group_ranges.last().map_or(0, |range| range.end as usize));
        Ok(out)
    }

    /// What the passes bind, and for how many blocks.
    pub(crate) fn passes(&self) -> (&[BindGroup; 3], u32) {
        (&self.passes, self.block_count)
    }
}

/// Where two lists of the same length differ, with small gaps filled.
fn changed_ranges(known: &[u64], words: &[u64]) -> Vec<Range<usize>> {
    let mut out: Vec<Range<usize>> = Vec::new();
    for (at, _) in known.iter().zip(words).enumerate().filter(|(_, (a, b))| a != b) {
        match out.last_mut() {
            Some(last) if at <= last.end + JOIN_GAP => last.end = at + 1,
            _ => out.push(at..at + 1),
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn near_changes_are_one_range_and_far_ones_are_not() {
        let known = vec![0u64; 10_000];
        let mut words = known.clone();
        assert!(changed_ranges(&known, &words).is_empty());
        for at in [0, 3, 3 + JOIN_GAP, 9999] {
            words[at] = 1;
        }
        assert_eq!(changed_ranges(&known, &words), [0..4 + JOIN_GAP, 9999..10_000]);
    }
}
