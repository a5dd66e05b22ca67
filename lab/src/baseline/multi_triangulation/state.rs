//! State of one instance: the fragments that are inserted and the triangles that are shown.

use striata::mesh::FragmentSequence;

use super::MultiTriangulation;
use crate::baseline::step_set::{StepSet, StepSetChange};

const NO_STEP: u32 = FragmentSequence::NO_STEP;

/// Marks a triangle that is not shown.
const NONE: u32 = u32::MAX;

/// State of one instance: a closed set of fragments and the triangles that it shows.
///
/// Two instances are equal if they show the same triangles, regardless of how they got there.
#[derive(Clone, Debug)]
pub struct MultiTriangulationState {
    pub(super) inserted: StepSet,
    /// Corners of the triangles shown.
    corners: Vec<[u32; 3]>,
    /// Indices of the triangles shown.
    shown: Vec<u32>,
    /// Index of each triangle in `shown`, or [`NONE`].
    shown_index_of: Vec<u32>,
    /// For each fragment, the number of its ceiling triangles that other fragments have replaced; 0 for a
    /// fragment on top.
    pub replaced_counts: Vec<u32>,
}

impl MultiTriangulationState {
    pub(super) fn base(model: &MultiTriangulation) -> Self {
        let step_count = model.errors.len();
        let mut state = Self {
            inserted: StepSet::new(step_count),
            corners: Vec::new(),
            shown: Vec::new(),
            shown_index_of: vec![NONE; model.triangles.len()],
            replaced_counts: vec![0; step_count],
        };
        (0..model.base_triangle_count as u32).for_each(|index| state.show(model, index));
        state
    }

    /// The triangles shown, of all groups, unordered.
    pub fn triangles(&self) -> &[[u32; 3]] {
        &self.corners
    }

    /// Indices of the triangles shown, in the order of [`triangles`](Self::triangles).
    pub fn triangle_indices(&self) -> &[u32] {
        &self.shown
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

    pub(super) fn indexed(&self) -> impl Iterator<Item = (u32, &[u32; 3])> {
        self.shown.iter().copied().zip(&self.corners)
    }

    /// Panics unless the state has the model's sizes.
    pub(super) fn check(&self, model: &MultiTriangulation) {
        assert!(
            self.inserted.limit() == model.errors.len() && self.shown_index_of.len() == model.triangles.len(),
            "the state belongs to another model"
        );
    }

    pub(super) fn level_change(&self, split_count: usize) -> StepSetChange {
        self.inserted.change_to_level(split_count)
    }

    pub(super) fn apply(&mut self, model: &MultiTriangulation, change: &StepSetChange) {
        change.removed.iter().for_each(|&step| self.remove(model, step));
        change.inserted.iter().for_each(|&step| self.insert(model, step));
    }

    /// Replaces a fragment's floor by its ceiling.
    pub(super) fn insert(&mut self, model: &MultiTriangulation, step: u32) {
        for &index in model.floor(step) {
            self.hide(index);
            let lower = model.triangles[index as usize].lower;
            if lower != NO_STEP {
                self.replaced_counts[lower as usize] += 1;
            }
        }
        model.ceiling(step).iter().for_each(|&index| self.show(model, index));
        self.inserted.insert(step);
    }

    /// Replaces a fragment's ceiling by its floor.
    pub(super) fn remove(&mut self, model: &MultiTriangulation, step: u32) {
        debug_assert_eq!(self.replaced_counts[step as usize], 0, "step {step} is not on top");
        model.ceiling(step).iter().for_each(|&index| self.hide(index));
        for &index in model.floor(step) {
            self.show(model, index);
            let lower = model.triangles[index as usize].lower;
            if lower != NO_STEP {
                self.replaced_counts[lower as usize] -= 1;
            }
        }
        self.inserted.remove(step);
    }

    fn show(&mut self, model: &MultiTriangulation, index: u32) {
        debug_assert_eq!(self.shown_index_of[index as usize], NONE, "triangle {index} is there twice");
        self.shown_index_of[index as usize] = self.shown.len() as u32;
        self.shown.push(index);
        self.corners.push(model.triangles[index as usize].corners);
    }

    fn hide(&mut self, index: u32) {
        let at = std::mem::replace(&mut self.shown_index_of[index as usize], NONE) as usize;
        self.shown.swap_remove(at);
        self.corners.swap_remove(at);
        if let Some(&moved) = self.shown.get(at) {
            self.shown_index_of[moved as usize] = at as u32;
        }
    }

    pub(super) fn bytes(&self) -> usize {
        self.inserted.bytes()
            + size_of_val(&self.corners[..])
            + 4 * (self.shown.len() + self.shown_index_of.len() + self.replaced_counts.len())
    }
}

impl PartialEq for MultiTriangulationState {
    fn eq(&self, other: &Self) -> bool {
        let shows = |&index: &u32| other.shown_index_of.get(index as usize).is_some_and(|&at| at != NONE);
        self.inserted == other.inserted
            && self.shown.len() == other.shown.len()
            && self.shown.iter().all(shows)
    }
}

impl Eq for MultiTriangulationState {}
