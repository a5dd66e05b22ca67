//! Strips of one LodStrips instance on the GPU; each move uploads only what has changed.

use std::ops::Range;

use striata::model::{LodStrips, LodStripsState, StripBuffer};

use crate::drawing::Drawing;
use crate::gpu::Gpu;
use crate::gpu_error::GpuError;
use crate::indices::GpuIndices;

/// Changed ranges with fewer unchanged indices than this between them are uploaded as one, since a write
/// has a fixed cost of about this many indices: 4.2 µs on the CPU and 2.5 µs on the queue, compared with
/// 0.7 ns per index.
///
/// We also tried one staging buffer from which the queue copies each range. That costs 1.1 µs per range plus
/// 40 µs, which pays off for 8 or more widely spaced ranges; but with many ranges, uploading all indices is
/// as fast for most meshes.
const JOIN_GAP: u32 = 8192;

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
        let changed = joined(self.buffer.take_changed_ranges(), JOIN_GAP);
        self.indices.write_ranges(gpu, self.buffer.indices(), &changed);
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
