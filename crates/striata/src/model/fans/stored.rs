//! What a file holds of a table, and the table that comes out of it.

use super::table::{Table, TableArrays};
use super::{Fans, validate};
use crate::model::ModelError;
use crate::model::step_bounds::StepBounds;
use crate::model::step_vertices::StepVertices;

/// The stored arrays of a table, without what the sequence knows already.
#[derive(Clone, Copy, Debug)]
pub(crate) struct FansParts<'a> {
    /// Bytes of all entries.
    pub(crate) entries: &'a [u8],
    /// Where each block of vertices begins, or each vertex where `starts` is empty.
    pub(crate) blocks: &'a [u32],
    /// Where each vertex begins in its block.
    pub(crate) starts: &'a [u16],
    /// Steps and further steps that they wait for.
    pub(crate) waits: &'a [[u32; 2]],
    /// Steps and those of targets that are not around them.
    pub(crate) far: &'a [[u32; 2]],
    /// Steps that hang from the base.
    pub(crate) orphans: &'a [u32],
}

impl Fans {
    /// The arrays that a file is to hold.
    pub(crate) fn parts(&self) -> FansParts<'_> {
        let TableArrays { entries, blocks, starts } = self.table.arrays();
        FansParts { entries, blocks, starts, waits: &self.waits, far: &self.far, orphans: &self.orphans }
    }

    /// Puts stored arrays together, in memory of their own, and checks them once, so that nothing can fail later. `removed` are
    /// the triangles that each step of the sequence takes away.
    pub(crate) fn from_parts(
        vertices: StepVertices<'_>,
        removed: &[u8],
        group_count: usize,
        parts: FansParts<'_>,
    ) -> Result<Self, ModelError> {
        let FansParts { entries, blocks, starts, waits, far, orphans } = parts;
        let step_count = removed.len();
        vertices.check(step_count)?;
        let arrays = TableArrays { entries, blocks, starts };
        let table = Table::from_arrays(arrays, vertices.vertex_count, group_count > 1)?;
        let fans = Self {
            vertices: vertices.without_targets(),
            step_count,
            group_count,
            table,
            waits: waits.to_vec(),
            far: far.to_vec(),
            orphans: orphans.to_vec(),
            removed: removed.into(),
            bounds: None,
        };
        validate::check(&fans)?;
        Ok(fans)
    }

    /// The same table with the bounds of its steps from their bytes, given the errors of the steps.
    ///
    /// # Errors
    /// If there are more or fewer records than errors, or one holds what no bounds are.
    pub(crate) fn with_stored_bounds(self, bytes: &[u8], errors: &[f32]) -> Result<Self, ModelError> {
        let bounds = StepBounds::from_bytes(bytes, errors.len(), Some(errors))?;
        Ok(Self { bounds: Some(bounds), ..self })
    }

    /// The bounds as a file is to hold them; none if the table was built without.
    pub(crate) fn stored_bounds(&self) -> &[u8] {
        self.bounds.as_ref().map_or(&[], StepBounds::as_bytes)
    }

    /// Steps that there are bounds of.
    pub(crate) fn bounded_step_count(&self) -> usize {
        self.bounds.as_ref().map_or(0, StepBounds::step_count)
    }
}
