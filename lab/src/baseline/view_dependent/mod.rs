//! View-dependent progressive meshes \[Hop97\]: a vertex hierarchy, and a surface that is refined in place.
//!
//! Every step is a node of the hierarchy: the vertex that it splits, whose children are the two resulting
//! vertices. An instance shows a front of the hierarchy: the active vertices, and the triangles between them,
//! each with three corners and three neighbors. A vertex can be split once the four triangles exist that will
//! be adjacent to the two new ones. A split can be undone while the two still have these four neighbors.
//!
//! ```text
//!            tip                         tip
//!          / | \      split            / |\ \
//!         /  |  \    ------->         /  | \ \        left: kept, restored, tip
//!      n0   kept  n1                n0 kept-restored n1     n0 and n1 lie neighbors it
//!      n2    |    n3                n2   | /  /   n3        right: restored, kept, tip
//!          \ | /      <-------         \ |/ /               n2 and n3 lie neighbors it
//!           tip       collapse          tip
//! ```
//!
//! Nodes and vertices are different things: vertex 7 of the buffer may be active as its leaf, or as the
//! vertex that step 12 or step 9 splits. It is at most one of these at a time.
//!
//! Differs: in \[Hop97\] both vertices of a split are new. Here one keeps the position and index of the
//! split vertex, so only the corners on the other's side change. Active vertices and triangles are stored
//! contiguously instead of in linked lists, so visiting all of them is a linear scan, and drawing needs no
//! copy. A restored vertex is evaluated on behalf of both children when deciding on a collapse, and the
//! collapses that this allows are tried immediately instead of in the next frame. All active vertices are
//! evaluated before anything changes, in batches, and verdicts can be kept while they are valid. Bounds are packed
//! into eight bytes. There are
//! no wedges, no geomorphs, and work is not spread over frames. The index of a triangle determines its
//! step, so no pointer is needed.
//!
//! The surface has to be manifold at every level (borders are allowed) with one vertex per position;
//! [`build`](ViewDependentMeshes::build) rejects others and reports where they fail.
//!
//! Cost: a frame evaluates each active vertex whose verdict may have changed, scans the others, and
//! touches about ten triangles per change. Building is linear in the stars that change.

mod adapt;
mod bounds;
mod build;
mod error;
mod state;
mod surface;

pub use self::adapt::Adapted;
pub use self::error::ViewDependentError;
pub use self::state::ViewDependentState;
use striata::model::{DrawCounts, LodModel, PartBytes, PartRecord, Topology};
use striata::view::Part;

use crate::paper_bytes::{Accounting, PaperBytes};

/// Marks a missing triangle or an inactive vertex.
const NONE: u32 = u32::MAX;

/// The node of a vertex that no step splits.
const LEAF: u32 = u32::MAX;

/// The parent of the roots of the hierarchy.
const ROOT: u32 = u32::MAX;

/// The static half of the model; see the [module](self).
#[derive(Clone, Debug, PartialEq)]
pub struct ViewDependentMeshes {
    /// One per step; the restored vertex follows from the step.
    splits: Vec<VertexSplit>,
    /// The bounds of each step, which criteria evaluate; their spheres have the split vertex as center.
    parts: Vec<PartRecord>,
    /// Positions of all vertices. They belong to the mesh, so they are not counted here, as for other models.
    positions: Vec<[f32; 3]>,
    /// The node of each vertex in the base.
    roots: Vec<u32>,
    base_corners: Vec<[u32; 3]>,
    base_triangles: Vec<Triangle>,
    group_count: usize,
    /// The group of each triangle; empty if there is only one group.
    groups: Vec<u32>,
}

/// A node of the hierarchy that can be split.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
struct VertexSplit {
    /// The split vertex, and the one of the two that keeps its index.
    target: u32,
    /// The parent node, or [`ROOT`].
    parent: u32,
    /// The child nodes, the one that keeps the index first.
    children: [u32; 2],
    /// Neighbors of the left triangle at the kept and at the restored vertex, then of the right triangle;
    /// [`NONE`] at borders.
    neighbors: [u32; 4],
}

/// A triangle and its neighbors.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Triangle {
    /// The neighbor opposite each corner, or [`NONE`].
    neighbors: [u32; 3],
    index: u32,
}

/// The corner of a triangle at which a vertex is.
#[inline]
fn corner_of(corners: &[u32; 3], vertex: u32) -> usize {
    debug_assert!(corners.contains(&vertex), "{corners:?} has no vertex {vertex}");
    usize::from(corners[1] == vertex) + 2 * usize::from(corners[2] == vertex)
}

impl VertexSplit {
    /// The triangles that the split creates, with [`NONE`] for one beyond a border.
    #[inline]
    fn present(&self, created: [u32; 2]) -> [u32; 2] {
        let [a, b, c, d] = self.neighbors;
        let has = [a != NONE || b != NONE, c != NONE || d != NONE];
        [0, 1].map(|side| if has[side] { created[side] } else { NONE })
    }
}

impl ViewDependentMeshes {
    /// Number of vertices in the full mesh.
    pub fn vertex_count(&self) -> usize {
        self.roots.len() + self.splits.len()
    }

    /// Creates an instance that shows the base.
    pub fn base_state(&self) -> ViewDependentState {
        ViewDependentState::base(self)
    }

    /// The bounds of everything that a step's split can restore, for criteria to evaluate.
    ///
    /// # Panics
    /// If the step does not exist.
    #[inline]
    pub fn part(&self, step: usize) -> Part {
        self.parts[step].part(self.positions[self.splits[step].target as usize])
    }

    /// Number of groups of triangles.
    pub fn group_count(&self) -> usize {
        self.group_count
    }

    /// Appends the triangles of one group, three indices each.
    ///
    /// # Panics
    /// If the group does not exist or the state belongs to another model.
    pub fn group_indices_into(&self, state: &ViewDependentState, group: usize, out: &mut Vec<u32>) {
        state.check(self);
        assert!(group < self.group_count, "group {group} of {}", self.group_count);
        if self.groups.is_empty() {
            out.extend_from_slice(state.triangles().as_flattened());
            return;
        }
        for (index, corners) in state.indexed() {
            if self.groups[index as usize] as usize == group {
                out.extend_from_slice(corners);
            }
        }
    }

    /// Memory of an instance as \[Cor01\] counts it: 112 bytes per active vertex.
    pub fn paper_state_bytes(&self, state: &ViewDependentState) -> usize {
        112 * state.vertex_count()
    }

    /// The vertex that a step restores.
    #[inline]
    fn restored(&self, step: u32) -> u32 {
        self.roots.len() as u32 + step
    }

    /// Indices of the triangles left and right of the edge that a step creates; at a border one is unused.
    #[inline]
    fn created_by(&self, step: u32) -> [u32; 2] {
        let left = self.base_triangles.len() as u32 + 2 * step;
        [left, left + 1]
    }

    /// The step that creates a triangle, or `None` if it is in the base.
    #[inline]
    fn maker(&self, index: u32) -> Option<u32> {
        index.checked_sub(self.base_triangles.len() as u32).map(|behind| behind / 2)
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

    /// Number of steps that are split, in whatever combination.
    fn split_count(&self, state: &ViewDependentState) -> usize {
        state.vertex_count() - self.roots.len()
    }

    fn move_to(&self, state: &mut ViewDependentState, split_count: usize) {
        assert!(split_count <= self.step_count(), "split count {split_count} of {}", self.step_count());
        state.check(self);
        for step in (split_count as u32..state.highest as u32).rev() {
            if state.is_split(self, step) {
                // Everything that could prevent this collapse is finer.
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
        // Invalidates all earlier verdicts.
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
    /// The structures of \[Hop97\], including the dynamic ones: a hierarchy vertex with two links of the
    /// active list, parent, children, left triangle, four neighbors and four numbers for the criterion; a
    /// triangle with two links, material, three vertices and three neighbors. Positions and normals are
    /// not counted.
    fn paper_bytes(&self, accounting: Accounting) -> usize {
        let nodes = self.vertex_count() + self.splits.len();
        let triangles = self.splits.iter().flat_map(|split| split.present([0, 1]));
        let triangle_count = self.base_triangles.len() + triangles.filter(|&t| t != NONE).count();
        accounting.bytes(triangle_count, 13 * nodes + 8 * triangle_count)
    }
}
