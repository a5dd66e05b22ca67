//! Combines patterns with the positions that a view criterion needs.

use super::Patterns;
use crate::model::step_bounds::StepBounds;
use crate::view::Part;

/// Patterns with bounds and the vertex positions of their mesh, as needed to evaluate a view criterion.
#[derive(Clone, Copy, Debug)]
pub struct PatternScene<'a> {
    patterns: &'a Patterns,
    bounds: &'a StepBounds,
    positions: &'a [[f32; 3]],
}

impl<'a> PatternScene<'a> {
    /// Combines patterns with the positions of their mesh.
    ///
    /// # Panics
    /// If their vertex counts differ, or the patterns were built without bounds.
    pub fn new(patterns: &'a Patterns, positions: &'a [[f32; 3]]) -> Self {
        let bounds = patterns.bounds.as_ref().expect("the patterns were built with bounds");
        assert_eq!(
            positions.len(),
            patterns.vertices.vertex_count,
            "the positions belong to a different mesh"
        );
        Self { patterns, bounds, positions }
    }

    /// Returns the patterns.
    pub fn patterns(&self) -> &'a Patterns {
        self.patterns
    }

    /// Returns the bounds of a fragment in the form that a criterion evaluates.
    ///
    /// # Panics
    /// If the fragment does not exist.
    #[inline]
    pub fn part(&self, step: u32) -> Part {
        let center = self.patterns.vertices.of_step(step as usize).start;
        self.bounds.part(step, self.positions[center as usize])
    }
}
