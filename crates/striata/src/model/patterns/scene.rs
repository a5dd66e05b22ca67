//! Patterns with what it takes to ask a criterion of their fragments.

use super::Patterns;
use crate::model::step_bounds::StepBounds;
use crate::view::Part;

/// Patterns with the positions that they are around: what is needed to ask a criterion of a fragment.
#[derive(Clone, Copy, Debug)]
pub struct PatternScene<'a> {
    patterns: &'a Patterns,
    bounds: &'a StepBounds,
    positions: &'a [[f32; 3]],
}

impl<'a> PatternScene<'a> {
    /// Puts the two together.
    ///
    /// # Panics
    /// If they are not of one mesh, by their counts, or the patterns are of fragments alone and have no bounds.
    pub fn new(patterns: &'a Patterns, positions: &'a [[f32; 3]]) -> Self {
        let bounds = patterns.bounds.as_ref().expect("the patterns were built with bounds");
        assert_eq!(positions.len(), patterns.vertices.vertex_count, "the positions are of another mesh");
        Self { patterns, bounds, positions }
    }

    /// The patterns.
    pub fn patterns(&self) -> &'a Patterns {
        self.patterns
    }

    /// What a fragment is to a criterion.
    ///
    /// # Panics
    /// If there is no such fragment.
    #[inline]
    pub fn part(&self, step: u32) -> Part {
        let center = self.patterns.vertices.of_step(step as usize).start;
        self.bounds.part(step, self.positions[center as usize])
    }
}
