//! Converts a table to and from the arrays of the file format.

use super::step_counts::StepCounts;
use super::table::{FanTable, TableArrays};
use super::{Fans, validate};
use crate::model::ModelError;
use crate::model::step_bounds::StepBounds;
use crate::model::step_vertices::StepVertices;

/// The stored arrays of a table, except for those that come from the sequence.
#[derive(Clone, Copy, Debug)]
pub(crate) struct FansParts<'a> {
    /// Encoded entries of all vertices.
    pub entries: &'a [u8],
    /// Offset of each block of vertices, or of each vertex if `starts` is empty.
    pub blocks: &'a [u32],
    /// Offset of each vertex from the start of its block.
    pub starts: &'a [u16],
    /// Pairs of a step and an additional step that must be collapsed before it.
    pub waits: &'a [[u32; 2]],
    /// Pairs of a step and the step of its target, for targets that are not in the ring.
    pub far: &'a [[u32; 2]],
    /// Steps that are children of the base without being listed in a base entry.
    pub orphans: &'a [u32],
}

impl Fans {
    /// Returns the arrays to store in a file.
    pub(crate) fn parts(&self) -> FansParts<'_> {
        let TableArrays { entries, blocks, starts } = self.table.arrays();
        FansParts { entries, blocks, starts, waits: &self.waits, far: &self.far, orphans: &self.orphans }
    }

    /// Copies stored arrays into a table and validates them, so that no later operation can fail. If the steps
    /// are collapses, `removed` is the number of triangles that each of them removes.
    pub(crate) fn from_parts(
        vertices: StepVertices<'_>,
        removed: Option<&[u8]>,
        group_count: usize,
        parts: FansParts<'_>,
    ) -> Result<Self, ModelError> {
        let FansParts { entries, blocks, starts, waits, far, orphans } = parts;
        let step_count = removed.map_or_else(|| vertices.step_count(), <[u8]>::len);
        vertices.check_firsts(step_count)?;
        let arrays = TableArrays { entries, blocks, starts };
        let table = FanTable::from_arrays(arrays, vertices.vertex_count, group_count > 1)?;
        let mut fans = Self {
            vertices: vertices.without_targets().shortened(),
            step_count,
            group_count,
            table,
            waits: waits.to_vec(),
            far: far.to_vec(),
            orphans: orphans.to_vec(),
            added: StepCounts::default(),
            bounds: None,
            quick: Default::default(),
        };
        fans.added = validate::check(&fans, removed)?;
        Ok(fans)
    }

    /// Adds bounds read from their stored bytes. `errors` are the errors of the steps, if they are known apart
    /// from the bounds.
    ///
    /// # Errors
    /// If the number of records differs from that of the errors, or a record is not a valid bound.
    pub(crate) fn with_stored_bounds(self, bytes: &[u8], errors: Option<&[f32]>) -> Result<Self, ModelError> {
        let bounds = StepBounds::from_bytes(bytes, self.step_count, errors)?;
        Ok(Self { bounds: Some(bounds), ..self })
    }

    /// Returns the bounds to store in a file; empty if the table was built without bounds.
    pub(crate) fn stored_bounds(&self) -> &[u8] {
        self.bounds.as_ref().map_or(&[], StepBounds::as_bytes)
    }

    /// Number of steps that have bounds.
    pub(crate) fn bounded_step_count(&self) -> usize {
        self.bounds.as_ref().map_or(0, StepBounds::step_count)
    }
}
