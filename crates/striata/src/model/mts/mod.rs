//! MTS, multiresolution triangle strips \[BRR02\], without what the paper stores twice, and with coherence.
//!
//! Each strip is stored at full detail, and with each of its places how many changes of the strip the place outlives. At
//! any level the strip is what is left of its places, in their order, each showing the first vertex in its chain of
//! targets that the level has. Strips are independent, so a change of level walks only those that it changes.
//!
//! ```text
//! places       0   1   2   3   4   5   6   7   8   9   10  11  12
//! last change  2   2   255 255 255 3   3   3   255 255 255 0   0
//! break        before 8, from change 4 on
//! shown        after one change 0 .. 10, after three 2 .. 10, after four 2 3 4 | 8 9 10
//! ```
//!
//! Differs: the published model is a graph of the strip's vertices whose arcs say which comes next and
//! down to which level (`res`); each collapse brings a new column and new arcs into every strip that it touches. Here
//! a column is a place of the strip. What vertex it shows is no matter of the strip: chains of targets are stored
//! once for all strips. Places keep their order, so where an arc leads and how far it reaches follows from how long
//! the places between are there: of row and arcs one `res` for each column is left. It counts the changes of the strip
//! and not levels of the mesh, and fits a byte; which strips a step changes is a record of a few bytes. The special
//! nodes -1 and -2 are breaks, -3 is the end of the places.
//!
//! Cost: a step walks two or three strips, of [`MAX_STRIP_INDICES`] places at most; recovery of a whole level is
//! linear in the places. Building is linear in the steps times [`MAX_STRIP_INDICES`].

mod build;
mod state;
mod validate;

use std::borrow::Cow;

pub use state::MtsState;

pub use super::lod_strips::MAX_STRIP_INDICES;
use super::step_vertices::StepVertices;
use super::{
    DrawCounts, LodModel, ModelError, PartBytes, StoredModel, StripModel, Topology, join_strips,
    strips_of_group_into,
};
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
    /// For each place the last change of its strip after which it is still there; 255 if it never goes.
    pub(crate) lasts: Cow<'a, [u8]>,
    /// First break of each strip, closed by their number.
    pub(crate) break_offsets: Cow<'a, [u32]>,
    /// Breaks by rising place: the place of its strip before which one is, and the change from which on.
    pub(crate) breaks: Cow<'a, [[u8; 2]]>,
    /// Bytes of each step's record, as in LodStrips.
    pub(crate) record_lengths: Cow<'a, [u8]>,
    /// For each step the strips that it changes.
    pub(crate) arena: Cow<'a, [u8]>,
}

impl<'a> Mts<'a> {
    /// Puts stored arrays together and checks them once, so that no later step can fail.
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

    /// Breaks between pieces of strips, over all levels.
    pub fn break_count(&self) -> usize {
        self.parts.breaks.len()
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
                lasts: parts.lasts.into_owned().into(),
                break_offsets: parts.break_offsets.into_owned().into(),
                breaks: parts.breaks.into_owned().into(),
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
        let MtsParts { indices, offsets, group_offsets, lasts, break_offsets, breaks, record_lengths, arena } =
            &self.parts;
        vec![
            part("strips", 4 * indices.len()),
            part("strip offsets", 4 * (offsets.len() + group_offsets.len())),
            part("targets", 4 * (self.vertices.targets.len() + self.vertices.firsts.len())),
            part("last changes", lasts.len()),
            part("breaks", 4 * break_offsets.len() + 2 * breaks.len()),
            part("changed strips", record_lengths.len() + arena.len()),
        ]
    }

    fn state_bytes(&self, state: &MtsState) -> usize {
        state.bytes()
    }
}

impl StoredModel for Mts<'_> {
    fn step_vertices(&self) -> &StepVertices<'_> {
        &self.vertices
    }

    fn group_count(&self) -> usize {
        self.group_offsets().len().saturating_sub(1)
    }

    fn group_triangles_into(&self, state: &MtsState, group: usize, out: &mut Vec<[u32; 3]>) {
        strips_of_group_into(self, state, group, out);
    }
}

impl StripModel for Mts<'_> {
    fn group_offsets(&self) -> &[u32] {
        &self.parts.group_offsets
    }

    fn strip<'s>(&self, state: &'s MtsState, strip: usize) -> &'s [u32] {
        state.live(strip)
    }
}
