//! LodStrips as first published \[RC04\]: strips of the full mesh in which each step substitutes indices.
//!
//! Each vertex has a change that lists, for every strip containing it when it collapses, the slots it
//! occupies. Coarsening writes its target to these slots, refining writes the vertex back. Strips keep
//! their full length, so nothing ever moves. Repetitions are filtered out while the strips are sent to the
//! GPU, as \[RCRG06\] describes for its forerunner.
//!
//! ```text
//! change of a vertex   strip, slot count, slots ... | strip, slot count, slots ... | ...
//! ```
//!
//! A strip whose last triangle has vanished draws nothing, whatever its indices are, so later changes
//! leave it out. That makes the changes of the bunny a third smaller.
//!
//! Differs: the publication has one vertex per position. Here a step has a separate change for each wedge
//! of its position, so that slots do not need to store their wedge.
//!
//! Cost: a slot is listed once for each vertex that it shows while its strip is drawn, even if the filter
//! would remove it; building is linear in that. Sending a level takes time linear in the strips of the
//! full mesh.

mod build;

use striata::model::{DrawCounts, LodModel, PartBytes, StepVertices, Topology};
use striata::strip::{RESTART, StripSet};

use super::repetitions::write_filtered;
use crate::paper_bytes::{Accounting, PaperBytes};

/// The static half of the model; see the [module](self).
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct OriginalLodStrips {
    vertices: StepVertices<'static>,
    strips: StripSet,
    /// Offset of the change of each vertex above the base, followed by the number of words.
    change_offsets: Vec<u32>,
    changes: Vec<u32>,
}

/// State of one instance: its level and its strips, all at full length.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct OriginalLodStripsState {
    split_count: usize,
    indices: Vec<u32>,
}

impl OriginalLodStrips {
    /// Number of strips, including those without triangles at coarse levels.
    pub fn strip_count(&self) -> usize {
        self.strips.strip_count()
    }

    /// Number of groups of triangles; strips never cross groups.
    pub fn group_count(&self) -> usize {
        self.strips.group_count()
    }

    /// Appends the indices that draw one group, with [`RESTART`] between strips.
    ///
    /// # Panics
    /// If the group does not exist.
    pub fn group_indices_into(&self, state: &OriginalLodStripsState, group: usize, out: &mut Vec<u32>) {
        self.strips_into(state, self.strips.group_strips(group), out);
    }

    fn strips_into(
        &self,
        state: &OriginalLodStripsState,
        strips: std::ops::Range<usize>,
        out: &mut Vec<u32>,
    ) {
        let mut is_first = true;
        for strip in strips {
            let indices = self.strip(state, strip);
            let before = out.len();
            if !is_first {
                out.push(RESTART);
            }
            let start = out.len();
            out.resize(start + indices.len(), 0);
            let length = write_filtered(indices.iter().copied(), &mut out[start..]);
            out.truncate(if length == 0 { before } else { start + length });
            is_first &= length == 0;
        }
    }

    /// The stored indices of a strip: at full length, with all repetitions.
    fn strip<'s>(&self, state: &'s OriginalLodStripsState, strip: usize) -> &'s [u32] {
        let offsets = self.strips.offsets();
        &state.indices[offsets[strip] as usize..offsets[strip + 1] as usize]
    }

    /// Writes the index `shown` to all slots that a vertex has while it is active.
    fn substitute(&self, indices: &mut [u32], vertex: u32, shown: u32) {
        let change = (vertex - self.vertices.base_vertex_count()) as usize;
        let [start, end] = [change, change + 1].map(|i| self.change_offsets[i] as usize);
        for record in StripRecords(&self.changes[start..end]) {
            let strip = &mut indices[self.strips.offsets()[record.strip as usize] as usize..];
            for &slot in record.slots {
                strip[slot as usize] = shown;
            }
        }
    }
}

/// The part of a change that affects one strip.
struct OriginalStripRecord<'m> {
    strip: u32,
    slots: &'m [u32],
}

/// Iterator over the records of a change.
struct StripRecords<'m>(&'m [u32]);

impl<'m> Iterator for StripRecords<'m> {
    type Item = OriginalStripRecord<'m>;

    #[inline]
    fn next(&mut self) -> Option<OriginalStripRecord<'m>> {
        let [strip, slot_count, rest @ ..] = self.0 else { return None };
        let (slots, rest) = rest.split_at_checked(*slot_count as usize)?;
        self.0 = rest;
        Some(OriginalStripRecord { strip: *strip, slots })
    }
}

impl LodModel for OriginalLodStrips {
    type State = OriginalLodStripsState;

    fn step_count(&self) -> usize {
        self.vertices.step_count()
    }

    fn new_state(&self) -> OriginalLodStripsState {
        OriginalLodStripsState { split_count: self.step_count(), indices: self.strips.indices().to_vec() }
    }

    fn split_count(&self, state: &OriginalLodStripsState) -> usize {
        state.split_count
    }

    fn move_to(&self, state: &mut OriginalLodStripsState, split_count: usize) {
        let step_count = self.step_count();
        assert!(split_count <= step_count, "split count {split_count} of {step_count}");
        assert_eq!(state.indices.len(), self.strips.indices().len(), "the state belongs to another model");
        while state.split_count > split_count {
            state.split_count -= 1;
            for vertex in self.vertices.of_step(state.split_count) {
                self.substitute(&mut state.indices, vertex, self.vertices.target(vertex));
            }
        }
        while state.split_count < split_count {
            for vertex in self.vertices.of_step(state.split_count) {
                self.substitute(&mut state.indices, vertex, vertex);
            }
            state.split_count += 1;
        }
    }

    fn topology(&self) -> Topology {
        Topology::Strips
    }

    fn draw_counts(&self, state: &OriginalLodStripsState) -> DrawCounts {
        let mut slot = Vec::new();
        let mut counts = DrawCounts::default();
        for strip in (0..self.strip_count()).map(|strip| self.strip(state, strip)) {
            slot.resize(slot.len().max(strip.len()), 0);
            let length = write_filtered(strip.iter().copied(), &mut slot);
            if length > 0 {
                counts.strip_count += 1;
                counts.index_count += length + 1;
            }
        }
        counts.index_count = counts.index_count.saturating_sub(1);
        counts
    }

    fn indices_into(&self, state: &OriginalLodStripsState, out: &mut Vec<u32>) {
        self.strips_into(state, 0..self.strip_count(), out);
    }

    fn bytes(&self) -> Vec<PartBytes> {
        let part = |name, words: usize| PartBytes { name, bytes: 4 * words };
        vec![
            part("strips", self.strips.indices().len()),
            part("strip offsets", self.strips.offsets().len() + self.strips.group_offsets().len()),
            part("targets", self.vertices.word_count()),
            part("change offsets", self.change_offsets.len()),
            part("changes", self.changes.len()),
        ]
    }

    fn state_bytes(&self, state: &OriginalLodStripsState) -> usize {
        4 * state.indices.len()
    }
}

impl PaperBytes for OriginalLodStrips {
    /// The structures of \[RCRG06\], its figure 3, without resizes: a `Collapse` per vertex, a pointer per
    /// strip, a two-word `Change` per step, a three-word `RecordChange` (strip, number of collapses,
    /// pointer) per strip that a step affects, and a word per slot.
    fn paper_bytes(&self, accounting: Accounting) -> usize {
        let record_count = StripRecords(&self.changes).count();
        // The strip and count of each record are already among the words of `changes`.
        let changes = self.step_count() + self.changes.len();
        let integers = self.vertices.vertex_count() + self.strips.indices().len() + changes;
        accounting.bytes(integers, self.strip_count() + self.step_count() + record_count)
    }
}
