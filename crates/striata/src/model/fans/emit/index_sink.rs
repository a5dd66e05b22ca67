//! Writes triangle lists without a branch per triangle.

use super::super::quick_table::{FanRecord, QUICK_ARCS, RecordNumber};
use super::super::table::{FanView, MAX_ARCS};

/// Few fans have more active arcs.
const USUAL_ARCS: usize = 5;

/// Number of indices of a fan with as many triangles as possible.
const SLOTS: usize = 3 * QUICK_ARCS;

/// The arcs of each mask, from the first, four bits each; then their number.
const ARCS: [u32; 1 << QUICK_ARCS] = {
    let mut all = [0; 1 << QUICK_ARCS];
    let mut mask = 0;
    while mask < all.len() {
        let (mut arc, mut count) = (0, 0);
        while arc < QUICK_ARCS {
            if mask >> arc & 1 != 0 {
                all[mask] |= (arc as u32) << (4 * count);
                count += 1;
            }
            arc += 1;
        }
        all[mask] |= count << COUNT_BIT;
        mask += 1;
    }
    all
};

/// First bit of the number of arcs.
const COUNT_BIT: u32 = 4 * QUICK_ARCS as u32;

/// A buffer of indices that is written from some place on. What lies behind that is overwritten, so that reusing a
/// buffer does not clear it.
#[derive(Clone, Debug, Default)]
pub(in super::super) struct IndexSink {
    buffer: Vec<u32>,
    len: usize,
}

impl IndexSink {
    /// Continues behind the first `len` indices of a buffer.
    pub(in super::super) fn new(buffer: Vec<u32>, len: usize) -> Self {
        debug_assert!(len <= buffer.len());
        Self { buffer, len }
    }

    /// Returns the indices that have been written.
    pub(in super::super) fn into_indices(self) -> Vec<u32> {
        let Self { mut buffer, len } = self;
        buffer.truncate(len);
        buffer
    }

    /// Writes the triangles of a fan whose arcs are in a mask.
    #[inline(always)]
    pub(in super::super) fn push_record<N: RecordNumber>(
        &mut self,
        record: &FanRecord<N>,
        vertex: u32,
        mask: u32,
    ) {
        let ring = record.ring(vertex);
        let arcs = ARCS[mask as usize & 127];
        let slots = match self.buffer[self.len..].first_chunk_mut::<SLOTS>() {
            Some(slots) => slots,
            None => self.grow(),
        };
        let mut write = |k: usize| {
            let arc = (arcs >> (4 * k)) as usize & 7;
            slots[3 * k] = vertex;
            slots[3 * k + 1] = ring[arc];
            slots[3 * k + 2] = ring[arc + 1];
        };
        // Whatever lies behind the last triangle is overwritten by the next fan. Few fans have more than five.
        (0..USUAL_ARCS).for_each(&mut write);
        // Counted in advance, because the baseline of x86 has no instruction for it.
        let count = (arcs >> COUNT_BIT) as usize;
        if count > USUAL_ARCS {
            (USUAL_ARCS..QUICK_ARCS).for_each(write);
        }
        self.len += 3 * count;
    }

    /// Number of bytes owned.
    pub(in super::super) fn bytes(&self) -> usize {
        4 * self.buffer.capacity()
    }

    /// Number of indices that have been written.
    pub(in super::super) fn len(&self) -> usize {
        self.len
    }

    /// Returns the indices that have been written.
    pub(in super::super) fn indices(&self) -> &[u32] {
        &self.buffer[..self.len]
    }

    /// Starts again at the beginning.
    pub(in super::super) fn restart(&mut self) {
        self.len = 0;
    }

    /// Writes triangles of any fan.
    pub(in super::super) fn push(&mut self, fan: &FanView<'_>, mut mask: u32) {
        let mut ring = [0; MAX_ARCS + 1];
        fan.ring_into(&mut ring);
        while mask != 0 {
            let at = mask.trailing_zeros() as usize;
            mask &= mask - 1;
            let slots = match self.buffer[self.len..].first_chunk_mut::<3>() {
                Some(slots) => slots,
                None => self.grow().first_chunk_mut().expect("three indices of more"),
            };
            *slots = [fan.vertex, ring[at], ring[at + 1]];
            self.len += 3;
        }
    }

    /// Appends indices with another writer.
    #[inline]
    pub(in super::super) fn append(&mut self, write: impl FnOnce(&mut Vec<u32>)) {
        self.buffer.truncate(self.len);
        write(&mut self.buffer);
        self.len = self.buffer.len();
    }

    /// Makes room for the triangles of a fan.
    #[cold]
    fn grow(&mut self) -> &mut [u32; SLOTS] {
        self.buffer.resize(self.len + self.len / 4 + 64 * SLOTS, 0);
        self.buffer[self.len..].first_chunk_mut().expect("the buffer has grown")
    }
}
