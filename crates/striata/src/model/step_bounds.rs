//! The bounds of all steps of a model: for each a sphere, a cone of normals and an error.

use super::ModelError;
use super::part_record::{Bounded, PartRecord, bound};
use crate::view::Part;

/// For each step a sphere and a cone of normals that hold whatever it and those below it in the tree of steps change, and
/// the error that is there while it is left out.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(in crate::model) struct StepBounds {
    records: Box<[PartRecord]>,
}

impl StepBounds {
    /// The bounds of steps, nested along their tree.
    pub(in crate::model) fn build(steps: &mut impl Bounded) -> Self {
        Self { records: bound(steps).into() }
    }

    /// The bounds of so many steps from the bytes of their records. If errors are given, each record has to have that of its
    /// step.
    ///
    /// # Errors
    /// If there are more or fewer records, or one holds what no bounds are.
    pub(in crate::model) fn from_bytes(
        bytes: &[u8],
        step_count: usize,
        errors: Option<&[f32]>,
    ) -> Result<Self, ModelError> {
        let records = PartRecord::read_all(bytes, step_count)?;
        for (step, record) in records.iter().enumerate() {
            let wrong = |reason| ModelError::Step { step, reason };
            record.check_shape().map_err(wrong)?;
            if errors.is_some_and(|errors| !record.has_error(errors[step])) {
                return Err(wrong("has another error in its bounds than in the sequence"));
            }
        }
        Ok(Self { records: records.into() })
    }

    /// What a step is to a criterion, given the center of its sphere.
    ///
    /// # Panics
    /// If there is no such step.
    #[inline]
    pub(in crate::model) fn part(&self, step: u32, center: [f32; 3]) -> Part {
        self.records[step as usize].part(center)
    }

    /// Steps that there are bounds of.
    pub(in crate::model) fn step_count(&self) -> usize {
        self.records.len()
    }

    /// The records as files hold them.
    pub(in crate::model) fn as_bytes(&self) -> &[u8] {
        bytemuck::must_cast_slice(&self.records)
    }
}
