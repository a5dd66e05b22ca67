//! An index buffer with primitive restart that follows an instance, ready for upload to a GPU.
//!
//! Each group owns a fixed region of the buffer, and each strip an allocation inside it, padded with
//! restart indices. A strip that outgrows its allocation is moved to the end of the used part of the region.
//! When the used part has become a quarter larger than the live indices, or the region is full, the region
//! is repacked. The amortized cost of a move is therefore proportional to what changes, each group is
//! drawn as one contiguous range, and the GPU buffer never has to grow. When the instance enters another
//! stage, all regions are repacked with its strips.

use std::ops::Range;

use super::stage::Stage;
use super::{LodStrips, LodStripsState};
use crate::model::StoredModel;
use crate::strip::RESTART;

/// Changed ranges with fewer than this many unchanged indices between them are merged.
const JOIN_GAP: u32 = 32;

/// An index buffer that follows one [`LodStripsState`].
#[derive(Clone, Debug)]
pub struct StripBuffer {
    indices: Vec<u32>,
    regions: Vec<GroupRegion>,
    allocations: Vec<Allocation>,
    changed: Vec<Range<u32>>,
    /// Scratch for the strips to write, kept so that `sync` does not allocate.
    strips: Vec<u32>,
}

#[derive(Clone, Copy, Debug)]
struct GroupRegion {
    first: u32,
    capacity: u32,
    /// Number of indices from `first` that are drawn.
    used: u32,
    /// Number of indices that the strips and their restarts need.
    live: u32,
    is_full: bool,
}

#[derive(Clone, Copy, Debug, Default)]
struct Allocation {
    first: u32,
    capacity: u32,
    /// Length of the strip, without its restart.
    length: u32,
}

impl Allocation {
    fn needed(length: u32) -> u32 {
        if length == 0 { 0 } else { length + 1 }
    }
}

impl StripBuffer {
    /// Creates a buffer with the current strips of a state. Only one buffer can follow a state, because
    /// the state reports each change once, to the next [`sync`](Self::sync).
    ///
    /// # Panics
    /// If the state belongs to a different model.
    pub fn new(model: &LodStrips<'_>, state: &mut LodStripsState) -> Self {
        let mut regions = Vec::with_capacity(model.group_count());
        let mut first = 0;
        for group in 0..model.group_count() {
            let of_stage = |stage: &Stage<'_>| {
                let (strips, firsts) = (stage.strips.group_strips(group), stage.strips.firsts());
                firsts[strips.end] - firsts[strips.start] + strips.len() as u32
            };
            let most = model.stages.iter().map(of_stage).max().unwrap_or(0);
            let capacity = most + most / 4;
            regions.push(GroupRegion { first, capacity, used: 0, live: 0, is_full: false });
            first += capacity;
        }
        let most_strips = model.stages.iter().map(|stage| stage.strips.strip_count()).max().unwrap_or(0);
        let mut buffer = Self {
            indices: vec![RESTART; first as usize],
            regions,
            allocations: vec![Allocation::default(); most_strips],
            changed: Vec::new(),
            strips: Vec::new(),
        };
        state.take_changed_into(model, &mut buffer.strips);
        buffer.pack_all(model, state);
        buffer
    }

    /// Returns the whole buffer, whose length never changes. Draw the [`group_ranges`](Self::group_ranges)
    /// of it.
    pub fn indices(&self) -> &[u32] {
        &self.indices
    }

    /// Returns for each group (material) the range to draw as strips with primitive restart.
    pub fn group_ranges(&self) -> impl Iterator<Item = Range<u32>> {
        self.regions.iter().map(|r| r.first..r.first + r.used)
    }

    /// Returns the range of each strip, for multi-draw calls without primitive restart; empty for an empty
    /// strip. Their number is that of the stage with the most strips.
    pub fn strip_ranges(&self) -> impl Iterator<Item = Range<u32>> {
        self.allocations.iter().map(|p| p.first..p.first + p.length)
    }

    /// Updates the buffer to the state; returns the number of indices written.
    ///
    /// # Panics
    /// If the state belongs to a different model than the buffer.
    pub fn sync(&mut self, model: &LodStrips<'_>, state: &mut LodStripsState) -> usize {
        let stage = model.stages.get(state.stage());
        assert!(
            stage.is_some_and(|stage| stage.strips.strip_count() <= self.allocations.len()),
            "the state belongs to a different model"
        );
        let mut strips = std::mem::take(&mut self.strips);
        let is_new_stage = state.take_changed_into(model, &mut strips);
        let written = match stage {
            Some(stage) if !is_new_stage => self.write_strips(stage, state, &strips),
            _ => self.pack_all(model, state),
        };
        self.strips = strips;
        written
    }

    /// Writes strips of the stage that the buffer already shows, in ascending order.
    fn write_strips(&mut self, stage: &Stage<'_>, state: &LodStripsState, strips: &[u32]) -> usize {
        let mut written = 0;
        let mut group = 0;
        for &strip in strips {
            while stage.strips.group_offsets[group + 1] <= strip {
                group += 1;
            }
            if !self.regions[group].is_full {
                written += self.write_strip(group, strip as usize, state.live(stage, strip as usize));
            }
        }
        for group in 0..self.regions.len() {
            let region = self.regions[group];
            if region.is_full || region.used > region.live + region.live / 4 + 64 {
                written += self.pack(stage, state, group);
            }
        }
        written
    }

    /// Writes all strips of the state's stage, one after the other.
    fn pack_all(&mut self, model: &LodStrips<'_>, state: &LodStripsState) -> usize {
        self.allocations.fill(Allocation::default());
        let stage = &model.stages[state.stage()];
        (0..self.regions.len()).map(|group| self.pack(stage, state, group)).sum()
    }

    /// Returns the ranges of [`indices`](Self::indices) that changed since the last call, sorted and
    /// disjoint, for a partial upload.
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

    /// Writes one strip into its allocation or, if that is too small, at the end of the region. Marks the
    /// region as full if neither has room. Returns the number of indices written.
    fn write_strip(&mut self, group: usize, strip: usize, live: &[u32]) -> usize {
        let region = &mut self.regions[group];
        let allocation = self.allocations[strip];
        let needed = Allocation::needed(live.len() as u32);
        let mut target = allocation;
        let is_moved = needed > allocation.capacity;
        if is_moved {
            let capacity = needed + needed / 4 + 1;
            if region.used + capacity > region.capacity {
                region.is_full = true;
                return 0;
            }
            target = Allocation { first: region.first + region.used, capacity, length: 0 };
            region.used += capacity;
            self.fill(allocation.first, 0, allocation.length);
        }
        let region = &mut self.regions[group];
        region.live = region.live + needed - Allocation::needed(allocation.length);
        let first = target.first as usize;
        self.indices[first..first + live.len()].copy_from_slice(live);
        self.allocations[strip] = Allocation { length: live.len() as u32, ..target };
        // An allocation at the end of the region may contain stale indices from before the last repack.
        let stale = if is_moved { target.capacity } else { allocation.length };
        self.fill(target.first, live.len() as u32, stale);
        live.len()
    }

    /// Marks the start of an allocation as changed and overwrites its indices `from..to` with restarts.
    fn fill(&mut self, first: u32, from: u32, to: u32) {
        if from < to {
            self.indices[(first + from) as usize..(first + to) as usize].fill(RESTART);
        }
        if to.max(from) > 0 {
            self.changed.push(first..first + to.max(from));
        }
    }

    /// Writes all strips of a region one after the other.
    fn pack(&mut self, stage: &Stage<'_>, state: &LodStripsState, group: usize) -> usize {
        let region = self.regions[group];
        let mut at = region.first;
        for strip in stage.strips.group_strips(group) {
            let live = state.live(stage, strip);
            let (length, needed) = (live.len() as u32, Allocation::needed(live.len() as u32));
            self.allocations[strip] = Allocation { first: at, capacity: needed, length };
            if length > 0 {
                self.indices[at as usize..at as usize + live.len()].copy_from_slice(live);
                self.indices[at as usize + live.len()] = RESTART;
            }
            at += needed;
        }
        let used = at - region.first;
        self.regions[group] = GroupRegion { used, live: used, is_full: false, ..region };
        // Earlier changes in this region are covered by the new range, or lie behind the part that is drawn.
        self.changed.retain(|r| r.start < region.first || r.start >= region.first + region.capacity);
        if used > 0 {
            self.changed.push(region.first..at);
        }
        used as usize
    }
}
