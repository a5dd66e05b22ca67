//! An instance of the table: one bit per step, and the moves from one valid set of steps to another.

use super::{FanScene, Fans, listed};
use crate::model::step_bits::StepBits;
use crate::view::Criterion;

/// Number of steps that are evaluated together.
const BATCH_SIZE: usize = 64;

/// A selectively refined instance of the model: the set of its collapsed steps, one bit each. Every set that
/// it can reach is also reachable by running the collapse sequence while leaving out some of its steps.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FanInstance {
    pub(super) step_count: usize,
    pub(super) collapsed: StepBits,
}

impl FanInstance {
    /// Returns an instance that shows the full mesh.
    pub fn full(fans: &Fans) -> Self {
        Self { step_count: fans.step_count, collapsed: StepBits::none(fans.step_count) }
    }

    /// Returns an instance at a uniform level.
    ///
    /// # Panics
    /// If `split_count` exceeds the step count.
    pub fn uniform(fans: &Fans, split_count: usize) -> Self {
        assert!(split_count <= fans.step_count, "split count {split_count} of {}", fans.step_count);
        let mut instance = Self::full(fans);
        instance.collapsed.set_range(split_count..fans.step_count);
        instance
    }

    /// Whether a step is refined, that is, its position is active.
    ///
    /// # Panics
    /// If the step does not exist.
    #[inline]
    pub fn is_refined(&self, step: u32) -> bool {
        !self.collapsed.has(step)
    }

    /// Number of refined steps.
    pub fn split_count(&self) -> usize {
        self.step_count - self.collapsed.count()
    }

    /// Number of collapsed steps.
    pub fn collapse_count(&self) -> usize {
        self.collapsed.count()
    }

    /// Number of bytes that the instance owns: one bit per step.
    pub fn bytes(&self) -> usize {
        self.collapsed.bytes()
    }

    /// Collapses a step and every step that must be collapsed before it; returns the number of steps
    /// collapsed.
    ///
    /// # Panics
    /// If the step does not exist, or the instance belongs to a different table.
    pub fn collapse(&mut self, fans: &Fans, step: u32) -> usize {
        self.check(fans, step);
        let mut waiting = vec![step];
        let mut count = 0;
        while let Some(step) = waiting.pop() {
            if !self.is_refined(step) {
                continue;
            }
            self.collapsed.insert(step);
            count += 1;
            fans.for_each_needed_by_collapse(step, |needed| {
                if self.is_refined(needed) {
                    waiting.push(needed);
                }
            });
        }
        count
    }

    /// Splits a step and every step that must be split before it; returns the number of steps split.
    ///
    /// # Panics
    /// If the step does not exist, or the instance belongs to a different table.
    pub fn split(&mut self, fans: &Fans, step: u32) -> usize {
        self.check(fans, step);
        let mut split_steps = Vec::new();
        if !self.is_refined(step) {
            self.split_into(fans, step, &mut split_steps);
        }
        split_steps.len()
    }

    /// Returns the coarsest instance in which every wanted step is refined. `is_wanted` is evaluated at
    /// most once per step, coarsest first, and not for steps that have already been refined because
    /// another step needs them.
    pub fn refined(fans: &Fans, mut is_wanted: impl FnMut(u32) -> bool) -> Self {
        let mut instance = Self::uniform(fans, 0);
        for step in 0..fans.step_count as u32 {
            if !instance.is_refined(step) && is_wanted(step) {
                instance.split(fans, step);
            }
        }
        instance
    }

    /// Refines from the base to exactly what a criterion wants and what that needs. Nothing is remembered
    /// from one view to the next, so the instance stays at one bit per step. Only the children of wanted
    /// steps are evaluated. Returns the number of refined steps.
    ///
    /// # Panics
    /// If the instance belongs to a different table.
    pub fn refine(&mut self, scene: &FanScene<'_>, criterion: &impl Criterion) -> usize {
        let fans = scene.fans;
        assert_eq!(self.step_count, fans.step_count, "the instance belongs to a different table");
        self.collapsed.set_range(0..self.step_count);
        let mut known = StepBits::none(self.step_count);
        fans.for_each_child(None, |child| known.insert(child));
        let (mut steps, mut parts, mut verdicts) = (Vec::new(), Vec::new(), Vec::new());
        // From coarse to fine, which reads memory in order.
        let mut next = 0;
        while known.take_from(next, BATCH_SIZE, &mut steps) {
            parts.clear();
            parts.extend(steps.iter().map(|&step| scene.part(step)));
            verdicts.clear();
            criterion.weigh_all(&parts, &mut verdicts);
            // Children are finer than their parents, but they may be coarser than others of the same batch.
            next = steps[0];
            for (step, verdict) in steps.drain(..).zip(&verdicts) {
                if verdict.should_refine() {
                    self.collapsed.remove(step);
                    fans.add_children(step, &mut known);
                }
            }
        }
        self.split_needed(fans)
    }

    /// Splits all steps that refined ones need. Returns the number of refined steps.
    fn split_needed(&mut self, fans: &Fans) -> usize {
        // A step needs only coarser steps, so a single pass from fine to coarse reaches all of them.
        let mut count = 0;
        let mut end = self.step_count as u32;
        while let Some(step) = self.collapsed.last_absent_before(end) {
            fans.for_each_needed_by_split(step, |needed| self.collapsed.remove(needed));
            count += 1;
            end = step;
        }
        count
    }

    /// Splits a step and everything that it needs, and appends all steps split.
    pub(super) fn split_into(&mut self, fans: &Fans, step: u32, split_steps: &mut Vec<u32>) {
        let mut at = split_steps.len();
        self.collapsed.remove(step);
        split_steps.push(step);
        while let Some(&step) = split_steps.get(at) {
            at += 1;
            fans.for_each_needed_by_split(step, |needed| {
                if self.collapsed.has(needed) {
                    self.collapsed.remove(needed);
                    split_steps.push(needed);
                }
            });
        }
    }

    fn check(&self, fans: &Fans, step: u32) {
        assert_eq!(self.step_count, fans.step_count, "the instance belongs to a different table");
        assert!((step as usize) < self.step_count, "step {step} of {}", self.step_count);
    }
}

impl Fans {
    /// Visits the steps that must be collapsed before this one.
    pub(super) fn for_each_needed_by_collapse(&self, step: u32, mut visit: impl FnMut(u32)) {
        for vertex in self.vertices.of_step(step as usize) {
            for fan in self.step_entry(vertex, step) {
                for creator in fan.creators() {
                    visit(creator.step);
                }
            }
        }
        listed(&self.waits, step).for_each(visit);
    }

    /// Whether all steps that must be collapsed before this one are collapsed.
    pub(super) fn is_free(&self, step: u32, collapsed: &StepBits) -> bool {
        let quick = self.quick();
        let is_free = |vertex: u32| {
            let is_free = quick.is_free(vertex, step + 1, |finer| collapsed.has(finer));
            is_free.unwrap_or_else(|| {
                let mut fans = self.step_entry(vertex, step);
                fans.all(|fan| fan.creators().all(|creator| collapsed.has(creator.step)))
            })
        };
        self.vertices.of_step(step as usize).all(is_free)
            && listed(&self.waits, step).all(|finer| collapsed.has(finer))
    }

    /// Visits the steps that must be split before this one, some of them repeatedly.
    #[inline(always)]
    pub(super) fn for_each_needed_by_split(&self, step: u32, mut visit: impl FnMut(u32)) {
        let quick = self.quick();
        let vertices = self.vertices.of_step(step as usize);
        let mut visit_vertex = |vertex: u32| {
            // A triangle between wedges of one position puts a wedge of the position itself into the ring.
            if vertex >= self.vertices.base_vertex_count && !vertices.contains(&vertex) {
                visit(quick.step_of(vertex, self.vertices.base_vertex_count));
            }
        };
        for vertex in vertices.clone() {
            match quick.nodes(vertex) {
                Some(nodes) => nodes.into_iter().for_each(&mut visit_vertex),
                None => self.step_entry(vertex, step).for_each(|fan| fan.nodes().for_each(&mut visit_vertex)),
            }
        }
        listed(&self.far, step).for_each(visit);
    }

    /// Adds the children of a step to a set.
    #[inline(always)]
    fn add_children(&self, step: u32, set: &mut StepBits) {
        let quick = self.quick();
        for vertex in self.vertices.of_step(step as usize) {
            if !quick.add_children(vertex, step + 1, set) {
                let creators = self.table.entry(vertex, step + 1).flat_map(|fan| fan.creators());
                creators.filter(|c| c.is_child).for_each(|creator| set.insert(creator.step));
            }
        }
    }

    /// Visits the children of a step in the tree, or of the base if `parent` is `None`. The parent of a
    /// step is one of the steps that must be split before it; each step has one parent.
    #[inline]
    pub(super) fn for_each_child(&self, parent: Option<u32>, mut visit: impl FnMut(u32)) {
        let quick = self.quick();
        let vertices = match parent {
            Some(step) => self.vertices.of_step(step as usize),
            None => 0..self.vertices.base_vertex_count,
        };
        let own_step = parent.map_or(0, |step| step + 1);
        for vertex in vertices {
            if !quick.for_each_child(vertex, own_step, &mut visit) {
                let creators = self.table.entry(vertex, own_step).flat_map(|fan| fan.creators());
                creators.filter(|c| c.is_child).for_each(|creator| visit(creator.step));
            }
        }
        if parent.is_none() {
            self.orphans.iter().for_each(|&step| visit(step));
        }
    }
}
