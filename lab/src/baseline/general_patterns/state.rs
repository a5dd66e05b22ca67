//! State of one instance: the fragments that are inserted, and the current triangulation with its directed
//! edges.

use std::collections::HashMap;

use striata::mesh::canonical_triangles;

use super::GeneralPatterns;
use super::records::PatternHead;
use crate::baseline::step_set::{StepSet, StepSetChange};

/// Marks an empty slot, the end of a list, and a vertex that is not known yet.
const NONE: u32 = u32::MAX;

/// State of one instance: a closed set of fragments and the triangulation that it shows.
///
/// Two instances are equal if they show the same triangles, regardless of how they got there.
#[derive(Clone, Debug)]
pub struct GeneralPatternsState {
    pub(super) inserted: StepSet,
    /// Corners of the triangles; those of free slots are [`NONE`].
    corners: Vec<[u32; 3]>,
    free: Vec<u32>,
    /// First half-edge (`3 * slot + corner`) of each directed edge.
    sides: HashMap<[u32; 2], u32>,
    /// The next half-edge with the same ends.
    next: Vec<u32>,
    /// The step that restores each vertex, or [`NONE`] for those of the base.
    step_of: Vec<u32>,
}

impl GeneralPatternsState {
    pub(super) fn base(model: &GeneralPatterns) -> Self {
        let mut step_of = vec![NONE; model.vertices.vertex_count()];
        for step in 0..model.records.len() {
            model.vertices.of_step(step).for_each(|vertex| step_of[vertex as usize] = step as u32);
        }
        let mut state = Self {
            inserted: StepSet::new(model.records.len()),
            corners: Vec::new(),
            free: Vec::new(),
            sides: HashMap::new(),
            next: Vec::new(),
            step_of,
        };
        model.base.iter().for_each(|&triangle| state.add(triangle));
        state
    }

    /// The triangles shown, unordered.
    pub fn triangles(&self) -> impl Iterator<Item = [u32; 3]> + '_ {
        self.corners.iter().copied().filter(|corners| corners[0] != NONE)
    }

    /// Number of triangles shown.
    pub fn triangle_count(&self) -> usize {
        self.corners.len() - self.free.len()
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
    pub(super) fn check(&self, model: &GeneralPatterns) {
        assert_eq!(self.inserted.limit(), model.records.len(), "the state belongs to another model");
    }

    pub(super) fn apply(&mut self, model: &GeneralPatterns, change: &StepSetChange) {
        change.removed.iter().for_each(|&step| self.remove_fragment(model, step));
        change.inserted.iter().for_each(|&step| self.insert_fragment(model, step));
    }

    /// Replaces a fragment's floor, which must be shown, by its ceiling.
    fn insert_fragment(&mut self, model: &GeneralPatterns, step: u32) {
        let PatternHead { anchors, rule, .. } = model.records.head(step);
        let rule = model.rules.get(rule as usize);
        let covered: Vec<u32> = model.records.covered(step).collect();
        let mut locals = vec![NONE; rule.local_count];
        locals[..2].copy_from_slice(&anchors);
        let mut slots = Vec::with_capacity(rule.floor.len());
        let is_below = |maker: u32| maker == NONE || covered.contains(&maker);
        let is_found = self.find(rule.floor, &mut locals, &mut slots, &is_below);
        assert!(is_found, "the floor of step {step} is shown");
        slots.iter().for_each(|&slot| self.remove(slot));
        for (&local, vertex) in rule.own.iter().zip(model.vertices.of_step(step as usize)) {
            locals[usize::from(local)] = vertex;
        }
        Self::set_listed(model, step, &mut locals);
        rule.ceiling.iter().for_each(|triangle| self.add(triangle.map(|local| locals[usize::from(local)])));
        self.inserted.insert(step);
    }

    /// Replaces a fragment's ceiling, all of which must be shown, by its floor.
    fn remove_fragment(&mut self, model: &GeneralPatterns, step: u32) {
        let PatternHead { anchors, rule, .. } = model.records.head(step);
        let rule = model.rules.get(rule as usize);
        let mut locals = vec![NONE; rule.local_count];
        locals[..2].copy_from_slice(&anchors);
        let mut slots = Vec::with_capacity(rule.ceiling.len());
        let is_found = self.find(rule.ceiling, &mut locals, &mut slots, &|maker| maker == step);
        assert!(is_found, "the ceiling of step {step} is shown");
        slots.iter().for_each(|&slot| self.remove(slot));
        Self::set_listed(model, step, &mut locals);
        rule.floor.iter().for_each(|triangle| self.add(triangle.map(|local| locals[usize::from(local)])));
        self.inserted.remove(step);
    }

    /// Sets the local vertices that a fragment lists.
    fn set_listed(model: &GeneralPatterns, step: u32, locals: &mut [u32]) {
        let rule_of = |rule: u32| model.rules.get(rule as usize);
        let listed = model.records.listed(step, |rule| rule_of(rule).listed.len());
        let rule = rule_of(model.records.head(step).rule);
        for (&local, &vertex) in rule.listed.iter().zip(listed) {
            locals[usize::from(local)] = vertex;
        }
    }

    /// Locates a pattern whose anchors are known: each triangle is entered over an edge whose ends are known.
    /// `accept` decides about the fragment that created a triangle. Returns false if it is not there.
    fn find(
        &self,
        pattern: &[[u8; 3]],
        locals: &mut [u32],
        slots: &mut Vec<u32>,
        accept: &impl Fn(u32) -> bool,
    ) -> bool {
        let Some((corners, rest)) = pattern.split_first() else { return true };
        let [x, y, z] = corners.map(usize::from);
        let known = locals[z];
        let mut at = self.sides.get(&[locals[x], locals[y]]).copied().unwrap_or(NONE);
        while at != NONE {
            let slot = at / 3;
            let corners = self.corners[slot as usize];
            let third = corners[(at as usize % 3 + 2) % 3];
            let is_new = !slots.contains(&slot);
            if is_new && (known == NONE || known == third) && accept(self.maker(corners)) {
                locals[z] = third;
                slots.push(slot);
                if self.find(rest, locals, slots, accept) {
                    return true;
                }
                slots.pop();
                locals[z] = known;
            }
            at = self.next[at as usize];
        }
        false
    }

    /// The fragment that creates a triangle: that of its youngest corner; [`NONE`] in the base.
    fn maker(&self, [a, b, c]: [u32; 3]) -> u32 {
        self.step_of[a.max(b).max(c) as usize]
    }

    fn add(&mut self, corners: [u32; 3]) {
        let slot = self.free.pop().unwrap_or_else(|| {
            self.corners.push([NONE; 3]);
            self.next.extend([NONE; 3]);
            self.corners.len() as u32 - 1
        });
        self.corners[slot as usize] = corners;
        for k in 0..3 {
            let side = [corners[k], corners[(k + 1) % 3]];
            let half_edge = 3 * slot + k as u32;
            self.next[half_edge as usize] = self.sides.insert(side, half_edge).unwrap_or(NONE);
        }
    }

    fn remove(&mut self, slot: u32) {
        let corners = std::mem::replace(&mut self.corners[slot as usize], [NONE; 3]);
        for k in 0..3 {
            let side = [corners[k], corners[(k + 1) % 3]];
            let half_edge = 3 * slot + k as u32;
            let following = std::mem::replace(&mut self.next[half_edge as usize], NONE);
            let mut at = self.sides[&side];
            if at == half_edge {
                if following == NONE {
                    self.sides.remove(&side);
                } else {
                    self.sides.insert(side, following);
                }
                continue;
            }
            while self.next[at as usize] != half_edge {
                at = self.next[at as usize];
            }
            self.next[at as usize] = following;
        }
        self.free.push(slot);
    }

    pub(super) fn bytes(&self) -> usize {
        let entry = size_of::<([u32; 2], u32)>() + 1;
        self.inserted.bytes()
            + size_of_val(&self.corners[..])
            + 4 * (self.free.len() + self.next.len() + self.step_of.len())
            + entry * self.sides.capacity()
    }
}

impl PartialEq for GeneralPatternsState {
    fn eq(&self, other: &Self) -> bool {
        let triangles = |state: &Self| canonical_triangles(&state.triangles().collect::<Vec<_>>());
        self.inserted == other.inserted && triangles(self) == triangles(other)
    }
}

impl Eq for GeneralPatternsState {}
