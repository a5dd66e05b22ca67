//! Sets of steps as whole words, and what a set shows for a vertex.

use super::{FanInstance, Fans};
use crate::mesh::CollapseSequence;

impl FanInstance {
    /// Steps from the base mesh to the full mesh.
    pub fn step_count(&self) -> usize {
        self.step_count
    }

    /// The bits, 64 steps a word, low ones first: set where a step is taken.
    pub fn words(&self) -> &[u64] {
        self.taken.words()
    }

    /// The coarsest instance that shows every vertex that either of two shows.
    ///
    /// # Panics
    /// If the instances are of different tables.
    pub fn union(&self, other: &Self) -> Self {
        assert_eq!(self.step_count, other.step_count, "the instances are of different tables");
        // What either needs undone is undone in it, and so in both together.
        Self { step_count: self.step_count, taken: self.taken.and(&other.taken) }
    }

    /// The vertex that is shown for one of the full mesh: itself if it is there, else the first of its targets that is.
    ///
    /// # Panics
    /// If the sequence is another mesh's, or has no such vertex.
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
        assert_eq!(self.step_count, fans.step_count, "the instance is of another table");
    }
}
