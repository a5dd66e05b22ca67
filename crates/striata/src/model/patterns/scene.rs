//! Combines patterns with the positions that a view criterion needs.

use super::bounds::{Axes, PackedBounds, axes};
use super::{PatternInstance, Patterns};
use crate::view::Part;

/// Patterns with bounds and the vertex positions of their mesh, as needed to evaluate a view criterion.
#[derive(Clone, Copy, Debug)]
pub struct PatternScene<'a> {
    patterns: &'a Patterns,
    bounds: &'a PackedBounds,
    axes: &'static Axes,
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
        Self { patterns, bounds, axes: axes(), positions }
    }

    /// Returns the patterns.
    pub fn patterns(&self) -> &'a Patterns {
        self.patterns
    }

    /// Returns the bounds of a fragment in the form that a criterion evaluates: of everything that its
    /// floor stands for.
    ///
    /// # Panics
    /// If the fragment does not exist.
    #[inline]
    pub fn part(&self, step: u32) -> Part {
        let center = self.patterns.vertices.of_step(step as usize).start;
        self.bounds.part(step, self.positions[center as usize], self.axes)
    }

    /// Returns the largest error of the triangles that an instance shows, in mesh units.
    ///
    /// # Panics
    /// If the instance belongs to a different model.
    pub fn error_of(&self, instance: &PatternInstance) -> f32 {
        let mut largest = 0.0f32;
        instance.for_each_shown_overlap(self.patterns, |overlap| largest = largest.max(overlap.error));
        largest
    }
}
