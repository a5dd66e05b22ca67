//! What one instance owns: the fragments that are inserted and the triangles that are there.

use striata::mesh::FragmentSequence;

use super::MultiTriangulation;
use crate::baseline::step_set::{Change, StepSet};

const NO_STEP: u32 = FragmentSequence::NO_STEP;

/// Not shown.
const NONE: u32 = u32::MAX;

/// An instance: a closed set of fragments and the triangles that it shows.
///
/// Two instances are equal if they show the same, however they came there.
#[derive(Clone, Debug)]
pub struct MultiTriangulationState {
    pub(super) inserted: StepSet,
    /// What is drawn.
    corners: Vec<[u32; 3]>,
    /// The numbers of these triangles.
    numbers: Vec<u32>,
    /// Where each triangle stands among them, or [`NONE`].
    place_of: Vec<u32>,
    /// How many triangles of its ceiling other fragments have replaced: 0 for a fragment on top.
    pub(super) replaced_counts: Vec<u32>,
}

impl MultiTriangulationState {
    pub(super) fn base(model: &MultiTriangulation) -> Self {
        let step_count = model.errors.len();
        let mut state = Self {
            inserted: StepSet::new(step_count),
            corners: Vec::new(),
            numbers: Vec::new(),
            place_of: vec![NONE; model.triangles.len()],
            replaced_counts: vec![0; step_count],
        };
        (0..model.base_triangle_count as u32).for_each(|number| state.show(model, number));
        state
    }

    /// The triangles that it shows, of all groups, in no order.
    pub fn triangles(&self) -> &[[u32; 3]] {
        &self.corners
    }

    /// Their numbers.
    pub fn triangle_numbers(&self) -> &[u32] {
        &self.numbers
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

    pub(super) fn numbered(&self) -> impl Iterator<Item = (u32, &[u32; 3])> {
        self.numbers.iter().copied().zip(&self.corners)
    }

    /// Whether the instance is one of the model's, as far as sizes tell.
    pub(super) fn check(&self, model: &MultiTriangulation) {
        assert!(
            self.inserted.limit() == model.errors.len() && self.place_of.len() == model.triangles.len(),
            "the state belongs to another model"
        );
    }

    pub(super) fn level_change(&self, split_count: usize) -> Change {
        self.inserted.change_to_level(split_count)
    }

    pub(super) fn apply(&mut self, model: &MultiTriangulation, change: &Change) {
        change.removed.iter().for_each(|&step| self.remove(model, step));
        change.inserted.iter().for_each(|&step| self.insert(model, step));
    }

    /// Replaces a floor by its ceiling.
    pub(super) fn insert(&mut self, model: &MultiTriangulation, step: u32) {
        for &number in model.floor(step) {
            self.hide(number);
            let lower = model.triangles[number as usize].lower;
            if lower != NO_STEP {
                self.replaced_counts[lower as usize] += 1;
            }
        }
        model.ceiling(step).iter().for_each(|&number| self.show(model, number));
        self.inserted.insert(step);
    }

    /// Replaces a ceiling by its floor.
    pub(super) fn remove(&mut self, model: &MultiTriangulation, step: u32) {
        debug_assert_eq!(self.replaced_counts[step as usize], 0, "step {step} is not on top");
        model.ceiling(step).iter().for_each(|&number| self.hide(number));
        for &number in model.floor(step) {
            self.show(model, number);
            let lower = model.triangles[number as usize].lower;
            if lower != NO_STEP {
                self.replaced_counts[lower as usize] -= 1;
            }
        }
        self.inserted.remove(step);
    }

    fn show(&mut self, model: &MultiTriangulation, number: u32) {
        debug_assert_eq!(self.place_of[number as usize], NONE, "triangle {number} is there twice");
        self.place_of[number as usize] = self.numbers.len() as u32;
        self.numbers.push(number);
        self.corners.push(model.triangles[number as usize].corners);
    }

    fn hide(&mut self, number: u32) {
        let place = std::mem::replace(&mut self.place_of[number as usize], NONE) as usize;
        self.numbers.swap_remove(place);
        self.corners.swap_remove(place);
        if let Some(&moved) = self.numbers.get(place) {
            self.place_of[moved as usize] = place as u32;
        }
    }

    pub(super) fn bytes(&self) -> usize {
        self.inserted.bytes()
            + size_of_val(&self.corners[..])
            + 4 * (self.numbers.len() + self.place_of.len() + self.replaced_counts.len())
    }
}

impl PartialEq for MultiTriangulationState {
    fn eq(&self, other: &Self) -> bool {
        let shows = |&number: &u32| other.place_of.get(number as usize).is_some_and(|&place| place != NONE);
        self.inserted == other.inserted
            && self.numbers.len() == other.numbers.len()
            && self.numbers.iter().all(shows)
    }
}

impl Eq for MultiTriangulationState {}
