//! MTS, multiresolution triangle strips \[BRR02\], in a compact form that also exploits coherence between
//! levels.
//!
//! Each strip is stored once, at full detail. For every slot we also store the last change of the strip
//! that the slot survives. At any level, the strip consists of the surviving slots in their original
//! order, and each slot shows the first vertex in its chain of targets that exists at the level. Strips
//! are independent of each other, so a change of level rebuilds only the strips that it affects.
//!
//! ```text
//! slot         0   1   2   3   4   5   6   7   8   9   10  11  12
//! last change  2   2   255 255 255 3   3   3   255 255 255 0   0
//! break        before 8, from change 4 on
//! result       after change 1: 0 .. 10, after change 3: 2 .. 10, after change 4: 2 3 4 | 8 9 10
//! ```
//!
//! Differs: the published model is a graph over the strip's vertices whose arcs store the next vertex and
//! the coarsest level at which the arc is used (`res`); each collapse adds a column and new arcs to every
//! strip that it touches. Here a column becomes a slot of the strip. The strip does not store which vertex
//! a slot currently shows; chains of targets are shared by all strips. Slots keep their order, so the
//! target and range of an arc follow from the lifetimes of the slots in between: of rows and arcs, only
//! one `res` per column remains. It counts changes of the strip rather than levels of the mesh, so it fits
//! into a byte; a record of a few bytes lists the strips that a step changes. The special nodes -1 and -2
//! of the paper are our breaks, and -3 is the end of the slots.
//!
//! Cost: a step rebuilds two or three strips of at most [`MAX_STRIP_INDICES`] slots; recovering a whole
//! level is linear in the number of slots. Building takes time linear in the number of steps times
//! [`MAX_STRIP_INDICES`].

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

/// The static half of the model, shared by all instances; see the [module](self).
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Mts<'a> {
    pub(crate) vertices: StepVertices<'a>,
    pub(crate) parts: MtsParts<'a>,
    /// Size of the first strip index of a record in bytes, derived from the strip count.
    head_bytes: usize,
}

/// The stored arrays of a model, except for those that come from the sequence.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct MtsParts<'a> {
    /// Vertex of each slot at full detail.
    pub(crate) indices: Cow<'a, [u32]>,
    /// First slot of each strip, followed by the slot count.
    pub(crate) offsets: Cow<'a, [u32]>,
    pub(crate) group_offsets: Cow<'a, [u32]>,
    /// For each slot, the last change of its strip that it survives; 255 if it is never dropped.
    pub(crate) lasts: Cow<'a, [u8]>,
    /// First break of each strip, followed by the break count.
    pub(crate) break_offsets: Cow<'a, [u32]>,
    /// Breaks in ascending slot order: the slot before which the strip breaks, and the change since which
    /// it does.
    pub(crate) breaks: Cow<'a, [[u8; 2]]>,
    /// Size of each step's record in bytes, as in LodStrips.
    pub(crate) record_lengths: Cow<'a, [u8]>,
    /// For each step, the strips that it changes.
    pub(crate) arena: Cow<'a, [u8]>,
}

impl<'a> Mts<'a> {
    /// Assembles a model from stored arrays and validates them, so that no later move can fail.
    pub(crate) fn from_parts(vertices: StepVertices<'a>, parts: MtsParts<'a>) -> Result<Self, ModelError> {
        let model = Self::unchecked(vertices, parts);
        validate::check(&model)?;
        Ok(model)
    }

    fn unchecked(vertices: StepVertices<'a>, parts: MtsParts<'a>) -> Self {
        let head_bytes = super::record_arena::head_bytes(parts.offsets.len().saturating_sub(1), 1);
        Self { vertices, parts, head_bytes }
    }

    /// Returns the vertex of each slot at full detail, strip by strip.
    pub fn indices(&self) -> &[u32] {
        &self.parts.indices
    }

    /// Number of breaks between pieces of strips, over all levels.
    pub fn break_count(&self) -> usize {
        self.parts.breaks.len()
    }

    /// Rebuilds every strip of an instance at its level, as the published model does whenever the level
    /// changes.
    ///
    /// # Panics
    /// If the state belongs to a model of a different shape.
    pub fn recover(&self, state: &mut MtsState) {
        state.recover(self);
    }

    /// Returns a copy that owns its arrays.
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
        let parts = &self.parts;
        vec![
            part("strips", 4 * parts.indices.len()),
            part("strip offsets", 4 * (parts.offsets.len() + parts.group_offsets.len())),
            part("targets", 4 * (self.vertices.targets.len() + self.vertices.firsts.len())),
            part("last changes", parts.lasts.len()),
            part("breaks", 4 * parts.break_offsets.len() + 2 * parts.breaks.len()),
            part("changed strips", parts.record_lengths.len() + parts.arena.len()),
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
