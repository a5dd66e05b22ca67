//! Strips of one LodStrips instance on the GPU; each move uploads only what has changed.

use std::ops::Range;

use striata::model::{LodStrips, LodStripsState, StripBuffer};

use crate::gpu::device::Gpu;
use crate::gpu::drawing::Drawing;
use crate::gpu::gpu_error::GpuError;
use crate::gpu::indices::GpuIndices;

/// Index buffer on the GPU that follows one [`LodStripsState`].
///
/// A move to another level changes a few indices in each of many strips. Ranges that are close to each
/// other are uploaded together with the indices between them, since every write has a fixed cost.
#[derive(Debug)]
pub struct GpuLodStrips {
    buffer: StripBuffer,
    indices: GpuIndices,
    groups: Vec<Range<u32>>,
}

impl GpuLodStrips {
    /// Uploads the whole strip buffer of a state. A state can be followed by one buffer only.
    ///
    /// # Panics
    /// If the state belongs to another model.
    ///
    /// # Errors
    /// [`GpuError::TooLarge`] if the buffer exceeds the device's limit.
    pub fn new(gpu: &Gpu, model: &LodStrips<'_>, state: &mut LodStripsState) -> Result<Self, GpuError> {
        let mut buffer = StripBuffer::new(model, state);
        buffer.take_changed_ranges();
        let indices = GpuIndices::upload(gpu, buffer.indices())?;
        let groups = buffer.group_ranges().collect();
        Ok(Self { buffer, indices, groups })
    }

    /// Uploads what has changed in the state since the last call.
    ///
    /// # Panics
    /// If the state belongs to another model.
    pub fn follow(&mut self, gpu: &Gpu, model: &LodStrips<'_>, state: &mut LodStripsState) {
        self.buffer.sync(model, state);
        let changed = self.buffer.take_changed_ranges();
        self.indices.write_changed(gpu, self.buffer.indices(), changed);
        self.groups.clear();
        self.groups.extend(self.buffer.group_ranges());
    }

    /// Draw call for the strips.
    pub fn drawing(&self) -> Drawing<'_> {
        Drawing::Strips { indices: &self.indices, groups: &self.groups }
    }

    /// The index buffer on the GPU.
    pub fn indices(&self) -> &GpuIndices {
        &self.indices
    }

    /// The strip buffer on the CPU, with equal contents.
    pub fn buffer(&self) -> &StripBuffer {
        &self.buffer
    }

    /// Bytes uploaded so far, including the first upload.
    pub fn uploaded_bytes(&self) -> u64 {
        self.indices.uploaded_bytes()
    }
}
