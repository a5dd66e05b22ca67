//! LodStrips as first published \[RC04\]: strips of the full mesh in which each step substitutes indices.
//!
//! Each vertex has a change: for every strip that it stands in when it is collapsed, the places where. Coarsening
//! puts its target there, refining puts it back. Strips keep their full length, so that nothing ever moves; what
//! repeats in them is left out while they are sent to the GPU, as \[RCRG06\] tells of its forerunner.
//!
//! ```text
//! change of a vertex   strip, place count, places ... | strip, place count, places ... | ...
//! ```
//!
//! A strip whose last triangle is gone draws nothing, whatever stands in it: later changes leave it out. That
//! makes the changes of the bunny a third smaller.
//!
//! Differs: the publication has one vertex a position. Here a step has one change for each wedge of its position, so
//! that no place needs to say which wedge stands there.
//!
//! Cost: a place is listed once for each vertex that it shows while its strip is drawn, also where a filter would
//! leave it out; building is linear in that. Sending a level costs the length of the strips of the full mesh.

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
    /// Where the change of each vertex above the base begins, closed by the number of words.
    change_offsets: Vec<u32>,
    changes: Vec<u32>,
}

/// An instance: its level and its strips, all at full length.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct OriginalLodStripsState {
    split_count: usize,
    indices: Vec<u32>,
}

impl OriginalLodStrips {
    /// Strips, those without triangles at coarse levels counted.
    pub fn strip_count(&self) -> usize {
        self.strips.strip_count()
    }

    /// Groups of triangles; strips never cross them.
    pub fn group_count(&self) -> usize {
        self.strips.group_count()
    }

    /// Appends what draws one group, with [`RESTART`] between strips.
    ///
    /// # Panics
    /// If there is no such group.
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

    /// A strip as it is stored: at full length, with all its repetitions.
    fn strip<'s>(&self, state: &'s OriginalLodStripsState, strip: usize) -> &'s [u32] {
        let offsets = self.strips.offsets();
        &state.indices[offsets[strip] as usize..offsets[strip + 1] as usize]
    }

    /// Puts `shown` in all places that a vertex has while it is there.
    fn substitute(&self, indices: &mut [u32], vertex: u32, shown: u32) {
        let change = (vertex - self.vertices.base_vertex_count()) as usize;
        let [start, end] = [change, change + 1].map(|i| self.change_offsets[i] as usize);
        for record in Records(&self.changes[start..end]) {
            let strip = &mut indices[self.strips.offsets()[record.strip as usize] as usize..];
            for &place in record.places {
                strip[place as usize] = shown;
            }
        }
    }
}

/// What a change does to one strip.
struct Record<'m> {
    strip: u32,
    places: &'m [u32],
}

/// The records of a change.
struct Records<'m>(&'m [u32]);

impl<'m> Iterator for Records<'m> {
    type Item = Record<'m>;

    #[inline]
    fn next(&mut self) -> Option<Record<'m>> {
        let [strip, place_count, rest @ ..] = self.0 else { return None };
        let (places, rest) = rest.split_at_checked(*place_count as usize)?;
        self.0 = rest;
        Some(Record { strip: *strip, places })
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
    /// The structures of \[RCRG06\], its figure 3, without resizes: a `Collapse` for each vertex, a pointer for each
    /// strip, a `Change` of two words for each step, a `RecordChange` of three (strip, number of collapses, pointer)
    /// for each strip that it affects, and a word for each place.
    fn paper_bytes(&self, accounting: Accounting) -> usize {
        let record_count = Records(&self.changes).count();
        // A record's strip and number are among the words already.
        let changes = self.step_count() + self.changes.len();
        let integers = self.vertices.vertex_count() + self.strips.indices().len() + changes;
        accounting.bytes(integers, self.strip_count() + self.step_count() + record_count)
    }
}
