//! Places of strips in an index buffer: one region per group, and a range of it for each strip.
//!
//! A range is padded with restart indices, which draw nothing, and so are ranges that no strip has.

use std::collections::BTreeSet;
use std::ops::Range;

/// Free ranges shorter than this are not worth keeping apart.
const LEAST_FREE: u32 = 8;

/// Consecutive indices of the buffer, for one strip and the restart after it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct StripSlot {
    pub first: u32,
    pub capacity: u32,
    /// Length of the strip, without its restart.
    pub length: u32,
}

impl StripSlot {
    /// Number of indices that a strip needs, with its restart.
    pub(super) fn needed(length: u32) -> u32 {
        length + 1
    }

    /// Range of the strip, without its restart.
    pub(super) fn strip(self) -> Range<usize> {
        self.first as usize..(self.first + self.length) as usize
    }
}

/// Part of the buffer for the strips of one group.
#[derive(Clone, Debug, Default)]
pub(super) struct SlotRegion {
    pub first: u32,
    pub capacity: u32,
    /// Number of indices from `first` that are drawn.
    pub used: u32,
    /// Number of indices that the strips and their restarts need.
    pub live: u32,
    /// Ranges that no strip has: length, first index.
    free: BTreeSet<(u32, u32)>,
}

impl SlotRegion {
    /// Creates an empty region.
    pub(super) fn new(first: u32, capacity: u32) -> Self {
        Self { first, capacity, ..Self::default() }
    }

    /// Takes room for a strip of this length: the smallest free range that suffices, otherwise room after the
    /// used part. [`None`] if the region is full.
    pub(super) fn take(&mut self, length: u32) -> Option<StripSlot> {
        let needed = StripSlot::needed(length);
        if let Some(&(capacity, first)) = self.free.range((needed, 0)..).next() {
            self.free.remove(&(capacity, first));
            return Some(self.without_rest(StripSlot { first, capacity, length }));
        }
        if needed > self.capacity - self.used {
            return None;
        }
        let first = self.first + self.used;
        self.used += needed;
        Some(StripSlot { first, capacity: needed, length })
    }

    /// Gives back what a strip does not need of its range, if that is worth it.
    pub(super) fn without_rest(&mut self, slot: StripSlot) -> StripSlot {
        let needed = StripSlot::needed(slot.length);
        // Some room to grow, for strips change often.
        let kept = needed + needed / 4;
        if slot.capacity < kept + LEAST_FREE {
            return slot;
        }
        self.give_back(slot.first + kept, slot.capacity - kept);
        StripSlot { capacity: kept, ..slot }
    }

    /// Makes a range free; it must contain restart indices only.
    pub(super) fn give_back(&mut self, first: u32, capacity: u32) {
        if first + capacity == self.first + self.used {
            self.used -= capacity;
        } else {
            self.free.insert((capacity, first));
        }
    }

    /// Whether more than a quarter of the used part draws nothing.
    pub(super) fn is_sparse(&self) -> bool {
        self.used > self.live + self.live / 4 + 64
    }

    /// Makes the whole region unused.
    pub(super) fn clear(&mut self) {
        (self.used, self.live) = (0, 0);
        self.free.clear();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_smallest_free_range_is_used_first() {
        let mut region = SlotRegion::new(100, 60);
        let [a, b, c] = [20, 9, 12].map(|length| region.take(length).unwrap());
        assert_eq!((a.first, b.first, c.first, region.used), (100, 121, 131, 44));
        region.give_back(a.first, a.capacity);
        region.give_back(b.first, b.capacity);
        assert_eq!(region.take(8).map(|slot| slot.first), Some(b.first));
        let half = region.take(9).unwrap();
        assert_eq!((half.first, half.capacity), (a.first, 12), "the rest of a range stays free");
        assert_eq!(region.take(16), None);
        assert_eq!(region.take(7).map(|slot| slot.first), Some(a.first + 12));
        region.give_back(c.first, c.capacity);
        assert_eq!(region.used, 31, "what is free at the end is not drawn");
    }
}
