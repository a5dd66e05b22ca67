//! The levels of a sequence of steps: how large each is, how far off, and which one a wish means.

use super::sequence_error::check_length;
use super::{PositionIndex, SequenceError};

/// What is known of each level, whatever the steps between them do.
///
/// Level `s` shows the base's positions and those of the first `s` steps.
#[derive(Clone, Debug, PartialEq)]
pub struct Levels {
    positions: PositionIndex,
    base_position_count: usize,
    errors: Vec<f32>,
    /// Triangles at split count `s`, `step_count + 1` of them.
    triangle_counts: Vec<u32>,
}

impl Levels {
    /// From the triangles of each level, coarse to fine, and the error of each but the last.
    ///
    /// # Errors
    /// [`SequenceError`] where a length does not fit, or an error is no number, negative, or grows with detail.
    pub fn new(
        positions: PositionIndex,
        base_position_count: usize,
        triangle_counts: Vec<u32>,
        errors: Vec<f32>,
    ) -> Result<Self, SequenceError> {
        let position_count = positions.position_count();
        let Some(step_count) = position_count.checked_sub(base_position_count) else {
            return Err(SequenceError::Length {
                what: "base positions",
                found: base_position_count,
                expected: position_count,
            });
        };
        check_length("errors", errors.len(), step_count)?;
        check_length("triangle counts", triangle_counts.len(), step_count + 1)?;
        let mut previous = f32::INFINITY;
        for (step, &error) in errors.iter().enumerate() {
            if !(error >= 0.0 && error <= previous && error.is_finite()) {
                return Err(SequenceError::Error { step, error, previous });
            }
            previous = error;
        }
        Ok(Self { positions, base_position_count, errors, triangle_counts })
    }

    /// Positions and their wedges.
    pub fn positions(&self) -> &PositionIndex {
        &self.positions
    }

    /// Steps from the base mesh to the full mesh.
    pub fn step_count(&self) -> usize {
        self.errors.len()
    }

    /// Positions of the base mesh.
    pub fn base_position_count(&self) -> usize {
        self.base_position_count
    }

    /// Vertices of the base mesh.
    pub fn base_vertex_count(&self) -> usize {
        self.vertex_count_at(0)
    }

    /// Vertices that a level shows: always the first so many of the vertex buffer.
    ///
    /// # Panics
    /// If `split_count` exceeds the step count.
    #[inline]
    pub fn vertex_count_at(&self, split_count: usize) -> usize {
        self.positions.first_vertices()[self.base_position_count + split_count] as usize
    }

    /// Triangles that a level shows.
    ///
    /// # Panics
    /// If `split_count` exceeds the step count.
    pub fn triangle_count_at(&self, split_count: usize) -> usize {
        self.triangle_counts[split_count] as usize
    }

    /// Object-space error of a level, mesh units; 0 for the full mesh.
    ///
    /// # Panics
    /// If `split_count` exceeds the step count.
    pub fn error_at(&self, split_count: usize) -> f32 {
        if split_count == self.errors.len() { 0.0 } else { self.errors[split_count] }
    }

    /// Error of the level at each split count below the step count; never rising.
    pub fn errors(&self) -> &[f32] {
        &self.errors
    }

    /// The vertices (wedges) that step `step` restores.
    #[inline]
    pub fn step_vertices(&self, step: usize) -> std::ops::Range<u32> {
        self.positions.wedges((self.base_position_count + step) as u32)
    }

    /// The step that restores a vertex; none for a vertex of the base.
    #[inline]
    pub fn step_of(&self, vertex: u32) -> Option<u32> {
        self.positions.position_of(vertex).checked_sub(self.base_position_count as u32)
    }

    /// The most detailed level with at most `triangle_count` triangles; the base if none has so few.
    pub fn split_count_for_triangles(&self, triangle_count: usize) -> usize {
        // One after the other: nothing keeps the floor of a fragment from being larger than its ceiling.
        self.triangle_counts.iter().rposition(|&n| n as usize <= triangle_count).unwrap_or(0)
    }

    /// The most detailed level with at most `vertex_count` vertices; the base if none has so few.
    pub fn split_count_for_vertices(&self, vertex_count: usize) -> usize {
        let first = &self.positions.first_vertices()[self.base_position_count..];
        first.partition_point(|&n| n as usize <= vertex_count).saturating_sub(1)
    }

    /// The coarsest level whose error is at most `error` mesh units.
    pub fn split_count_for_error(&self, error: f64) -> usize {
        self.errors.partition_point(|&e| f64::from(e) > error)
    }

    /// The level nearest to a detail of 0 (base) to 1 (full) that does not exceed it.
    pub fn split_count_for_detail(&self, detail: f64) -> usize {
        // The small term keeps `k / step_count` from rounding down to k - 1.
        let exact = detail.clamp(0.0, 1.0) * self.step_count() as f64;
        ((exact + 1e-9 * exact.max(1.0)) as usize).min(self.step_count())
    }
}
