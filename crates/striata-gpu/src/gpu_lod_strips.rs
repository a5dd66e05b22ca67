//! The strips of one instance of LodStrips on the GPU, of which only what changes is sent.

use std::ops::Range;

use striata::model::{LodStrips, LodStripsState, StripBuffer};

use crate::drawing::Drawing;
use crate::gpu::Gpu;
use crate::gpu_error::GpuError;
use crate::indices::GpuIndices;

/// Changed ranges with fewer unchanged indices between them are sent as one: a write costs as much as so many indices, 4.2
/// µs of the processor and 2.5 of the queue beside 0.7 ns an index.
///
/// Tried: all ranges in one buffer, from which the queue copies each. That is 1.1 µs a range and 40 µs once, which pays from 8 ranges
/// that are far apart on, and where many are, all the indices of most meshes are sent as quickly.
const JOIN_GAP: u32 = 8192;

/// An index buffer on the GPU that follows one [`LodStripsState`].
///
/// A move to another level changes a few indices in each of many strips. Ranges of them that lie near each other are sent
/// together with what is between, since each write has a cost of its own.
#[derive(Debug)]
pub struct GpuLodStrips {
    buffer: StripBuffer,
    indices: GpuIndices,
    groups: Vec<Range<u32>>,
}

impl GpuLodStrips {
    /// A buffer that shows what the state shows, uploaded whole. A state is followed by one buffer only.
    ///
    /// # Panics
    /// If the state belongs to another model.
    ///
    /// # Errors
    /// [`GpuError::TooLarge`].
    pub fn new(gpu: &Gpu, model: &LodStrips<'_>, state: &mut LodStripsState) -> Result<Self, GpuError> {
        let mut buffer = StripBuffer::new(model, state);
        buffer.take_changed_ranges();
        let indices = GpuIndices::upload(gpu, buffer.indices())?;
        let groups = buffer.group_ranges().collect();
        Ok(Self { buffer, indices, groups })
    }

    /// Follows the state: sends what has changed since the last time.
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

    /// What to draw.
    pub fn drawing(&self) -> Drawing<'_> {
        Drawing::Strips { indices: &self.indices, groups: &self.groups }
    }

    /// The indices on the GPU.
    pub fn indices(&self) -> &GpuIndices {
        &self.indices
    }

    /// The same indices on the processor.
    pub fn buffer(&self) -> &StripBuffer {
        &self.buffer
    }

    /// Bytes sent so far, those of the first upload among them.
    pub fn uploaded_bytes(&self) -> u64 {
        self.indices.uploaded_bytes()
    }
}

/// Rising ranges, those with small gaps between them as one.
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
    fn ranges_join_over_small_gaps_only() {
        assert_eq!(joined(vec![0..3, 5..6, 9..20, 24..25], 3), [0..20, 24..25]);
        assert_eq!(joined(vec![0..9, 2..4, 9..10, 15..16], 0), [0..10, 15..16]);
        assert!(joined(Vec::new(), 5).is_empty());
    }
}
