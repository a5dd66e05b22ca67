//! Builds the triangle list and the records in one pass from the full mesh to the base, following each
//! corner.

use striata::mesh::{RefinableMesh, is_proper};
use striata::model::StepVertices;

use super::ProgressiveMeshes;
use super::counts::{GroupIndices, PackedCounts};

/// End of a chain of corners.
const END: u32 = u32::MAX;

/// Marks a triangle without area in the full mesh, which no level shows.
const NEVER: u32 = u32::MAX;

impl ProgressiveMeshes {
    /// Builds the model from a mesh and its sequence.
    ///
    /// # Panics
    /// If the mesh does not match the sequence: it refers to other vertices, or its groups do not tile it.
    pub fn build(refinable: &RefinableMesh) -> Self {
        let mut builder = ProgressiveMeshesBuilder::new(refinable);
        for step in (0..refinable.sequence.step_count()).rev() {
            builder.collapse(step);
        }
        builder.finish()
    }
}

struct ProgressiveMeshesBuilder<'r> {
    refinable: &'r RefinableMesh,
    /// The triangles at the current level; removed ones keep their last corners.
    triangles: Vec<[u32; 3]>,
    /// The split count from which each triangle is shown.
    shown_from: Vec<u32>,
    /// First corner of each vertex's chain.
    chains: Vec<u32>,
    /// The next corner of the same chain. Corners of removed triangles are dropped the next time a chain
    /// is walked.
    next: Vec<u32>,
    /// The corners that each vertex above the base passes to its target, last vertex first.
    corners: Vec<u32>,
    corner_counts: Vec<u32>,
    moved: Vec<(u32, u32)>,
}

impl<'r> ProgressiveMeshesBuilder<'r> {
    fn new(refinable: &'r RefinableMesh) -> Self {
        let triangles = refinable.mesh.triangles.clone();
        let vertex_count = refinable.sequence.positions().vertex_count();
        let mut chains = vec![END; vertex_count];
        let mut next = vec![END; 3 * triangles.len()];
        for (corner, &vertex) in triangles.as_flattened().iter().enumerate() {
            next[corner] = std::mem::replace(&mut chains[vertex as usize], corner as u32);
        }
        Self {
            refinable,
            shown_from: triangles.iter().map(|t| if is_proper(t) { 0 } else { NEVER }).collect(),
            triangles,
            chains,
            next,
            corners: Vec::new(),
            corner_counts: vec![0; refinable.sequence.targets().len()],
            moved: Vec::new(),
        }
    }

    /// Replaces the vertices of a step by their targets, and records which corners change and which
    /// triangles vanish.
    fn collapse(&mut self, step: usize) {
        let sequence = &self.refinable.sequence;
        self.moved.clear();
        for vertex in sequence.step_vertices(step).rev() {
            let mut corner = self.chains[vertex as usize];
            while corner != END {
                if self.shown_from[corner as usize / 3] == 0 {
                    self.triangles.as_flattened_mut()[corner as usize] = sequence.target(vertex);
                    self.moved.push((corner, vertex));
                }
                corner = self.next[corner as usize];
            }
        }
        // Only after all wedges have moved is it known which triangles remain.
        for &(corner, vertex) in &self.moved {
            let triangle = corner as usize / 3;
            if !is_proper(&self.triangles[triangle]) {
                self.shown_from[triangle] = step as u32 + 1;
                continue;
            }
            self.corners.push(corner);
            self.corner_counts[vertex as usize - sequence.base_vertex_count()] += 1;
            let chain = &mut self.chains[sequence.target(vertex) as usize];
            self.next[corner as usize] = std::mem::replace(chain, corner);
        }
    }

    fn finish(self) -> ProgressiveMeshes {
        let sequence = &self.refinable.sequence;
        let full = &self.refinable.mesh;
        let mut indices = Vec::with_capacity(3 * full.triangle_count());
        let mut group_offsets = vec![0];
        let mut index_of = vec![END; full.triangle_count()];
        let mut removed = Vec::new();
        for (group, range) in full.groups_or_whole().iter().map(|group| group.range()).enumerate() {
            let shown = range.map(|t| (self.shown_from[t], t)).filter(|&(from, _)| from != NEVER);
            let mut order: Vec<(u32, usize)> = shown.collect();
            order.sort_unstable();
            for &(from, triangle) in &order {
                index_of[triangle] = indices.len() as u32 / 3;
                indices.extend(full.triangles[triangle]);
                if let Some(step) = from.checked_sub(1) {
                    removed.push((step, group as u32));
                }
            }
            group_offsets.push(indices.len() as u32 / 3);
        }
        removed.sort_unstable();
        let mut removed_counts = vec![0; sequence.step_count()];
        removed.iter().for_each(|&(step, _)| removed_counts[step as usize] += 1);
        let group_count = group_offsets.len() - 1;
        ProgressiveMeshes {
            step_count: sequence.step_count(),
            vertices: StepVertices::of_sequence(sequence).into_owned(),
            indices,
            group_offsets,
            corners: self.corners_in_list(&index_of),
            corner_counts: PackedCounts::of(&self.corner_counts),
            removed_counts: PackedCounts::of(&removed_counts),
            removed_groups: GroupIndices::of(removed.into_iter().map(|(_, group)| group), group_count),
        }
    }

    /// The corners of all records, first vertex first, as positions in the list; ascending for each vertex.
    fn corners_in_list(&self, index_of: &[u32]) -> Vec<u32> {
        let in_list = |&corner: &u32| 3 * index_of[corner as usize / 3] + corner % 3;
        let mut corners: Vec<u32> = self.corners.iter().rev().map(in_list).collect();
        let mut rest = corners.as_mut_slice();
        for &count in &self.corner_counts {
            let (own, others) = rest.split_at_mut(count as usize);
            own.sort_unstable();
            rest = others;
        }
        corners
    }
}
