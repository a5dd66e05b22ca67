//! What one instance of MTS owns, and how it moves between levels.
//!
//! The record of a step names the strips that it changes, by rising number: the first in as many bytes as the largest
//! needs, the others as varints of the gap to the last less one; each shifted by one bit, which says whether the strip
//! loses places, or only shows other vertices at them.

use std::ops::Range;

use super::Mts;
use crate::model::record_arena::{read_fixed, read_varint, record_at, record_before};
use crate::model::{StoredModel, StripModel};
use crate::strip::RESTART;

/// Where more than one strip in so many is walked, all chains of targets are followed first.
const MANY: usize = 8;

/// An instance: its level and its current strips. Made by [`LodModel::new_state`](crate::model::LodModel).
#[derive(Clone, Debug)]
pub struct MtsState {
    split_count: usize,
    /// End of the record of step `split_count - 1` in the arena, where that of step `split_count` begins.
    cursor: usize,
    /// What the strips show, each in a slot of its full length.
    slots: Vec<u32>,
    strips: Vec<LiveStrip>,
    /// Strips to walk again at the end of a move; kept so that no move allocates.
    touched: Vec<u32>,
    /// What each vertex shows at the level; made when many strips are walked at once, empty before.
    shown: Vec<u32>,
}

/// One strip of an instance.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct LiveStrip {
    /// Where its slot begins.
    first: u32,
    /// What it shows, restarts between its pieces counted.
    length: u32,
    /// How often it has changed since the full mesh.
    change: u8,
    is_touched: bool,
}

/// Equal where the same is shown: what a slot held before is no part of the state.
impl PartialEq for MtsState {
    fn eq(&self, other: &Self) -> bool {
        (self.split_count, self.cursor, self.slots.len())
            == (other.split_count, other.cursor, other.slots.len())
            && self.strips == other.strips
            && (0..self.strips.len()).all(|strip| self.live(strip) == other.live(strip))
    }
}

impl Eq for MtsState {}

impl MtsState {
    pub(super) fn new(model: &Mts<'_>) -> Self {
        let strip = |w: &[u32]| LiveStrip { first: w[0], length: 0, change: 0, is_touched: false };
        let mut state = Self {
            split_count: model.parts.record_lengths.len(),
            cursor: model.parts.arena.len(),
            slots: vec![0; model.parts.indices.len()],
            strips: model.parts.offsets.windows(2).map(strip).collect(),
            touched: Vec::with_capacity(model.strip_count()),
            shown: Vec::new(),
        };
        state.recover(model);
        state
    }

    /// The level it shows.
    pub fn split_count(&self) -> usize {
        self.split_count
    }

    /// Bytes that the instance owns.
    pub fn bytes(&self) -> usize {
        4 * (self.slots.len() + self.touched.capacity() + self.shown.capacity())
            + size_of_val(&self.strips[..])
    }

    pub(super) fn live(&self, strip: usize) -> &[u32] {
        let LiveStrip { first, length, .. } = self.strips[strip];
        &self.slots[first as usize..(first + length) as usize]
    }

    pub(super) fn recover(&mut self, model: &Mts<'_>) {
        self.check_model(model);
        self.touched.clear();
        self.touched.extend(0..self.strips.len() as u32);
        self.walk_touched(model);
    }

    fn check_model(&self, model: &Mts<'_>) {
        assert!(
            self.slots.len() == model.parts.indices.len() && self.strips.len() == model.strip_count(),
            "the state belongs to another model"
        );
    }

    pub(super) fn move_to(&mut self, model: &Mts<'_>, split_count: usize) {
        let step_count = model.parts.record_lengths.len();
        assert!(split_count <= step_count, "split count {split_count} of {step_count}");
        self.check_model(model);
        while self.split_count > split_count {
            let done = self.touch_coarser(model);
            debug_assert!(done.is_some(), "a checked record ended early");
        }
        while self.split_count < split_count {
            let done = self.touch_finer(model);
            debug_assert!(done.is_some(), "a checked record ended early");
        }
        self.walk_touched(model);
    }

    /// Walks the touched strips, after which none is.
    fn walk_touched(&mut self, model: &Mts<'_>) {
        let vertex_count = model.vertex_count_at(self.split_count) as u32;
        let mut touched = std::mem::take(&mut self.touched);
        let is_full = self.split_count == model.parts.record_lengths.len();
        // Following chains of targets place by place costs more than following all of them once.
        if !is_full && touched.len() > self.strips.len() / MANY {
            self.show_all(model, vertex_count);
            touched.iter().for_each(|&strip| self.walk_shown(model, strip as usize));
        } else {
            touched.iter().for_each(|&strip| self.walk(model, strip as usize, vertex_count));
        }
        touched.clear();
        self.touched = touched;
    }

    /// Finds what every vertex shows at the level. A target is older than its vertex, so it is known by then.
    fn show_all(&mut self, model: &Mts<'_>, vertex_count: u32) {
        self.shown.clear();
        self.shown.extend(0..vertex_count);
        for vertex in vertex_count..model.vertices.vertex_count as u32 {
            let target = model.vertices.target(vertex);
            self.shown.push(self.shown[target as usize]);
        }
    }

    fn touch_coarser(&mut self, model: &Mts<'_>) -> Option<()> {
        self.split_count -= 1;
        let length = model.parts.record_lengths[self.split_count];
        let (body, start) = record_before(&model.parts.arena, self.cursor, length)?;
        self.cursor = start;
        self.touch(body, model.head_bytes, |change, drops| *change += u8::from(drops))
    }

    fn touch_finer(&mut self, model: &Mts<'_>) -> Option<()> {
        let length = model.parts.record_lengths[self.split_count];
        let (body, end) = record_at(&model.parts.arena, self.cursor, length)?;
        self.split_count += 1;
        self.cursor = end;
        self.touch(body, model.head_bytes, |change, drops| *change -= u8::from(drops))
    }

    /// Marks the strips of a record for a walk; `count` counts the changes of their places.
    #[inline]
    fn touch(&mut self, body: &[u8], head_bytes: usize, count: impl Fn(&mut u8, bool)) -> Option<()> {
        for_each_strip(body, head_bytes, |strip, drops| {
            let live = &mut self.strips[strip as usize];
            count(&mut live.change, drops);
            if !std::mem::replace(&mut live.is_touched, true) {
                self.touched.push(strip);
            }
        })
    }

    fn walk(&mut self, model: &Mts<'_>, strip: usize, vertex_count: u32) {
        let live = &mut self.strips[strip];
        let slot = &mut self.slots[live.first as usize..model.parts.offsets[strip + 1] as usize];
        let length = model.places(strip).recover(live.change, slot, |vertex| vertex);
        for vertex in &mut slot[..length] {
            while *vertex >= vertex_count && *vertex != RESTART {
                *vertex = model.vertices.target(*vertex);
            }
        }
        live.length = length as u32;
        live.is_touched = false;
    }

    /// The same where it is known what each vertex shows.
    fn walk_shown(&mut self, model: &Mts<'_>, strip: usize) {
        let live = &mut self.strips[strip];
        let slot = &mut self.slots[live.first as usize..model.parts.offsets[strip + 1] as usize];
        let shown = |vertex: u32| self.shown[vertex as usize];
        live.length = model.places(strip).recover(live.change, slot, shown) as u32;
        live.is_touched = false;
    }
}

/// Calls `visit` with each strip of a record and whether its places change; `None` where the record ends too early.
#[inline]
pub(super) fn for_each_strip(
    mut body: &[u8],
    head_bytes: usize,
    mut visit: impl FnMut(u32, bool),
) -> Option<()> {
    if body.is_empty() {
        return Some(());
    }
    let head = read_fixed(&mut body, head_bytes)?;
    let mut strip = head >> 1;
    visit(strip, head & 1 != 0);
    while !body.is_empty() {
        let head = read_varint(&mut body)?;
        strip = strip.checked_add(head >> 1)?.checked_add(1)?;
        visit(strip, head & 1 != 0);
    }
    Some(())
}

/// One strip's part of the arrays.
#[derive(Clone, Copy, Debug)]
pub(super) struct Places<'m> {
    pub(super) indices: &'m [u32],
    pub(super) lasts: &'m [u8],
    pub(super) breaks: &'m [[u8; 2]],
}

impl Places<'_> {
    /// Writes what is left of the strip after so many changes; returns how many indices that is.
    #[inline]
    pub(super) fn recover(&self, change: u8, slot: &mut [u32], shown: impl Fn(u32) -> u32) -> usize {
        let take = |range: Range<usize>, slot: &mut [u32], mut length: usize| {
            // Each index is written, and kept or not: which of them are left cannot be guessed.
            for (&index, &last) in self.indices[range.clone()].iter().zip(&self.lasts[range]) {
                slot[length] = shown(index);
                length += usize::from(last >= change);
            }
            length
        };
        let mut length = 0;
        let mut from = 0;
        for &[place, since] in self.breaks {
            let place = usize::from(place);
            if since <= change && self.lasts[place] >= change {
                length = take(from..place, slot, length);
                from = place;
                // Nothing may be left of what came before; behind a restart the place of its break is.
                if length > 0 {
                    slot[length] = RESTART;
                    length += 1;
                }
            }
        }
        take(from..self.indices.len(), slot, length)
    }
}

impl Mts<'_> {
    #[inline]
    pub(super) fn places(&self, strip: usize) -> Places<'_> {
        let parts = &self.parts;
        let places = parts.offsets[strip] as usize..parts.offsets[strip + 1] as usize;
        let breaks = parts.break_offsets[strip] as usize..parts.break_offsets[strip + 1] as usize;
        Places {
            indices: &parts.indices[places.clone()],
            lasts: &parts.lasts[places],
            breaks: &parts.breaks[breaks],
        }
    }

    /// How often strips change, over all steps.
    pub fn change_count(&self) -> usize {
        let mut count = 0;
        let mut cursor = 0;
        for &length in self.parts.record_lengths.iter() {
            let Some((body, end)) = record_at(&self.parts.arena, cursor, length) else { break };
            cursor = end;
            let counted = for_each_strip(body, self.head_bytes, |_, _| count += 1);
            debug_assert!(counted.is_some(), "a checked record ended early");
        }
        count
    }
}
