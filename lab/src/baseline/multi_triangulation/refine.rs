//! Selective refinement by a condition on triangles: \[KG98\] section 3.4 with explicit triangles.

use striata::mesh::FragmentSequence;
use striata::model::PatternChange;

use super::{MultiTriangulation, MultiTriangulationState};

const NO_STEP: u32 = FragmentSequence::NO_STEP;

/// Argument of a condition. The condition decides whether a triangle is too coarse, so that the fragment
/// that replaces it is needed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct MtQuery {
    /// The triangle, or `None` if the fragment has no floor.
    pub triangle: Option<u32>,
    /// The fragment that replaces it.
    pub upper: u32,
}

impl MultiTriangulation {
    /// Moves to the smallest closed set of fragments in which no triangle is too coarse, from any current
    /// set.
    ///
    /// For any condition that set is unique: each fragment in it replaces a too coarse triangle that every
    /// other such set would also have to refine. The condition is evaluated for the triangles of the base
    /// and for those that fragments of the set create.
    ///
    /// # Panics
    /// If the state belongs to another model.
    pub fn adapt(
        &self,
        state: &mut MultiTriangulationState,
        is_coarse: impl Fn(MtQuery) -> bool,
    ) -> PatternChange {
        state.check(self);
        let coarse_into = |triangles: &mut dyn Iterator<Item = u32>, out: &mut Vec<u32>| {
            for triangle in triangles {
                let upper = self.triangles[triangle as usize].upper;
                if upper != NO_STEP && is_coarse(MtQuery { triangle: Some(triangle), upper }) {
                    out.push(upper);
                }
            }
        };
        let mut wanted = Vec::new();
        coarse_into(&mut (0..self.base_triangle_count as u32), &mut wanted);
        let floorless = self.floorless.iter().copied();
        wanted.extend(floorless.filter(|&upper| is_coarse(MtQuery { triangle: None, upper })));
        let change = state.inserted.change_to(wanted, |step, waiting| {
            waiting.extend(self.lowers(step));
            coarse_into(&mut self.ceiling(step).iter().copied(), waiting);
        });
        state.apply(self, &change);
        PatternChange { inserted: change.inserted.len(), removed: change.removed.len() }
    }

    /// Removes fragments from the top as long as no triangle of their floors is too coarse. Returns the
    /// number of fragments removed.
    ///
    /// If a finer triangle is never required when the coarser one below it is accurate enough, coarsening
    /// and then [refining](Self::refine) leads to the same set as [`adapt`](Self::adapt).
    ///
    /// # Panics
    /// If the state belongs to another model.
    pub fn coarsen(&self, state: &mut MultiTriangulationState, is_coarse: impl Fn(MtQuery) -> bool) -> usize {
        state.check(self);
        let first_of = |step: u32| self.ceiling(step).first().copied();
        // All ceiling triangles of a fragment on top are shown; the first one identifies it.
        let mut waiting: Vec<u32> = state
            .triangle_indices()
            .iter()
            .filter_map(|&index| {
                let lower = self.triangles[index as usize].lower;
                (lower != NO_STEP && first_of(lower) == Some(index)).then_some(lower)
            })
            .collect();
        waiting.extend(self.floorless.iter().filter(|&&step| first_of(step).is_none()));
        let mut count = 0;
        while let Some(step) = waiting.pop() {
            if !state.inserted.has(step) || state.replaced_counts[step as usize] > 0 {
                continue;
            }
            let is_needed = match self.floor(step) {
                [] => is_coarse(MtQuery { triangle: None, upper: step }),
                floor => {
                    floor.iter().any(|&triangle| is_coarse(MtQuery { triangle: Some(triangle), upper: step }))
                }
            };
            if !is_needed {
                state.remove(self, step);
                count += 1;
                waiting.extend(self.lowers(step));
            }
        }
        count
    }

    /// Inserts the upper fragments of all triangles that are too coarse, along with their prerequisites,
    /// until none is left. Returns the number of fragments inserted.
    ///
    /// # Panics
    /// If the state belongs to another model.
    pub fn refine(&self, state: &mut MultiTriangulationState, is_coarse: impl Fn(MtQuery) -> bool) -> usize {
        state.check(self);
        let mut count = 0;
        for &upper in &self.floorless {
            if !state.inserted.has(upper) && is_coarse(MtQuery { triangle: None, upper }) {
                count += self.insert(state, upper);
            }
        }
        let mut waiting: Vec<u32> = state.triangle_indices().to_vec();
        while let Some(triangle) = waiting.pop() {
            let upper = self.triangles[triangle as usize].upper;
            if upper == NO_STEP
                || state.inserted.has(upper)
                || !is_coarse(MtQuery { triangle: Some(triangle), upper })
            {
                continue;
            }
            count += self.insert_closure(state, upper, &mut waiting);
        }
        count
    }

    /// Inserts a fragment after its prerequisites. Returns the number of fragments inserted.
    ///
    /// # Panics
    /// If the fragment does not exist or the state belongs to another model.
    pub fn insert(&self, state: &mut MultiTriangulationState, step: u32) -> usize {
        state.check(self);
        self.insert_closure(state, step, &mut Vec::new())
    }

    /// Inserts a fragment and its prerequisites, and appends the triangles that this adds to `created`.
    fn insert_closure(
        &self,
        state: &mut MultiTriangulationState,
        step: u32,
        created: &mut Vec<u32>,
    ) -> usize {
        let mut count = 0;
        let mut waiting = vec![step];
        while let Some(&step) = waiting.last() {
            if state.inserted.has(step) {
                waiting.pop();
                continue;
            }
            let before = waiting.len();
            waiting.extend(self.lowers(step).filter(|&lower| !state.inserted.has(lower)));
            if waiting.len() == before {
                waiting.pop();
                state.insert(self, step);
                created.extend(self.ceiling(step));
                count += 1;
            }
        }
        count
    }

    /// The fragments that a fragment depends on, possibly with duplicates.
    fn lowers(&self, step: u32) -> impl Iterator<Item = u32> + '_ {
        let lowers = self.floor(step).iter().map(|&triangle| self.triangles[triangle as usize].lower);
        lowers.filter(|&lower| lower != NO_STEP)
    }
}
