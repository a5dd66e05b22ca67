//! Skip strips: display strips made anew where the vertices below them have changed \[EAV99\].
//!
//! The strips of the full mesh are stored as nodes: each place names the node of its vertex, and each node its parent,
//! the node that stands for the vertex's target in the same strip. What a place shows at a level is the first
//! active vertex on the way up. A move marks the strips that the steps in between change, then makes each marked
//! strip once: it climbs from every place and leaves out what repeats.
//!
//! ```text
//! places of a strip     7  4  9  2  9  5        node of vertex 9: parent 4;  7: parent 2;  5: parent 2
//! active: below 7       2  4  4  2  4  5        the display strip after a move to that level
//! ```
//!
//! A node is there for every vertex that a strip shows at some level. Once the last triangle of a strip is gone, no
//! coarser step changes it: its nodes end there, and the steps behind do not mark it.
//!
//! Differs: \[EAV99\] chooses active vertices by view, here they are a prefix. Its nodes also list their children,
//! to be told of a split; strips are marked by step here, so that lists of children would only be walked past:
//! they are counted in `paper_bytes` and not stored.
//!
//! Cost: a move costs the nodes and places of the strips that it marks, however many steps mark them.

mod build;
mod grow;
mod place_groups;
mod state;

use std::ops::Range;

pub use state::SkipStripsState;

use striata::model::{DrawCounts, LodModel, PartBytes, StepVertices, Topology, join_strips};

use crate::paper_bytes::{Accounting, PaperBytes};

/// Stands where a node has no parent.
const NO_NODE: u32 = u32::MAX;

/// The static half of the model; see the [module](self).
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SkipStrips {
    vertices: StepVertices<'static>,
    /// All strips, closed by one that holds the ends.
    strips: Vec<SkipStrip>,
    group_offsets: Vec<u32>,
    /// The node of each place, counted in its strip.
    places: Vec<u32>,
    /// The vertex of each node, rising in each strip.
    node_vertices: Vec<u32>,
    /// The parent of each node, counted in its strip; it stands before the node.
    node_parents: Vec<u32>,
    /// Where the strips that each step changes begin, closed by their number.
    step_offsets: Vec<u32>,
    affected_strips: Vec<u32>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct SkipStrip {
    first_place: u32,
    first_node: u32,
    /// The coarsest level at which the strip has a triangle.
    drawn_from: u32,
}

impl SkipStrips {
    /// Strips, those without triangles at coarse levels counted.
    pub fn strip_count(&self) -> usize {
        self.strips.len() - 1
    }

    /// Groups of triangles; strips never cross them.
    pub fn group_count(&self) -> usize {
        self.group_offsets.len() - 1
    }

    /// What a strip shows now; empty once all its triangles are gone.
    ///
    /// # Panics
    /// If there is no such strip.
    pub fn strip<'s>(&self, state: &'s SkipStripsState, strip: usize) -> &'s [u32] {
        state.shown(strip)
    }

    /// Appends what draws one group, with [`RESTART`](striata::strip::RESTART) between strips.
    ///
    /// # Panics
    /// If there is no such group.
    pub fn group_indices_into(&self, state: &SkipStripsState, group: usize, out: &mut Vec<u32>) {
        let strips = self.group_offsets[group] as usize..self.group_offsets[group + 1] as usize;
        join_strips(strips.map(|strip| state.shown(strip)), out);
    }

    fn places(&self, strip: usize) -> Range<usize> {
        self.strips[strip].first_place as usize..self.strips[strip + 1].first_place as usize
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
            part("places", self.places.len()),
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
    /// The structures of \[EAV99\] as others describe them: a pointer for each strip and a word for each place; a node
    /// of four words (vertex, parent, number of children, pointer to them) and a word for each child; a vertex of the
    /// hierarchy with three (parent, number of affected strips, pointer to them) and a word for each affected strip.
    fn paper_bytes(&self, accounting: Accounting) -> usize {
        let children = self.node_parents.iter().filter(|&&parent| parent != NO_NODE).count();
        let nodes = self.node_vertices.len();
        let vertex_count = self.vertices.vertex_count();
        // Numbers of children and of affected strips are integers, all else names something.
        let longs = self.strip_count() + self.places.len() + 3 * nodes + children;
        let hierarchy = 2 * vertex_count + self.affected_strips.len();
        accounting.bytes(nodes + vertex_count, longs + hierarchy)
    }
}
