//! State of one instance of progressive meshes, and how it moves between levels.

use super::ProgressiveMeshes;
use super::counts::GroupIndices;

/// State of one instance: its level and its triangle list. Created by
/// [`LodModel::new_state`](striata::model::LodModel).
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ProgressiveMeshesState {
    split_count: usize,
    /// End of the corners of the last refined step, which is where those of the next step begin.
    corner_cursor: usize,
    /// End of the groups of that step's triangles.
    group_cursor: usize,
    /// The triangle list; see the drawing in the [module](super).
    indices: Vec<u32>,
    /// Number of triangles shown in each group.
    live_counts: Vec<u32>,
}

impl ProgressiveMeshesState {
    pub(super) fn new(model: &ProgressiveMeshes) -> Self {
        Self {
            split_count: model.step_count,
            corner_cursor: model.corners.len(),
            group_cursor: model.removed_groups.len(),
            indices: model.indices.clone(),
            live_counts: model.group_offsets.windows(2).map(|w| w[1] - w[0]).collect(),
        }
    }

    /// The current level.
    pub fn split_count(&self) -> usize {
        self.split_count
    }

    /// The triangle list, three indices per triangle. It includes triangles that are not shown, so its
    /// length never changes; [`ProgressiveMeshes::group_ranges`] returns the parts to draw.
    pub fn indices(&self) -> &[u32] {
        &self.indices
    }

    /// Bytes owned by the instance.
    pub fn bytes(&self) -> usize {
        4 * (self.indices.len() + self.live_counts.len())
    }

    /// Number of triangles shown in each group.
    pub(super) fn live_counts(&self) -> &[u32] {
        &self.live_counts
    }

    pub(super) fn move_to(&mut self, model: &ProgressiveMeshes, split_count: usize) {
        let step_count = model.step_count;
        assert!(split_count <= step_count, "split count {split_count} of {step_count}");
        assert!(
            self.indices.len() == model.indices.len() && self.live_counts.len() == model.group_count(),
            "the state belongs to another model"
        );
        while self.split_count > split_count {
            self.coarsen(model);
        }
        while self.split_count < split_count {
            self.refine(model);
        }
    }

    /// Collapses the last refined step.
    #[inline]
    fn coarsen(&mut self, model: &ProgressiveMeshes) {
        self.split_count -= 1;
        let step = self.split_count;
        for vertex in model.vertices.of_step(step).rev() {
            let count = model.corner_counts.get((vertex - model.vertices.base_vertex_count()) as usize);
            let start = self.corner_cursor - count;
            let target = model.vertices.target(vertex);
            for &corner in &model.corners[start..self.corner_cursor] {
                self.indices[corner as usize] = target;
            }
            self.corner_cursor = start;
        }
        let removed = model.removed_counts.get(step);
        let Self { live_counts, group_cursor, .. } = self;
        match &model.removed_groups {
            GroupIndices::One => live_counts[0] -= removed as u32,
            groups => {
                *group_cursor -= removed;
                groups.for_each(*group_cursor..*group_cursor + removed, |group| live_counts[group] -= 1);
            }
        }
    }

    /// Refines the next step.
    #[inline]
    fn refine(&mut self, model: &ProgressiveMeshes) {
        let step = self.split_count;
        self.split_count += 1;
        for vertex in model.vertices.of_step(step) {
            let count = model.corner_counts.get((vertex - model.vertices.base_vertex_count()) as usize);
            let end = self.corner_cursor + count;
            for &corner in &model.corners[self.corner_cursor..end] {
                self.indices[corner as usize] = vertex;
            }
            self.corner_cursor = end;
        }
        let removed = model.removed_counts.get(step);
        let Self { live_counts, group_cursor, .. } = self;
        match &model.removed_groups {
            GroupIndices::One => live_counts[0] += removed as u32,
            groups => {
                groups.for_each(*group_cursor..*group_cursor + removed, |group| live_counts[group] += 1);
                *group_cursor += removed;
            }
        }
    }
}
