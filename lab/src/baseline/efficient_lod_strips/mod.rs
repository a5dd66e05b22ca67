//! LodStrips as published in \[RCRG06\]: the structures of its figure 3, word for word.
//!
//! Each vertex stores the vertex that it collapses to, and each vertex has a change: the strips that it
//! affects, and for each of them the positions where a vertex is replaced and the positions where a
//! repetition is removed. Only the two patterns of the paper are removed, `aa(a)+` and `ab(ab)+`.
//!
//! ```text
//! Change         number of strips, first record
//! RecordChange   strip, number of collapses, number of resizes, first position
//! data           positions of the collapses | positions of the resizes | ...
//! ```
//!
//! An instance has the strips twice (section 6.2): `hwStrips`, which changes edit, and `disStrips`, which
//! are drawn. After a move, each strip that has been edited is copied from one to the other.
//!
//! Differs: indices instead of pointers. By default, repetitions `aa(a)+` are removed in pairs, because an
//! odd number flips the rest of the strip; [`Winding::Lost`] follows the paper. A position with several
//! vertices (wedges) has a change for each. Strips whose last triangle has vanished are not drawn, and
//! later changes leave them out.
//!
//! [`LodStrips`](striata::model::LodStrips) implements the same idea in fewer bytes.
//!
//! Cost: a step replaces about three indices and moves the ends of the strips that lose some; the copies
//! add the lengths of these strips. Building scans the strips that a step affects.

mod build;
mod resizes;

pub use resizes::Winding;

use striata::model::{DrawCounts, LodModel, PartBytes, StepVertices, Topology, join_strips};
use striata::strip::StripSet;

use self::resizes::has_triangle;
use crate::paper_bytes::{Accounting, PaperBytes};

/// Range of the records of a collapse: one record for each strip that it changes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct VertexChange {
    record_count: u32,
    first_record: u32,
}

/// Changes of a collapse to one strip: the numbers of positions to edit, and the first of them in the data.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct RecordChange {
    strip: u32,
    collapse_count: u32,
    resize_count: u32,
    /// The first position, of the collapses and then of the resizes.
    data: u32,
}

/// The static half of the model; see the [module](self).
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct EfficientLodStrips {
    /// The vertices of each step, without targets.
    vertices: StepVertices<'static>,
    /// The vertex that each vertex collapses to; vertices of the base refer to themselves.
    collapses: Vec<u32>,
    strips: StripSet,
    winding: Winding,
    /// The change of each vertex above the base.
    changes: Vec<VertexChange>,
    records: Vec<RecordChange>,
    data: Vec<u32>,
}

/// State of one instance: its level and its strips.
#[derive(Clone, Debug)]
pub struct EfficientLodStripsState {
    split_count: usize,
    /// Strips at the current level, each in room for its full length.
    hw_strips: Vec<u32>,
    hw_lengths: Vec<u32>,
    /// The strips that are drawn, in the same form; a strip without triangles has no length.
    dis_strips: Vec<u32>,
    dis_lengths: Vec<u32>,
    is_dirty: Vec<bool>,
    dirty: Vec<u32>,
}

/// The drawn strips follow from the others. Their slots beyond what is drawn hold whatever was drawn before.
impl PartialEq for EfficientLodStripsState {
    fn eq(&self, other: &Self) -> bool {
        self.split_count == other.split_count
            && self.hw_strips == other.hw_strips
            && self.hw_lengths == other.hw_lengths
            && self.dis_lengths == other.dis_lengths
    }
}

impl Eq for EfficientLodStripsState {}

impl EfficientLodStrips {
    /// Number of strips, including those without triangles at coarse levels.
    pub fn strip_count(&self) -> usize {
        self.strips.strip_count()
    }

    /// Number of groups of triangles; strips never cross groups.
    pub fn group_count(&self) -> usize {
        self.strips.group_count()
    }

    /// Number of collapses and resizes in all changes.
    pub fn edit_counts(&self) -> [usize; 2] {
        let sum = |count: fn(&RecordChange) -> u32| self.records.iter().map(|r| count(r) as usize).sum();
        [sum(|r| r.collapse_count), sum(|r| r.resize_count)]
    }

    /// Returns the drawn indices of a strip; empty once all its triangles have vanished.
    ///
    /// # Panics
    /// If the strip does not exist.
    pub fn strip<'s>(&self, state: &'s EfficientLodStripsState, strip: usize) -> &'s [u32] {
        let first = self.strips.offsets()[strip] as usize;
        &state.dis_strips[first..first + state.dis_lengths[strip] as usize]
    }

    /// Appends the indices that draw one group, with [`RESTART`](striata::strip::RESTART) between strips.
    ///
    /// # Panics
    /// If the group does not exist.
    pub fn group_indices_into(&self, state: &EfficientLodStripsState, group: usize, out: &mut Vec<u32>) {
        join_strips(self.strips.group_strips(group).map(|strip| self.strip(state, strip)), out);
    }

    /// Calls `edit` with each strip that the change of a vertex affects: its record and its positions.
    #[inline]
    fn for_each_record(&self, vertex: u32, mut edit: impl FnMut(&RecordChange, &[u32], &[u32])) {
        let VertexChange { record_count, first_record } =
            self.changes[(vertex - self.vertices.base_vertex_count()) as usize];
        let first = first_record as usize;
        for record in &self.records[first..first + record_count as usize] {
            let data = &self.data[record.data as usize..];
            let (collapses, data) = data.split_at(record.collapse_count as usize);
            edit(record, collapses, &data[..record.resize_count as usize]);
        }
    }

    /// Collapses a vertex: replaces it, then removes repetitions.
    fn collapse(&self, state: &mut EfficientLodStripsState, vertex: u32) {
        let target = self.collapses[vertex as usize];
        self.for_each_record(vertex, |record, collapses, resizes| {
            let (slots, length) = state.edited(self, record.strip as usize);
            for &position in collapses {
                slots[position as usize] = target;
            }
            for &position in resizes {
                *length = self.winding.apply(slots, *length as usize, position as usize) as u32;
            }
        });
    }

    /// Splits a vertex off its target: undoes the change in reverse order.
    fn split(&self, state: &mut EfficientLodStripsState, vertex: u32) {
        self.for_each_record(vertex, |record, collapses, resizes| {
            let (slots, length) = state.edited(self, record.strip as usize);
            for &position in resizes.iter().rev() {
                *length = self.winding.undo(slots, *length as usize, position as usize) as u32;
            }
            for &position in collapses {
                slots[position as usize] = vertex;
            }
        });
    }
}

impl EfficientLodStripsState {
    /// Marks a strip as dirty and returns its slots and its length.
    #[inline]
    fn edited(&mut self, model: &EfficientLodStrips, strip: usize) -> (&mut [u32], &mut u32) {
        if !std::mem::replace(&mut self.is_dirty[strip], true) {
            self.dirty.push(strip as u32);
        }
        let offsets = model.strips.offsets();
        let slots = offsets[strip] as usize..offsets[strip + 1] as usize;
        (&mut self.hw_strips[slots], &mut self.hw_lengths[strip])
    }

    /// Copies the strips that have been edited to those that are drawn.
    fn display(&mut self, model: &EfficientLodStrips) {
        for strip in self.dirty.drain(..) {
            let strip = strip as usize;
            let first = model.strips.offsets()[strip] as usize;
            let edited = &self.hw_strips[first..first + self.hw_lengths[strip] as usize];
            let shown = if has_triangle(edited) { edited } else { &[] };
            self.dis_strips[first..first + shown.len()].copy_from_slice(shown);
            self.dis_lengths[strip] = shown.len() as u32;
            self.is_dirty[strip] = false;
        }
    }
}

impl LodModel for EfficientLodStrips {
    type State = EfficientLodStripsState;

    fn step_count(&self) -> usize {
        self.vertices.step_count()
    }

    fn new_state(&self) -> EfficientLodStripsState {
        let lengths: Vec<u32> = self.strips.strips().map(|strip| strip.len() as u32).collect();
        let strip_count = lengths.len();
        let mut state = EfficientLodStripsState {
            split_count: self.step_count(),
            hw_strips: self.strips.indices().to_vec(),
            hw_lengths: lengths.clone(),
            dis_strips: self.strips.indices().to_vec(),
            dis_lengths: lengths,
            is_dirty: vec![true; strip_count],
            dirty: (0..strip_count as u32).collect(),
        };
        state.display(self);
        state
    }

    fn split_count(&self, state: &EfficientLodStripsState) -> usize {
        state.split_count
    }

    fn move_to(&self, state: &mut EfficientLodStripsState, split_count: usize) {
        let step_count = self.step_count();
        assert!(split_count <= step_count, "split count {split_count} of {step_count}");
        assert_eq!(state.hw_strips.len(), self.strips.indices().len(), "the state belongs to another model");
        while state.split_count > split_count {
            state.split_count -= 1;
            for vertex in self.vertices.of_step(state.split_count).rev() {
                self.collapse(state, vertex);
            }
        }
        while state.split_count < split_count {
            for vertex in self.vertices.of_step(state.split_count) {
                self.split(state, vertex);
            }
            state.split_count += 1;
        }
        state.display(self);
    }

    fn topology(&self) -> Topology {
        Topology::Strips
    }

    fn draw_counts(&self, state: &EfficientLodStripsState) -> DrawCounts {
        DrawCounts::of_strips((0..self.strip_count()).map(|strip| self.strip(state, strip)))
    }

    fn indices_into(&self, state: &EfficientLodStripsState, out: &mut Vec<u32>) {
        join_strips((0..self.strip_count()).map(|strip| self.strip(state, strip)), out);
    }

    fn bytes(&self) -> Vec<PartBytes> {
        let part = |name, bytes| PartBytes { name, bytes };
        let strip_words =
            self.strips.indices().len() + self.strips.offsets().len() + self.strips.group_offsets().len();
        vec![
            part("strips", 4 * strip_words),
            part("collapses", 4 * (self.collapses.len() + self.vertices.word_count())),
            part("changes", size_of_val(&self.changes[..])),
            part("records", size_of_val(&self.records[..])),
            part("positions", 4 * self.data.len()),
        ]
    }

    fn state_bytes(&self, state: &EfficientLodStripsState) -> usize {
        let words = state.hw_strips.len() + state.hw_lengths.len();
        8 * words + state.is_dirty.len() + 4 * state.dirty.capacity()
    }
}

impl PaperBytes for EfficientLodStrips {
    /// Figure 3 of \[RCRG06\]: a `Collapse` per vertex, a pointer per strip, a two-word `Change` per vertex
    /// that collapses, a four-word `RecordChange` per strip that it affects, and a word per position.
    fn paper_bytes(&self, accounting: Accounting) -> usize {
        let records = 3 * self.records.len() + self.data.len();
        let integers = self.collapses.len() + self.strips.indices().len() + self.changes.len() + records;
        accounting.bytes(integers, self.strip_count() + self.changes.len() + self.records.len())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use striata::mesh::{CollapseSequence, IndexedMesh, PositionIndex, RefinableMesh, SequenceParts};

    /// The strip of figure 4. The paper numbers vertices in the order of their collapse, and this library
    /// in the opposite order.
    const PAPER_STRIP: [u32; 6] = [0, 2, 3, 1, 5, 4];

    fn ours(vertex: u32) -> u32 {
        5 - vertex
    }

    /// The strip of figure 4, whose vertex 0 collapses to 3. The transcript of the figure ends there; then
    /// 1 collapses to 5, and 2 to 3.
    fn example(winding: Winding) -> EfficientLodStrips {
        let positions = (0..6).map(|i| [i as f32, (i % 2) as f32, (i * i) as f32]).collect();
        let triangles = [[0, 2, 3], [3, 2, 1], [3, 1, 5], [5, 1, 4]].map(|t: [u32; 3]| t.map(ours));
        let sequence = CollapseSequence::from_parts(SequenceParts {
            positions: PositionIndex::identity(6),
            base_position_count: 3,
            targets: [3, 5, 3].map(ours).into_iter().rev().collect(),
            errors: vec![3.0, 2.0, 1.0],
            removed_triangle_counts: vec![1, 2, 1],
            triangle_count: 4,
        })
        .unwrap();
        let refinable = RefinableMesh { mesh: IndexedMesh::new(positions, triangles.to_vec()), sequence };
        let mut strips = StripSet::new();
        strips.push(&PAPER_STRIP.map(ours));
        strips.end_group();
        EfficientLodStrips::build(&refinable, &strips, winding).unwrap()
    }

    #[test]
    fn worked_example_of_figure_4() {
        let model = example(Winding::Lost);
        let mut state = model.new_state();
        model.move_to(&mut state, 2);
        // "we collapse vertex 0 to vertex 3, the result is the strip 3 2 3 1 5 4".
        assert_eq!(model.strip(&state, 0), [3, 2, 3, 1, 5, 4].map(ours));
        // "1 strip affected by this collapse", strip 0, "only 1 collapse and 0 resizes", and "the position
        // where the collapse takes place in the strip, that is 0".
        let change = model.changes[2];
        assert_eq!(change.record_count, 1);
        let record = model.records[change.first_record as usize];
        assert_eq!((record.strip, record.collapse_count, record.resize_count), (0, 1, 0));
        assert_eq!(model.data[record.data as usize], 0);
        assert_eq!(model.collapses[ours(0) as usize], ours(3));
    }

    #[test]
    fn worked_example_goes_on_with_resizes_and_back() {
        let model = example(Winding::Lost);
        let mut state = model.new_state();
        let levels: [&[u32]; 4] =
            [&[0, 2, 3, 1, 5, 4], &[3, 2, 3, 1, 5, 4], &[3, 2, 3, 5, 5, 4], &[3, 3, 5, 5, 4]];
        let down = (0..4).rev().map(|split_count| (split_count, levels[3 - split_count]));
        let up = (0..4).map(|split_count| (split_count, levels[3 - split_count]));
        for (split_count, expected) in down.chain(up) {
            model.move_to(&mut state, split_count);
            let strip: Vec<u32> =
                state.hw_strips[..state.hw_lengths[0] as usize].iter().map(|&v| ours(v)).collect();
            assert_eq!(strip, expected, "split count {split_count}");
        }
        // 3 3 3 loses its third index, at position 2.
        let record = model.records[model.changes[0].first_record as usize];
        assert_eq!((record.collapse_count, record.resize_count), (1, 1));
        assert_eq!(model.data[record.data as usize..][..2], [1, 2]);
    }
}
