//! The hardware form: one index buffer with primitive restart that follows an instance.
//!
//! Each group owns a fixed region of the buffer, each strip a place in it, filled up with restart indices. A
//! strip that outgrows its place moves to the end of the used part; when that part is a quarter larger
//! than what it shows, or full, the region is packed afresh. So a move costs what it changes, amortised, and
//! each group draws one contiguous range. A GPU buffer of the same size never has to grow.

use crate::model::{StoredModel, StripModel};
use std::ops::Range;

use super::{LodStrips, LodStripsState};
use crate::strip::RESTART;

/// Changed ranges with fewer unchanged indices between them are uploaded as one.
const JOIN_GAP: u32 = 32;

/// An index buffer that follows one [`LodStripsState`].
#[derive(Clone, Debug)]
pub struct StripBuffer {
    indices: Vec<u32>,
    regions: Vec<Region>,
    places: Vec<Place>,
    changed: Vec<Range<u32>>,
    /// Strips to follow; kept so that a sync allocates nothing.
    strips: Vec<u32>,
}

#[derive(Clone, Copy, Debug)]
struct Region {
    first: u32,
    capacity: u32,
    /// Indices from `first` that are drawn.
    used: u32,
    /// Indices that the strips and their restarts need.
    live: u32,
    is_full: bool,
}

#[derive(Clone, Copy, Debug, Default)]
struct Place {
    first: u32,
    capacity: u32,
    /// Indices of the strip, the restart not counted.
    length: u32,
}

impl Place {
    fn needed(length: u32) -> u32 {
        if length == 0 { 0 } else { length + 1 }
    }
}

impl StripBuffer {
    /// A buffer that shows what the state shows. A state is followed by one buffer only: what changed
    /// since the last [`sync`](Self::sync) is noted once.
    ///
    /// # Panics
    /// If the state belongs to another model.
    pub fn new(model: &LodStrips<'_>, state: &mut LodStripsState) -> Self {
        let mut regions = Vec::with_capacity(model.group_count());
        let mut first = 0;
        for group in 0..model.group_count() {
            let strips = model.group_strips(group);
            let full = model.offsets[strips.end] - model.offsets[strips.start] + strips.len() as u32;
            let capacity = full + full / 4;
            regions.push(Region { first, capacity, used: 0, live: 0, is_full: false });
            first += capacity;
        }
        let mut buffer = Self {
            indices: vec![RESTART; first as usize],
            regions,
            places: vec![Place::default(); model.strip_count()],
            changed: Vec::new(),
            strips: Vec::new(),
        };
        state.take_changed_into(&mut buffer.strips);
        for group in 0..model.group_count() {
            buffer.pack(model, state, group);
        }
        buffer
    }

    /// All regions; [`group_ranges`](Self::group_ranges) says what to draw of it. Its length never changes.
    pub fn indices(&self) -> &[u32] {
        &self.indices
    }

    /// For each group (material) the range to draw as strips with primitive restart.
    pub fn group_ranges(&self) -> impl Iterator<Item = Range<u32>> {
        self.regions.iter().map(|r| r.first..r.first + r.used)
    }

    /// Where each strip stands, for multi-draw calls without restart; empty for a strip that is gone.
    pub fn strip_ranges(&self) -> impl Iterator<Item = Range<u32>> {
        self.places.iter().map(|p| p.first..p.first + p.length)
    }

    /// Follows the state; returns how many indices were written.
    ///
    /// # Panics
    /// If the state belongs to another model than the buffer.
    pub fn sync(&mut self, model: &LodStrips<'_>, state: &mut LodStripsState) -> usize {
        assert_eq!(self.places.len(), state.strips.len(), "the state belongs to another model");
        let mut strips = std::mem::take(&mut self.strips);
        state.take_changed_into(&mut strips);
        strips.sort_unstable();
        let mut written = 0;
        let mut group = 0;
        for &strip in &strips {
            while model.group_offsets[group + 1] <= strip {
                group += 1;
            }
            if !self.regions[group].is_full {
                written += self.write_strip(group, strip as usize, model.strip(state, strip as usize));
            }
        }
        self.strips = strips;
        for group in 0..self.regions.len() {
            let region = self.regions[group];
            if region.is_full || region.used > region.live + region.live / 4 + 64 {
                written += self.pack(model, state, group);
            }
        }
        written
    }

    /// What changed in [`indices`](Self::indices) since the last call, sorted and apart: upload just that.
    pub fn take_changed_ranges(&mut self) -> Vec<Range<u32>> {
        self.changed.sort_unstable_by_key(|r| r.start);
        let mut out: Vec<Range<u32>> = Vec::new();
        for range in self.changed.drain(..) {
            match out.last_mut() {
                Some(last) if range.start <= last.end.saturating_add(JOIN_GAP) => {
                    last.end = last.end.max(range.end);
                }
                _ => out.push(range),
            }
        }
        out
    }

    /// Writes one strip in its place, or at the end of the region; marks the region where neither fits.
    fn write_strip(&mut self, group: usize, strip: usize, live: &[u32]) -> usize {
        let region = &mut self.regions[group];
        let place = self.places[strip];
        let needed = Place::needed(live.len() as u32);
        let mut target = place;
        let moves = needed > place.capacity;
        if moves {
            let capacity = needed + needed / 4 + 1;
            if region.used + capacity > region.capacity {
                region.is_full = true;
                return 0;
            }
            target = Place { first: region.first + region.used, capacity, length: 0 };
            region.used += capacity;
            self.fill(place.first, 0, place.length);
        }
        let region = &mut self.regions[group];
        region.live = region.live + needed - Place::needed(place.length);
        let first = target.first as usize;
        self.indices[first..first + live.len()].copy_from_slice(live);
        self.places[strip] = Place { length: live.len() as u32, ..target };
        // A place at the region's end may hold what the last packing left there.
        let stale = if moves { target.capacity } else { place.length };
        self.fill(target.first, live.len() as u32, stale);
        live.len()
    }

    /// Notes a place as changed and overwrites what of it is no longer shown.
    fn fill(&mut self, first: u32, from: u32, to: u32) {
        if from < to {
            self.indices[(first + from) as usize..(first + to) as usize].fill(RESTART);
        }
        if to.max(from) > 0 {
            self.changed.push(first..first + to.max(from));
        }
    }

    /// Writes all strips of a region one after the other.
    fn pack(&mut self, model: &LodStrips<'_>, state: &LodStripsState, group: usize) -> usize {
        let region = self.regions[group];
        let mut at = region.first;
        for strip in model.group_strips(group) {
            let live = model.strip(state, strip);
            let (length, needed) = (live.len() as u32, Place::needed(live.len() as u32));
            self.places[strip] = Place { first: at, capacity: needed, length };
            if length > 0 {
                self.indices[at as usize..at as usize + live.len()].copy_from_slice(live);
                self.indices[at as usize + live.len()] = RESTART;
            }
            at += needed;
        }
        let used = at - region.first;
        self.regions[group] = Region { used, live: used, is_full: false, ..region };
        // Earlier changes in this region are covered, or lie behind what is drawn.
        self.changed.retain(|r| r.start < region.first || r.start >= region.first + region.capacity);
        if used > 0 {
            self.changed.push(region.first..at);
        }
        used as usize
    }
}
