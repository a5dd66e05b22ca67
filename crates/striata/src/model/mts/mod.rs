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
//! into a few bits; a record of a few bytes lists the strips that a step changes. The special nodes -1 and
//! -2 of the paper are our breaks, and -3 is the end of the slots.
//!
//! Cost: a step rebuilds two or three strips of at most [`MAX_STRIP_INDICES`] slots; recovering a whole
//! level is linear in the number of slots. Building takes time linear in the number of steps times
//! [`MAX_STRIP_INDICES`].

mod build;
mod lifetimes;
mod record;
mod state;
mod validate;

use std::borrow::Cow;

pub use state::MtsState;

use self::lifetimes::StripSlots;
use self::record::MtsRecordFormat;
pub use super::lod_strips::MAX_STRIP_INDICES;
use super::packed_vertices::PackedVertices;
use super::step_vertices::StepVertices;
use super::stored_strips::StoredStrips;
use super::{
    DrawCounts, LodModel, ModelError, PartBytes, StoredModel, StripModel, Topology, join_strips,
    strips_of_group_into,
};
use crate::strip::RESTART;

/// The static half of the model, shared by all instances; see the [module](self).
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Mts<'a> {
    /// The vertices of each step, without targets.
    vertices: StepVertices<'a>,
    /// Target of each vertex above the base.
    targets: PackedVertices<'a>,
    parts: MtsParts<'a>,
    /// Offset of each strip's entry in the lifetimes.
    entries: Vec<u32>,
    format: MtsRecordFormat,
    /// Number of bits of all records.
    record_bits: usize,
}

/// The stored arrays of a model, except for those that come from the sequence.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct MtsParts<'a> {
    /// Strips of the full mesh.
    pub strips: StoredStrips<'a>,
    /// For each strip, how long its slots survive and where it breaks; see `lifetimes.rs`.
    pub lifetimes: Cow<'a, [u8]>,
    /// For each step, the head of its record.
    pub heads: Cow<'a, [u8]>,
    /// For each step, the strips that it changes; see `record.rs`.
    pub arena: Cow<'a, [u8]>,
}

impl<'a> Mts<'a> {
    /// Assembles a model from stored arrays and validates them, so that no later move can fail.
    pub(crate) fn from_parts(
        vertices: StepVertices<'a>,
        targets: PackedVertices<'a>,
        parts: MtsParts<'a>,
    ) -> Result<Self, ModelError> {
        let model = Self::unchecked(vertices, targets, parts)?;
        validate::check(&model)?;
        Ok(model)
    }

    /// Finds the entries of the strips and the end of the records.
    fn unchecked(
        vertices: StepVertices<'a>,
        targets: PackedVertices<'a>,
        parts: MtsParts<'a>,
    ) -> Result<Self, ModelError> {
        let entries = lifetimes::offsets(&parts.lifetimes, &parts.strips.lengths)
            .map_err(|strip| ModelError::Strip { strip, reason: "has no room for its lifetimes" })?;
        let format = MtsRecordFormat::new(parts.strips.strip_count());
        let mut record_bits = 0;
        for (step, &head) in parts.heads.iter().enumerate() {
            let record = format.record_at(&parts.arena, record_bits, head);
            record_bits = record.ok_or(ModelError::Record { step, reason: "ends too early" })?.end;
        }
        Ok(Self { vertices, targets, parts, entries, format, record_bits })
    }

    /// The stored arrays, except for those that come from the sequence.
    pub(crate) fn parts(&self) -> &MtsParts<'a> {
        &self.parts
    }

    /// Number of slots: indices of the strips at full detail.
    pub fn slot_count(&self) -> usize {
        self.parts.strips.slot_count()
    }

    /// Number of breaks between pieces of strips, over all levels.
    pub fn break_count(&self) -> usize {
        (0..self.strip_count()).map(|strip| self.strip_slots(strip).breaks().len()).sum()
    }

    /// Number of changes of strips, summed over all steps.
    pub fn change_count(&self) -> usize {
        let mut count = 0;
        let mut cursor = 0;
        for &head in self.parts.heads.iter() {
            let Some(record) = self.format.record_at(&self.parts.arena, cursor, head) else { break };
            cursor = record.end;
            let counted = self.format.for_each_strip(&self.parts.arena, record, |_, _| count += 1);
            debug_assert!(counted.is_some(), "a checked record ended early");
        }
        count
    }

    #[inline]
    fn strip_slots(&self, strip: usize) -> StripSlots<'_> {
        let MtsParts { strips, lifetimes, .. } = &self.parts;
        StripSlots {
            indices: &strips.indices,
            first: strips.firsts()[strip] as usize,
            length: usize::from(strips.lengths[strip]),
            entry: &lifetimes[self.entries[strip] as usize..],
        }
    }

    /// Returns the vertex that a vertex above the base collapses to.
    #[inline]
    fn target(&self, vertex: u32) -> u32 {
        self.targets.get((vertex - self.vertices.base_vertex_count()) as usize)
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
        let MtsParts { strips, lifetimes, heads, arena } = self.parts;
        Mts {
            vertices: self.vertices.into_owned(),
            targets: self.targets.into_owned(),
            parts: MtsParts {
                strips: strips.into_owned(),
                lifetimes: lifetimes.into_owned().into(),
                heads: heads.into_owned().into(),
                arena: arena.into_owned().into(),
            },
            entries: self.entries,
            format: self.format,
            record_bits: self.record_bits,
        }
    }

    fn live_strips<'s>(&self, state: &'s MtsState) -> impl Iterator<Item = &'s [u32]> {
        (0..self.strip_count()).map(|strip| state.live(strip))
    }
}

impl LodModel for Mts<'_> {
    type State = MtsState;

    fn step_count(&self) -> usize {
        self.parts.heads.len()
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
        let [strips, offsets] = self.parts.strips.bytes();
        vec![
            part("strips", strips),
            part("strip offsets", offsets + size_of_val(&self.entries[..])),
            part("targets", self.targets.bytes().len() + 4 * self.vertices.word_count()),
            part("lifetimes", self.parts.lifetimes.len()),
            part("changed strips", self.parts.heads.len() + self.parts.arena.len()),
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
        &self.parts.strips.group_offsets
    }

    fn strip<'s>(&self, state: &'s MtsState, strip: usize) -> &'s [u32] {
        state.live(strip)
    }
}
