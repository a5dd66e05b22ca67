//! Progressive fans \[Cor01\]: every level, uniform or view-dependent, from one static table and one bit
//! per step.
//!
//! Every triangle of every level is stored with the first of its corners to be removed, which is the one
//! with the highest index. The triangles that a vertex has when it is removed form its entry. A triangle
//! is active while the vertex of its entry is active and after the step that creates it (if any) has been
//! collapsed. An instance is therefore fully described by the set of its collapsed steps, one bit each,
//! and the active triangles of a vertex depend only on these bits.
//!
//! ```text
//!          c                 entry of v: ring a b c d e, closed
//!       d / \ b              arcs a-b, b-c ... are the triangles v a b, v b c ...
//!       |  v  |              arcs 11000 need no step, 00110 are created by step 7, 00001 by step 9
//!        e---a               with 7 collapsed and 9 not, arcs 11110 are active: the fan v; a b c d e
//! ```
//!
//! **Valid sets of steps.** A step can be collapsed once all steps are collapsed that replaced a triangle at
//! one of its vertices: those that create the triangles of its entry, and some whose floor left no triangle
//! at the vertex, for example at a boundary; these are listed separately. A step can be split once every
//! position around it is active, and so is its target if the floor uses a target that is not in the ring.
//! [`FanInstance::collapse`] and [`FanInstance::split`] also move all steps that are needed for this.
//!
//! Differs: \[Cor01\] stores machine words, while an entry here is a few bytes (see `table.rs`). The paper
//! recurses; this implementation uses a stack. A ring longer than [`MAX_ARCS`] is cut into several fans of
//! one vertex. Crowns are fans too, so no arc has to be marked as void. A position with several wedges has
//! an entry for each, but only one bit.
//!
//! **From frame to frame.** [`FanFront`] follows a view. It evaluates only those steps whose verdict may have
//! changed since it was made, which it knows from the motion of the camera; see `front.rs`.
//!
//! The parents of a step are derived from the entries, so they take no bytes, but the bounds of a step are wider than
//! those of VDPM: a view has 13 to 45 % more triangles.
//!
//! Cost: the table contains every triangle of every level, about three times as many as the full mesh has.
//! Extraction is linear in the number of active vertices; a change is linear in the size of the entries
//! that it touches.

mod bounds;
mod budget;
mod build;
mod crowns;
mod emit;
mod expiries;
mod fan_triangles;
mod fragments;
mod front;
mod instance;
mod level;
mod morphs;
mod quick_table;
mod scene;
mod set_operations;
mod step_counts;
mod stored;
mod table;
mod table_fan;
mod validate;

pub use bounds::FanBoxes;
pub use build::{BoundScope, FanOptions, FanSource};
pub use emit::{FanForm, FanIndices, fan_triangles_into};
pub use fan_triangles::FanTriangles;
pub use front::{FanFront, FanUpdate};
pub use instance::FanInstance;
pub use morphs::{FanMorphs, MovingVertex};
pub use scene::FanScene;
pub(crate) use stored::FansParts;
pub use table::MAX_ARCS;
pub use table_fan::{ArcMaker, TableFan};

use self::quick_table::LazyQuickTable;
use self::step_counts::StepCounts;
use self::table::{FanEntry, FanTable};
use super::step_bounds::StepBounds;
use super::step_vertices::StepVertices;
use super::{DrawCounts, LodModel, PartBytes, StoredModel, Topology};

/// The static table of fans, shared by all instances; see the [module](self).
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fans {
    vertices: StepVertices<'static>,
    step_count: usize,
    group_count: usize,
    table: FanTable,
    /// Pairs of a step and an additional step that must be collapsed before it, ascending.
    waits: Vec<[u32; 2]>,
    /// Pairs of a step and the step of its target, for targets that are not in the ring, ascending.
    far: Vec<[u32; 2]>,
    /// Steps that no entry lists as a child; in the tree they are children of the base.
    orphans: Vec<u32>,
    /// Number of triangles that each step adds.
    added: StepCounts,
    /// Bounds of each step for view-dependent refinement, unless the table was built without them.
    bounds: Option<StepBounds>,
    /// The table in a form that is decoded quickly.
    quick: LazyQuickTable,
}

impl Fans {
    /// Name of the part of [`bytes`](LodModel::bytes) that is made in memory when it is first needed. Files do not
    /// have it.
    pub const MADE_RECORDS: &str = "quick records";

    /// Number of vertices of the full mesh.
    pub fn vertex_count(&self) -> usize {
        self.vertices.vertex_count
    }

    /// Number of vertices of a uniform level; the level uses exactly the vertices below this index.
    ///
    /// # Panics
    /// If `split_count` exceeds the step count.
    pub fn vertex_count_at(&self, split_count: usize) -> usize {
        self.vertices.count_at(split_count)
    }

    /// Number of triangles of the base mesh.
    pub fn base_triangle_count(&self) -> usize {
        self.draw_counts(&self.level_at(0)).index_count / 3
    }

    /// Returns the triangle count of each level, from coarse to fine.
    pub fn triangle_counts(&self) -> Vec<u32> {
        let mut count = self.base_triangle_count();
        let mut counts = Vec::with_capacity(self.step_count + 1);
        counts.push(count as u32);
        for step in 0..self.step_count as u32 {
            count = count.saturating_add_signed(self.added.of(step));
            counts.push(count as u32);
        }
        counts
    }

    /// Number of triangle groups.
    pub fn group_count(&self) -> usize {
        self.group_count
    }

    /// Returns the state of a uniform level.
    pub(crate) fn level_at(&self, split_count: usize) -> FansLevel {
        let mut level = self.new_state();
        self.move_to(&mut level, split_count);
        level
    }

    /// Returns the fans of a base vertex.
    #[inline]
    fn base_entry(&self, vertex: u32) -> FanEntry<'_> {
        self.table.entry(vertex, 0)
    }

    /// Returns the fans of a vertex that a step removes.
    #[inline]
    fn step_entry(&self, vertex: u32, step: u32) -> FanEntry<'_> {
        self.table.entry(vertex, step + 1)
    }

    /// Visits the fans of all vertices that are active at a uniform level.
    fn for_each_fan_at(&self, split_count: usize, mut visit: impl FnMut(table::FanView<'_>)) {
        for vertex in 0..self.vertices.base_vertex_count {
            for fan in self.base_entry(vertex) {
                visit(fan);
            }
        }
        for step in 0..split_count {
            for vertex in self.vertices.of_step(step) {
                for fan in self.step_entry(vertex, step as u32) {
                    visit(fan);
                }
            }
        }
    }
}

/// Returns the second elements of all pairs whose first is `step`; the pairs are sorted.
fn listed(pairs: &[[u32; 2]], step: u32) -> impl Iterator<Item = u32> {
    let first = pairs.partition_point(|pair| pair[0] < step);
    pairs[first..].iter().take_while(move |pair| pair[0] == step).map(|pair| pair[1])
}

/// An instance of [`Fans`] at a uniform level, which is just a split count.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FansLevel {
    split_count: usize,
}

impl LodModel for Fans {
    type State = FansLevel;

    fn step_count(&self) -> usize {
        self.step_count
    }

    fn new_state(&self) -> FansLevel {
        FansLevel { split_count: self.step_count }
    }

    fn split_count(&self, state: &FansLevel) -> usize {
        state.split_count
    }

    fn move_to(&self, state: &mut FansLevel, split_count: usize) {
        assert!(split_count <= self.step_count, "split count {split_count} of {}", self.step_count);
        state.split_count = split_count;
    }

    fn topology(&self) -> Topology {
        Topology::Triangles
    }

    fn draw_counts(&self, state: &FansLevel) -> DrawCounts {
        self.level_draw_counts(state, FanForm::Triangles)
    }

    fn indices_into(&self, state: &FansLevel, out: &mut Vec<u32>) {
        emit::append_all(self, state, FanForm::Triangles, out);
    }

    fn bytes(&self) -> Vec<PartBytes> {
        let part = |name, bytes| PartBytes { name, bytes };
        let [entries, starts] = self.table.sizes();
        let mut parts = vec![
            part("first vertices", 4 * self.vertices.firsts.len()),
            part("entries", entries),
            part("starts", starts),
            part("waits", size_of_val(&self.waits[..]) + size_of_val(&self.far[..])),
            part("orphans", size_of_val(&self.orphans[..])),
            part("triangle counts", self.added.bytes()),
        ];
        parts.extend(self.bounds.as_ref().map(|bounds| part("bounds", bounds.as_bytes().len())));
        let quick = self.quick.bytes();
        parts.extend((quick > 0).then(|| part(Self::MADE_RECORDS, quick)));
        parts
    }

    fn state_bytes(&self, _: &FansLevel) -> usize {
        size_of::<FansLevel>()
    }
}

impl StoredModel for Fans {
    fn step_vertices(&self) -> &StepVertices<'_> {
        &self.vertices
    }

    fn group_count(&self) -> usize {
        self.group_count
    }

    fn group_triangles_into(&self, state: &FansLevel, group: usize, out: &mut Vec<[u32; 3]>) {
        assert!(group < self.group_count, "group {group} of {}", self.group_count);
        let is_collapsed = |step: u32| step as usize >= state.split_count;
        let mut indices = Vec::new();
        self.for_each_fan_at(state.split_count, |fan| {
            if fan.group as usize == group {
                fan.triangles_into(fan.mask(is_collapsed), &mut indices);
            }
        });
        out.extend_from_slice(indices.as_chunks().0);
    }
}
