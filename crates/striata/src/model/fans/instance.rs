//! An instance of the table: a bit for each step, and the moves between sets of steps that are possible.

use super::{FanScene, Fans, listed};
use crate::model::step_bits::StepBits;
use crate::view::Criterion;

/// Which steps an instance has taken: one bit each. Any set that it comes to is one that the sequence, leaving steps out,
/// can come to.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FanInstance {
    pub(super) step_count: usize,
    pub(super) taken: StepBits,
}

impl FanInstance {
    /// An instance that shows the full mesh.
    pub fn full(fans: &Fans) -> Self {
        Self { step_count: fans.step_count, taken: StepBits::none(fans.step_count) }
    }

    /// An instance at a uniform level.
    ///
    /// # Panics
    /// If `split_count` exceeds the step count.
    pub fn uniform(fans: &Fans, split_count: usize) -> Self {
        assert!(split_count <= fans.step_count, "split count {split_count} of {}", fans.step_count);
        let mut instance = Self::full(fans);
        instance.taken.set_range(split_count..fans.step_count);
        instance
    }

    /// Whether a step is undone: its position is then there.
    ///
    /// # Panics
    /// If there is no such step.
    #[inline]
    pub fn is_refined(&self, step: u32) -> bool {
        !self.taken.has(step)
    }

    /// Steps that are undone.
    pub fn split_count(&self) -> usize {
        self.step_count - self.taken.count()
    }

    /// Steps that are taken: those that are not undone.
    pub fn collapse_count(&self) -> usize {
        self.taken.count()
    }

    /// Bytes that the instance owns: a bit a step.
    pub fn bytes(&self) -> usize {
        self.taken.bytes()
    }

    /// Collapses a step, and before it every step that it waits for; returns how many that were.
    ///
    /// # Panics
    /// If there is no such step, or the instance is of another table.
    pub fn collapse(&mut self, fans: &Fans, step: u32) -> usize {
        self.check(fans, step);
        let mut waiting = vec![step];
        let mut count = 0;
        while let Some(step) = waiting.pop() {
            if !self.is_refined(step) {
                continue;
            }
            self.taken.insert(step);
            count += 1;
            fans.for_each_needed_by_collapse(step, |needed| {
                if self.is_refined(needed) {
                    waiting.push(needed);
                }
            });
        }
        count
    }

    /// Undoes a step, and before it every step that has taken a position around it; returns how many that were.
    ///
    /// # Panics
    /// If there is no such step, or the instance is of another table.
    pub fn split(&mut self, fans: &Fans, step: u32) -> usize {
        self.check(fans, step);
        let mut undone = Vec::new();
        if !self.is_refined(step) {
            self.split_into(fans, step, &mut undone);
        }
        undone.len()
    }

    /// An instance that has undone every step that is wanted, and beside these only what they need: the coarsest one that
    /// does. Every step is asked for once, coarsest first, unless it has been undone for another.
    pub fn refined(fans: &Fans, mut is_wanted: impl FnMut(u32) -> bool) -> Self {
        let mut instance = Self::uniform(fans, 0);
        for step in 0..fans.step_count as u32 {
            if !instance.is_refined(step) && is_wanted(step) {
                instance.split(fans, step);
            }
        }
        instance
    }

    /// Goes to what a criterion wants and to no more than that needs, from the base and without a memory of the last view:
    /// the instance stays a bit a step. Asks only for steps that are right below a wanted one in the tree. Returns how many
    /// were undone.
    ///
    /// # Panics
    /// If the instance is of another table.
    pub fn refine(&mut self, scene: &FanScene<'_>, criterion: &impl Criterion) -> usize {
        let fans = scene.fans;
        assert_eq!(self.step_count, fans.step_count, "the instance is of another table");
        self.taken.set_range(0..self.step_count);
        let (mut undone, mut steps) = (Vec::new(), Vec::new());
        let (mut parts, mut verdicts) = (Vec::new(), Vec::new());
        fans.for_each_child(None, |child| steps.push(child));
        // Generation by generation, so that many can be asked at once.
        while !steps.is_empty() {
            parts.clear();
            parts.extend(steps.iter().map(|&step| scene.part(step)));
            verdicts.clear();
            criterion.weigh_all(&parts, &mut verdicts);
            for (step, verdict) in std::mem::take(&mut steps).into_iter().zip(&verdicts) {
                if verdict.should_refine() {
                    if self.taken.has(step) {
                        self.split_into(fans, step, &mut undone);
                    }
                    fans.for_each_child(Some(step), |child| steps.push(child));
                }
            }
        }
        undone.len()
    }

    /// Undoes a step and before it what it needs, and appends all that were.
    pub(super) fn split_into(&mut self, fans: &Fans, step: u32, undone: &mut Vec<u32>) {
        let mut at = undone.len();
        self.taken.remove(step);
        undone.push(step);
        while let Some(&step) = undone.get(at) {
            at += 1;
            fans.for_each_needed_by_split(step, |needed| {
                if self.taken.has(needed) {
                    self.taken.remove(needed);
                    undone.push(needed);
                }
            });
        }
    }

    fn check(&self, fans: &Fans, step: u32) {
        assert_eq!(self.step_count, fans.step_count, "the instance is of another table");
        assert!((step as usize) < self.step_count, "step {step} of {}", self.step_count);
    }
}

impl Fans {
    /// Steps that have to be collapsed before this one.
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

    /// Whether all steps are taken that have to be before this one.
    pub(super) fn is_free(&self, step: u32, taken: &StepBits) -> bool {
        let vertices = self.vertices.of_step(step as usize);
        vertices
            .flat_map(|vertex| self.step_entry(vertex, step))
            .all(|fan| fan.creators().all(|c| taken.has(c.step)))
            && listed(&self.waits, step).all(|finer| taken.has(finer))
    }

    /// Steps that have to be undone before this one.
    pub(super) fn for_each_needed_by_split(&self, step: u32, mut visit: impl FnMut(u32)) {
        let vertices = self.vertices.of_step(step as usize);
        let mut visit_vertex = |vertex: u32| {
            // Wedges of the position itself stand in its rings where wedges meet in a triangle.
            if vertex >= self.vertices.base_vertex_count && !vertices.contains(&vertex) {
                visit(self.vertices.step_of(vertex) as u32);
            }
        };
        for vertex in vertices.clone() {
            for fan in self.step_entry(vertex, step) {
                for node in fan.nodes() {
                    visit_vertex(node);
                }
            }
        }
        listed(&self.far, step).for_each(visit);
    }

    /// The steps below one in the tree, or below the base: those that wait for nothing coarser than it. Each step is below
    /// one of the steps that it needs, and below one only.
    // Always: most of what a view without a memory takes is here.
    #[inline(always)]
    pub(super) fn for_each_child(&self, parent: Option<u32>, mut visit: impl FnMut(u32)) {
        let vertices = match parent {
            Some(step) => self.vertices.of_step(step as usize),
            None => 0..self.vertices.base_vertex_count,
        };
        let own_step = parent.map_or(0, |step| step + 1);
        for vertex in vertices {
            for fan in self.table.entry(vertex, own_step) {
                for creator in fan.creators() {
                    if creator.is_child {
                        visit(creator.step);
                    }
                }
            }
        }
        if parent.is_none() {
            self.orphans.iter().for_each(|&step| visit(step));
        }
    }
}
