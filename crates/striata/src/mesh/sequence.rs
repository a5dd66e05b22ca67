//! The simplification sequence that every model is built from.
//!
//! A mesh of [`RefinableMesh`] is numbered in **refinement order**: the base mesh's positions first, then each
//! position in the order in which refinement brings it back. A mesh refined by `split_count` vertex splits
//! therefore uses a prefix of the vertices, and the sequence needs to store only where each vertex
//! collapses to, its **target**, which always has a smaller number.
//!
//! ```text
//! positions   0 1 2 .. base-1 | base  base+1  ..  base+step_count-1
//! step                        |  0      1             step_count-1
//! split_count 0 shows the base; split_count n shows positions 0 .. base+n
//! ```

use super::sequence_error::check_length;
use super::{IndexedMesh, Levels, PositionIndex, SequenceError};

/// The arrays of a [`CollapseSequence`], as builders and files hand them over.
#[derive(Clone, Debug)]
pub struct SequenceParts {
    /// First vertex of every position in refinement order, closed by the vertex count.
    pub positions: PositionIndex,
    /// Positions of the base mesh.
    pub base_position_count: usize,
    /// Target of every vertex from the base's vertex count on.
    pub targets: Vec<u32>,
    /// Error of the level at split count `s`, one for each step, mesh units; never rising.
    pub errors: Vec<f32>,
    /// Triangles that collapsing the position of step `s` removes.
    pub removed_triangle_counts: Vec<u8>,
    /// Triangles of the full mesh.
    pub triangle_count: usize,
}

/// Where every position collapses to, in refinement order, with errors and triangle counts.
#[derive(Clone, Debug, PartialEq)]
pub struct CollapseSequence {
    levels: Levels,
    targets: Vec<u32>,
    removed_triangle_counts: Vec<u8>,
}

impl CollapseSequence {
    /// Checks the parts and puts them together.
    ///
    /// # Errors
    /// [`SequenceError`] naming the first part that does not fit.
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
        let levels = Levels::new(positions, base_position_count, triangle_counts, errors)?;
        let expected = levels.positions().vertex_count() - levels.base_vertex_count();
        check_length("targets", targets.len(), expected)?;
        check_targets(levels.positions(), base_position_count, &targets)?;
        Ok(Self { levels, targets, removed_triangle_counts })
    }

    /// How large each level is, and how far off.
    pub fn levels(&self) -> &Levels {
        &self.levels
    }

    /// Positions and their wedges.
    pub fn positions(&self) -> &PositionIndex {
        self.levels.positions()
    }

    /// Steps from the base mesh to the full mesh.
    pub fn step_count(&self) -> usize {
        self.levels.step_count()
    }

    /// Positions of the base mesh.
    pub fn base_position_count(&self) -> usize {
        self.levels.base_position_count()
    }

    /// Vertices of the base mesh.
    pub fn base_vertex_count(&self) -> usize {
        self.vertex_count_at(0)
    }

    /// Vertices that a level shows: always the first so many of the vertex buffer.
    ///
    /// # Panics
    /// If `split_count` exceeds the step count.
    pub fn vertex_count_at(&self, split_count: usize) -> usize {
        self.levels.vertex_count_at(split_count)
    }

    /// Triangles that a level shows.
    ///
    /// # Panics
    /// If `split_count` exceeds the step count.
    pub fn triangle_count_at(&self, split_count: usize) -> usize {
        self.levels.triangle_count_at(split_count)
    }

    /// Object-space error of a level, mesh units; 0 for the full mesh.
    ///
    /// # Panics
    /// If `split_count` exceeds the step count.
    pub fn error_at(&self, split_count: usize) -> f32 {
        self.levels.error_at(split_count)
    }

    /// The vertices (wedges) that step `step` restores.
    #[inline]
    pub fn step_vertices(&self, step: usize) -> std::ops::Range<u32> {
        self.levels.step_vertices(step)
    }

    /// The vertex that `vertex` becomes when its position is collapsed; itself for a vertex of the base.
    #[inline]
    pub fn target(&self, vertex: u32) -> u32 {
        let base = self.levels.base_vertex_count() as u32;
        if vertex < base { vertex } else { self.targets[(vertex - base) as usize] }
    }

    /// Targets of the vertices from the base's vertex count on.
    pub fn targets(&self) -> &[u32] {
        &self.targets
    }

    /// Error of the level at each split count below the step count; never rising.
    pub fn errors(&self) -> &[f32] {
        self.levels.errors()
    }

    /// Triangles that each step's collapse removes.
    pub fn removed_triangle_counts(&self) -> &[u8] {
        &self.removed_triangle_counts
    }

    /// The most detailed level with at most `triangle_count` triangles; the base if none has so few.
    pub fn split_count_for_triangles(&self, triangle_count: usize) -> usize {
        self.levels.split_count_for_triangles(triangle_count)
    }

    /// The most detailed level with at most `vertex_count` vertices; the base if none has so few.
    pub fn split_count_for_vertices(&self, vertex_count: usize) -> usize {
        self.levels.split_count_for_vertices(vertex_count)
    }

    /// The coarsest level whose error is at most `error` mesh units.
    pub fn split_count_for_error(&self, error: f64) -> usize {
        self.levels.split_count_for_error(error)
    }

    /// The level nearest to a detail of 0 (base) to 1 (full) that does not exceed it.
    pub fn split_count_for_detail(&self, detail: f64) -> usize {
        self.levels.split_count_for_detail(detail)
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

/// A mesh in refinement order with its sequence: all levels of detail at once.
#[derive(Clone, Debug, PartialEq)]
pub struct RefinableMesh {
    /// The full mesh, vertices in refinement order, no unused vertices, no degenerate triangles.
    pub mesh: IndexedMesh,
    /// How it is simplified.
    pub sequence: CollapseSequence,
}

impl RefinableMesh {
    /// The same without the coarsest levels: its base is what this one shows at a split count.
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
