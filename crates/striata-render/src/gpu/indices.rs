//! Index buffers and indirect draw buffers on the GPU, written whole or by changed ranges.

use std::ops::Range;

use bytemuck::cast_slice;
use wgpu::{Buffer, BufferUsages};

use crate::gpu::copy_back::copy_back;
use crate::gpu::device::Gpu;
use crate::gpu::gpu_error::GpuError;

/// Changed ranges with fewer unchanged indices than this between them are uploaded as one, since a write
/// has a fixed cost of about this many indices: 4.2 µs on the CPU and 2.5 µs on the queue, compared with
/// 0.7 ns per index.
///
/// We also tried one staging buffer from which the queue copies each range. That costs 1.1 µs per range plus
/// 40 µs, which pays off for 8 or more widely spaced ranges; but with many ranges, uploading all indices is
/// as fast for most meshes.
const JOIN_GAP: u32 = 8192;

/// Buffer of 32-bit indices that can be rewritten.
///
/// If a write does not fit, the buffer grows to 1.5 times the needed size; it never shrinks. Each write
/// adds to [`uploaded_bytes`](Self::uploaded_bytes).
#[derive(Debug)]
pub struct GpuIndices {
    pub(crate) buffer: Buffer,
    capacity: usize,
    uploaded_bytes: u64,
}

impl GpuIndices {
    /// Creates an empty buffer with room for `capacity` indices.
    ///
    /// # Errors
    /// [`GpuError::TooLarge`] if it exceeds the device's limit.
    pub fn new(gpu: &Gpu, capacity: usize) -> Result<Self, GpuError> {
        // Storage as well: an inspection reads triangles from it, and compute shaders write it.
        let read = BufferUsages::INDEX | BufferUsages::STORAGE | BufferUsages::INDIRECT;
        let usage = read | BufferUsages::COPY_DST | BufferUsages::COPY_SRC;
        let buffer = gpu.empty_buffer("indices", 4 * capacity as u64, usage)?;
        Ok(Self { buffer, capacity, uploaded_bytes: 0 })
    }

    /// Creates a buffer that contains `indices`.
    ///
    /// # Errors
    /// [`GpuError::TooLarge`] if it exceeds the device's limit.
    pub fn upload(gpu: &Gpu, indices: &[u32]) -> Result<Self, GpuError> {
        let mut buffer = Self::new(gpu, indices.len())?;
        buffer.write(gpu, indices)?;
        Ok(buffer)
    }

    /// Replaces the contents of the buffer.
    ///
    /// # Errors
    /// [`GpuError::TooLarge`] if it would have to grow beyond the device's limit.
    pub fn write(&mut self, gpu: &Gpu, indices: &[u32]) -> Result<(), GpuError> {
        if indices.len() > self.capacity {
            let uploaded_bytes = self.uploaded_bytes;
            *self = Self::new(gpu, indices.len() + indices.len() / 2)?;
            self.uploaded_bytes = uploaded_bytes;
        }
        if !indices.is_empty() {
            gpu.queue.write_buffer(&self.buffer, 0, cast_slice(indices));
            self.uploaded_bytes += 4 * indices.len() as u64;
        }
        Ok(())
    }

    /// Writes only the given ranges of `indices`, each to its position in the buffer: those changed since
    /// the last write.
    ///
    /// # Panics
    /// If a range ends past `indices`, or `indices` do not fit; call [`write`](Self::write) once before.
    pub fn write_ranges(&mut self, gpu: &Gpu, indices: &[u32], ranges: &[Range<u32>]) {
        assert!(
            indices.len() <= self.capacity,
            "{} indices do not fit into a buffer of {}",
            indices.len(),
            self.capacity
        );
        for range in ranges.iter().filter(|r| !r.is_empty()) {
            let part = &indices[range.start as usize..range.end as usize];
            gpu.queue.write_buffer(&self.buffer, 4 * u64::from(range.start), cast_slice(part));
            self.uploaded_bytes += 4 * part.len() as u64;
        }
    }

    /// Writes ascending ranges of `indices` like [`write_ranges`](Self::write_ranges), but together those that
    /// are close to each other, with the indices between them, since every write has a fixed cost.
    ///
    /// # Panics
    /// See [`write_ranges`](Self::write_ranges).
    pub fn write_changed(&mut self, gpu: &Gpu, indices: &[u32], ranges: Vec<Range<u32>>) {
        self.write_ranges(gpu, indices, &joined(ranges, JOIN_GAP));
    }

    /// Reads the buffer back up to its capacity, for inspection rather than drawing; waits for the GPU.
    ///
    /// # Errors
    /// [`GpuError::Failed`] if the device fails, [`GpuError::TooLarge`] if the copy exceeds the device's
    /// limit.
    pub fn read(&self, gpu: &Gpu) -> Result<Vec<u32>, GpuError> {
        let mut indices = copy_back(gpu, &self.buffer)?;
        indices.truncate(self.capacity);
        Ok(indices)
    }

    /// Number of indices that fit.
    pub fn capacity(&self) -> usize {
        self.capacity
    }

    /// Bytes uploaded so far.
    pub fn uploaded_bytes(&self) -> u64 {
        self.uploaded_bytes
    }

    /// The wgpu buffer.
    pub fn buffer(&self) -> &Buffer {
        &self.buffer
    }
}

/// Indirect indexed draws, one per strip, so that no restart index is needed.
#[derive(Debug)]
pub struct GpuMultiDraw {
    /// Index count, instance count, first index, base vertex and first instance of each draw.
    words: GpuIndices,
    command_count: u32,
}

/// Words of one indirect indexed draw command.
pub(crate) const COMMAND_WORDS: usize = 5;

impl GpuMultiDraw {
    /// Creates a buffer with room for `capacity` draws.
    ///
    /// # Errors
    /// [`GpuError::TooLarge`] if it exceeds the device's limit.
    pub fn new(gpu: &Gpu, capacity: usize) -> Result<Self, GpuError> {
        Ok(Self { words: GpuIndices::new(gpu, COMMAND_WORDS * capacity)?, command_count: 0 })
    }

    /// Writes one draw for each non-empty range of an index buffer.
    ///
    /// # Errors
    /// [`GpuError::TooLarge`] if it would have to grow beyond the device's limit.
    pub fn write(&mut self, gpu: &Gpu, ranges: impl Iterator<Item = Range<u32>>) -> Result<(), GpuError> {
        let commands: Vec<[u32; COMMAND_WORDS]> =
            ranges.filter(|r| !r.is_empty()).map(|r| [r.end - r.start, 1, r.start, 0, 0]).collect();
        self.command_count = commands.len() as u32;
        self.words.write(gpu, commands.as_flattened())
    }

    /// The buffer of the draws.
    pub(crate) fn commands(&self) -> &Buffer {
        &self.words.buffer
    }

    /// Number of draws written last.
    pub fn command_count(&self) -> u32 {
        self.command_count
    }

    /// Bytes uploaded so far.
    pub fn uploaded_bytes(&self) -> u64 {
        self.words.uploaded_bytes
    }
}

/// Merges ascending ranges whose gaps are at most `gap`.
fn joined(mut ranges: Vec<Range<u32>>, gap: u32) -> Vec<Range<u32>> {
    ranges.dedup_by(|range, before| {
        let is_near = range.start <= before.end.saturating_add(gap);
        if is_near {
            before.end = before.end.max(range.end);
        }
        is_near
    });
    ranges
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_ranges_with_small_gaps_are_joined() {
        assert_eq!(joined(vec![0..3, 5..6, 9..20, 24..25], 3), [0..20, 24..25]);
        assert_eq!(joined(vec![0..9, 2..4, 9..10, 15..16], 0), [0..10, 15..16]);
        assert!(joined(Vec::new(), 5).is_empty());
    }
}
