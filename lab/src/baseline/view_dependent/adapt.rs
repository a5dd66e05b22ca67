//! Adapts an instance to a criterion, from one view to the next.

use striata::view::{Criterion, Part, Verdict};

use super::state::DUE_NOW;
use super::{LEAF, NONE, ROOT, ViewDependentMeshes, ViewDependentState};

/// Number of parts evaluated together: few enough to stay in the cache.
const BLOCK_LEN: usize = 64;

/// Number of changes that an adaptation took.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Adapted {
    /// Number of splits.
    pub split_count: usize,
    /// Number of collapses.
    pub collapse_count: usize,
}

impl Adapted {
    /// Total number of splits and collapses.
    pub fn change_count(self) -> usize {
        self.split_count + self.collapse_count
    }
}

impl ViewDependentMeshes {
    /// Refines an instance wherever the criterion requires it, including the splits needed to make that
    /// legal, and coarsens it wherever the criterion permits and it is legal: `adapt_refinement` of
    /// \[Hop97\]. The pass starts with the vertices shown, so its cost is linear in these and in the
    /// changes. Afterwards nothing is left that could be coarsened.
    ///
    /// # Panics
    /// If the state belongs to another model.
    pub fn adapt(&self, state: &mut ViewDependentState, criterion: &impl Criterion) -> Adapted {
        self.adapt_after(state, criterion, f32::INFINITY)
    }

    /// Adapts to a criterion that has moved by `motion` since the previous one
    /// ([`motion_since`](Criterion::motion_since)). Verdicts of earlier criteria that are still valid are
    /// not evaluated again, which \[Hop97\] does not have. Motions accumulate from call to call, so no
    /// call may be skipped.
    ///
    /// # Panics
    /// If the state belongs to another model.
    pub fn adapt_after(
        &self,
        state: &mut ViewDependentState,
        criterion: &impl Criterion,
        motion: f32,
    ) -> Adapted {
        state.check(self);
        if motion.is_finite() && state.elapsed.is_finite() {
            state.elapsed += f64::from(motion.max(0.0));
        } else {
            state.elapsed = 0.0;
            state.active.iter_mut().for_each(|active| active.due = [DUE_NOW; 2]);
        }
        let elapsed = (state.elapsed as f32).next_up();
        let mut pass = Pass {
            model: self,
            state,
            criterion,
            elapsed,
            adapted: Adapted::default(),
            block: EvaluationBatch::default(),
            required: Vec::new(),
            dispensable: Vec::new(),
        };
        pass.evaluate_due();
        pass.refine();
        pass.coarsen();
        pass.adapted
    }
}

/// One pass over the active vertices.
struct Pass<'p, C> {
    model: &'p ViewDependentMeshes,
    state: &'p mut ViewDependentState,
    criterion: &'p C,
    elapsed: f32,
    adapted: Adapted,
    block: EvaluationBatch,
    /// Steps to split.
    required: Vec<u32>,
    /// Steps to collapse: not required, and both of their children are active.
    dispensable: Vec<u32>,
}

/// A batch of parts to evaluate.
#[derive(Default)]
struct EvaluationBatch {
    parts: Vec<Part>,
    requests: Vec<EvaluationRequest>,
    verdicts: Vec<Verdict>,
}

/// Asks whether to split the vertex at an index of `active` (`kind` 0), or to collapse the step that
/// restored it (`kind` 1).
#[derive(Clone, Copy)]
struct EvaluationRequest {
    index: u32,
    kind: usize,
    step: u32,
}

impl<C: Criterion> Pass<'_, C> {
    /// `qrefine` of the paper: whether a step is required, and the accumulated motion at which to evaluate
    /// it again.
    #[inline]
    fn evaluate(&self, step: u32) -> (bool, f32) {
        let verdict = self.criterion.weigh(&self.model.part(step as usize));
        (verdict.should_refine(), self.due(verdict))
    }

    /// The accumulated motion at which a verdict expires; immediately if it is valid for one view only.
    fn due(&self, verdict: Verdict) -> f32 {
        // Rounding makes large sums of motion inaccurate, so expire slightly earlier.
        let due = (self.state.elapsed + f64::from(verdict.motion_margin * (1.0 - 1e-4))) as f32;
        if verdict.motion_margin > 0.0 { due.next_down() } else { DUE_NOW }
    }

    /// Evaluates the active vertices whose verdicts have expired. Verdicts depend only on the view, so
    /// later changes in this pass do not invalidate them.
    fn evaluate_due(&mut self) {
        let base_count = self.model.roots.len() as u32;
        for index in 0..self.state.active.len() as u32 {
            let active = &mut self.state.active[index as usize];
            if active.due[0] > self.elapsed && active.due[1] > self.elapsed {
                continue;
            }
            // Of two children, the restored one represents both.
            let restored_by = || active.vertex - base_count;
            let steps = [(active.node != LEAF).then_some(active.node), active.has_both.then(restored_by)];
            for (kind, step) in steps.into_iter().enumerate() {
                if active.due[kind] > self.elapsed {
                    continue;
                }
                let Some(step) = step else {
                    // There is nothing to evaluate; it becomes due when there is.
                    active.due[kind] = f32::INFINITY;
                    continue;
                };
                self.block.parts.push(self.model.part(step as usize));
                self.block.requests.push(EvaluationRequest { index, kind, step });
            }
            if self.block.parts.len() >= BLOCK_LEN {
                self.evaluate_block();
            }
        }
        self.evaluate_block();
    }

    /// Evaluates the batch.
    fn evaluate_block(&mut self) {
        let mut block = std::mem::take(&mut self.block);
        self.criterion.weigh_all(&block.parts, &mut block.verdicts);
        for (&EvaluationRequest { index, kind, step }, &verdict) in block.requests.iter().zip(&block.verdicts)
        {
            self.state.active[index as usize].due[kind] = self.due(verdict);
            match (kind, verdict.should_refine()) {
                (0, true) => self.required.push(step),
                (1, false) => self.dispensable.push(step),
                _ => {}
            }
        }
        block.parts.clear();
        block.requests.clear();
        block.verdicts.clear();
        self.block = block;
    }

    fn refine(&mut self) {
        for step in std::mem::take(&mut self.required) {
            self.force_split(step);
            self.refine_arrived();
        }
    }

    fn coarsen(&mut self) {
        for step in std::mem::take(&mut self.dispensable) {
            // A step that cannot collapse yet is evaluated again when it can.
            if self.state.has_children(self.model, step) && self.state.can_collapse(self.model, step) {
                self.collapse(step);
                self.coarsen_collapsible();
            }
        }
    }

    /// Splits newly active vertices as long as the criterion requires it. A vertex split as a prerequisite
    /// cannot collapse while its dependents are active.
    fn refine_arrived(&mut self) {
        while let Some(vertex) = self.state.arrived.pop() {
            let index = self.state.index_of[vertex as usize] as usize;
            let Some(active) = self.state.active.get(index) else { continue };
            if active.node == LEAF || active.due[0] > self.elapsed {
                continue;
            }
            let (is_required, due) = self.evaluate(active.node);
            if is_required {
                self.force_split(active.node);
            } else {
                self.state.active[index].due[0] = due;
            }
        }
    }

    /// Splits a vertex after all of its prerequisites.
    fn force_split(&mut self, step: u32) {
        let (model, state) = (self.model, &mut *self.state);
        state.waiting.push(step);
        while let Some(&step) = state.waiting.last() {
            let split = &model.splits[step as usize];
            if state.is_split(model, step) {
                state.waiting.pop();
                continue;
            }
            if state.node_of(split.target) != Some(step) {
                debug_assert!(split.parent != ROOT, "a root of the hierarchy is neither there nor split");
                state.waiting.push(split.parent);
                continue;
            }
            let count = state.waiting.len();
            for triangle in split.neighbors {
                if triangle != NONE && !state.has_triangle(triangle) {
                    state.waiting.extend(model.maker(triangle));
                }
            }
            if state.waiting.len() == count {
                state.waiting.pop();
                state.split(model, step);
                state.arrived.extend([split.target, model.restored(step)]);
                self.adapted.split_count += 1;
            }
        }
    }

    /// Collapses a step and records the steps that may have become collapsible.
    fn collapse(&mut self, step: u32) {
        let model = self.model;
        self.state.collapse(model, step);
        self.adapted.collapse_count += 1;
        let split = &model.splits[step as usize];
        // The parent may have two children again, and adjacent triangles may have their original neighbors
        // again.
        let neighbors = split.neighbors.into_iter().filter(|&triangle| triangle != NONE);
        let makers = neighbors.filter_map(|triangle| model.maker(triangle));
        self.state.collapsible.extend(makers.chain((split.parent != ROOT).then_some(split.parent)));
    }

    fn coarsen_collapsible(&mut self) {
        while let Some(step) = self.state.collapsible.pop() {
            if !self.state.has_children(self.model, step) {
                continue;
            }
            let (is_required, due) = self.evaluate(step);
            let index = self.state.index_of[self.model.restored(step) as usize] as usize;
            self.state.active[index].due[1] = due;
            if !is_required && self.state.can_collapse(self.model, step) {
                self.collapse(step);
            }
        }
    }
}
