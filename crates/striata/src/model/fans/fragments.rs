//! Converts a table back to the fragments that it was built from.

use super::Fans;
use crate::mesh::{Face, Fragment, FragmentError, FragmentSequence, SequenceError};
use crate::model::ModelError;
use crate::model::fans::table::FanView;

impl Fans {
    /// Reconstructs the fragments of the steps, given the errors of their floors. The faces of a fragment come in
    /// the order of the table.
    ///
    /// # Errors
    /// [`ModelError`] if the number of errors is not the step count, or an error is negative or not finite.
    pub fn to_fragments(&self, floor_errors: &[f32]) -> Result<FragmentSequence, ModelError> {
        if floor_errors.len() != self.step_count {
            let (found, expected) = (floor_errors.len(), self.step_count);
            return Err(ModelError::Length { what: "errors", found, expected });
        }
        let with_error = |&error: &f32| Fragment { error, ..Fragment::default() };
        let mut fragments: Vec<Fragment> = floor_errors.iter().map(with_error).collect();
        let mut base = Vec::new();
        for fan in self.table_fans() {
            let every_arc = u32::MAX >> (32 - fan.view.arc_count());
            let ceiling = match fan.own_step() {
                Some(step) => &mut fragments[step as usize].ceiling,
                None => &mut base,
            };
            faces_into(&fan.view, every_arc, ceiling);
            for creator in fan.view.creators() {
                faces_into(&fan.view, creator.mask, &mut fragments[creator.step as usize].floor);
            }
        }
        let positions = self.vertices.positions();
        FragmentSequence::from_fragments(positions, base, fragments.into_iter()).map_err(|error| {
            let step = match error {
                FragmentError::Sequence(SequenceError::Error { step, .. }) => step,
                FragmentError::Floor { step, .. } => step as usize,
                _ => 0,
            };
            ModelError::Step { step, reason: "does not replace triangles of coarser steps by its own" }
        })
    }
}

/// Appends the triangles of some arcs of a fan.
fn faces_into(fan: &FanView<'_>, arcs: u32, out: &mut Vec<Face>) {
    let mut indices = Vec::new();
    fan.triangles_into(arcs, &mut indices);
    let triangles: &[[u32; 3]] = indices.as_chunks().0;
    out.extend(triangles.iter().map(|&corners| Face { corners, group: fan.group }));
}
