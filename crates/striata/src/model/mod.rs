//! Multiresolution models built from one collapse sequence.
//!
//! A model has two halves. The static half is built once and never changes; any number of instances can
//! share it, and it can borrow its arrays from a memory-mapped file. The state belongs to one instance on
//! screen and records the level that the instance shows.
//!
//! ```
//! use striata::model::{LodModel as _, LodStrips};
//! use striata::{mesh::shapes, simplify::build_sequence, strip::stripify};
//!
//! let refinable = build_sequence(&shapes::torus(32, 16, 1.0, 0.4), &Default::default())?.refinable;
//! let model = LodStrips::build(&refinable, &stripify(&refinable.mesh)?)?; // shared by all instances
//! let mut state = model.new_state(); // one instance
//! model.move_to(&mut state, model.step_count() / 2);
//! let mut indices = Vec::new();
//! model.indices_into(&state, &mut indices); // strips with restarts, over the vertices of refinable.mesh
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

pub mod fans;
pub mod geomorph;
pub mod lod_strips;
pub mod mts;
pub mod patterns;
pub mod strip_history;

mod bits;
mod error;
mod kind;
mod packed_vertices;
mod part_record;
mod step_bits;
mod step_bounds;
mod step_vertices;
mod stored_strips;
mod strip_input;
mod strip_run;
mod superfluous;
mod varint;

pub use bits::Bits;
pub use error::ModelError;
pub use fans::{
    BoundScope, FanBoxes, FanForm, FanFront, FanIndices, FanInstance, FanMorphs, FanOptions, FanScene,
    FanSource, FanTriangles, FanUpdate, Fans, FansLevel, MovingVertex, fan_triangles_into,
};
pub use geomorph::{Geomorph, MorphVertex, VertexBlend};
pub use kind::{ModelKind, UnknownModel};
pub use lod_strips::{LodStrips, LodStripsState, StageOptions, StripBuffer};
pub use mts::{Mts, MtsState};
pub(crate) use packed_vertices::PackedVertices;
pub use part_record::PartRecord;
pub use patterns::{
    Condition, CriterionCondition, Overlap, PatternChange, PatternInstance, PatternScene, Patterns,
    PatternsState,
};
pub use step_bits::StepBits;
pub use step_vertices::StepVertices;
pub(crate) use stored_strips::StoredStrips;
pub use strip_input::check_strips;

use std::ops::Range;

use crate::strip::{RESTART, StripSet, restart_triangles_into};

/// Size of one part of a model.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PartBytes {
    /// Name of the part, as used in the description of the file format.
    pub name: &'static str,
    /// Size in bytes.
    pub bytes: usize,
}

/// How the indices of a model are to be drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Topology {
    /// A triangle list: three indices per triangle.
    Triangles,
    /// Triangle strips, separated by [`RESTART`].
    Strips,
}

/// Number of strips and indices needed to draw an instance.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct DrawCounts {
    /// Number of strips; 0 for a model that draws a triangle list.
    pub strip_count: usize,
    /// Number of indices, including the restarts between strips.
    pub index_count: usize,
}

impl DrawCounts {
    /// Counts strips drawn with [`RESTART`] between them; empty strips are skipped.
    pub fn of_strips<'s>(strips: impl Iterator<Item = &'s [u32]>) -> Self {
        let mut counts = Self::default();
        for strip in strips.filter(|strip| !strip.is_empty()) {
            counts.strip_count += 1;
            counts.index_count += strip.len() + 1;
        }
        counts.index_count = counts.index_count.saturating_sub(1);
        counts
    }
}

/// Appends strips with [`RESTART`] between them, skipping empty ones.
pub fn join_strips<'s>(strips: impl Iterator<Item = &'s [u32]>, out: &mut Vec<u32>) {
    let mut is_first = true;
    for strip in strips.filter(|strip| !strip.is_empty()) {
        if !is_first {
            out.push(RESTART);
        }
        is_first = false;
        out.extend_from_slice(strip);
    }
}

/// A model that can show any uniform level of a collapse sequence.
pub trait LodModel {
    /// The data owned by one instance.
    type State;

    /// Number of steps from the base mesh to the full mesh.
    fn step_count(&self) -> usize;

    /// Returns a new instance, which shows the full mesh.
    fn new_state(&self) -> Self::State;

    /// Returns the level that an instance shows, as a split count.
    fn split_count(&self, state: &Self::State) -> usize;

    /// Moves an instance to a level and updates the indices that it keeps for drawing. (Fans keep none;
    /// they generate their triangles on request.) A model with only a few discrete levels picks the finest
    /// level that does not exceed `split_count`, or its coarsest level if there is none.
    ///
    /// # Panics
    /// If `split_count` exceeds the step count, or the state belongs to a model of a different shape.
    fn move_to(&self, state: &mut Self::State, split_count: usize);

    /// Returns how the output of [`indices_into`](Self::indices_into) is to be drawn.
    fn topology(&self) -> Topology;

    /// Counts what is needed to draw the instance at its current level.
    fn draw_counts(&self, state: &Self::State) -> DrawCounts;

    /// Appends all indices of the instance, group by group; their number is the `index_count` of
    /// [`draw_counts`](Self::draw_counts).
    fn indices_into(&self, state: &Self::State, out: &mut Vec<u32>);

    /// Appends the triangles that an instance shows, group by group.
    fn triangles_into(&self, state: &Self::State, out: &mut Vec<[u32; 3]>) {
        let mut indices = Vec::with_capacity(self.draw_counts(state).index_count);
        self.indices_into(state, &mut indices);
        match self.topology() {
            Topology::Triangles => out.extend_from_slice(indices.as_chunks().0),
            Topology::Strips => restart_triangles_into(&indices, out),
        }
    }

    /// Returns the size of the static half by part, excluding positions and attributes, which belong to
    /// the mesh.
    fn bytes(&self) -> Vec<PartBytes>;

    /// Returns the number of bytes that an instance owns.
    fn state_bytes(&self, state: &Self::State) -> usize;
}

/// A model that can be stored in a file: it knows the vertex count of every level and keeps triangle
/// groups apart.
pub trait StoredModel: LodModel {
    /// Returns the vertices of the base mesh and of each step.
    fn step_vertices(&self) -> &StepVertices<'_>;

    /// Number of vertices of the full mesh.
    fn vertex_count(&self) -> usize {
        self.step_vertices().vertex_count()
    }

    /// Number of vertices of a level; the level uses exactly the vertices below this index.
    ///
    /// # Panics
    /// If `split_count` exceeds the step count.
    fn vertex_count_at(&self, split_count: usize) -> usize {
        self.step_vertices().count_at(split_count)
    }

    /// Number of triangle groups.
    fn group_count(&self) -> usize;

    /// Appends the triangles of one group at the instance's current level.
    ///
    /// # Panics
    /// If the group does not exist.
    fn group_triangles_into(&self, state: &Self::State, group: usize, out: &mut Vec<[u32; 3]>);
}

/// A stored model made of strips. Strips never cross groups, and a strip that has become empty keeps its
/// index.
pub trait StripModel: StoredModel {
    /// Index of the first strip of each group, followed by the strip count.
    fn group_offsets(&self) -> &[u32];

    /// Returns the current indices of a strip, with [`RESTART`] between its pieces if there are several.
    /// Empty once all triangles of the strip have collapsed.
    ///
    /// # Panics
    /// If the strip does not exist.
    fn strip<'s>(&self, state: &'s Self::State, strip: usize) -> &'s [u32];

    /// Number of strips, including those that are empty at the current level.
    fn strip_count(&self) -> usize {
        self.group_offsets().last().map_or(0, |&count| count as usize)
    }

    /// Returns the range of strips of one group.
    ///
    /// # Panics
    /// If the group does not exist.
    fn group_strips(&self, group: usize) -> Range<usize> {
        self.group_offsets()[group] as usize..self.group_offsets()[group + 1] as usize
    }

    /// Returns the strips that an instance shows, group by group, without those that have no triangle left.
    fn strips_at(&self, state: &Self::State) -> StripSet {
        let mut strips = StripSet::new();
        for group in 0..self.group_count() {
            for strip in self.group_strips(group) {
                let pieces = self.strip(state, strip).split(|&index| index == RESTART);
                pieces.filter(|piece| piece.len() >= 3).for_each(|piece| strips.push(piece));
            }
            strips.end_group();
        }
        strips
    }
}

/// Appends the triangles that the strips of one group currently show.
fn strips_of_group_into<M: StripModel>(model: &M, state: &M::State, group: usize, out: &mut Vec<[u32; 3]>) {
    for strip in model.group_strips(group) {
        restart_triangles_into(model.strip(state, strip), out);
    }
}
