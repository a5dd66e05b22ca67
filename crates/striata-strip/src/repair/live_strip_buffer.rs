//! Index buffer with primitive restart that follows live strips, and the ranges of it that have changed.
//!
//! Each strip has a range of the buffer. After a move, only strips with a changed triangle or link are written
//! again: into the range of a strip that they replace if they fit there, so that their first indices stay, then
//! into a free range, then after the used part. Ranges that no strip has any more are filled with restarts.
//! When a quarter of the used part draws nothing, the strips of a group are moved together, and when its
//! region is full, the whole buffer is laid out again with more room.
//!
//! Cost: proportional to the indices of the strips that changed; 4 bytes per triangle and 16 per strip besides
//! the buffer itself.

use std::ops::Range;

use striata::mesh::NO_TWIN;
use striata::strip::{RESTART, StripLinks, StripPath};

use super::live_strips::LiveStrips;
use super::slots::{SlotRegion, StripSlot};

/// Changed ranges with fewer than this many unchanged indices between them are merged.
const JOIN_GAP: u32 = 32;
/// Number of changed ranges from which they are merged, even if nobody asks for them.
const MANY_RANGES: usize = 1 << 16;

/// Index buffer of the strips of one [`LiveStrips`], drawn with primitive restart.
///
/// ```
/// use striata::{mesh::shapes, simplify::build_sequence};
/// use striata_strip::{LiveStripBuffer, LiveStrips, RepairOptions};
///
/// let refinable = build_sequence(&shapes::torus(32, 16, 1.0, 0.4), &Default::default())?.refinable;
/// let (full, strips) = (refinable.sequence.step_count(), striata::strip::stripify(&refinable.mesh)?);
/// let mut live = LiveStrips::new(&refinable, full, &strips, &RepairOptions::default())?;
/// let mut buffer = LiveStripBuffer::new(&mut live);
/// let mut on_gpu = buffer.indices().to_vec();
/// live.move_to(full - 20);
/// buffer.sync(&mut live);
/// on_gpu.resize(buffer.indices().len(), 0);
/// for range in buffer.take_changed_ranges() {
///     let range = range.start as usize..range.end as usize;
///     on_gpu[range.clone()].copy_from_slice(&buffer.indices()[range]);
/// }
/// assert_eq!(on_gpu, buffer.indices());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct LiveStripBuffer {
    indices: Vec<u32>,
    regions: Vec<SlotRegion>,
    /// Strips by id; the slots of unused ids have no capacity.
    strips: Vec<Strip>,
    unused_ids: Vec<u32>,
    /// Id of the strip of each triangle of the full mesh, or [`NO_TWIN`].
    strip_of: Vec<u32>,
    changed: Vec<Range<u32>>,
    scratch: BufferScratch,
}

#[derive(Clone, Copy, Debug, Default)]
struct Strip {
    slot: StripSlot,
    group: u32,
    /// Whether a triangle or link of the strip has changed since it was written.
    is_stale: bool,
}

/// Lists that are reused between calls.
#[derive(Clone, Debug, Default)]
struct BufferScratch {
    triangles: Vec<u32>,
    stale: Vec<u32>,
    path: StripPath,
    written: Vec<u32>,
    reversed: Vec<u32>,
}

impl LiveStripBuffer {
    /// Creates a buffer with the current strips.
    ///
    /// Only one buffer can follow live strips, because they report each change once, to the next
    /// [`sync`](Self::sync).
    pub fn new(live: &mut LiveStrips<'_>) -> Self {
        let count = live.graph.all_corners().len();
        live.changes.watch(count);
        let mut buffer = Self {
            indices: Vec::new(),
            regions: vec![SlotRegion::default(); live.graph.group_ends().len()],
            strips: Vec::new(),
            unused_ids: Vec::new(),
            strip_of: vec![NO_TWIN; count],
            changed: Vec::new(),
            scratch: BufferScratch::default(),
        };
        let links = StripLinks::from_bits(live.graph.twins(), std::mem::take(&mut live.solid));
        buffer.lay_out(live, &links);
        live.solid = links.into_bits();
        buffer
    }

    /// Returns the whole buffer. Draw its [`group_ranges`](Self::group_ranges).
    ///
    /// Its length changes only when it has to grow; [`take_changed_ranges`](Self::take_changed_ranges) then
    /// returns one range that covers it all.
    pub fn indices(&self) -> &[u32] {
        &self.indices
    }

    /// Returns for each group (material) the range to draw as strips with primitive restart.
    pub fn group_ranges(&self) -> impl Iterator<Item = Range<u32>> {
        self.regions.iter().map(|region| region.first..region.first + region.used)
    }

    /// Returns the range of each strip, in no particular order, for multi-draw calls without primitive
    /// restart.
    pub fn strip_ranges(&self) -> impl Iterator<Item = Range<u32>> {
        let slots = self.strips.iter().map(|strip| strip.slot).filter(|slot| slot.capacity > 0);
        slots.map(|slot| slot.first..slot.first + slot.length)
    }

    /// Number of indices that the strips need, with a restart after each.
    pub fn live_index_count(&self) -> usize {
        self.regions.iter().map(|region| region.live as usize).sum()
    }

    /// Returns the ranges of [`indices`](Self::indices) that have changed since the last call, sorted and
    /// disjoint, for a partial upload.
    pub fn take_changed_ranges(&mut self) -> Vec<Range<u32>> {
        self.changed.sort_unstable_by_key(|range| range.start);
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

    /// Updates the buffer after moves of the live strips.
    ///
    /// # Panics
    /// If the live strips belong to a mesh of another size.
    pub fn sync(&mut self, live: &mut LiveStrips<'_>) {
        let mut triangles = std::mem::take(&mut self.scratch.triangles);
        live.changes.take_into(&mut triangles);
        assert_eq!(self.strip_of.len(), live.graph.all_corners().len(), "the strips of another mesh");
        self.mark_stale(&triangles, live);
        let links = StripLinks::from_bits(live.graph.twins(), std::mem::take(&mut live.solid));
        let fits = triangles.iter().all(|&triangle| {
            let is_written = !live.is_shown(triangle) || !self.is_unwritten(triangle);
            is_written || self.write_strip_of(triangle, live, &links)
        });
        self.give_back_stale();
        if !fits {
            self.lay_out(live, &links);
        }
        for group in 0..self.regions.len() {
            if self.regions[group].is_sparse() {
                self.pack(group);
            }
        }
        live.solid = links.into_bits();
        self.scratch.triangles = triangles;
        if self.changed.len() > MANY_RANGES {
            self.changed = self.take_changed_ranges();
        }
    }

    /// Marks the strips of changed triangles.
    fn mark_stale(&mut self, triangles: &[u32], live: &LiveStrips<'_>) {
        for &triangle in triangles {
            let id = self.strip_of[triangle as usize];
            if id != NO_TWIN && !std::mem::replace(&mut self.strips[id as usize].is_stale, true) {
                self.scratch.stale.push(id);
            }
            if !live.is_shown(triangle) {
                self.strip_of[triangle as usize] = NO_TWIN;
            }
        }
    }

    /// Whether the strip of a triangle has not been written since it changed.
    fn is_unwritten(&self, triangle: u32) -> bool {
        let id = self.strip_of[triangle as usize];
        id == NO_TWIN || self.strips[id as usize].is_stale
    }

    /// Writes the strip of a triangle. Returns false if its region has no room for it.
    fn write_strip_of(&mut self, triangle: u32, live: &LiveStrips<'_>, links: &StripLinks<'_>) -> bool {
        let mut path = std::mem::take(&mut self.scratch.path);
        let end = links.first_solid(triangle).map_or(triangle, |side| links.end_beyond(side));
        path.follow(links, end);
        let group = live.graph.group_of(triangle);
        let home = self.home_of(&path, links);
        self.write_path(&mut path, live, links, home);
        let length = self.scratch.written.len() as u32;
        let slot = match home {
            Some(slot) if slot.capacity >= StripSlot::needed(length) => Some(StripSlot { length, ..slot }),
            Some(slot) => {
                self.give_back(slot, group);
                self.regions[group as usize].take(length)
            }
            None => self.regions[group as usize].take(length),
        };
        if let Some(slot) = slot {
            let slot = self.write_to(slot, group);
            let id = self.new_id(Strip { slot, group, is_stale: false });
            path.triangles(links).for_each(|triangle| self.strip_of[triangle as usize] = id);
        }
        self.scratch.path = path;
        slot.is_some()
    }

    /// Takes the range of one of the stale strips that a strip replaces: the longest.
    fn home_of(&mut self, path: &StripPath, links: &StripLinks<'_>) -> Option<StripSlot> {
        let ids = path.triangles(links).map(|triangle| self.strip_of[triangle as usize]);
        let with_room = ids.filter(|&id| id != NO_TWIN && self.strips[id as usize].slot.capacity > 0);
        let longest = with_room.max_by_key(|&id| self.strips[id as usize].slot.capacity)?;
        let home = self.strips[longest as usize].slot;
        debug_assert!(
            self.strips[longest as usize].is_stale,
            "a strip has changed, but none of its triangles"
        );
        // Long enough for most strips: two indices and swaps.
        if home.capacity < StripSlot::needed(path.exits.len() as u32 + 3) {
            return None;
        }
        let strip = &mut self.strips[longest as usize];
        self.regions[strip.group as usize].live -= StripSlot::needed(home.length);
        strip.slot = StripSlot::default();
        Some(home)
    }

    /// Writes the indices of a strip to `scratch.written`, in the direction that is cheaper or, if both are
    /// equal, keeps more of the indices at its home.
    fn write_path(
        &mut self,
        path: &mut StripPath,
        live: &LiveStrips<'_>,
        links: &StripLinks<'_>,
        home: Option<StripSlot>,
    ) {
        let corners = live.graph.all_corners();
        let BufferScratch { written, reversed, .. } = &mut self.scratch;
        let [begins, ends] = [path.begins_without_parity_fix(links), path.ends_without_parity_fix(links)];
        if !begins && ends {
            path.reverse(links);
        }
        written.clear();
        path.write(corners, links, false, written);
        let Some(home) = home.filter(|_| begins == ends) else { return };
        let before = &self.indices[home.strip()];
        if same_at_ends(written, before) >= 3 {
            return;
        }
        path.reverse(links);
        reversed.clear();
        path.write(corners, links, false, reversed);
        if same_at_ends(reversed, before) > same_at_ends(written, before) {
            std::mem::swap(written, reversed);
        }
    }

    /// Writes `scratch.written` to a slot, and restarts after it; returns the slot without the rest that the
    /// strip does not need.
    fn write_to(&mut self, slot: StripSlot, group: u32) -> StripSlot {
        let written = &self.scratch.written;
        let all = &mut self.indices[slot.first as usize..(slot.first + slot.capacity) as usize];
        let (strip, rest) = all.split_at_mut(written.len());
        let first = strip.iter().zip(written).position(|(before, after)| before != after);
        let last = rest.iter().rposition(|&before| before != RESTART).map(|at| written.len() + at);
        let last = last.or_else(|| strip.iter().zip(written).rposition(|(before, after)| before != after));
        strip.copy_from_slice(written);
        rest.fill(RESTART);
        if let Some(last) = last {
            let first = first.unwrap_or(written.len());
            self.changed.push(slot.first + first as u32..slot.first + last as u32 + 1);
        }
        let region = &mut self.regions[group as usize];
        region.live += StripSlot::needed(slot.length);
        region.without_rest(slot)
    }

    fn new_id(&mut self, strip: Strip) -> u32 {
        match self.unused_ids.pop() {
            Some(id) => {
                self.strips[id as usize] = strip;
                id
            }
            None => {
                self.strips.push(strip);
                self.strips.len() as u32 - 1
            }
        }
    }

    /// Fills the ranges of stale strips that no other strip took over with restarts.
    fn give_back_stale(&mut self) {
        let mut stale = std::mem::take(&mut self.scratch.stale);
        for id in stale.drain(..) {
            let Strip { slot, group, .. } = std::mem::take(&mut self.strips[id as usize]);
            if slot.capacity > 0 {
                self.regions[group as usize].live -= StripSlot::needed(slot.length);
                self.give_back(slot, group);
            }
            self.unused_ids.push(id);
        }
        self.scratch.stale = stale;
    }

    /// Fills a range with restarts and makes it free.
    fn give_back(&mut self, slot: StripSlot, group: u32) {
        self.indices[slot.strip()].fill(RESTART);
        self.changed.push(slot.first..slot.first + slot.length);
        self.regions[group as usize].give_back(slot.first, slot.capacity);
    }

    /// Moves the strips of a region together.
    fn pack(&mut self, group: usize) {
        let mut ids: Vec<u32> = (0..self.strips.len() as u32)
            .filter(|&id| {
                let strip = &self.strips[id as usize];
                strip.group as usize == group && strip.slot.capacity > 0
            })
            .collect();
        ids.sort_unstable_by_key(|&id| self.strips[id as usize].slot.first);
        let region = &mut self.regions[group];
        let end_before = region.first + region.used;
        let live = region.live;
        region.clear();
        for id in ids {
            let slot = &mut self.strips[id as usize].slot;
            let first = region.first + region.used;
            self.indices.copy_within(slot.strip(), first as usize);
            self.indices[(first + slot.length) as usize] = RESTART;
            *slot = StripSlot { first, capacity: StripSlot::needed(slot.length), length: slot.length };
            region.used += slot.capacity;
        }
        region.live = live;
        // Indices that are no longer drawn must be restarts, because strips may be appended there.
        let end = region.first + region.used;
        self.indices[end as usize..end_before as usize].fill(RESTART);
        self.changed.push(region.first..end_before);
    }

    /// Lays out the whole buffer again, with room to grow.
    fn lay_out(&mut self, live: &LiveStrips<'_>, links: &StripLinks<'_>) {
        let mut lengths = vec![0u32; self.regions.len()];
        let mut paths: Vec<(u32, Vec<u32>, Vec<u32>)> = Vec::new();
        let mut is_done = vec![false; self.strip_of.len()];
        for triangle in (0..self.strip_of.len() as u32).filter(|&t| live.is_shown(t)) {
            if std::mem::replace(&mut is_done[triangle as usize], true) {
                continue;
            }
            let mut path = std::mem::take(&mut self.scratch.path);
            let end = links.first_solid(triangle).map_or(triangle, |side| links.end_beyond(side));
            path.follow(links, end);
            self.write_path(&mut path, live, links, None);
            let group = live.graph.group_of(triangle);
            let triangles: Vec<u32> = path.triangles(links).collect();
            triangles.iter().for_each(|&t| is_done[t as usize] = true);
            lengths[group as usize] += StripSlot::needed(self.scratch.written.len() as u32);
            paths.push((group, self.scratch.written.clone(), triangles));
            self.scratch.path = path;
        }
        let mut first = 0;
        for (region, length) in self.regions.iter_mut().zip(lengths) {
            *region = SlotRegion::new(first, length + length / 2 + 64);
            first += region.capacity;
        }
        self.indices = vec![RESTART; first as usize];
        self.strips.clear();
        self.unused_ids.clear();
        self.strip_of.fill(NO_TWIN);
        for (group, written, triangles) in paths {
            self.scratch.written = written;
            let length = self.scratch.written.len() as u32;
            let Some(slot) = self.regions[group as usize].take(length) else { continue };
            let slot = self.write_to(slot, group);
            let id = self.new_id(Strip { slot, group, is_stale: false });
            triangles.iter().for_each(|&triangle| self.strip_of[triangle as usize] = id);
        }
        self.changed.clear();
        self.changed.push(0..first);
    }
}

/// Number of indices that are equal at the beginning, and at the end if none is at the beginning.
fn same_at_ends(a: &[u32], b: &[u32]) -> usize {
    let at_start = a.iter().zip(b).take_while(|(a, b)| a == b).count();
    let at_end = || a.iter().rev().zip(b.iter().rev()).take_while(|(a, b)| a == b).count();
    if at_start > 0 { at_start } else { at_end() }
}
