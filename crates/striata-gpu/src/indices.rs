//! Index buffers on the GPU: written whole, or only where they have changed.

use std::ops::Range;

use bytemuck::cast_slice;
use wgpu::{Buffer, BufferUsages};

use crate::copy_back::copy_back;
use crate::gpu::Gpu;
use crate::gpu_error::GpuError;

/// An index buffer of 32-bit indices that is written again and again.
///
/// It grows by half where it is too small, and never shrinks. Each write adds to [`uploaded_bytes`](Self::uploaded_bytes).
#[derive(Debug)]
pub struct GpuIndices {
    pub(crate) buffer: Buffer,
    capacity: usize,
    uploaded_bytes: u64,
}

impl GpuIndices {
    /// An index buffer with room for so many indices.
    ///
    /// # Errors
    /// [`GpuError::TooLarge`].
    pub fn new(gpu: &Gpu, capacity: usize) -> Result<Self, GpuError> {
        // Storage too: an inspection reads triangles from it, and compute shaders write it.
        let usage =
            BufferUsages::INDEX | BufferUsages::STORAGE | BufferUsages::COPY_DST | BufferUsages::COPY_SRC;
        let buffer = gpu.empty_buffer("indices", 4 * capacity as u64, usage)?;
        Ok(Self { buffer, capacity, uploaded_bytes: 0 })
    }

    /// An index buffer that holds these.
    ///
    /// # Errors
    /// [`GpuError::TooLarge`].
    pub fn upload(gpu: &Gpu, indices: &[u32]) -> Result<Self, GpuError> {
        let mut buffer = Self::new(gpu, indices.len())?;
        buffer.write(gpu, indices)?;
        Ok(buffer)
    }

    /// Writes all indices, from the first on.
    ///
    /// # Errors
    /// [`GpuError::TooLarge`] where it has to grow and cannot.
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

    /// Writes only some ranges of `indices`, each to its own place: those that have changed since the last write.
    ///
    /// # Panics
    /// If a range ends behind `indices`, or `indices` do not fit: [`write`](Self::write) them once before.
    pub fn write_ranges(&mut self, gpu: &Gpu, indices: &[u32], ranges: &[Range<u32>]) {
        assert!(indices.len() <= self.capacity, "{} indices, room for {}", indices.len(), self.capacity);
        for range in ranges.iter().filter(|r| !r.is_empty()) {
            let part = &indices[range.start as usize..range.end as usize];
            gpu.queue.write_buffer(&self.buffer, 4 * u64::from(range.start), cast_slice(part));
            self.uploaded_bytes += 4 * part.len() as u64;
        }
    }

    /// The indices on the GPU, as many as fit, waited for and copied back: to look at them, not to draw them.
    ///
    /// # Errors
    /// [`GpuError::Failed`], [`GpuError::TooLarge`].
    pub fn read(&self, gpu: &Gpu) -> Result<Vec<u32>, GpuError> {
        let mut indices = copy_back(gpu, &self.buffer)?;
        indices.truncate(self.capacity);
        Ok(indices)
    }

    /// Indices that fit.
    pub fn capacity(&self) -> usize {
        self.capacity
    }

    /// Bytes written so far.
    pub fn uploaded_bytes(&self) -> u64 {
        self.uploaded_bytes
    }

    /// The buffer.
    pub fn buffer(&self) -> &Buffer {
        &self.buffer
    }
}

/// Indexed draws that the GPU reads from a buffer: one for each strip, so that no restart index is needed.
#[derive(Debug)]
pub struct GpuMultiDraw {
    pub(crate) commands: Buffer,
    capacity: usize,
    command_count: u32,
    uploaded_bytes: u64,
}

/// Bytes of one indirect indexed draw.
pub(crate) const COMMAND_BYTES: u64 = 20;

impl GpuMultiDraw {
    /// Room for so many draws.
    ///
    /// # Errors
    /// [`GpuError::TooLarge`].
    pub fn new(gpu: &Gpu, capacity: usize) -> Result<Self, GpuError> {
        let usage = BufferUsages::INDIRECT | BufferUsages::STORAGE | BufferUsages::COPY_DST;
        let commands = gpu.empty_buffer("draws", COMMAND_BYTES * capacity as u64, usage)?;
        Ok(Self { commands, capacity, command_count: 0, uploaded_bytes: 0 })
    }

    /// Draws these ranges of an index buffer, each by a draw of its own; empty ones are left out.
    ///
    /// # Errors
    /// [`GpuError::TooLarge`] where it has to grow and cannot.
    pub fn write(&mut self, gpu: &Gpu, ranges: impl Iterator<Item = Range<u32>>) -> Result<(), GpuError> {
        // Index count, instance count, first index, base vertex, first instance.
        let commands: Vec<[u32; 5]> =
            ranges.filter(|r| !r.is_empty()).map(|r| [r.end - r.start, 1, r.start, 0, 0]).collect();
        if commands.len() > self.capacity {
            let uploaded_bytes = self.uploaded_bytes;
            *self = Self::new(gpu, commands.len() + commands.len() / 2)?;
            self.uploaded_bytes = uploaded_bytes;
        }
        self.command_count = commands.len() as u32;
        if !commands.is_empty() {
            gpu.queue.write_buffer(&self.commands, 0, cast_slice(&commands));
            self.uploaded_bytes += COMMAND_BYTES * commands.len() as u64;
        }
        Ok(())
    }

    /// Draws that are written.
    pub fn command_count(&self) -> u32 {
        self.command_count
    }

    /// Bytes written so far.
    pub fn uploaded_bytes(&self) -> u64 {
        self.uploaded_bytes
    }
}
