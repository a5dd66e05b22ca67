//! What one instance owns: the fragments that are inserted and the current triangulation with its neighbors.

use striata::mesh::canonical_triangles;

use super::LoopPatterns;
use super::records::Head;
use super::surface::{Found, Side, Surface};
use crate::baseline::step_set::{Change, StepSet};

/// An instance: a closed set of fragments and the triangulation that it shows.
///
/// Two instances are equal if they show the same, however they came there.
#[derive(Clone, Debug)]
pub struct LoopPatternsState {
    pub(super) inserted: StepSet,
    surface: Surface,
    /// Scratch.
    found: Found,
    star: Vec<Side>,
}

impl LoopPatternsState {
    pub(super) fn base(model: &LoopPatterns) -> Self {
        let step_count = model.records.len();
        let vertex_count = model.vertices.vertex_count();
        let surface = Surface::new(&model.base, vertex_count);
        Self {
            inserted: StepSet::new(step_count),
            surface: surface.expect("the base was checked when the model was built"),
            found: Found::default(),
            star: Vec::new(),
        }
    }

    /// The triangles that it shows, in no order.
    pub fn triangles(&self) -> &[[u32; 3]] {
        self.surface.corners()
    }

    /// Whether a vertex is there.
    ///
    /// # Panics
    /// If there is no such vertex.
    pub fn is_active(&self, vertex: u32) -> bool {
        self.surface.has(vertex)
    }

    /// Whether a fragment is inserted.
    ///
    /// # Panics
    /// If there is no such fragment.
    pub fn is_refined(&self, step: u32) -> bool {
        self.inserted.has(step)
    }

    /// Fragments that are inserted.
    pub fn split_count(&self) -> usize {
        self.inserted.len()
    }

    /// Whether the instance is one of the model's, as far as sizes tell.
    pub(super) fn check(&self, model: &LoopPatterns) {
        assert_eq!(self.inserted.limit(), model.records.len(), "the state belongs to another model");
    }

    pub(super) fn apply(&mut self, model: &LoopPatterns, change: &Change) {
        change.removed.iter().for_each(|&step| self.remove_fragment(model, step));
        change.inserted.iter().for_each(|&step| self.insert_fragment(model, step));
    }

    /// Replaces the floor of a fragment, which is there, by its ceiling.
    pub(super) fn insert_fragment(&mut self, model: &LoopPatterns, step: u32) {
        let Head { anchors: [a, b], rule, down } = model.records.head(step);
        let rule = model.rules.get(rule as usize);
        let surface = &self.surface;
        if rule.apexes.is_empty() {
            let side = surface.find_side(b, a, |side| surface.is_border(side));
            let (on, _) = side.expect("what a fragment hangs on is there before it");
            self.found.hang([a, b], on);
        } else {
            // Two triangles may have the anchors. The first fragment of the loop makes the right one, if it is not of the base.
            let is_made_by = |maker: Option<u32>| {
                move |(slot, _): Side| model.maker(&surface.corners()[slot as usize]) == maker
            };
            let side = surface
                .find_side(a, b, is_made_by((down.step != step).then_some(down.step)))
                .or_else(|| surface.find_side(a, b, is_made_by(None)));
            let side = side.expect("a floor is there before its ceiling");
            let is_there = surface.find_floor(rule, side, &mut self.found);
            assert!(is_there, "the floor of step {step} is another");
        }
        self.surface.put_fan(model.vertices.base_vertex_count() + step, rule, &mut self.found);
        self.inserted.insert(step);
    }

    /// Replaces the ceiling of a fragment, which is all there, by its floor.
    pub(super) fn remove_fragment(&mut self, model: &LoopPatterns, step: u32) {
        let Head { anchors, rule, .. } = model.records.head(step);
        let (vertex, rule) = (model.vertices.base_vertex_count() + step, model.rules.get(rule as usize));
        self.surface.find_fan(vertex, anchors[0], &mut self.found, &mut self.star);
        self.surface.put_floor(vertex, rule, &mut self.found);
        self.inserted.remove(step);
    }

    pub(super) fn bytes(&self) -> usize {
        self.inserted.bytes() + self.surface.bytes()
    }
}

impl PartialEq for LoopPatternsState {
    fn eq(&self, other: &Self) -> bool {
        self.inserted == other.inserted
            && self.triangles().len() == other.triangles().len()
            && canonical_triangles(self.triangles()) == canonical_triangles(other.triangles())
    }
}

impl Eq for LoopPatternsState {}
