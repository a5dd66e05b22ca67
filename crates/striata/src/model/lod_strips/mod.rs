//! LodStrips: triangle strips that are edited in place to follow a collapse sequence \[RCRG06\].
//!
//! The strips of the full mesh are stored once. Each step of the sequence has a record that lists where
//! its vertices occur in the strips. Coarsening replaces these vertices by their targets and drops indices
//! that have become superfluous; refining undoes both. Changing the level costs only the records between
//! the two levels.
//!
//! ```text
//! slots of a strip   | live indices .......... | dropped indices, the last dropped first |
//!                    0                      length                             full length
//! ```
//!
//! Dropping a run rotates it behind the live indices, where it stays until refining rotates it back. A
//! record therefore contains only indices, no vertices, and refining is an exact inverse by construction.
//! A run is dropped if the strip shows the same triangles without it (see `superfluous.rs`).
//!
//! Differs: \[RCRG06\] drops only `aa(a)+` and `ab(ab)+` and stores machine words. Here a record is a few
//! bytes in one arena that can be walked in both directions; strips are sorted along a space-filling
//! curve, so that the gaps between strip indices are small.
//!
//! Cost: a step replaces about three indices in two or three strips. Building takes time linear in the
//! number of steps times [`MAX_STRIP_INDICES`].

mod build;
mod record;
mod state;
mod strip_buffer;
mod validate;

use std::borrow::Cow;

pub use record::EditCounts;
pub use state::LodStripsState;
pub use strip_buffer::StripBuffer;

use super::record_arena::{head_bytes, record_at};
use super::step_vertices::StepVertices;
use super::{
    DrawCounts, LodModel, ModelError, PartBytes, StoredModel, StripModel, Topology, join_strips,
    strips_of_group_into,
};

/// Longest strip of a model. Longer strips are cut when the model is built, so that an edit moves few
/// indices.
pub const MAX_STRIP_INDICES: usize = 128;

/// The static half of the model, shared by all instances; see the [module](self).
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LodStrips<'a> {
    pub(crate) vertices: StepVertices<'a>,
    pub(crate) indices: Cow<'a, [u32]>,
    pub(crate) offsets: Cow<'a, [u32]>,
    pub(crate) group_offsets: Cow<'a, [u32]>,
    /// Size of each step's record in bytes; 255 means that the record stores its own length at both ends.
    pub(crate) record_lengths: Cow<'a, [u8]>,
    pub(crate) arena: Cow<'a, [u8]>,
    /// Size of the first strip index of a record in bytes, derived from the strip count.
    head_bytes: usize,
}

/// The stored arrays of a model, except for those that come from the sequence.
pub(crate) struct LodStripsParts<'a> {
    pub(crate) indices: Cow<'a, [u32]>,
    pub(crate) offsets: Cow<'a, [u32]>,
    pub(crate) group_offsets: Cow<'a, [u32]>,
    pub(crate) record_lengths: Cow<'a, [u8]>,
    pub(crate) arena: Cow<'a, [u8]>,
}

impl<'a> LodStrips<'a> {
    /// Assembles a model from stored arrays and validates every record, so that no later move can fail.
    pub(crate) fn from_parts(
        vertices: StepVertices<'a>,
        parts: LodStripsParts<'a>,
    ) -> Result<Self, ModelError> {
        let model = Self::unchecked(vertices, parts);
        validate::check(&model)?;
        Ok(model)
    }

    fn unchecked(vertices: StepVertices<'a>, parts: LodStripsParts<'a>) -> Self {
        let LodStripsParts { indices, offsets, group_offsets, record_lengths, arena } = parts;
        let head_bytes = head_bytes(offsets.len().saturating_sub(1), record::FLAG_BITS);
        Self { vertices, indices, offsets, group_offsets, record_lengths, arena, head_bytes }
    }

    /// Returns a copy that owns its arrays.
    pub fn into_owned(self) -> LodStrips<'static> {
        LodStrips {
            vertices: self.vertices.into_owned(),
            indices: self.indices.into_owned().into(),
            offsets: self.offsets.into_owned().into(),
            group_offsets: self.group_offsets.into_owned().into(),
            record_lengths: self.record_lengths.into_owned().into(),
            arena: self.arena.into_owned().into(),
            head_bytes: self.head_bytes,
        }
    }

    /// Returns the strips of the full mesh, one after the other.
    pub fn indices(&self) -> &[u32] {
        &self.indices
    }

    /// Counts the edits of all records.
    pub fn edit_counts(&self) -> EditCounts {
        let mut counts = EditCounts::default();
        let mut cursor = 0;
        for (step, &length) in self.record_lengths.iter().enumerate() {
            let Some((body, end)) = record_at(&self.arena, cursor, length) else { break };
            cursor = end;
            let vertices = self.vertices.of_step(step);
            let counted = counts.add(body, self.head_bytes, vertices.end - vertices.start);
            debug_assert!(counted.is_some(), "a checked record ended early");
        }
        counts
    }
}

impl LodModel for LodStrips<'_> {
    type State = LodStripsState;

    fn step_count(&self) -> usize {
        self.record_lengths.len()
    }

    fn new_state(&self) -> LodStripsState {
        LodStripsState::new(self)
    }

    fn split_count(&self, state: &LodStripsState) -> usize {
        state.split_count()
    }

    fn move_to(&self, state: &mut LodStripsState, split_count: usize) {
        state.move_to(self, split_count);
    }

    fn topology(&self) -> Topology {
        Topology::Strips
    }

    fn draw_counts(&self, state: &LodStripsState) -> DrawCounts {
        DrawCounts::of_strips((0..self.strip_count()).map(|strip| self.strip(state, strip)))
    }

    fn indices_into(&self, state: &LodStripsState, out: &mut Vec<u32>) {
        join_strips((0..self.strip_count()).map(|strip| self.strip(state, strip)), out);
    }

    fn bytes(&self) -> Vec<PartBytes> {
        let part = |name, bytes| PartBytes { name, bytes };
        vec![
            part("strips", 4 * self.indices.len()),
            part("strip offsets", 4 * (self.offsets.len() + self.group_offsets.len())),
            part("targets", 4 * (self.vertices.targets.len() + self.vertices.firsts.len())),
            part("record lengths", self.record_lengths.len()),
            part("records", self.arena.len()),
        ]
    }

    fn state_bytes(&self, state: &LodStripsState) -> usize {
        state.bytes()
    }
}

impl StoredModel for LodStrips<'_> {
    fn step_vertices(&self) -> &StepVertices<'_> {
        &self.vertices
    }

    fn group_count(&self) -> usize {
        self.group_offsets().len().saturating_sub(1)
    }

    fn group_triangles_into(&self, state: &LodStripsState, group: usize, out: &mut Vec<[u32; 3]>) {
        strips_of_group_into(self, state, group, out);
    }
}

impl StripModel for LodStrips<'_> {
    fn group_offsets(&self) -> &[u32] {
        &self.group_offsets
    }

    fn strip<'s>(&self, state: &'s LodStripsState, strip: usize) -> &'s [u32] {
        state.live(strip)
    }
}
