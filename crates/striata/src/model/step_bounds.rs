//! Bounds of all steps of a model: a sphere, a normal cone and an error per step.

use super::ModelError;
use super::part_record::{Bounded, PartRecord, bound};
use crate::view::Part;
use crate::{Cancelled, ProgressFn};

/// For each step, a sphere and a normal cone that enclose everything changed by the step and its
/// descendants in the tree of steps, plus the error that remains while the step is collapsed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(in crate::model) struct StepBounds {
    records: Box<[PartRecord]>,
}

impl StepBounds {
    /// Computes the bounds of all steps, nested along their tree.
    ///
    /// # Errors
    /// [`Cancelled`] if the callback cancels.
    pub(in crate::model) fn build(
        steps: &mut impl Bounded,
        progress: &mut ProgressFn<'_>,
    ) -> Result<Self, Cancelled> {
        Ok(Self { records: bound(steps, progress)?.into() })
    }

    /// Wraps the records of all steps.
    pub(in crate::model) fn of_records(records: Vec<PartRecord>) -> Self {
        Self { records: records.into() }
    }

    /// Reads the bounds of `step_count` steps from stored records. If `errors` is given, the error of each
    /// record must match the error of its step.
    ///
    /// # Errors
    /// If the number of records is wrong, or a record is not a valid bound.
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
                return Err(wrong("has different errors in its bounds and in the sequence"));
            }
        }
        Ok(Self { records: records.into() })
    }

    /// Returns the bounds of a step in the form that a criterion evaluates, given the center of its sphere.
    ///
    /// # Panics
    /// If the step does not exist.
    #[inline(always)]
    pub(in crate::model) fn part(&self, step: u32, center: [f32; 3]) -> Part {
        self.records[step as usize].part(center)
    }

    /// Number of steps that have bounds.
    pub(in crate::model) fn step_count(&self) -> usize {
        self.records.len()
    }

    /// Returns the records in the layout of the file format.
    pub(in crate::model) fn as_bytes(&self) -> &[u8] {
        bytemuck::must_cast_slice(&self.records)
    }
}
