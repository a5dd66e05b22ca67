//! Simplifies a patch of a larger mesh, whose border stays.

use super::collapse::cost_evaluator::CostEvaluator;
use super::collapse::simplifier::Simplifier;
use super::scaled_space::ScaledSpace;
use super::{SequenceOptions, SimplifyError};
use crate::ignore_progress;
use crate::mesh::Welded;

/// A vertex that an earlier simplification has removed, from which errors are measured.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct CarriedWitness {
    /// Position of the patch at which it is measured.
    pub position: u32,
    /// Place of the vertex, mesh units.
    pub place: [f32; 3],
    /// Distance from the surface when it was last measured, mesh units.
    pub distance: f32,
}

/// A part of a mesh that is simplified on its own. Vertices to keep are those that the options lock.
pub(crate) struct LockedPatch<'a> {
    pub welded: &'a Welded,
    /// Diagonal of the whole mesh, mesh units.
    pub diagonal: f64,
    /// Whether the whole mesh is [a scan](CostEvaluator::is_scan).
    pub is_scan: bool,
    /// At most one witness for each position.
    pub witnesses: &'a [CarriedWitness],
    /// Error of the patch so far, mesh units. Smaller errors are not measured.
    pub error: f32,
}

/// Result of [`LockedPatch::simplify`].
pub(crate) struct SimplifiedPatch {
    /// The vertex that each vertex becomes: itself, or a vertex that is left.
    pub targets: Vec<u32>,
    /// At least [`LockedPatch::error`], mesh units.
    pub error: f32,
}

impl LockedPatch<'_> {
    /// Simplifies the patch as far as the options allow.
    ///
    /// # Errors
    /// [`SimplifyError`] if the simplifier fails.
    pub(crate) fn simplify(&self, options: &SequenceOptions) -> Result<SimplifiedPatch, SimplifyError> {
        let mesh = &self.welded.mesh;
        let mut evaluator = CostEvaluator::with_scale(self.welded, options, self.diagonal);
        evaluator.is_cell = true;
        evaluator.is_scan = self.is_scan;
        let mut simplifier = Simplifier::with_evaluator(self.welded, options, evaluator);
        let space = ScaledSpace::with_scale(mesh, self.diagonal);
        let scaled = |distance: f32| (f64::from(distance) / self.diagonal) as f32;
        let witnesses = simplifier.witnesses_mut();
        for witness in self.witnesses {
            witnesses.carry(
                witness.position,
                space.scaled(witness.place).as_vec3(),
                scaled(witness.distance),
            );
        }
        witnesses.raise(scaled(self.error).powi(2));
        let part = simplifier.run_part(&mut ignore_progress)?;
        let positions = &self.welded.positions;
        let mut targets: Vec<u32> = (0..mesh.vertex_count() as u32).collect();
        // In reverse order, so that the target of a target is final.
        for v in part.record.removed.iter().rev().flat_map(|&p| positions.wedges(p)) {
            targets[v as usize] = targets[part.record.targets[v as usize] as usize];
        }
        Ok(SimplifiedPatch {
            error: part.record.errors.last().map_or(self.error, |&error| error.max(self.error)),
            targets,
        })
    }
}
