//! Skip strips \[EAV99\]: display strips that are rebuilt when vertices they depend on have changed.
//!
//! The strips of the full mesh are stored as nodes: each slot refers to the node of its vertex, and each node
//! to its parent, which is the node of the vertex's target in the same strip. At a given level, a slot shows
//! the first active vertex on its path to the root. A move marks the strips that any of the steps in between
//! changes, then rebuilds each marked strip once: it climbs from every slot and removes repetitions.
//!
//! ```text
//! slots of a strip      7  4  9  2  9  5        node of vertex 9: parent 4;  7: parent 2;  5: parent 2
//! active: below 7       2  4  4  2  4  5        the display strip after a move to that level
//! ```
//!
//! There is a node for every vertex that a strip shows at some level. Once the last triangle of a strip
//! has vanished, coarser steps no longer change it: its nodes end there, and those steps do not mark it.
//!
//! Differs: \[EAV99\] chooses active vertices by view; here they are a prefix. Its nodes also list their
//! children, so that these can be notified of a split. Here strips are marked by step and lists of
//! children would never be read, so they are counted in `paper_bytes` but not stored.
//!
//! Cost: a move is linear in the nodes and slots of the strips that it marks, regardless of how many steps
//! mark them.

mod build;
mod node_builder;
mod slot_groups;
mod state;

use std::ops::Range;

pub use state::SkipStripsState;

use striata::model::{DrawCounts, LodModel, PartBytes, StepVertices, Topology, join_strips};

use crate::paper_bytes::{Accounting, PaperBytes};

/// Parent of a node without a parent.
const NO_NODE: u32 = u32::MAX;

/// The static half of the model; see the [module](self).
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SkipStrips {
    vertices: StepVertices<'static>,
    /// All strips, followed by an entry with the end offsets.
    strips: Vec<SkipStrip>,
    group_offsets: Vec<u32>,
    /// The node of each slot, relative to its strip.
    slots: Vec<u32>,
    /// The vertex of each node, ascending within each strip.
    node_vertices: Vec<u32>,
    /// The parent of each node, relative to its strip; it precedes the node.
    node_parents: Vec<u32>,
    /// Offset of the strips that each step changes, followed by their number.
    step_offsets: Vec<u32>,
    affected_strips: Vec<u32>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct SkipStrip {
    first_slot: u32,
    first_node: u32,
    /// The coarsest level at which the strip has a triangle.
    drawn_from: u32,
}

impl SkipStrips {
    /// Number of strips, including those without triangles at coarse levels.
    pub fn strip_count(&self) -> usize {
        self.strips.len() - 1
    }

    /// Number of groups of triangles; strips never cross groups.
    pub fn group_count(&self) -> usize {
        self.group_offsets.len() - 1
    }

    /// The current indices of a strip; empty once all its triangles have vanished.
    ///
    /// # Panics
    /// If the strip does not exist.
    pub fn strip<'s>(&self, state: &'s SkipStripsState, strip: usize) -> &'s [u32] {
        state.shown(strip)
    }

    /// Appends the indices that draw one group, with [`RESTART`](striata::strip::RESTART) between strips.
    ///
    /// # Panics
    /// If the group does not exist.
    pub fn group_indices_into(&self, state: &SkipStripsState, group: usize, out: &mut Vec<u32>) {
        let strips = self.group_offsets[group] as usize..self.group_offsets[group + 1] as usize;
        join_strips(strips.map(|strip| state.shown(strip)), out);
    }

    fn slots(&self, strip: usize) -> Range<usize> {
        self.strips[strip].first_slot as usize..self.strips[strip + 1].first_slot as usize
    }

    fn nodes(&self, strip: usize) -> Range<usize> {
        self.strips[strip].first_node as usize..self.strips[strip + 1].first_node as usize
    }
}

impl LodModel for SkipStrips {
    type State = SkipStripsState;

    fn step_count(&self) -> usize {
        self.vertices.step_count()
    }

    fn new_state(&self) -> SkipStripsState {
        SkipStripsState::new(self)
    }

    fn split_count(&self, state: &SkipStripsState) -> usize {
        state.split_count
    }

    fn move_to(&self, state: &mut SkipStripsState, split_count: usize) {
        state.move_to(self, split_count);
    }

    fn topology(&self) -> Topology {
        Topology::Strips
    }

    fn draw_counts(&self, state: &SkipStripsState) -> DrawCounts {
        DrawCounts::of_strips((0..self.strip_count()).map(|strip| state.shown(strip)))
    }

    fn indices_into(&self, state: &SkipStripsState, out: &mut Vec<u32>) {
        join_strips((0..self.strip_count()).map(|strip| state.shown(strip)), out);
    }

    fn bytes(&self) -> Vec<PartBytes> {
        let part = |name, words: usize| PartBytes { name, bytes: 4 * words };
        vec![
            part("strips", 3 * self.strips.len() + self.group_offsets.len()),
            part("places", self.slots.len()),
            part("nodes", self.node_vertices.len() + self.node_parents.len()),
            part("first vertices", self.vertices.word_count()),
            part("affected strips", self.step_offsets.len() + self.affected_strips.len()),
        ]
    }

    fn state_bytes(&self, state: &SkipStripsState) -> usize {
        state.bytes()
    }
}

impl PaperBytes for SkipStrips {
    /// The structures of \[EAV99\] as described by others: a pointer per strip and a word per slot; a node
    /// with four words (vertex, parent, number of children, pointer to them) and a word per child; a
    /// hierarchy vertex with three words (parent, number of affected strips, pointer to them) and a word
    /// per affected strip.
    fn paper_bytes(&self, accounting: Accounting) -> usize {
        let children = self.node_parents.iter().filter(|&&parent| parent != NO_NODE).count();
        let nodes = self.node_vertices.len();
        let vertex_count = self.vertices.vertex_count();
        // Counts of children and of affected strips are integers; all other words are references.
        let longs = self.strip_count() + self.slots.len() + 3 * nodes + children;
        let hierarchy = 2 * vertex_count + self.affected_strips.len();
        accounting.bytes(nodes + vertex_count, longs + hierarchy)
    }
}
