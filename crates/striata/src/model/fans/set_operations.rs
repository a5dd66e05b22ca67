//! Set operations on instances, and lookup of the vertex that stands in for a removed one.

use super::{FanInstance, Fans};
use crate::mesh::CollapseSequence;

impl FanInstance {
    /// Number of steps from the base mesh to the full mesh.
    pub fn step_count(&self) -> usize {
        self.step_count
    }

    /// Returns the bits as words of 64 steps, low bits first; a bit is set if its step is collapsed.
    pub fn words(&self) -> &[u64] {
        self.collapsed.words()
    }

    /// Returns the coarsest instance that shows every vertex shown by either of the two.
    ///
    /// # Panics
    /// If the instances belong to different tables.
    pub fn union(&self, other: &Self) -> Self {
        assert_eq!(self.step_count, other.step_count, "the instances belong to different tables");
        // Each set contains all splits that its refined steps need, so their union does too.
        Self { step_count: self.step_count, collapsed: self.collapsed.and(&other.collapsed) }
    }

    /// Returns the vertex that represents a vertex of the full mesh: itself if it is active, or else the
    /// first active vertex in its chain of targets.
    ///
    /// # Panics
    /// If the sequence belongs to a different mesh, or the vertex does not exist.
    pub fn vertex_shown_for(&self, sequence: &CollapseSequence, mut vertex: u32) -> u32 {
        let base = sequence.base_position_count() as u32;
        loop {
            match sequence.positions().position_of(vertex).checked_sub(base) {
                Some(step) if !self.is_refined(step) => vertex = sequence.target(vertex),
                _ => return vertex,
            }
        }
    }

    pub(super) fn check_table(&self, fans: &Fans) {
        assert_eq!(self.step_count, fans.step_count, "the instance belongs to a different table");
    }
}
