//! Sizes and errors of the levels of a refinement sequence, and the choice of a level for a target.

use super::sequence_error::check_length;
use super::{PositionIndex, SequenceError};

/// Sizes and errors of all levels, independent of what each refinement step does to the triangles.
///
/// Level `s` contains the positions of the base mesh and those that the first `s` steps restore.
#[derive(Clone, Debug, PartialEq)]
pub struct LevelTable {
    positions: PositionIndex,
    base_position_count: usize,
    errors: Vec<f32>,
    /// Triangle count at each split count; `step_count + 1` entries.
    triangle_counts: Vec<u32>,
    /// Whether triangle counts never fall as detail rises; those of collapses never do.
    is_rising: bool,
}

impl LevelTable {
    /// Creates the table from the triangle count of each level, coarse to fine, and the error of each level
    /// but the last.
    ///
    /// # Errors
    /// [`SequenceError`] if a length does not fit, or if an error is not finite, negative, or grows with
    /// detail.
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
        let is_rising = triangle_counts.is_sorted();
        Ok(Self { positions, base_position_count, errors, triangle_counts, is_rising })
    }

    /// The vertices (wedges) of each position.
    pub fn positions(&self) -> &PositionIndex {
        &self.positions
    }

    /// Number of steps from the base mesh to the full mesh.
    pub fn step_count(&self) -> usize {
        self.errors.len()
    }

    /// Number of positions of the base mesh.
    pub fn base_position_count(&self) -> usize {
        self.base_position_count
    }

    /// Number of vertices of the base mesh.
    pub fn base_vertex_count(&self) -> usize {
        self.vertex_count_at(0)
    }

    /// Number of vertices at a level: it uses this many vertices from the start of the vertex buffer.
    ///
    /// # Panics
    /// If `split_count` exceeds the step count.
    #[inline]
    pub fn vertex_count_at(&self, split_count: usize) -> usize {
        self.positions.first_vertices()[self.base_position_count + split_count] as usize
    }

    /// Number of triangles at a level.
    ///
    /// # Panics
    /// If `split_count` exceeds the step count.
    pub fn triangle_count_at(&self, split_count: usize) -> usize {
        self.triangle_counts[split_count] as usize
    }

    /// Object-space error of a level, in mesh units; 0 for the full mesh.
    ///
    /// # Panics
    /// If `split_count` exceeds the step count.
    pub fn error_at(&self, split_count: usize) -> f32 {
        if split_count == self.errors.len() { 0.0 } else { self.errors[split_count] }
    }

    /// Error of the level at each split count below the step count; never increasing.
    pub fn errors(&self) -> &[f32] {
        &self.errors
    }

    /// The vertices (wedges) that a step restores.
    #[inline]
    pub fn step_vertices(&self, step: usize) -> std::ops::Range<u32> {
        self.positions.wedges((self.base_position_count + step) as u32)
    }

    /// The step that restores a vertex; `None` for a vertex of the base mesh.
    #[inline]
    pub fn step_of(&self, vertex: u32) -> Option<u32> {
        self.positions.position_of(vertex).checked_sub(self.base_position_count as u32)
    }

    /// Split count of the most detailed level with at most `triangle_count` triangles; 0 if there is none.
    pub fn split_count_for_triangles(&self, triangle_count: usize) -> usize {
        let is_within = |&n: &u32| n as usize <= triangle_count;
        if self.is_rising {
            return self.triangle_counts.partition_point(is_within).saturating_sub(1);
        }
        // Counts need not rise, since the floor of a fragment may be larger than its ceiling.
        self.triangle_counts.iter().rposition(is_within).unwrap_or(0)
    }

    /// Split count of the most detailed level with at most `vertex_count` vertices; 0 if there is none.
    pub fn split_count_for_vertices(&self, vertex_count: usize) -> usize {
        let first = &self.positions.first_vertices()[self.base_position_count..];
        first.partition_point(|&n| n as usize <= vertex_count).saturating_sub(1)
    }

    /// Split count of the coarsest level whose error is at most `error` mesh units.
    pub fn split_count_for_error(&self, error: f64) -> usize {
        self.errors.partition_point(|&e| f64::from(e) > error)
    }

    /// Split count of the most detailed level that does not exceed a detail from 0.0 (base) to 1.0 (full).
    pub fn split_count_for_detail(&self, detail: f64) -> usize {
        steps_for_detail(detail, self.step_count())
    }
}

/// Number of steps that a detail from 0.0 (base) to 1.0 (full) applies, of `step_count` in all.
pub fn steps_for_detail(detail: f64, step_count: usize) -> usize {
    // The small term keeps `k / step_count` from rounding down to `k - 1`.
    let exact = detail.clamp(0.0, 1.0) * step_count as f64;
    ((exact + 1e-9 * exact.max(1.0)) as usize).min(step_count)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn levels_for_triangles_are_found_in_rising_and_other_counts() {
        for counts in [vec![2, 2, 4, 4, 9], vec![2, 5, 4, 8, 7]] {
            let table = LevelTable::new(PositionIndex::identity(7), 3, counts.clone(), vec![0.0; 4]);
            let table = table.expect("a table");
            for limit in 0..12 {
                let expected = counts.iter().rposition(|&n| n as usize <= limit).unwrap_or(0);
                assert_eq!(table.split_count_for_triangles(limit), expected, "{counts:?} {limit}");
            }
        }
    }
}
