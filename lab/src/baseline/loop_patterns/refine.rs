//! Selective refinement, \[KG98\] section 3.4.
//!
//! A triangle belongs to an overlap: between the fragment that creates it, identified by its youngest
//! corner, and one that covers it. An overlap is part of the current triangulation if its lower fragment
//! is inserted and its upper one is not.

use striata::model::{Condition, Overlap, PatternChange};

use super::{LoopPatterns, LoopPatternsState};

impl LoopPatterns {
    /// Moves to the smallest closed set of fragments in which no overlap is too coarse, from any current set.
    ///
    /// That set is unique for any condition, even if the condition calls a fine overlap too coarse but
    /// accepts the coarser one below it. With such a condition, the paper's two operations may stop at a
    /// larger set.
    ///
    /// # Panics
    /// If the state belongs to another model.
    pub fn adapt(&self, state: &mut LoopPatternsState, condition: &impl Condition) -> PatternChange {
        state.check(self);
        let coarse = |lower, upper| condition.is_too_coarse(Self::overlap(lower, upper));
        let wanted = self.base_covers.iter().copied().filter(|&upper| coarse(None, upper)).collect();
        let change = state.inserted.change_to(wanted, |step, waiting| {
            waiting.extend(self.records.covered(step));
            waiting.extend(self.records.covering(step).filter(|&upper| coarse(Some(step), upper)));
        });
        state.apply(self, &change);
        PatternChange { inserted: change.inserted.len(), removed: change.removed.len() }
    }

    /// Removes fragments from the top as long as none of the overlaps in their floors is too coarse.
    /// Returns the number of fragments removed.
    ///
    /// # Panics
    /// If the state belongs to another model.
    pub fn coarsen(&self, state: &mut LoopPatternsState, condition: &impl Condition) -> usize {
        state.check(self);
        let mut waiting = state.inserted.steps().to_vec();
        let mut count = 0;
        while let Some(step) = waiting.pop() {
            let is_top = |step| !self.records.covering(step).any(|upper| state.inserted.has(upper));
            if !state.inserted.has(step) || !is_top(step) || self.is_wanted(step, condition) {
                continue;
            }
            state.remove_fragment(self, step);
            count += 1;
            waiting.extend(self.records.covered(step));
        }
        count
    }

    /// An overlap of the published form, which stores no errors.
    fn overlap(lower: Option<u32>, upper: u32) -> Overlap {
        Overlap { lower, upper, error: f32::INFINITY }
    }

    /// Whether an overlap in the floor of a fragment is too coarse.
    fn is_wanted(&self, step: u32, condition: &impl Condition) -> bool {
        let is_coarse = |lower| condition.is_too_coarse(Self::overlap(lower, step));
        self.base_covers.binary_search(&step).is_ok() && is_coarse(None)
            || self.records.covered(step).any(|lower| is_coarse(Some(lower)))
    }

    /// Inserts the upper fragments of all overlaps that are too coarse, along with their prerequisites,
    /// until none is left. Returns the number of fragments inserted.
    ///
    /// # Panics
    /// If the state belongs to another model.
    pub fn refine(&self, state: &mut LoopPatternsState, condition: &impl Condition) -> usize {
        state.check(self);
        let coarse = |lower, upper| condition.is_too_coarse(Self::overlap(lower, upper));
        let mut arrived = state.inserted.steps().to_vec();
        let mut count = 0;
        for &upper in &self.base_covers {
            if !state.inserted.has(upper) && coarse(None, upper) {
                count += self.insert_closure(state, upper, &mut arrived);
            }
        }
        while let Some(step) = arrived.pop() {
            for upper in self.records.covering(step) {
                if !state.inserted.has(upper) && coarse(Some(step), upper) {
                    count += self.insert_closure(state, upper, &mut arrived);
                }
            }
        }
        count
    }

    /// Inserts a fragment after its prerequisites. Returns the number of fragments inserted.
    ///
    /// # Panics
    /// If the fragment does not exist or the state belongs to another model.
    pub fn insert(&self, state: &mut LoopPatternsState, step: u32) -> usize {
        state.check(self);
        self.insert_closure(state, step, &mut Vec::new())
    }

    /// The paper's `layFoundation`, with an explicit stack instead of recursion. Appends the inserted
    /// fragments to `arrived`.
    fn insert_closure(&self, state: &mut LoopPatternsState, step: u32, arrived: &mut Vec<u32>) -> usize {
        let before = state.inserted.len();
        let mut waiting = vec![step];
        while let Some(&step) = waiting.last() {
            if state.inserted.has(step) {
                waiting.pop();
                continue;
            }
            let count = waiting.len();
            waiting.extend(self.records.covered(step).filter(|&below| !state.inserted.has(below)));
            if waiting.len() == count {
                waiting.pop();
                state.insert_fragment(self, step);
                arrived.push(step);
            }
        }
        state.inserted.len() - before
    }
}
