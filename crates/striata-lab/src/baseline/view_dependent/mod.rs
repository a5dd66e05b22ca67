//! View-dependent progressive meshes: a hierarchy of vertices, and a surface that is refined in place \[Hop97\].
//!
//! Every step is a node of a hierarchy: the vertex that it splits, with the two that come of it as its children. An instance shows
//! a front of the hierarchy: a list of vertices that are active, and the triangles between them, each with its
//! three corners and its three neighbors. A vertex can be split once the four triangles are there that will lie beside the two
//! that the split makes; a split can be undone while those two still have these four as neighbors.
//!
//! ```text
//!            tip                         tip
//!          / | \      split            / |\ \
//!         /  |  \    ------->         /  | \ \        left: kept, restored, tip
//!      n0   kept  n1                n0 kept-restored n1     n0 and n1 lie beside it
//!      n2    |    n3                n2   | /  /   n3        right: restored, kept, tip
//!          \ | /      <-------         \ |/ /               n2 and n3 lie beside it
//!           tip       collapse          tip
//! ```
//!
//! A node is told from a vertex: vertex 7 of the buffer is active as its leaf, or as the vertex that step 12 or step 9
//! splits. It is at most one of these at a time.
//!
//! Differs: in \[Hop97\] both vertices of a split are new, here one keeps the position and the number of the vertex that is
//! split, so only the corners on the other's side change. Active vertices and triangles are not linked in lists but stand side by
//! side, so that looking at all of them is a walk through memory, and drawing needs no copy. A restored vertex
//! is asked for both children whether they go, and what a collapse allows is tried at once, not in the next frame.
//! All active vertices are asked before anything changes, many at once, and verdicts can be kept as long as they last.
//! There are no wedges, no geomorphs and no spreading of work over frames. Numbers of triangles tell their step, so that
//! it needs no pointer.
//!
//! The surface has to be manifold at every level, borders allowed, with one vertex a position:
//! [`build`](ViewDependentMeshes::build) refuses others and says where.
//!
//! Cost: a frame costs a question for each active vertex that may have changed its mind, a look at the others, and about ten triangles for each change. Building is linear in the stars that
//! change.

mod adapt;
mod bounds;
mod build;
mod error;
mod state;
mod surface;

pub use self::adapt::Adapted;
pub use self::error::ViewDependentError;
pub use self::state::ViewDependentState;
use striata::model::{DrawCounts, LodModel, PartBytes, Topology};
use striata::view::Part;

use crate::paper_bytes::{Accounting, PaperBytes};

/// No triangle, or no place.
const NONE: u32 = u32::MAX;

/// The node of a vertex that nothing splits.
const LEAF: u32 = u32::MAX;

/// Above the roots of the hierarchy.
const ROOT: u32 = u32::MAX;

/// The static half of the model; see the [module](self).
#[derive(Clone, Debug, PartialEq)]
pub struct ViewDependentMeshes {
    /// One for each step; the vertex that it restores follows from its number.
    splits: Vec<VertexSplit>,
    /// What a criterion is asked of each.
    parts: Vec<Part>,
    /// The node of each vertex of the base.
    roots: Vec<u32>,
    base_corners: Vec<[u32; 3]>,
    base_triangles: Vec<Triangle>,
    group_count: usize,
    /// The group of each triangle; empty where there is one group.
    groups: Vec<u32>,
}

/// A node of the hierarchy that can be split.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
struct VertexSplit {
    /// The vertex that is split, and the one of the two that keeps its number.
    target: u32,
    /// The node above, or [`ROOT`].
    parent: u32,
    /// The nodes that come of it, the one that keeps the number first.
    children: [u32; 2],
    /// Beside the left triangle at the kept vertex and at the restored one, and beside the right; [`NONE`] at borders.
    beside: [u32; 4],
}

/// A triangle among others.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Triangle {
    /// Behind the side opposite of each corner, or [`NONE`].
    beside: [u32; 3],
    number: u32,
}

/// Where a vertex stands in a triangle that has it.
#[inline]
fn turn_of(corners: &[u32; 3], vertex: u32) -> usize {
    debug_assert!(corners.contains(&vertex), "{corners:?} has no vertex {vertex}");
    usize::from(corners[1] == vertex) + 2 * usize::from(corners[2] == vertex)
}

impl VertexSplit {
    /// The triangles that the split makes; [`NONE`] for one beyond a border.
    #[inline]
    fn present(&self, made: [u32; 2]) -> [u32; 2] {
        let [a, b, c, d] = self.beside;
        let has = [a != NONE || b != NONE, c != NONE || d != NONE];
        [0, 1].map(|side| if has[side] { made[side] } else { NONE })
    }
}

impl ViewDependentMeshes {
    /// Vertices of the full mesh.
    pub fn vertex_count(&self) -> usize {
        self.roots.len() + self.splits.len()
    }

    /// A new instance that shows the base.
    pub fn base_state(&self) -> ViewDependentState {
        ViewDependentState::base(self)
    }

    /// What a criterion is asked of a step: all that its split can bring back.
    ///
    /// # Panics
    /// If there is no such step.
    pub fn part(&self, step: usize) -> &Part {
        &self.parts[step]
    }

    /// Groups of triangles.
    pub fn group_count(&self) -> usize {
        self.group_count
    }

    /// Appends the triangles of one group, three indices each.
    ///
    /// # Panics
    /// If there is no such group, or the state belongs to another model.
    pub fn group_indices_into(&self, state: &ViewDependentState, group: usize, out: &mut Vec<u32>) {
        state.check(self);
        assert!(group < self.group_count, "group {group} of {}", self.group_count);
        if self.groups.is_empty() {
            out.extend_from_slice(state.triangles().as_flattened());
            return;
        }
        for (number, corners) in state.numbered() {
            if self.groups[number as usize] as usize == group {
                out.extend_from_slice(corners);
            }
        }
    }

    /// What an instance takes as others count it: 112 bytes an active vertex \[Cor01\].
    pub fn paper_state_bytes(&self, state: &ViewDependentState) -> usize {
        112 * state.vertex_count()
    }

    /// The vertex that a step restores.
    #[inline]
    fn restored(&self, step: u32) -> u32 {
        self.roots.len() as u32 + step
    }

    /// Numbers of the triangles left and right of the edge that a step makes; a border leaves one unused.
    #[inline]
    fn made_by(&self, step: u32) -> [u32; 2] {
        let left = self.base_triangles.len() as u32 + 2 * step;
        [left, left + 1]
    }

    /// The step that makes a triangle; `None` for one of the base.
    #[inline]
    fn maker(&self, number: u32) -> Option<u32> {
        number.checked_sub(self.base_triangles.len() as u32).map(|behind| behind / 2)
    }
}

impl LodModel for ViewDependentMeshes {
    type State = ViewDependentState;

    fn step_count(&self) -> usize {
        self.splits.len()
    }

    fn new_state(&self) -> ViewDependentState {
        let mut state = self.base_state();
        self.move_to(&mut state, self.step_count());
        state
    }

    /// Steps that are split, whichever they are.
    fn split_count(&self, state: &ViewDependentState) -> usize {
        state.vertex_count() - self.roots.len()
    }

    fn move_to(&self, state: &mut ViewDependentState, split_count: usize) {
        assert!(split_count <= self.step_count(), "split count {split_count} of {}", self.step_count());
        state.check(self);
        for step in (split_count as u32..state.highest as u32).rev() {
            if state.is_split(self, step) {
                // All that could be in its way is finer.
                debug_assert!(state.has_children(self, step) && state.can_collapse(self, step));
                state.collapse(self, step);
            }
        }
        for step in state.lowest as u32..split_count as u32 {
            if !state.is_split(self, step) {
                state.split(self, step);
            }
        }
        (state.lowest, state.highest) = (split_count, split_count);
        // Nothing is known any more of what was asked.
        state.elapsed = f64::INFINITY;
    }

    fn topology(&self) -> Topology {
        Topology::Triangles
    }

    fn draw_counts(&self, state: &ViewDependentState) -> DrawCounts {
        DrawCounts { strip_count: 0, index_count: 3 * state.triangles().len() }
    }

    fn indices_into(&self, state: &ViewDependentState, out: &mut Vec<u32>) {
        (0..self.group_count).for_each(|group| self.group_indices_into(state, group, out));
    }

    fn bytes(&self) -> Vec<PartBytes> {
        let part = |name, bytes| PartBytes { name, bytes };
        let base = size_of_val(&self.base_corners[..]) + size_of_val(&self.base_triangles[..]);
        vec![
            part("splits", size_of_val(&self.splits[..])),
            part("criteria", size_of_val(&self.parts[..])),
            part("base", base + 4 * self.roots.len()),
            part("groups", 4 * self.groups.len()),
        ]
    }

    fn state_bytes(&self, state: &ViewDependentState) -> usize {
        state.bytes()
    }
}

impl PaperBytes for ViewDependentMeshes {
    /// The structures of \[Hop97\], dynamic ones among them as there: a vertex of the hierarchy with two links of the active
    /// list, parent, children, left triangle, four neighbors and four numbers for the criterion; a triangle with two links,
    /// material, three vertices and three neighbors. Positions and normals are not counted.
    fn paper_bytes(&self, accounting: Accounting) -> usize {
        let nodes = self.vertex_count() + self.splits.len();
        let triangles = self.splits.iter().flat_map(|split| split.present([0, 1]));
        let triangle_count = self.base_triangles.len() + triangles.filter(|&t| t != NONE).count();
        accounting.bytes(triangle_count, 13 * nodes + 8 * triangle_count)
    }
}
