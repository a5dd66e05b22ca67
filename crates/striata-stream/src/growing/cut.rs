//! [`HierarchyCut`]: the set of steps that a view refines, and the triangles of that level.

use std::collections::BinaryHeap;

use striata::model::StepBits;
use striata::view::{Criterion, Part, Verdict};

use super::hierarchy::{ALL_UP_TO, GrowingHierarchy, NONE};
use crate::reader::prefix::PrefixMesh;

/// Number of steps evaluated per call of the criterion: few enough to stay in the cache.
const EVALUATED_TOGETHER: usize = 64;

/// A set of refined steps that includes the dependencies of each.
///
/// Every view starts again from the base, so a cut does not depend on earlier views, and the hierarchy may
/// grow between views.
#[derive(Clone, Debug)]
pub struct HierarchyCut {
    /// Steps with this index or a higher one stay coarse.
    step_limit: u32,
    refined: StepBits,
    refined_count: usize,
    triangle_count: usize,
    /// Every step with a lower index is refined.
    refined_until: u32,
    /// Steps that the last call of `refine_step` refined, so that a triangle budget can undo it.
    last_refined: Vec<u32>,
    evaluations: Evaluations,
}

/// Result of [`HierarchyCut::refine`].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct CutUpdate {
    /// Number of steps for which the criterion was evaluated.
    pub evaluated_count: usize,
    /// Number of triangles of the cut.
    pub triangle_count: usize,
    /// Weight above which parts are refined: 1, or more if the triangle limit required it.
    pub threshold: f32,
}

impl Default for HierarchyCut {
    fn default() -> Self {
        Self::new()
    }
}

/// Scratch memory for evaluating the criterion.
#[derive(Clone, Debug, Default)]
struct Evaluations {
    parts: Vec<Part>,
    verdicts: Vec<Verdict>,
}

impl HierarchyCut {
    /// Creates an empty cut; call [`refine`](Self::refine) before reading triangles.
    pub fn new() -> Self {
        Self {
            step_limit: u32::MAX,
            refined: StepBits::default(),
            refined_count: 0,
            triangle_count: 0,
            refined_until: 0,
            last_refined: Vec::new(),
            evaluations: Evaluations::default(),
        }
    }

    /// Keeps all steps from `step_limit` on coarse, even if they have been decoded: the renderer may not
    /// yet have their vertices.
    pub fn limit_steps(&mut self, step_limit: usize) {
        self.step_limit = u32::try_from(step_limit).unwrap_or(u32::MAX);
    }

    /// Refines the steps that a criterion requests, and their dependencies, up to a number of triangles.
    ///
    /// If the limit is too low for all of them, the steps with the highest weights are refined: the cut
    /// uses the lowest threshold above 1 that fits. The base mesh is shown even if it exceeds the limit.
    pub fn refine(
        &mut self,
        hierarchy: &GrowingHierarchy,
        criterion: &impl Criterion,
        triangle_limit: usize,
    ) -> CutUpdate {
        self.clear(hierarchy);
        let mut update = CutUpdate { threshold: 1.0, ..CutUpdate::default() };
        if triangle_limit < hierarchy.triangle_count() {
            self.refine_within_limit(hierarchy, criterion, triangle_limit, &mut update);
        } else {
            self.refine_all(hierarchy, criterion, &mut update);
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

    /// Returns the number of refined steps.
    pub fn split_count(&self) -> usize {
        self.refined_count
    }

    /// Returns the index of the first step that is not refined, or the number of steps if all are.
    pub fn first_coarse_step(&self, hierarchy: &GrowingHierarchy) -> usize {
        let step_count = hierarchy.step_count() as u32;
        (self.refined_until..step_count).find(|&step| !self.is_refined(step)).unwrap_or(step_count) as usize
    }

    /// Appends the triangles of the cut, each with its index in the mesh.
    ///
    /// The mesh may have grown since the cut was made: vertices that the cut does not know are inactive.
    ///
    /// # Panics
    /// If the hierarchy has grown since the cut was made, or belongs to another mesh.
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
        (self.refined_count, self.refined_until) = (0, 0);
        self.triangle_count = hierarchy.base_triangle_count();
    }

    /// Refines every requested step, level by level of the tree, so that many steps are evaluated together.
    fn refine_all(
        &mut self,
        hierarchy: &GrowingHierarchy,
        criterion: &impl Criterion,
        update: &mut CutUpdate,
    ) {
        let (mut steps, mut next_steps) = (Vec::new(), Vec::new());
        self.append_children(hierarchy, NONE, &mut steps);
        while !steps.is_empty() {
            for together in steps.chunks(EVALUATED_TOGETHER) {
                self.evaluate(hierarchy, criterion, together, update);
                for (at, &step) in together.iter().enumerate() {
                    if self.evaluations.verdicts[at].should_refine() {
                        self.refine_step(hierarchy, step);
                        self.append_children(hierarchy, step, &mut next_steps);
                    }
                }
            }
            steps.clear();
            std::mem::swap(&mut steps, &mut next_steps);
        }
    }

    /// Refines by falling weight until the next step and its dependencies would exceed the limit.
    fn refine_within_limit(
        &mut self,
        hierarchy: &GrowingHierarchy,
        criterion: &impl Criterion,
        triangle_limit: usize,
        update: &mut CutUpdate,
    ) {
        let mut queue = BinaryHeap::new();
        let mut children = Vec::new();
        let mut parent = NONE;
        loop {
            children.clear();
            self.append_children(hierarchy, parent, &mut children);
            for together in children.chunks(EVALUATED_TOGETHER) {
                self.evaluate(hierarchy, criterion, together, update);
                let wanted =
                    together.iter().zip(&self.evaluations.verdicts).filter(|(_, v)| v.should_refine());
                // Weights are above 1, so they sort like their bits; of equal weights, the older step comes
                // first.
                queue.extend(wanted.map(|(&step, verdict)| (verdict.weight.to_bits(), !step)));
            }
            let Some((weight, step)) = queue.pop() else { return };
            self.refine_step(hierarchy, !step);
            if self.triangle_count > triangle_limit {
                self.undo_last_refinement(hierarchy);
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

    fn evaluate(
        &mut self,
        hierarchy: &GrowingHierarchy,
        criterion: &impl Criterion,
        steps: &[u32],
        update: &mut CutUpdate,
    ) {
        let Evaluations { parts, verdicts } = &mut self.evaluations;
        parts.clear();
        verdicts.clear();
        parts.extend(steps.iter().map(|&step| hierarchy.part(step)));
        criterion.weigh_all(parts, verdicts);
        update.evaluated_count += steps.len();
    }

    /// Refines a step and all its dependencies.
    fn refine_step(&mut self, hierarchy: &GrowingHierarchy, step: u32) {
        self.last_refined.clear();
        self.refine_one(hierarchy, step);
        let mut at = 0;
        while let Some(&step) = self.last_refined.get(at) {
            at += 1;
            for &dependency in hierarchy.dependencies_of(step) {
                if dependency & ALL_UP_TO == 0 {
                    self.refine_one(hierarchy, dependency);
                    continue;
                }
                let last = dependency & !ALL_UP_TO;
                (self.refined_until..=last).for_each(|step| self.refine_one(hierarchy, step));
                self.refined_until = self.refined_until.max(last + 1);
            }
        }
    }

    fn refine_one(&mut self, hierarchy: &GrowingHierarchy, step: u32) {
        if !self.refined.has(step) {
            self.refined.insert(step);
            self.refined_count += 1;
            self.triangle_count += hierarchy.added_triangles(step).len();
            self.last_refined.push(step);
        }
    }

    /// Undoes the last call of `refine_step`.
    fn undo_last_refinement(&mut self, hierarchy: &GrowingHierarchy) {
        for &step in &self.last_refined {
            self.refined.remove(step);
            self.refined_count -= 1;
            self.triangle_count -= hierarchy.added_triangles(step).len();
            self.refined_until = self.refined_until.min(step);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::grow::limit_dependencies;
    use super::*;

    /// A hierarchy whose steps depend on all older ones: untruncated lists would grow quadratically.
    fn fully_dependent_steps(step_count: u32) -> GrowingHierarchy {
        let mut hierarchy = GrowingHierarchy {
            first_triangles: (0..=step_count).collect(),
            first_dependencies: vec![0],
            ..GrowingHierarchy::default()
        };
        for step in 0..step_count {
            let first = hierarchy.dependencies.len();
            hierarchy.dependencies.extend(0..step);
            limit_dependencies(&mut hierarchy.dependencies, first, step as usize);
            hierarchy.first_dependencies.push(hierarchy.dependencies.len() as u32);
        }
        hierarchy.parents = vec![NONE; step_count as usize];
        hierarchy
    }

    #[test]
    fn long_dependency_lists_are_replaced_by_all_older_steps() {
        let hierarchy = fully_dependent_steps(3000);
        assert!(
            hierarchy.dependencies.len() < 30 * 3000 + 40_000,
            "{} entries",
            hierarchy.dependencies.len()
        );
        let mut cut = HierarchyCut::new();
        for step in [0, 1, 20, 2500, 2999] {
            cut.clear(&hierarchy);
            cut.refine_step(&hierarchy, step);
            assert_eq!((cut.split_count(), cut.triangle_count), (step as usize + 1, step as usize + 1));
            assert_eq!(cut.first_coarse_step(&hierarchy), step as usize + 1);
        }
        cut.undo_last_refinement(&hierarchy);
        assert_eq!((cut.split_count(), cut.first_coarse_step(&hierarchy)), (0, 0));
    }

    #[test]
    fn an_empty_hierarchy_has_nothing_to_refine() {
        let (mut hierarchy, mut cut) = (GrowingHierarchy::new(), HierarchyCut::new());
        hierarchy.grow(&PrefixMesh::default(), &[], |_| 0.0);
        let update = cut.refine(&hierarchy, &|_: &Part| 2.0, usize::MAX);
        assert_eq!((update.evaluated_count, update.triangle_count), (0, 0));
        let mut triangles = Vec::new();
        cut.triangles_into(&hierarchy, &PrefixMesh::default(), &mut triangles);
        assert!(triangles.is_empty());
    }
}
