//! Progressive meshes \[Hop96\], \[Hop98\]: one list of triangles, edited in place by the record of each
//! step.
//!
//! Each group's triangles are stored in the order in which refinement restores them, so a level shows a
//! first part of every group. The record of a step lists the corners that change between its vertices and
//! their targets, and the number of triangles that appear or vanish; no triangle is ever moved or copied.
//! A triangle that vanishes keeps its last corners, which are the ones it needs when it reappears.
//!
//! ```text
//! group of the list | base | step 0 | step 1 | step 2 | ... | last step |
//! split count 2     | ------- shown ------- | --- waiting, unchanged --- |
//! ```
//!
//! Differs: \[Hop96\] moves vertices and splits them into wedges as it refines. Here collapses are
//! half-edge collapses over one vertex buffer, so attributes need no record. \[Hop98\] finds the corners
//! of a split by walking around the vertex, for which each instance stores the neighbors of its triangles.
//! Here the corners are listed, which works for any mesh, needs no neighbors, and reduces a step to a few
//! writes. A corner is a word, a count is a byte.
//!
//! Cost: a step touches about three corners and two triangles. Building is linear in the corners that
//! change, plus sorting.

mod build;
mod counts;
mod state;

use std::ops::Range;

use self::counts::{GroupIndices, PackedCounts};
pub use self::state::ProgressiveMeshesState;
use striata::model::{DrawCounts, LodModel, PartBytes, StepVertices, Topology};

use crate::paper_bytes::{Accounting, PaperBytes};

/// The static half of the model; see the [module](self).
///
/// A renderer draws the [`group_ranges`](Self::group_ranges) of the list [`ProgressiveMeshesState::indices`].
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ProgressiveMeshes {
    step_count: usize,
    vertices: StepVertices<'static>,
    /// The list of the full mesh, three indices per triangle.
    indices: Vec<u32>,
    /// First triangle of each group in the list, followed by the number of triangles.
    group_offsets: Vec<u32>,
    /// Positions in the list that change between a vertex and its target, by vertex, beginning above the
    /// base.
    corners: Vec<u32>,
    /// For each vertex above the base, its number of entries in `corners`.
    corner_counts: PackedCounts,
    /// For each step, the number of triangles that its collapse removes.
    removed_counts: PackedCounts,
    /// The groups of these triangles, by step.
    removed_groups: GroupIndices,
}

impl ProgressiveMeshes {
    /// Number of groups of triangles.
    pub fn group_count(&self) -> usize {
        self.group_offsets.len() - 1
    }

    /// For each group (material), the range of [`ProgressiveMeshesState::indices`] to draw as triangles.
    ///
    /// # Panics
    /// If the state belongs to a model with another number of groups.
    pub fn group_ranges(&self, state: &ProgressiveMeshesState) -> impl Iterator<Item = Range<u32>> {
        assert_eq!(state.live_counts().len(), self.group_count(), "the state belongs to another model");
        let live = self.group_offsets.iter().zip(state.live_counts());
        live.map(|(&first, &count)| 3 * first..3 * (first + count))
    }
}

impl LodModel for ProgressiveMeshes {
    type State = ProgressiveMeshesState;

    fn step_count(&self) -> usize {
        self.step_count
    }

    fn new_state(&self) -> ProgressiveMeshesState {
        ProgressiveMeshesState::new(self)
    }

    fn split_count(&self, state: &ProgressiveMeshesState) -> usize {
        state.split_count()
    }

    fn move_to(&self, state: &mut ProgressiveMeshesState, split_count: usize) {
        state.move_to(self, split_count);
    }

    fn topology(&self) -> Topology {
        Topology::Triangles
    }

    fn draw_counts(&self, state: &ProgressiveMeshesState) -> DrawCounts {
        let triangle_count: usize = state.live_counts().iter().map(|&n| n as usize).sum();
        DrawCounts { strip_count: 0, index_count: 3 * triangle_count }
    }

    fn indices_into(&self, state: &ProgressiveMeshesState, out: &mut Vec<u32>) {
        for range in self.group_ranges(state) {
            out.extend_from_slice(&state.indices()[range.start as usize..range.end as usize]);
        }
    }

    fn bytes(&self) -> Vec<PartBytes> {
        let part = |name, bytes| PartBytes { name, bytes };
        let counts = self.corner_counts.bytes() + self.removed_counts.bytes() + self.removed_groups.bytes();
        vec![
            part("triangles", 4 * self.indices.len()),
            part("targets", 4 * self.vertices.word_count()),
            part("corners", 4 * self.corners.len()),
            part("counts", counts + 4 * self.group_offsets.len()),
        ]
    }

    fn state_bytes(&self, state: &ProgressiveMeshesState) -> usize {
        state.bytes()
    }
}

impl PaperBytes for ProgressiveMeshes {
    /// The list of the full mesh, three long indices per triangle, which includes the triangles that
    /// splits add. For each vertex of a split, its target, a pointer to its corners and a long index for
    /// each; and per split the number of triangles added.
    fn paper_bytes(&self, accounting: Accounting) -> usize {
        let target_count = self.vertices.vertex_count() - self.vertices.base_vertex_count() as usize;
        let splits = 2 * target_count + self.corners.len();
        accounting.bytes(self.step_count, self.indices.len() + splits)
    }
}
