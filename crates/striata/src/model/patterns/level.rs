//! Patterns as a model of uniform levels.

use super::{PatternInstance, Patterns};
use crate::model::{DrawCounts, LodModel, PartBytes, StepVertices, StoredModel, Topology};

/// An instance of [`Patterns`] at a uniform level.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PatternsState {
    instance: PatternInstance,
}

impl PatternsState {
    /// Returns the instance.
    pub fn instance(&self) -> &PatternInstance {
        &self.instance
    }
}

impl LodModel for Patterns {
    type State = PatternsState;

    fn step_count(&self) -> usize {
        self.fragment_count()
    }

    fn new_state(&self) -> PatternsState {
        PatternsState { instance: PatternInstance::full(self) }
    }

    fn split_count(&self, state: &PatternsState) -> usize {
        state.instance.split_count()
    }

    fn move_to(&self, state: &mut PatternsState, split_count: usize) {
        assert!(
            split_count <= self.fragment_count(),
            "split count {split_count} of {}",
            self.fragment_count()
        );
        state.instance.check(self);
        let now = state.instance.split_count();
        for step in (split_count..now).rev() {
            state.instance.remove_top(self, step as u32);
        }
        for step in now..split_count {
            state.instance.insert_next(self, step as u32);
        }
    }

    fn topology(&self) -> Topology {
        Topology::Triangles
    }

    fn draw_counts(&self, state: &PatternsState) -> DrawCounts {
        DrawCounts { strip_count: 0, index_count: 3 * state.instance.triangle_count() }
    }

    fn indices_into(&self, state: &PatternsState, out: &mut Vec<u32>) {
        let mut triangles = Vec::new();
        self.triangles_into(state, &mut triangles);
        out.extend_from_slice(triangles.as_flattened());
    }

    fn triangles_into(&self, state: &PatternsState, out: &mut Vec<[u32; 3]>) {
        for group in 0..self.group_count {
            self.group_triangles_into(state, group, out);
        }
    }

    fn bytes(&self) -> Vec<PartBytes> {
        let [records, blocks] = self.records.bytes();
        let part = |name, bytes| PartBytes { name, bytes };
        let mut parts = vec![
            part("records", records),
            part("blocks of records", blocks),
            part("table of rules", self.rules.bytes()),
            part("table of sharings", self.sharings.bytes()),
            part("table of kinds", self.kinds.bytes()),
            part("base", size_of_val(&self.base[..]) + size_of_val(&self.floorless[..])),
            part("first vertices", size_of_val(&self.vertices.firsts[..])),
        ];
        parts.extend(self.bounds.as_ref().map(|bounds| part("bounds", bounds.as_bytes().len())));
        parts
    }

    fn state_bytes(&self, state: &PatternsState) -> usize {
        state.instance.bytes()
    }
}

impl StoredModel for Patterns {
    fn step_vertices(&self) -> &StepVertices<'_> {
        &self.vertices
    }

    fn group_count(&self) -> usize {
        self.group_count
    }

    fn group_triangles_into(&self, state: &PatternsState, group: usize, out: &mut Vec<[u32; 3]>) {
        assert!(group < self.group_count, "group {group} of {}", self.group_count);
        state.instance.group_triangles_into(group as u32, out);
    }
}
