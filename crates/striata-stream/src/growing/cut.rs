//! Cuts: which steps a view refines, and the triangles that these show.

use std::collections::BinaryHeap;

use striata::model::StepBits;
use striata::view::{Criterion, Part, Verdict};

use super::hierarchy::{ALL_THROUGH, GrowingHierarchy, NONE};
use crate::reader::prefix::PrefixMesh;

/// Steps that are asked about together: few enough to stay in a cache.
const ASKED_TOGETHER: usize = 64;

/// A set of refined steps that holds all that each of them needs.
///
/// A cut begins at the base for every view, so it does not depend on the views before, and the hierarchy may grow in between.
#[derive(Clone, Debug)]
pub struct HierarchyCut {
    /// Steps from this one on stay coarse.
    step_limit: u32,
    refined: StepBits,
    refined_count: usize,
    triangle_count: usize,
    /// Every step before this one is refined.
    whole_until: u32,
    /// Steps that the last refinement refined, for a budget to take back.
    last: Vec<u32>,
    asked: Asked,
}

/// What a view made of a cut.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct CutUpdate {
    /// Steps that the criterion was asked about.
    pub asked_count: usize,
    /// Triangles that the cut shows.
    pub triangle_count: usize,
    /// Parts that weigh more are refined: 1, or more if a budget of triangles asked for it.
    pub threshold: f32,
}

impl Default for HierarchyCut {
    fn default() -> Self {
        Self::new()
    }
}

/// Scratch memory for questions.
#[derive(Clone, Debug, Default)]
struct Asked {
    parts: Vec<Part>,
    verdicts: Vec<Verdict>,
}

impl HierarchyCut {
    /// A cut that shows nothing yet.
    pub fn new() -> Self {
        Self {
            step_limit: u32::MAX,
            refined: StepBits::default(),
            refined_count: 0,
            triangle_count: 0,
            whole_until: 0,
            last: Vec::new(),
            asked: Asked::default(),
        }
    }

    /// Keeps steps from this one on coarse from now on, although they have arrived: whoever draws may not have their vertices yet.
    pub fn limit_steps(&mut self, step_limit: usize) {
        self.step_limit = u32::try_from(step_limit).unwrap_or(u32::MAX);
    }

    /// Refines what a criterion wants, and what that needs, up to a number of triangles.
    ///
    /// If the limit is too low for all that is wanted, the parts that weigh most are refined: of all thresholds above 1 the lowest whose
    /// cut fits. The base is shown even if it has more triangles.
    pub fn refine(
        &mut self,
        hierarchy: &GrowingHierarchy,
        criterion: &impl Criterion,
        triangle_limit: usize,
    ) -> CutUpdate {
        self.clear(hierarchy);
        let mut update = CutUpdate { threshold: 1.0, ..CutUpdate::default() };
        if triangle_limit < hierarchy.triangle_count() {
            self.refine_heaviest(hierarchy, criterion, triangle_limit, &mut update);
        } else {
            self.refine_wanted(hierarchy, criterion, &mut update);
        }
        update.triangle_count = self.triangle_count;
        update
    }

    /// Whether a step is refined.
    ///
    /// # Panics
    /// If the hierarchy had no such step when the cut was made.
    #[inline]
    pub fn is_refined(&self, step: u32) -> bool {
        self.refined.has(step)
    }

    /// Steps that are refined.
    pub fn split_count(&self) -> usize {
        self.refined_count
    }

    /// The coarsest step that is not refined; as many as there are if all are.
    pub fn first_coarse_step(&self, hierarchy: &GrowingHierarchy) -> usize {
        let step_count = hierarchy.step_count() as u32;
        (self.whole_until..step_count).find(|&step| !self.is_refined(step)).unwrap_or(step_count) as usize
    }

    /// Appends the triangles that the cut shows, each with its number in the mesh.
    ///
    /// The mesh may have grown since the cut was made: vertices that the cut does not know are not active.
    ///
    /// # Panics
    /// If the hierarchy has grown since the cut was made, or is another mesh's.
    pub fn triangles_into(
        &self,
        hierarchy: &GrowingHierarchy,
        mesh: &PrefixMesh<'_>,
        out: &mut Vec<(u32, [u32; 3])>,
    ) {
        let vertex_count = hierarchy.vertex_count() as u32;
        let is_refined = |vertex| hierarchy.step_of(vertex).is_none_or(|step| self.is_refined(step));
        let shown = mesh.shown_vertices(|vertex| vertex < vertex_count && is_refined(vertex));
        mesh.append_shown(0..hierarchy.base_triangle_count(), &shown, out);
        let mut step = self.refined.first_from(0);
        while let Some(refined) = step {
            mesh.append_shown(hierarchy.added_triangles(refined), &shown, out);
            step = self.refined.first_from(refined + 1);
        }
    }

    fn clear(&mut self, hierarchy: &GrowingHierarchy) {
        self.refined = StepBits::none(hierarchy.step_count());
        (self.refined_count, self.whole_until) = (0, 0);
        self.triangle_count = hierarchy.base_triangle_count();
    }

    /// Refines all that is wanted, generation by generation, so that many steps are asked about together.
    fn refine_wanted(
        &mut self,
        hierarchy: &GrowingHierarchy,
        criterion: &impl Criterion,
        update: &mut CutUpdate,
    ) {
        let (mut steps, mut finer) = (Vec::new(), Vec::new());
        self.append_children(hierarchy, NONE, &mut steps);
        while !steps.is_empty() {
            for together in steps.chunks(ASKED_TOGETHER) {
                self.ask(hierarchy, criterion, together, update);
                for (at, &step) in together.iter().enumerate() {
                    if self.asked.verdicts[at].is_wanted() {
                        self.refine_step(hierarchy, step);
                        self.append_children(hierarchy, step, &mut finer);
                    }
                }
            }
            steps.clear();
            std::mem::swap(&mut steps, &mut finer);
        }
    }

    /// Refines by falling weight until the next step and what it needs would exceed the limit.
    fn refine_heaviest(
        &mut self,
        hierarchy: &GrowingHierarchy,
        criterion: &impl Criterion,
        triangle_limit: usize,
        update: &mut CutUpdate,
    ) {
        let mut waiting = BinaryHeap::new();
        let mut children = Vec::new();
        let mut parent = NONE;
        loop {
            children.clear();
            self.append_children(hierarchy, parent, &mut children);
            for together in children.chunks(ASKED_TOGETHER) {
                self.ask(hierarchy, criterion, together, update);
                let wanted = together.iter().zip(&self.asked.verdicts).filter(|(_, v)| v.is_wanted());
                // Weights above 1 are ordered as their bits are; among equal ones the older step comes first.
                waiting.extend(wanted.map(|(&step, verdict)| (verdict.weight.to_bits(), !step)));
            }
            let Some((weight, step)) = waiting.pop() else { return };
            self.refine_step(hierarchy, !step);
            if self.triangle_count > triangle_limit {
                self.take_back(hierarchy);
                update.threshold = f32::from_bits(weight);
                return;
            }
            parent = !step;
        }
    }

    fn append_children(&self, hierarchy: &GrowingHierarchy, parent: u32, out: &mut Vec<u32>) {
        hierarchy.for_each_child(parent, |child| {
            if child < self.step_limit {
                out.push(child);
            }
        });
    }

    fn ask(
        &mut self,
        hierarchy: &GrowingHierarchy,
        criterion: &impl Criterion,
        steps: &[u32],
        update: &mut CutUpdate,
    ) {
        let Asked { parts, verdicts } = &mut self.asked;
        parts.clear();
        verdicts.clear();
        parts.extend(steps.iter().map(|&step| hierarchy.part(step)));
        criterion.weigh_all(parts, verdicts);
        update.asked_count += steps.len();
    }

    /// Refines a step and all that it needs.
    fn refine_step(&mut self, hierarchy: &GrowingHierarchy, step: u32) {
        self.last.clear();
        self.refine_one(hierarchy, step);
        let mut at = 0;
        while let Some(&step) = self.last.get(at) {
            at += 1;
            for &need in hierarchy.needs_of(step) {
                if need & ALL_THROUGH == 0 {
                    self.refine_one(hierarchy, need);
                    continue;
                }
                let last = need & !ALL_THROUGH;
                (self.whole_until..=last).for_each(|step| self.refine_one(hierarchy, step));
                self.whole_until = self.whole_until.max(last + 1);
            }
        }
    }

    fn refine_one(&mut self, hierarchy: &GrowingHierarchy, step: u32) {
        if !self.refined.has(step) {
            self.refined.insert(step);
            self.refined_count += 1;
            self.triangle_count += hierarchy.added_triangles(step).len();
            self.last.push(step);
        }
    }

    /// Takes the last refinement back.
    fn take_back(&mut self, hierarchy: &GrowingHierarchy) {
        for &step in &self.last {
            self.refined.remove(step);
            self.refined_count -= 1;
            self.triangle_count -= hierarchy.added_triangles(step).len();
            self.whole_until = self.whole_until.min(step);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::grow::shorten_from;
    use super::*;

    /// Steps that each need all older ones: their lists would grow with the square of their number.
    fn each_on_all(step_count: u32) -> GrowingHierarchy {
        let mut hierarchy = GrowingHierarchy {
            first_triangles: (0..=step_count).collect(),
            first_needs: vec![0],
            ..GrowingHierarchy::default()
        };
        for step in 0..step_count {
            let first = hierarchy.needs.len();
            hierarchy.needs.extend(0..step);
            shorten_from(&mut hierarchy.needs, first, step as usize);
            hierarchy.first_needs.push(hierarchy.needs.len() as u32);
        }
        hierarchy.parents = vec![NONE; step_count as usize];
        hierarchy
    }

    #[test]
    fn lists_of_needs_that_are_too_long_stand_for_all_older_steps() {
        let hierarchy = each_on_all(3000);
        assert!(hierarchy.needs.len() < 30 * 3000 + 40_000, "{} entries", hierarchy.needs.len());
        let mut cut = HierarchyCut::new();
        for step in [0, 1, 20, 2500, 2999] {
            cut.clear(&hierarchy);
            cut.refine_step(&hierarchy, step);
            assert_eq!((cut.split_count(), cut.triangle_count), (step as usize + 1, step as usize + 1));
            assert_eq!(cut.first_coarse_step(&hierarchy), step as usize + 1);
        }
        cut.take_back(&hierarchy);
        assert_eq!((cut.split_count(), cut.first_coarse_step(&hierarchy)), (0, 0));
    }

    #[test]
    fn before_the_base_there_is_nothing_to_refine() {
        let (mut hierarchy, mut cut) = (GrowingHierarchy::new(), HierarchyCut::new());
        hierarchy.grow(&PrefixMesh::default(), &[], |_| 0.0);
        let update = cut.refine(&hierarchy, &|_: &Part| 2.0, usize::MAX);
        assert_eq!((update.asked_count, update.triangle_count), (0, 0));
        let mut triangles = Vec::new();
        cut.triangles_into(&hierarchy, &PrefixMesh::default(), &mut triangles);
        assert!(triangles.is_empty());
    }
}
