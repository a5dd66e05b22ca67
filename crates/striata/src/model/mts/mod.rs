//! MTS, multiresolution triangle strips \[BRR02\], without what the paper stores twice, and with coherence.
//!
//! Each strip with all its levels is a graph: a column for each place of the strip at full detail, and for each
//! column a row of arcs, which say what comes next and down to which level. Recovery enters at the first beginning
//! that reaches the level and follows, from place to place, the first arc that reaches it. Strips are
//! independent, so a change of level walks only those that it changes.
//!
//! ```text
//! places   0  1  2  3  4  5  6  7  8  9     an empty row: the next place, for as long as this one is there
//! row of 2    -> 3 (res 4), -> 6 (rest)     down to the fourth change of the strip 3 follows, then 6
//! row of 6    -> 7 (res 9), break -> 9      later the strip ends here, and another begins at 9
//! ```
//!
//! Differs: [`MtsGraph`] is the model as published; its columns are vertices, so each collapse brings a new column and
//! new arcs into every strip that it touches. A column here is a place. What vertex it shows is no matter of the
//! strip: it is the first of the vertex's chain of targets that the level has, and those are stored once for
//! all strips. What is left to store is where places are dropped. `res` counts the changes of the strip and not
//! levels of the mesh, and fits 16 bits; which strips a step changes is a record of a few bytes. A place is
//! passed once, so no row must remember how far it was read, and the special node -1 (the next strip begins with
//! the same vertex) is a break to a place that shows it.
//!
//! Cost: a step walks two or three strips, of [`MAX_STRIP_INDICES`] places at most; recovery of a whole level is
//! linear in what it shows. Building is linear in the steps times [`MAX_STRIP_INDICES`].

mod arcs;
mod build;
pub mod graph;
mod state;
mod validate;

use std::borrow::Cow;

pub use graph::{MtsGraph, MtsGraphState};
pub use state::MtsState;

pub use super::lod_strips::MAX_STRIP_INDICES;
use super::step_vertices::StepVertices;
use super::{DrawCounts, LodModel, ModelError, PartBytes, StripModel, Topology, join_strips};
use crate::strip::RESTART;

/// The static half of the model; see the [module](self).
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Mts<'a> {
    pub(crate) vertices: StepVertices<'a>,
    pub(crate) parts: MtsParts<'a>,
    /// Bytes of the first strip number in a record, from the strip count.
    head_bytes: usize,
}

/// The stored arrays of a model, without what the sequence knows already.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct MtsParts<'a> {
    /// Vertex of each place at full detail.
    pub(crate) indices: Cow<'a, [u32]>,
    /// First place of each strip, closed by their number.
    pub(crate) offsets: Cow<'a, [u32]>,
    pub(crate) group_offsets: Cow<'a, [u32]>,
    /// First arc of each strip, closed by their number.
    pub(crate) arc_offsets: Cow<'a, [u32]>,
    /// For each strip where the rows of its beginnings and of its places start among its arcs: two more than it has
    /// places.
    pub(crate) rows: Cow<'a, [u16]>,
    /// See [`arcs`].
    pub(crate) arcs: Cow<'a, [u32]>,
    /// Bytes of each step's record, as in LodStrips.
    pub(crate) record_lengths: Cow<'a, [u8]>,
    /// For each step the strips that it changes.
    pub(crate) arena: Cow<'a, [u8]>,
}

impl<'a> Mts<'a> {
    /// Puts stored arrays together and walks every strip at each of its changes once, so that no later step can fail.
    pub(crate) fn from_parts(vertices: StepVertices<'a>, parts: MtsParts<'a>) -> Result<Self, ModelError> {
        let model = Self::unchecked(vertices, parts);
        validate::check(&model)?;
        Ok(model)
    }

    fn unchecked(vertices: StepVertices<'a>, parts: MtsParts<'a>) -> Self {
        let head_bytes = super::record_arena::head_bytes(parts.offsets.len().saturating_sub(1), 1);
        Self { vertices, parts, head_bytes }
    }

    /// Vertex of each place at full detail, strip after strip.
    pub fn indices(&self) -> &[u32] {
        &self.parts.indices
    }

    /// Walks every strip of an instance at its level, as the published model does at each change of level.
    ///
    /// # Panics
    /// If the state belongs to a model of another shape.
    pub fn recover(&self, state: &mut MtsState) {
        state.recover(self);
    }

    /// The same model with arrays of its own.
    pub fn into_owned(self) -> Mts<'static> {
        let parts = self.parts;
        Mts {
            vertices: self.vertices.into_owned(),
            parts: MtsParts {
                indices: parts.indices.into_owned().into(),
                offsets: parts.offsets.into_owned().into(),
                group_offsets: parts.group_offsets.into_owned().into(),
                arc_offsets: parts.arc_offsets.into_owned().into(),
                rows: parts.rows.into_owned().into(),
                arcs: parts.arcs.into_owned().into(),
                record_lengths: parts.record_lengths.into_owned().into(),
                arena: parts.arena.into_owned().into(),
            },
            head_bytes: self.head_bytes,
        }
    }

    fn live_strips<'s>(&self, state: &'s MtsState) -> impl Iterator<Item = &'s [u32]> {
        (0..self.strip_count()).map(|strip| state.live(strip))
    }
}

impl LodModel for Mts<'_> {
    type State = MtsState;

    fn step_count(&self) -> usize {
        self.parts.record_lengths.len()
    }

    fn new_state(&self) -> MtsState {
        MtsState::new(self)
    }

    fn split_count(&self, state: &MtsState) -> usize {
        state.split_count()
    }

    fn move_to(&self, state: &mut MtsState, split_count: usize) {
        state.move_to(self, split_count);
    }

    fn topology(&self) -> Topology {
        Topology::Strips
    }

    fn draw_counts(&self, state: &MtsState) -> DrawCounts {
        let mut counts = DrawCounts::of_strips(self.live_strips(state));
        counts.strip_count += self.live_strips(state).flatten().filter(|&&index| index == RESTART).count();
        counts
    }

    fn indices_into(&self, state: &MtsState, out: &mut Vec<u32>) {
        join_strips(self.live_strips(state), out);
    }

    fn bytes(&self) -> Vec<PartBytes> {
        let part = |name, bytes| PartBytes { name, bytes };
        let MtsParts { indices, offsets, group_offsets, arc_offsets, rows, arcs, record_lengths, arena } =
            &self.parts;
        vec![
            part("strips", 4 * indices.len()),
            part("strip offsets", 4 * (offsets.len() + group_offsets.len() + arc_offsets.len())),
            part("targets", 4 * (self.vertices.targets.len() + self.vertices.firsts.len())),
            part("rows", 2 * rows.len()),
            part("arcs", 4 * arcs.len()),
            part("changed strips", record_lengths.len() + arena.len()),
        ]
    }

    fn state_bytes(&self, state: &MtsState) -> usize {
        state.bytes()
    }

    /// Listing 1 of \[BRR02\] for these graphs: three words a column, two an arc (one where a row is empty) or a
    /// beginning, two a strip; and a word for each target and each change of a strip, which coherence needs.
    fn paper_bytes(&self) -> usize {
        let parts = &self.parts;
        let arcs = parts.arcs.len() + parts.indices.len();
        let changes = self.vertices.targets.len() + self.change_count();
        12 * parts.indices.len() + 8 * arcs + 8 * self.strip_count() + 4 * changes
    }
}

impl StripModel for Mts<'_> {
    fn vertex_count(&self) -> usize {
        self.vertices.vertex_count
    }

    fn vertex_count_at(&self, split_count: usize) -> usize {
        self.vertices.count_at(split_count)
    }

    fn group_offsets(&self) -> &[u32] {
        &self.parts.group_offsets
    }

    fn strip<'s>(&self, state: &'s MtsState, strip: usize) -> &'s [u32] {
        state.live(strip)
    }
}
