//! Converts patterns back to fragments.

use super::Patterns;
use super::walk::FragmentWalk;
use crate::mesh::{Face, Fragment, FragmentError, FragmentSequence};
use crate::model::ModelError;

impl Patterns {
    /// Reconstructs the fragments, given the errors of their floors. Faces come in the order of the rules.
    ///
    /// # Errors
    /// [`ModelError`] if the number of errors is not that of the fragments, or if an error is not finite or
    /// is negative.
    pub fn unpack(&self, floor_errors: Vec<f32>) -> Result<FragmentSequence, ModelError> {
        let step_count = self.records.step_count;
        if floor_errors.len() != step_count {
            let (found, expected) = (floor_errors.len(), step_count);
            return Err(ModelError::Length { what: "errors", found, expected });
        }
        let base: Vec<Face> =
            self.base.iter().map(|face| Face { corners: face.corners, group: face.group }).collect();
        let mut fragments = Vec::with_capacity(step_count);
        let mut errors = floor_errors.into_iter();
        FragmentWalk::new(self)?.for_each(|ceiling, floor| {
            let error = errors.next().unwrap_or(0.0);
            fragments.push(Fragment { ceiling: ceiling.to_vec(), floor: floor.to_vec(), error });
        })?;
        FragmentSequence::from_fragments(self.vertices.positions(), base, fragments.into_iter())
            .map_err(combination_error)
    }
}

/// Converts an error that only shows when the fragments are combined.
fn combination_error(error: FragmentError) -> ModelError {
    let (step, reason) = match error {
        FragmentError::Degenerate { step, .. } => (step, "has a triangle with a repeated corner"),
        FragmentError::Ceiling { step, .. } => (step, "has a triangle whose youngest corner is not its own"),
        FragmentError::Floor { step, .. } => (Some(step), "has a floor triangle that does not exist"),
        FragmentError::Sequence(_) => (None, "has inconsistent levels"),
    };
    match step {
        Some(step) => ModelError::Step { step: step as usize, reason },
        None => ModelError::Listed { what: "base", place: 0, reason },
    }
}
