//! What one instance of MTS owns, and how it moves between levels.
//!
//! The record of a step names the strips that it changes, by rising number: the first in as many bytes as the largest
//! needs, the others as varints of the gap to the last less one; each shifted by one bit, which says whether the strip
//! passes other places from there on, or only shows other vertices at them.

use super::Mts;
use super::arcs::Arc;
use crate::model::StripModel;
use crate::model::record_arena::{read_fixed, read_varint, record_at, record_before};
use crate::strip::RESTART;

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
}

/// One strip of an instance.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct LiveStrip {
    /// Where its slot begins.
    first: u32,
    /// What it shows, restarts between its pieces counted.
    length: u32,
    /// How often it has changed since the full mesh.
    change: u16,
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
        4 * (self.slots.len() + self.touched.capacity()) + size_of_val(&self.strips[..])
    }

    pub(super) fn live(&self, strip: usize) -> &[u32] {
        let LiveStrip { first, length, .. } = self.strips[strip];
        &self.slots[first as usize..(first + length) as usize]
    }

    pub(super) fn recover(&mut self, model: &Mts<'_>) {
        self.check_model(model);
        let vertex_count = model.vertex_count_at(self.split_count) as u32;
        for strip in 0..self.strips.len() {
            self.walk(model, strip, vertex_count);
        }
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
        let vertex_count = model.vertex_count_at(split_count) as u32;
        let mut touched = std::mem::take(&mut self.touched);
        for &strip in &touched {
            self.strips[strip as usize].is_touched = false;
            self.walk(model, strip as usize, vertex_count);
        }
        touched.clear();
        self.touched = touched;
    }

    fn touch_coarser(&mut self, model: &Mts<'_>) -> Option<()> {
        self.split_count -= 1;
        let length = model.parts.record_lengths[self.split_count];
        let (body, start) = record_before(&model.parts.arena, self.cursor, length)?;
        self.cursor = start;
        for_each_strip(body, model.head_bytes, |strip, drops| {
            let live = &mut self.strips[strip as usize];
            live.change += u16::from(drops);
            if !std::mem::replace(&mut live.is_touched, true) {
                self.touched.push(strip);
            }
        })
    }

    fn touch_finer(&mut self, model: &Mts<'_>) -> Option<()> {
        let length = model.parts.record_lengths[self.split_count];
        let (body, end) = record_at(&model.parts.arena, self.cursor, length)?;
        self.split_count += 1;
        self.cursor = end;
        for_each_strip(body, model.head_bytes, |strip, drops| {
            let live = &mut self.strips[strip as usize];
            live.change -= u16::from(drops);
            if !std::mem::replace(&mut live.is_touched, true) {
                self.touched.push(strip);
            }
        })
    }

    fn walk(&mut self, model: &Mts<'_>, strip: usize, vertex_count: u32) {
        let LiveStrip { first, change, .. } = self.strips[strip];
        let end = model.parts.offsets[strip + 1];
        let slot = &mut self.slots[first as usize..end as usize];
        let length = model.graph(strip).recover(change, slot, |mut vertex| {
            while vertex >= vertex_count {
                vertex = model.vertices.target(vertex);
            }
            vertex
        });
        debug_assert!(length.is_some(), "a checked strip has an arc too many");
        self.strips[strip].length = length.unwrap_or(0) as u32;
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
pub(super) struct StripGraph<'m> {
    pub(super) indices: &'m [u32],
    pub(super) rows: &'m [u16],
    pub(super) arcs: &'m [u32],
}

impl StripGraph<'_> {
    /// What follows the place whose row this is, after so many changes of the strip.
    #[inline]
    fn next(&self, row: usize, change: u16) -> Option<Arc> {
        let row = self.arcs.get(usize::from(self.rows[row])..usize::from(self.rows[row + 1]))?;
        if row.is_empty() {
            return Some(Arc::NEXT);
        }
        row.iter().map(|&arc| Arc(arc)).find(|arc| arc.res() >= change)
    }

    /// Writes what the strip shows; `None` where the arcs lead outside of the strip or do not end.
    pub(super) fn recover(&self, change: u16, slot: &mut [u32], shown: impl Fn(u32) -> u32) -> Option<usize> {
        let mut length = 0;
        let mut at = 0;
        loop {
            let arc = self.next(at, change)?;
            if arc.skip() == 0 {
                return Some(length);
            }
            if arc.is_break() {
                *slot.get_mut(length)? = RESTART;
                length += 1;
            }
            at += arc.skip();
            *slot.get_mut(length)? = shown(*self.indices.get(at - 1)?);
            length += 1;
        }
    }
}

impl Mts<'_> {
    #[inline]
    pub(super) fn graph(&self, strip: usize) -> StripGraph<'_> {
        let parts = &self.parts;
        let places = parts.offsets[strip] as usize..parts.offsets[strip + 1] as usize;
        let rows = places.start + 2 * strip..places.end + 2 * (strip + 1);
        let arcs = parts.arc_offsets[strip] as usize..parts.arc_offsets[strip + 1] as usize;
        StripGraph { indices: &parts.indices[places], rows: &parts.rows[rows], arcs: &parts.arcs[arcs] }
    }

    /// How often strips change, over all steps.
    pub(super) fn change_count(&self) -> usize {
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
