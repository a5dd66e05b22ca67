//! Following a criterion from one view to the next.

use striata::view::{Criterion, Part, Verdict};

use super::state::ASK;
use super::{LEAF, NONE, ROOT, ViewDependentMeshes, ViewDependentState};

/// Questions that are asked at once: few enough to stay in a cache.
const BLOCK_LEN: usize = 64;

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
        self.adapt_after(state, criterion, f32::INFINITY)
    }

    /// The same for a criterion that has moved by so much since the one before
    /// ([`motion_since`](Criterion::motion_since)): whatever verdict of an earlier one lasts is not asked for again, which \[Hop97\]
    /// does not have. Motions add up from call to call, so that none may be left out.
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
            state.active.iter_mut().for_each(|active| active.due = [ASK; 2]);
        }
        let elapsed = (state.elapsed as f32).next_up();
        let mut pass = Pass {
            model: self,
            state,
            criterion,
            elapsed,
            adapted: Adapted::default(),
            block: Block::default(),
            wanted: Vec::new(),
            unwanted: Vec::new(),
        };
        pass.ask_due();
        pass.refine();
        pass.coarsen();
        pass.adapted
    }
}

/// One go over the active vertices.
struct Pass<'p, C> {
    model: &'p ViewDependentMeshes,
    state: &'p mut ViewDependentState,
    criterion: &'p C,
    elapsed: f32,
    adapted: Adapted,
    block: Block,
    /// Steps that are to be split.
    wanted: Vec<u32>,
    /// Steps that are not, and have both children.
    unwanted: Vec<u32>,
}

/// Questions that are put together.
#[derive(Default)]
struct Block {
    parts: Vec<Part>,
    asked: Vec<Question>,
    verdicts: Vec<Verdict>,
}

/// Whether to split the vertex at a place (`kind` 0), or whether to undo the step that restored it (1).
#[derive(Clone, Copy)]
struct Question {
    place: u32,
    kind: usize,
    step: u32,
}

impl<C: Criterion> Pass<'_, C> {
    /// `qrefine` of the paper: whether a step is wanted, and after how much motion it is to be asked again.
    #[inline]
    fn ask(&self, step: u32) -> (bool, f32) {
        let verdict = self.criterion.weigh(&self.model.parts[step as usize]);
        (verdict.should_refine(), self.due(verdict))
    }

    /// What lasts for one view only is due at once.
    fn due(&self, verdict: Verdict) -> f32 {
        // Where sums of motion are coarse it lasts rather less.
        let due = (self.state.elapsed + f64::from(verdict.motion_margin * (1.0 - 1e-4))) as f32;
        if verdict.motion_margin > 0.0 { due.next_down() } else { ASK }
    }

    /// Asks whatever is due of the active vertices: verdicts tell of a view, so that they hold whatever changes then.
    fn ask_due(&mut self) {
        let base_count = self.model.roots.len() as u32;
        for place in 0..self.state.active.len() as u32 {
            let active = &mut self.state.active[place as usize];
            if active.due[0] > self.elapsed && active.due[1] > self.elapsed {
                continue;
            }
            // Of two children the restored one speaks for both.
            let restored_by = || active.vertex - base_count;
            let steps = [(active.node != LEAF).then_some(active.node), active.has_both.then(restored_by)];
            for (kind, step) in steps.into_iter().enumerate() {
                if active.due[kind] > self.elapsed {
                    continue;
                }
                let Some(step) = step else {
                    // There is nothing to ask; once there is, it will be.
                    active.due[kind] = f32::INFINITY;
                    continue;
                };
                self.block.parts.push(self.model.parts[step as usize]);
                self.block.asked.push(Question { place, kind, step });
            }
            if self.block.parts.len() >= BLOCK_LEN {
                self.hear();
            }
        }
        self.hear();
    }

    /// Has the block's questions answered.
    fn hear(&mut self) {
        let mut block = std::mem::take(&mut self.block);
        self.criterion.weigh_all(&block.parts, &mut block.verdicts);
        for (&Question { place, kind, step }, &verdict) in block.asked.iter().zip(&block.verdicts) {
            self.state.active[place as usize].due[kind] = self.due(verdict);
            match (kind, verdict.should_refine()) {
                (0, true) => self.wanted.push(step),
                (1, false) => self.unwanted.push(step),
                _ => {}
            }
        }
        block.parts.clear();
        block.asked.clear();
        block.verdicts.clear();
        self.block = block;
    }

    fn refine(&mut self) {
        for step in std::mem::take(&mut self.wanted) {
            self.force_split(step);
            self.refine_arrived();
        }
    }

    fn coarsen(&mut self) {
        for step in std::mem::take(&mut self.unwanted) {
            // Where it cannot go yet it is asked again when it can.
            if self.state.has_children(self.model, step) && self.state.can_collapse(self.model, step) {
                self.collapse(step);
                self.coarsen_loosened();
            }
        }
    }

    /// Splits the vertices that have come as long as that is wanted. What came for another's sake cannot go while that is there.
    fn refine_arrived(&mut self) {
        while let Some(vertex) = self.state.arrived.pop() {
            let place = self.state.place_of[vertex as usize] as usize;
            let Some(active) = self.state.active.get(place) else { continue };
            if active.node == LEAF || active.due[0] > self.elapsed {
                continue;
            }
            let (is_wanted, due) = self.ask(active.node);
            if is_wanted {
                self.force_split(active.node);
            } else {
                self.state.active[place].due[0] = due;
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

    /// Undoes a split, and notes what that may allow.
    fn collapse(&mut self, step: u32) {
        let model = self.model;
        self.state.collapse(model, step);
        self.adapted.collapse_count += 1;
        let split = &model.splits[step as usize];
        // The vertex above has two children again, perhaps, and the triangles beside have the neighbors that they were made with.
        let beside = split.beside.into_iter().filter(|&number| number != NONE);
        let makers = beside.filter_map(|number| model.maker(number));
        self.state.loosened.extend(makers.chain((split.parent != ROOT).then_some(split.parent)));
    }

    fn coarsen_loosened(&mut self) {
        while let Some(step) = self.state.loosened.pop() {
            if !self.state.has_children(self.model, step) {
                continue;
            }
            let (is_wanted, due) = self.ask(step);
            let place = self.state.place_of[self.model.restored(step) as usize] as usize;
            self.state.active[place].due[1] = due;
            if !is_wanted && self.state.can_collapse(self.model, step) {
                self.collapse(step);
            }
        }
    }
}
