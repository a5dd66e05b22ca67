//! State of one instance: the fragments that are inserted and the current triangulation with adjacency.

use striata::mesh::canonical_triangles;

use super::LoopPatterns;
use super::records::LoopHead;
use super::surface::{LoopRegion, LoopSurface, Side};
use crate::baseline::step_set::{StepSet, StepSetChange};

/// State of one instance: a closed set of fragments and the triangulation that it shows.
///
/// Two instances are equal if they show the same triangles, regardless of how they got there.
#[derive(Clone, Debug)]
pub struct LoopPatternsState {
    pub(super) inserted: StepSet,
    surface: LoopSurface,
    /// Scratch: the floor or fan being replaced.
    region: LoopRegion,
    star: Vec<Side>,
}

impl LoopPatternsState {
    pub(super) fn base(model: &LoopPatterns) -> Self {
        let step_count = model.records.len();
        let vertex_count = model.vertices.vertex_count();
        let surface = LoopSurface::new(&model.base, vertex_count);
        Self {
            inserted: StepSet::new(step_count),
            surface: surface.expect("the base was checked when the model was built"),
            region: LoopRegion::default(),
            star: Vec::new(),
        }
    }

    /// The triangles shown, unordered.
    pub fn triangles(&self) -> &[[u32; 3]] {
        self.surface.corners()
    }

    /// Whether a vertex is active.
    ///
    /// # Panics
    /// If the vertex does not exist.
    pub fn is_active(&self, vertex: u32) -> bool {
        self.surface.has(vertex)
    }

    /// Whether a fragment is inserted.
    ///
    /// # Panics
    /// If the fragment does not exist.
    pub fn is_refined(&self, step: u32) -> bool {
        self.inserted.has(step)
    }

    /// Number of fragments inserted.
    pub fn split_count(&self) -> usize {
        self.inserted.len()
    }

    /// Panics unless the state has the model's sizes.
    pub(super) fn check(&self, model: &LoopPatterns) {
        assert_eq!(self.inserted.limit(), model.records.len(), "the state belongs to another model");
    }

    pub(super) fn apply(&mut self, model: &LoopPatterns, change: &StepSetChange) {
        change.removed.iter().for_each(|&step| self.remove_fragment(model, step));
        change.inserted.iter().for_each(|&step| self.insert_fragment(model, step));
    }

    /// Replaces a fragment's floor, which must be shown, by its ceiling.
    pub(super) fn insert_fragment(&mut self, model: &LoopPatterns, step: u32) {
        let LoopHead { anchors: [a, b], rule, down } = model.records.head(step);
        let rule = model.rules.get(rule as usize);
        let surface = &self.surface;
        if rule.apexes.is_empty() {
            let side = surface.find_side(b, a, |side| surface.is_border(side));
            let (on, _) = side.expect("the triangle a fragment is attached to exists before it");
            self.region.attach([a, b], on);
        } else {
            // Two triangles may contain both anchors. The correct one was created by the first fragment of
            // the loop, or else is in the base.
            let is_made_by = |maker: Option<u32>| {
                move |(slot, _): Side| model.maker(&surface.corners()[slot as usize]) == maker
            };
            let side = surface
                .find_side(a, b, is_made_by((down.step != step).then_some(down.step)))
                .or_else(|| surface.find_side(a, b, is_made_by(None)));
            let side = side.expect("a floor exists before its ceiling");
            let is_match = surface.find_floor(rule, side, &mut self.region);
            assert!(is_match, "the floor of step {step} does not match its rule");
        }
        self.surface.replace_by_fan(model.vertices.base_vertex_count() + step, rule, &mut self.region);
        self.inserted.insert(step);
    }

    /// Replaces a fragment's ceiling, all of which must be shown, by its floor.
    pub(super) fn remove_fragment(&mut self, model: &LoopPatterns, step: u32) {
        let LoopHead { anchors, rule, .. } = model.records.head(step);
        let (vertex, rule) = (model.vertices.base_vertex_count() + step, model.rules.get(rule as usize));
        self.surface.find_fan(vertex, anchors[0], &mut self.region, &mut self.star);
        self.surface.replace_by_floor(vertex, rule, &mut self.region);
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
