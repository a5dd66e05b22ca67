//! A trial: LodStrips that store the lifetimes of their slots instead of what each step edits.
//!
//! [`Mts`](striata::model::Mts) became small by storing how long each slot of a strip survives, and which
//! strips a step changes. LodStrips could store the same and still edit strips in place. Coarsening looks for
//! the vertices of the step in the strips that it changes and replaces them; slots whose lifetime ends are
//! removed. Refining is harder: a slot that shows the target may belong to it or to the restored vertex, so
//! its chain of targets is followed, and dropped slots are put back between the others.
//!
//! ```text
//! row of a strip     shown vertex  9  4  |  7  2        slot  0  3  |  8  9       | a break
//! ```
//!
//! The strips of all levels are those of [`Mts`](striata::model::Mts), breaks included. Stored as compactly
//! as there, the two take the same bytes; this form uses plain words and bytes. What editing saves compared
//! with rebuilding is shown by `compare`.

use striata::mesh::RefinableMesh;
use striata::model::mts::MAX_STRIP_INDICES;
use striata::model::strip_history::{Piece, StripHistory};
use striata::model::{
    DrawCounts, LodModel, ModelError, PartBytes, StepVertices, Topology, check_strips, join_strips,
};
use striata::strip::{RESTART, StripSet, strip_triangles};

use crate::paper_bytes::{Accounting, PaperBytes};

/// Last change of a slot that is never dropped.
const FOREVER: u8 = u8::MAX;
/// Slot of a restart in a row.
const BREAK: u8 = u8::MAX;

/// The static half of the trial; see the [module](self).
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LifetimeLodStrips {
    vertices: StepVertices<'static>,
    strips: StripSet,
    /// The last change of its strip that each slot survives.
    lasts: Vec<u8>,
    /// For each slot the change since which the strip breaks before it, or [`FOREVER`] if it never does.
    breaks: Vec<u8>,
    /// Offset of each step in `changes`, followed by their number.
    change_offsets: Vec<u32>,
    /// The strips that a step changes, shifted by one bit, which is set if the strip loses slots.
    changes: Vec<u32>,
}

/// State of one instance: its level and the rows of its strips.
#[derive(Clone, Debug)]
pub struct LifetimeLodStripsState {
    split_count: usize,
    /// Vertices that the rows show, each row in room for all slots of its strip.
    shown: Vec<u32>,
    /// The slot of each of them.
    slots: Vec<u8>,
    rows: Vec<Row>,
    scratch: Vec<(u32, u8)>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Row {
    length: u8,
    /// Number of changes since the full mesh.
    change: u8,
}

/// States are equal if they show the same rows.
impl PartialEq for LifetimeLodStripsState {
    fn eq(&self, other: &Self) -> bool {
        self.split_count == other.split_count && self.rows == other.rows && self.shown == other.shown
    }
}

impl Eq for LifetimeLodStripsState {}

impl LifetimeLodStrips {
    /// Builds the model from strips of the full mesh; strips longer than [`MAX_STRIP_INDICES`] are cut.
    ///
    /// # Errors
    /// [`ModelError`] if the strips do not match the mesh.
    pub fn build(refinable: &RefinableMesh, strips: &StripSet) -> Result<Self, ModelError> {
        check_strips(&refinable.mesh, strips)?;
        let strips = drawn_strips(&strips.cut(MAX_STRIP_INDICES));
        let sequence = &refinable.sequence;
        let mut of_steps = vec![Vec::new(); sequence.step_count()];
        let slot_count = strips.indices().len();
        let (mut lasts, mut breaks) = (vec![0; slot_count], vec![FOREVER; slot_count]);
        for (index, strip) in strips.strips().enumerate() {
            let first = strips.offsets()[index] as usize;
            let mut history = StripHistory::new(sequence, strip);
            let mut change = 0;
            while let Some(touch) = history.coarsen() {
                of_steps[touch.step as usize].push((index as u32) << 1 | u32::from(touch.drops));
                change += u8::from(touch.drops);
                for (at, Piece { places, .. }) in history.pieces().iter().enumerate() {
                    places.iter().for_each(|&slot| lasts[first + slot as usize] = change);
                    let since = &mut breaks[first + places[0] as usize];
                    if at > 0 && *since == FOREVER {
                        *since = change;
                    }
                }
            }
            for &slot in history.pieces().iter().flat_map(|piece| &piece.places) {
                lasts[first + slot as usize] = FOREVER;
            }
        }
        let ends = of_steps.iter().scan(0, |end, changes| {
            *end += changes.len() as u32;
            Some(*end)
        });
        let change_offsets = std::iter::once(0).chain(ends).collect();
        let vertices = StepVertices::of_sequence(sequence).into_owned();
        Ok(Self { vertices, strips, lasts, breaks, change_offsets, changes: of_steps.concat() })
    }

    /// Number of strips, including those without triangles at coarse levels.
    pub fn strip_count(&self) -> usize {
        self.strips.strip_count()
    }

    fn strip<'s>(&self, state: &'s LifetimeLodStripsState, strip: usize) -> &'s [u32] {
        let first = self.strips.offsets()[strip] as usize;
        &state.shown[first..first + usize::from(state.rows[strip].length)]
    }

    /// The strips that a step changes, and whether each loses slots.
    fn changes_of(&self, step: usize) -> impl Iterator<Item = (usize, bool)> {
        let [start, end] = [step, step + 1].map(|step| self.change_offsets[step] as usize);
        self.changes[start..end].iter().map(|change| (*change as usize >> 1, change & 1 != 0))
    }

    /// The vertex that a slot shows at a level with this many vertices.
    fn resolved(&self, slot: usize, vertex_count: u32) -> u32 {
        let mut vertex = self.strips.indices()[slot];
        while vertex >= vertex_count {
            vertex = self.vertices.target(vertex);
        }
        vertex
    }

    /// Collapses the last step in the strips that it changes.
    fn coarsen(&self, state: &mut LifetimeLodStripsState) {
        state.split_count -= 1;
        let vertices = self.vertices.of_step(state.split_count);
        for (strip, drops) in self.changes_of(state.split_count) {
            let first = self.strips.offsets()[strip] as usize;
            let row = &mut state.rows[strip];
            for vertex in &mut state.shown[first..first + usize::from(row.length)] {
                if vertices.contains(vertex) {
                    *vertex = self.vertices.target(*vertex);
                }
            }
            if drops {
                row.change += 1;
                self.drop_slots(state, strip);
            }
        }
    }

    /// Removes the slots whose lifetime has ended, and sets the restarts of the breaks that apply.
    fn drop_slots(&self, state: &mut LifetimeLodStripsState, strip: usize) {
        let first = self.strips.offsets()[strip] as usize;
        let Row { length, change } = state.rows[strip];
        let LifetimeLodStripsState { scratch, shown, slots, .. } = state;
        scratch.clear();
        let row = first..first + usize::from(length);
        let live = shown[row.clone()].iter().copied().zip(slots[row].iter().copied());
        let survives =
            |&(_, slot): &(u32, u8)| slot != BREAK && self.lasts[first + usize::from(slot)] >= change;
        for (vertex, slot) in live.filter(survives) {
            self.push(scratch, (first, slot, change), vertex);
        }
        state.write_row(first, strip);
    }

    /// Restores the next step in the strips that it changes.
    fn refine(&self, state: &mut LifetimeLodStripsState) {
        let vertices = self.vertices.of_step(state.split_count);
        for (strip, drops) in self.changes_of(state.split_count) {
            if drops {
                state.rows[strip].change -= 1;
                self.restore_slots(state, strip, vertices.end);
                continue;
            }
            let first = self.strips.offsets()[strip] as usize;
            let row = first..first + usize::from(state.rows[strip].length);
            for (vertex, &slot) in state.shown[row.clone()].iter_mut().zip(&state.slots[row]) {
                if vertices.clone().any(|restored| self.vertices.target(restored) == *vertex) {
                    *vertex = self.resolved(first + usize::from(slot), vertices.end);
                }
            }
        }
        state.split_count += 1;
    }

    /// Rebuilds the row of a strip that gets slots back.
    fn restore_slots(&self, state: &mut LifetimeLodStripsState, strip: usize, vertex_count: u32) {
        let [first, end] = [strip, strip + 1].map(|strip| self.strips.offsets()[strip] as usize);
        let change = state.rows[strip].change;
        state.scratch.clear();
        for slot in (first..end).filter(|&slot| self.lasts[slot] >= change) {
            let vertex = self.resolved(slot, vertex_count);
            self.push(&mut state.scratch, (first, (slot - first) as u8, change), vertex);
        }
        state.write_row(first, strip);
    }

    /// Appends a slot to a row, after a restart if a break precedes it.
    fn push(&self, row: &mut Vec<(u32, u8)>, (first, slot, change): (usize, u8, u8), vertex: u32) {
        let since = self.breaks[first + usize::from(slot)];
        if since != FOREVER && since <= change && !row.is_empty() {
            row.push((RESTART, BREAK));
        }
        row.push((vertex, slot));
    }
}

/// The strips that have triangles.
fn drawn_strips(strips: &StripSet) -> StripSet {
    let mut drawn = StripSet::new();
    for group in 0..strips.group_count() {
        for strip in strips.group_strips(group).map(|index| strips.strip(index)) {
            if strip_triangles(strip).next().is_some() {
                drawn.push(strip);
            }
        }
        drawn.end_group();
    }
    drawn
}

impl LifetimeLodStripsState {
    /// Copies the scratch to the row of a strip. What is behind the row becomes zero, so that equal rows make
    /// equal states.
    fn write_row(&mut self, first: usize, strip: usize) {
        let behind = first + self.scratch.len()..first + usize::from(self.rows[strip].length);
        self.shown[behind.start..behind.end.max(behind.start)].fill(0);
        for (at, &(vertex, slot)) in (first..).zip(&self.scratch) {
            (self.shown[at], self.slots[at]) = (vertex, slot);
        }
        self.rows[strip].length = self.scratch.len() as u8;
    }
}

impl LodModel for LifetimeLodStrips {
    type State = LifetimeLodStripsState;

    fn step_count(&self) -> usize {
        self.vertices.step_count()
    }

    fn new_state(&self) -> LifetimeLodStripsState {
        let row = |strip: &[u32]| Row { length: strip.len() as u8, change: 0 };
        LifetimeLodStripsState {
            split_count: self.step_count(),
            shown: self.strips.indices().to_vec(),
            slots: self.strips.strips().flat_map(|strip| 0..strip.len() as u8).collect(),
            rows: self.strips.strips().map(row).collect(),
            scratch: Vec::with_capacity(MAX_STRIP_INDICES),
        }
    }

    fn split_count(&self, state: &LifetimeLodStripsState) -> usize {
        state.split_count
    }

    fn move_to(&self, state: &mut LifetimeLodStripsState, split_count: usize) {
        let step_count = self.step_count();
        assert!(split_count <= step_count, "split count {split_count} of {step_count}");
        assert_eq!(state.rows.len(), self.strip_count(), "the state belongs to another model");
        while state.split_count > split_count {
            self.coarsen(state);
        }
        while state.split_count < split_count {
            self.refine(state);
        }
    }

    fn topology(&self) -> Topology {
        Topology::Strips
    }

    fn draw_counts(&self, state: &LifetimeLodStripsState) -> DrawCounts {
        let mut counts = DrawCounts::of_strips((0..self.strip_count()).map(|strip| self.strip(state, strip)));
        let restarts = (0..self.strip_count()).flat_map(|strip| self.strip(state, strip));
        counts.strip_count += restarts.filter(|&&index| index == RESTART).count();
        counts
    }

    fn indices_into(&self, state: &LifetimeLodStripsState, out: &mut Vec<u32>) {
        join_strips((0..self.strip_count()).map(|strip| self.strip(state, strip)), out);
    }

    fn bytes(&self) -> Vec<PartBytes> {
        let part = |name, bytes| PartBytes { name, bytes };
        let offsets = self.strips.offsets().len() + self.strips.group_offsets().len();
        vec![
            part("strips", 4 * self.strips.indices().len()),
            part("strip offsets", 4 * offsets),
            part("targets", 4 * self.vertices.word_count()),
            part("lifetimes", self.lasts.len() + self.breaks.len()),
            part("changed strips", 4 * (self.change_offsets.len() + self.changes.len())),
        ]
    }

    fn state_bytes(&self, state: &LifetimeLodStripsState) -> usize {
        4 * state.shown.len() + state.slots.len() + size_of_val(&state.rows[..])
    }
}

impl PaperBytes for LifetimeLodStrips {
    /// A vertex and a lifetime per slot, a pointer per strip, a target per vertex, two words per step and a
    /// word per strip that it changes.
    fn paper_bytes(&self, accounting: Accounting) -> usize {
        let words = 2 * self.strips.indices().len() + self.vertices.word_count() + self.changes.len();
        accounting.bytes(words + self.step_count(), self.strip_count() + self.step_count())
    }
}
