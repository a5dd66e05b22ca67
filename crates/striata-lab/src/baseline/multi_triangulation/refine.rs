//! Selective refinement by a condition on triangles: \[KG98\] section 3.4 where triangles are explicit.

use striata::mesh::FragmentSequence;
use striata::model::PatternChange;

use super::{MultiTriangulation, MultiTriangulationState};

const NO_STEP: u32 = FragmentSequence::NO_STEP;

/// What a condition is asked: whether a triangle is too coarse, so that the fragment has to come that replaces it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct MtQuestion {
    /// The triangle; none where the fragment has no floor.
    pub triangle: Option<u32>,
    /// The fragment that replaces it.
    pub upper: u32,
}

impl MultiTriangulation {
    /// Goes to the smallest closed set of fragments in which no triangle is too coarse, from wherever the instance is.
    ///
    /// That set is the same for any condition: each fragment in it is needed by a triangle that any other such set shows as
    /// well. The condition is asked for the triangles of the base and for those that fragments of the set make.
    ///
    /// # Panics
    /// If the state belongs to another model.
    pub fn adapt(
        &self,
        state: &mut MultiTriangulationState,
        is_coarse: impl Fn(MtQuestion) -> bool,
    ) -> PatternChange {
        state.check(self);
        let coarse_into = |triangles: &mut dyn Iterator<Item = u32>, out: &mut Vec<u32>| {
            for triangle in triangles {
                let upper = self.triangles[triangle as usize].upper;
                if upper != NO_STEP && is_coarse(MtQuestion { triangle: Some(triangle), upper }) {
                    out.push(upper);
                }
            }
        };
        let mut wanted = Vec::new();
        coarse_into(&mut (0..self.base_triangle_count as u32), &mut wanted);
        let floorless = self.floorless.iter().copied();
        wanted.extend(floorless.filter(|&upper| is_coarse(MtQuestion { triangle: None, upper })));
        let change = state.inserted.change_to(wanted, |step, waiting| {
            waiting.extend(self.lowers(step));
            coarse_into(&mut self.ceiling(step).iter().copied(), waiting);
        });
        state.apply(self, &change);
        PatternChange { inserted: change.inserted.len(), removed: change.removed.len() }
    }

    /// Removes fragments from the top as long as no triangle of their floors is too coarse; how many went.
    ///
    /// Where nothing finer is wanted than what is below it, what is left, then [refined](Self::refine), is what
    /// [`adapt`](Self::adapt) comes to.
    ///
    /// # Panics
    /// If the state belongs to another model.
    pub fn coarsen(
        &self,
        state: &mut MultiTriangulationState,
        is_coarse: impl Fn(MtQuestion) -> bool,
    ) -> usize {
        state.check(self);
        let first_of = |step: u32| self.ceiling(step).first().copied();
        // A fragment on top has its whole ceiling there; it is found by the first triangle.
        let mut waiting: Vec<u32> = state
            .triangle_numbers()
            .iter()
            .filter_map(|&number| {
                let lower = self.triangles[number as usize].lower;
                (lower != NO_STEP && first_of(lower) == Some(number)).then_some(lower)
            })
            .collect();
        waiting.extend(self.floorless.iter().filter(|&&step| first_of(step).is_none()));
        let mut count = 0;
        while let Some(step) = waiting.pop() {
            if !state.inserted.has(step) || state.replaced_counts[step as usize] > 0 {
                continue;
            }
            let is_needed = match self.floor(step) {
                [] => is_coarse(MtQuestion { triangle: None, upper: step }),
                floor => floor
                    .iter()
                    .any(|&triangle| is_coarse(MtQuestion { triangle: Some(triangle), upper: step })),
            };
            if !is_needed {
                state.remove(self, step);
                count += 1;
                waiting.extend(self.lowers(step));
            }
        }
        count
    }

    /// Inserts the upper fragments of all triangles that are too coarse, with what they stand on, until there are none; how many
    /// fragments came.
    ///
    /// # Panics
    /// If the state belongs to another model.
    pub fn refine(
        &self,
        state: &mut MultiTriangulationState,
        is_coarse: impl Fn(MtQuestion) -> bool,
    ) -> usize {
        state.check(self);
        let mut count = 0;
        for &upper in &self.floorless {
            if !state.inserted.has(upper) && is_coarse(MtQuestion { triangle: None, upper }) {
                count += self.insert(state, upper);
            }
        }
        let mut waiting: Vec<u32> = state.triangle_numbers().to_vec();
        while let Some(triangle) = waiting.pop() {
            let upper = self.triangles[triangle as usize].upper;
            if upper == NO_STEP
                || state.inserted.has(upper)
                || !is_coarse(MtQuestion { triangle: Some(triangle), upper })
            {
                continue;
            }
            count += self.lay_foundation(state, upper, &mut waiting);
        }
        count
    }

    /// Inserts a fragment, and first what it stands on; how many fragments came.
    ///
    /// # Panics
    /// If there is no such fragment, or the state belongs to another model.
    pub fn insert(&self, state: &mut MultiTriangulationState, step: u32) -> usize {
        state.check(self);
        self.lay_foundation(state, step, &mut Vec::new())
    }

    /// Inserts a fragment and its foundation, and lists what triangles come.
    fn lay_foundation(&self, state: &mut MultiTriangulationState, step: u32, made: &mut Vec<u32>) -> usize {
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
                made.extend(self.ceiling(step));
                count += 1;
            }
        }
        count
    }

    /// The fragments that a fragment stands on, some of them several times.
    fn lowers(&self, step: u32) -> impl Iterator<Item = u32> + '_ {
        let lowers = self.floor(step).iter().map(|&triangle| self.triangles[triangle as usize].lower);
        lowers.filter(|&lower| lower != NO_STEP)
    }
}
