//! Following a criterion from one view to the next.

use super::{LEAF, NONE, ROOT, ViewDependentMeshes, ViewDependentState};
use crate::view::Criterion;

/// What a change of view took.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Adapted {
    /// Vertices that were split.
    pub split_count: usize,
    /// Splits that were undone.
    pub collapse_count: usize,
}

impl Adapted {
    /// Splits and collapses.
    pub fn change_count(self) -> usize {
        self.split_count + self.collapse_count
    }
}

impl ViewDependentMeshes {
    /// Refines an instance where the criterion wants it, with all that this takes to be legal, and coarsens it where it does
    /// not and that is legal: `adapt_refinement` of \[Hop97\]. It begins with what the instance shows, so that the
    /// cost is that of its vertices and of what changes; nothing is left that could be coarsened.
    ///
    /// # Panics
    /// If the state belongs to another model.
    pub fn adapt(&self, state: &mut ViewDependentState, criterion: &impl Criterion) -> Adapted {
        state.check(self);
        let mut pass = Pass { model: self, state, criterion, adapted: Adapted::default() };
        // Backwards: what takes the place of a vertex that goes has been looked at, and what comes is noted.
        let mut place = pass.state.active.len();
        while place > 0 {
            place = (place - 1).min(pass.state.active.len());
            let Some(&active) = pass.state.active.get(place) else { continue };
            if active.node != LEAF && pass.is_wanted(active.node) {
                pass.force_split(active.node);
                pass.refine_arrived();
            } else if active.has_both {
                // Of two children the restored one speaks for both.
                pass.coarsen(active.vertex - self.roots.len() as u32);
            }
        }
        pass.adapted
    }
}

/// One go over the active vertices.
struct Pass<'p, C> {
    model: &'p ViewDependentMeshes,
    state: &'p mut ViewDependentState,
    criterion: &'p C,
    adapted: Adapted,
}

impl<C: Criterion> Pass<'_, C> {
    /// `qrefine` of the paper.
    #[inline]
    fn is_wanted(&self, step: u32) -> bool {
        self.criterion.weigh(&self.model.parts[step as usize]).is_wanted()
    }

    /// Splits the vertices that have come as long as that is wanted. What came for another's sake cannot go while that is there.
    fn refine_arrived(&mut self) {
        while let Some(vertex) = self.state.arrived.pop() {
            if let Some(node) = self.state.node_of(vertex)
                && node != LEAF
                && self.is_wanted(node)
            {
                self.force_split(node);
            }
        }
    }

    /// Splits a vertex, and first all that has to be split for that.
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
            for number in split.beside {
                if number != NONE && !state.has_triangle(number) {
                    state.waiting.extend(model.maker(number));
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

    /// Undoes a split whose children are there, if it is not wanted and can be, and then what that allows.
    #[inline]
    fn coarsen(&mut self, step: u32) {
        if !self.is_wanted(step) && self.state.can_collapse(self.model, step) {
            self.collapse(step);
            self.coarsen_loosened();
        }
    }

    fn collapse(&mut self, step: u32) {
        let model = self.model;
        self.state.collapse(model, step);
        self.adapted.collapse_count += 1;
        let split = &model.splits[step as usize];
        // The vertex above has two children again, perhaps, and the triangles beside have the neighbours that they were made with.
        let beside = split.beside.into_iter().filter(|&number| number != NONE);
        let makers = beside.filter_map(|number| model.maker(number));
        self.state.loosened.extend(makers.chain((split.parent != ROOT).then_some(split.parent)));
    }

    fn coarsen_loosened(&mut self) {
        while let Some(step) = self.state.loosened.pop() {
            let can_collapse =
                self.state.has_children(self.model, step) && self.state.can_collapse(self.model, step);
            if can_collapse && !self.is_wanted(step) {
                self.collapse(step);
            }
        }
    }
}
