//! Multiresolution models over one collapse sequence.
//!
//! A model has two halves. The static half is built once, never changes, may be shared by any number of
//! instances and may borrow its arrays from a mapped file. The state is what one instance on the
//! screen owns: where it stands and what it shows.
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
mod part_record;
mod record_arena;
mod step_bits;
mod step_bounds;
mod step_vertices;
mod strip_input;
mod strip_run;
mod superfluous;

pub use bits::Bits;
pub use error::ModelError;
pub use fans::{
    FanForm, FanFront, FanIndices, FanInstance, FanMorphs, FanScene, FanTriangles, FanUpdate, Fans,
    FansLevel, MovingVertex, fan_triangles_into,
};
pub use geomorph::{Geomorph, MorphPlace, MorphVertex};
pub use kind::{ModelKind, UnknownModel};
pub use lod_strips::{LodStrips, LodStripsState, StripBuffer};
pub use mts::{Mts, MtsState};
pub use patterns::{
    Condition, Overlap, PatternChange, PatternInstance, PatternScene, Patterns, PatternsState, Wanted,
};
pub use step_bits::StepBits;
pub use step_vertices::StepVertices;
pub use strip_input::check_strips;

use std::ops::Range;

use crate::strip::{RESTART, restart_triangles_into};

/// What a part of a model takes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PartBytes {
    /// The part, in the words of the format's description.
    pub name: &'static str,
    /// Its bytes.
    pub bytes: usize,
}

/// How the indices of a model are drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Topology {
    /// Three indices a triangle.
    Triangles,
    /// Strips with [`RESTART`] between them.
    Strips,
}

/// What it takes to draw what an instance shows.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct DrawCounts {
    /// Strips; 0 for a model that draws single triangles.
    pub strip_count: usize,
    /// Indices, those between strips counted.
    pub index_count: usize,
}

impl DrawCounts {
    /// Of strips drawn with [`RESTART`] between them; empty ones are not drawn.
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

/// Appends strips with [`RESTART`] between them; empty ones are left out.
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

/// A model that shows any level of a collapse sequence as a whole.
pub trait LodModel {
    /// What one instance owns.
    type State;

    /// Steps from the base mesh to the full mesh.
    fn step_count(&self) -> usize;

    /// A new instance; it shows the full mesh.
    fn new_state(&self) -> Self::State;

    /// The level that an instance shows.
    fn split_count(&self, state: &Self::State) -> usize;

    /// Moves an instance to a level; what it keeps to draw is then up to date (fans keep nothing, and make their
    /// triangles as they hand them over). A model of few levels goes to the finest that does not exceed it, or to its
    /// coarsest.
    ///
    /// # Panics
    /// If `split_count` exceeds the step count, or the state belongs to a model of another shape.
    fn move_to(&self, state: &mut Self::State, split_count: usize);

    /// How [`indices_into`](Self::indices_into) is drawn.
    fn topology(&self) -> Topology;

    /// What drawing the instance takes now.
    fn draw_counts(&self, state: &Self::State) -> DrawCounts;

    /// Appends all that is drawn, group after group: as many indices as [`draw_counts`](Self::draw_counts) says.
    fn indices_into(&self, state: &Self::State, out: &mut Vec<u32>);

    /// Appends the triangles that an instance shows, group after group.
    fn triangles_into(&self, state: &Self::State, out: &mut Vec<[u32; 3]>) {
        let mut indices = Vec::with_capacity(self.draw_counts(state).index_count);
        self.indices_into(state, &mut indices);
        match self.topology() {
            Topology::Triangles => out.extend_from_slice(indices.as_chunks().0),
            Topology::Strips => restart_triangles_into(&indices, out),
        }
    }

    /// Bytes of the static half by part; positions and attributes are the mesh's and not counted.
    fn bytes(&self) -> Vec<PartBytes>;

    /// Bytes that an instance owns.
    fn state_bytes(&self, state: &Self::State) -> usize;
}

/// A model that a file holds: it knows how many vertices a level has, and tells groups of triangles apart.
pub trait StoredModel: LodModel {
    /// The vertices of the base and of each step.
    fn step_vertices(&self) -> &StepVertices<'_>;

    /// Vertices of the full mesh.
    fn vertex_count(&self) -> usize {
        self.step_vertices().vertex_count()
    }

    /// Vertices that a level shows: the first so many.
    ///
    /// # Panics
    /// If `split_count` exceeds the step count.
    fn vertex_count_at(&self, split_count: usize) -> usize {
        self.step_vertices().count_at(split_count)
    }

    /// Groups of triangles.
    fn group_count(&self) -> usize;

    /// Appends the triangles that one group shows now.
    ///
    /// # Panics
    /// If there is no such group.
    fn group_triangles_into(&self, state: &Self::State, group: usize, out: &mut Vec<[u32; 3]>);
}

/// A model of strips that a file holds: strips never cross groups, dead ones keep their number.
pub trait StripModel: StoredModel {
    /// First strip of each group, closed by the number of strips.
    fn group_offsets(&self) -> &[u32];

    /// What a strip shows now, [`RESTART`] between its pieces if there are several; empty once all its triangles are
    /// gone.
    ///
    /// # Panics
    /// If there is no such strip.
    fn strip<'s>(&self, state: &'s Self::State, strip: usize) -> &'s [u32];

    /// Strips, dead ones at coarse levels counted.
    fn strip_count(&self) -> usize {
        self.group_offsets().last().map_or(0, |&count| count as usize)
    }

    /// The strips of one group.
    ///
    /// # Panics
    /// If there is no such group.
    fn group_strips(&self, group: usize) -> Range<usize> {
        self.group_offsets()[group] as usize..self.group_offsets()[group + 1] as usize
    }
}

/// Appends the triangles that the strips of one group show now.
fn strips_of_group_into<M: StripModel>(model: &M, state: &M::State, group: usize, out: &mut Vec<[u32; 3]>) {
    for strip in model.group_strips(group) {
        restart_triangles_into(model.strip(state, strip), out);
    }
}
