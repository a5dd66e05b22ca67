//! The collapse sequence that every model is built from.
//!
//! The vertices of a [`RefinableMesh`] are in **refinement order**: first the positions of the base mesh,
//! then every other position in the order in which refinement restores it. A mesh refined by `split_count`
//! vertex splits therefore uses a prefix of the vertices. All that the sequence has to store is the vertex
//! that each vertex collapses to, its **target**, which always has a smaller index.
//!
//! ```text
//! positions   0 1 2 .. base-1 | base  base+1  ..  base+step_count-1
//! step                        |  0      1             step_count-1
//! split_count 0 shows the base; split_count n shows positions 0 .. base+n
//! ```

use super::sequence_error::check_length;
use super::{IndexedMesh, LevelTable, PositionIndex, SequenceError};

/// The arrays of a [`CollapseSequence`], as passed by builders and file readers.
#[derive(Clone, Debug)]
pub struct SequenceParts {
    /// First vertex of every position in refinement order, followed by the vertex count.
    pub positions: PositionIndex,
    /// Number of positions of the base mesh.
    pub base_position_count: usize,
    /// Target of every vertex that is not in the base mesh.
    pub targets: Vec<u32>,
    /// Error of the level at each split count below the step count, in mesh units; never increasing.
    pub errors: Vec<f32>,
    /// Number of triangles that collapsing the position of each step removes.
    pub removed_triangle_counts: Vec<u8>,
    /// Number of triangles of the full mesh.
    pub triangle_count: usize,
}

/// The target of every collapsed vertex, in refinement order, with the errors and triangle counts of the
/// levels.
#[derive(Clone, Debug, PartialEq)]
pub struct CollapseSequence {
    levels: LevelTable,
    targets: Vec<u32>,
    removed_triangle_counts: Vec<u8>,
}

impl CollapseSequence {
    /// Checks the parts and assembles them into a sequence.
    ///
    /// # Errors
    /// [`SequenceError`] for the first inconsistency found.
    pub fn from_parts(parts: SequenceParts) -> Result<Self, SequenceError> {
        let SequenceParts {
            positions,
            base_position_count,
            targets,
            errors,
            removed_triangle_counts,
            triangle_count,
        } = parts;
        let removed: u64 = removed_triangle_counts.iter().map(|&n| u64::from(n)).sum();
        let Some(base_triangles) = (triangle_count as u64).checked_sub(removed) else {
            return Err(SequenceError::TriangleCount { removed, triangle_count });
        };
        let mut triangle_counts = Vec::with_capacity(removed_triangle_counts.len() + 1);
        let mut count = base_triangles as u32;
        triangle_counts.push(count);
        for &n in &removed_triangle_counts {
            count += u32::from(n);
            triangle_counts.push(count);
        }
        let levels = LevelTable::new(positions, base_position_count, triangle_counts, errors)?;
        let expected = levels.positions().vertex_count() - levels.base_vertex_count();
        check_length("targets", targets.len(), expected)?;
        check_targets(levels.positions(), base_position_count, &targets)?;
        Ok(Self { levels, targets, removed_triangle_counts })
    }

    /// Sizes and errors of the levels.
    pub fn levels(&self) -> &LevelTable {
        &self.levels
    }

    /// The vertices (wedges) of each position.
    pub fn positions(&self) -> &PositionIndex {
        self.levels.positions()
    }

    /// Number of steps from the base mesh to the full mesh.
    pub fn step_count(&self) -> usize {
        self.levels.step_count()
    }

    /// Number of positions of the base mesh.
    pub fn base_position_count(&self) -> usize {
        self.levels.base_position_count()
    }

    /// Number of vertices of the base mesh.
    pub fn base_vertex_count(&self) -> usize {
        self.vertex_count_at(0)
    }

    /// Number of vertices at a level: it uses this many vertices from the start of the vertex buffer.
    ///
    /// # Panics
    /// If `split_count` exceeds the step count.
    pub fn vertex_count_at(&self, split_count: usize) -> usize {
        self.levels.vertex_count_at(split_count)
    }

    /// The vertex that a vertex of the full mesh has collapsed to at a level, or the vertex itself.
    ///
    /// # Panics
    /// If `split_count` exceeds the step count.
    pub fn target_at(&self, mut vertex: u32, split_count: usize) -> u32 {
        let vertex_count = self.vertex_count_at(split_count) as u32;
        while vertex >= vertex_count {
            vertex = self.target(vertex);
        }
        vertex
    }

    /// Number of triangles at a level.
    ///
    /// # Panics
    /// If `split_count` exceeds the step count.
    pub fn triangle_count_at(&self, split_count: usize) -> usize {
        self.levels.triangle_count_at(split_count)
    }

    /// Object-space error of a level, in mesh units; 0 for the full mesh.
    ///
    /// # Panics
    /// If `split_count` exceeds the step count.
    pub fn error_at(&self, split_count: usize) -> f32 {
        self.levels.error_at(split_count)
    }

    /// The vertices (wedges) that a step restores.
    #[inline]
    pub fn step_vertices(&self, step: usize) -> std::ops::Range<u32> {
        self.levels.step_vertices(step)
    }

    /// The vertex that `vertex` becomes when its position is collapsed; `vertex` itself if it is in the
    /// base mesh.
    #[inline]
    pub fn target(&self, vertex: u32) -> u32 {
        let base = self.levels.base_vertex_count() as u32;
        if vertex < base { vertex } else { self.targets[(vertex - base) as usize] }
    }

    /// Targets of all vertices that are not in the base mesh, in order.
    pub fn targets(&self) -> &[u32] {
        &self.targets
    }

    /// Error of the level at each split count below the step count; never increasing.
    pub fn errors(&self) -> &[f32] {
        self.levels.errors()
    }

    /// Number of triangles that the collapse of each step removes.
    pub fn removed_triangle_counts(&self) -> &[u8] {
        &self.removed_triangle_counts
    }

    /// Split count of the most detailed level with at most `triangle_count` triangles; 0 if there is none.
    pub fn split_count_for_triangles(&self, triangle_count: usize) -> usize {
        self.levels.split_count_for_triangles(triangle_count)
    }

    /// Split count of the most detailed level with at most `vertex_count` vertices; 0 if there is none.
    pub fn split_count_for_vertices(&self, vertex_count: usize) -> usize {
        self.levels.split_count_for_vertices(vertex_count)
    }

    /// Split count of the coarsest level whose error is at most `error` mesh units.
    pub fn split_count_for_error(&self, error: f64) -> usize {
        self.levels.split_count_for_error(error)
    }

    /// Split count of the most detailed level that does not exceed a detail from 0.0 (base) to 1.0 (full).
    pub fn split_count_for_detail(&self, detail: f64) -> usize {
        self.levels.split_count_for_detail(detail)
    }

    /// Split counts of the full mesh, and of levels with half as many triangles each down to the base mesh.
    pub fn halving_split_counts(&self) -> Vec<usize> {
        let full = self.step_count();
        let (mut splits, mut last) = (vec![full], full);
        let mut limit = self.triangle_count_at(full);
        while last > 0 {
            limit /= 2;
            let split_count = if limit > 0 { self.split_count_for_triangles(limit) } else { 0 };
            if split_count < last {
                splits.push(split_count);
                last = split_count;
            }
        }
        splits
    }
}

fn check_targets(positions: &PositionIndex, base: usize, targets: &[u32]) -> Result<(), SequenceError> {
    let base_vertex_count = positions.first_vertices()[base];
    for position in base as u32..positions.position_count() as u32 {
        let wedges = positions.wedges(position);
        let limit = wedges.start;
        let mut expected = None;
        for vertex in wedges {
            let target = targets[(vertex - base_vertex_count) as usize];
            if target >= limit {
                return Err(SequenceError::Target { vertex: vertex as usize, target, limit });
            }
            let found = positions.position_of(target);
            if *expected.get_or_insert(found) != found {
                let expected = expected.unwrap_or(found);
                return Err(SequenceError::SplitTarget { vertex: vertex as usize, found, expected });
            }
        }
    }
    Ok(())
}

/// A mesh in refinement order together with its collapse sequence, from which every level can be derived.
#[derive(Clone, Debug, PartialEq)]
pub struct RefinableMesh {
    /// The full mesh: vertices in refinement order, no unused vertices, no degenerate triangles.
    pub mesh: IndexedMesh,
    /// How the mesh is simplified.
    pub sequence: CollapseSequence,
}

impl RefinableMesh {
    /// Drops the coarsest levels: the level at `split_count` becomes the new base mesh.
    ///
    /// # Panics
    /// If `split_count` exceeds the step count.
    pub fn without_levels_below(mut self, split_count: usize) -> Self {
        let CollapseSequence { levels, mut targets, mut removed_triangle_counts } = self.sequence;
        let first = levels.vertex_count_at(split_count) - levels.base_vertex_count();
        targets.drain(..first);
        removed_triangle_counts.drain(..split_count);
        let parts = SequenceParts {
            base_position_count: levels.base_position_count() + split_count,
            errors: levels.errors()[split_count..].to_vec(),
            positions: levels.positions().clone(),
            targets,
            removed_triangle_counts,
            triangle_count: self.mesh.triangle_count(),
        };
        self.sequence = CollapseSequence::from_parts(parts).expect("the last steps of a sequence are one");
        self
    }
}
