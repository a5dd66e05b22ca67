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
            let Some(active) = pass.state.active.get(place) else { continue };
            pass.visit(active.vertex, active.node);
            while let Some(vertex) = pass.state.pending.pop() {
                if let Some(node) = pass.state.node_of(vertex) {
                    pass.visit(vertex, node);
                }
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

    #[inline]
    fn visit(&mut self, vertex: u32, node: u32) {
        if node != LEAF && self.is_wanted(node) {
            self.force_split(node);
        } else if let Some(step) = (vertex as usize).checked_sub(self.model.roots.len()) {
            // Of two children the restored one speaks for both.
            self.coarsen(step as u32);
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
                state.pending.extend([split.target, model.restored(step)]);
                self.adapted.split_count += 1;
            }
        }
    }

    /// Undoes a split that is not wanted if it can be undone, and notes what that may allow.
    fn coarsen(&mut self, step: u32) {
        let (model, state) = (self.model, &*self.state);
        if !state.has_children(model, step) || self.is_wanted(step) || !state.can_collapse(model, step) {
            return;
        }
        self.state.collapse(model, step);
        self.adapted.collapse_count += 1;
        let split = &model.splits[step as usize];
        // The vertex above has two children again, perhaps, and the triangles beside have the neighbours that they were made with.
        let beside = split.beside.into_iter().filter(|&number| number != NONE);
        let makers = beside.filter_map(|number| model.maker(number));
        let parent = (split.parent != ROOT).then_some(split.parent);
        self.state.pending.extend(makers.chain(parent).map(|step| model.restored(step)));
    }
}
