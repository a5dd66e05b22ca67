//! Levels for views and boxes, from patterns.

use super::{FoundLevel, LEAST_PIXELS};
use crate::mesh::IndexedMesh;
use crate::model::{Overlap, PatternInstance, PatternScene, Patterns};
use crate::simplify::StopReason;
use crate::view::{Criterion, DetailBox, Part, ScreenError};

/// Patterns with the mesh that they refer to, as a source of levels for views and boxes.
///
/// Each overlap gets a weight, from the bounds of the upper fragment and the error of the overlap. A level is the
/// coarsest surface without triangles whose weight exceeds a threshold; with a triangle limit, the threshold is the
/// lowest one that respects it \[KG98\].
#[derive(Clone, Debug)]
pub struct PatternLevels {
    patterns: Patterns,
    mesh: IndexedMesh,
}

/// Limits of a level.
#[derive(Clone, Copy, Debug)]
struct PatternBudget {
    triangle_limit: Option<usize>,
    /// Fragments whose weight is at most this may be left out.
    threshold: f32,
}

/// An instance within a budget.
struct BudgetedInstance {
    instance: PatternInstance,
    /// Fragments whose weight is at most this may be left out.
    threshold: f32,
    stop_reason: StopReason,
}

impl PatternLevels {
    /// Wraps patterns and the mesh that they refer to.
    pub fn new(patterns: Patterns, mesh: IndexedMesh) -> Self {
        Self { patterns, mesh }
    }

    /// The patterns.
    pub fn patterns(&self) -> &Patterns {
        &self.patterns
    }

    /// Returns the level for a view: see [`Levels::find_for_view`](super::Levels::find_for_view).
    pub fn view(&self, criterion: &ScreenError, triangle_limit: Option<usize>) -> FoundLevel<IndexedMesh> {
        let criterion = match triangle_limit {
            Some(_) => criterion.clone().at_least(LEAST_PIXELS),
            None => criterion.clone(),
        };
        // Fragments around the eye have infinite weight, but must be removable if there are too many
        // triangles.
        let weight = |part: &Part| criterion.weigh(part).weight.min(f32::MAX);
        let (level, threshold) = self.level(weight, PatternBudget { triangle_limit, threshold: 1.0 });
        FoundLevel { relaxation: f64::from(threshold), ..level }
    }

    /// Returns the level with full detail in a box: see [`Levels::find_for_box`](super::Levels::find_for_box).
    pub fn detail_box(
        &self,
        detail_box: &DetailBox,
        triangle_limit: Option<usize>,
    ) -> FoundLevel<IndexedMesh> {
        // The weight of a fragment outside the box is its error. Without a limit, all of these fragments may be
        // left out.
        let threshold = match (detail_box.error_outside.is_finite(), triangle_limit) {
            (true, _) => detail_box.error_outside,
            (false, Some(_)) => 0.0,
            (false, None) => f32::MAX,
        };
        let inside = DetailBox { error_outside: f32::INFINITY, ..*detail_box };
        let weight =
            |part: &Part| if inside.weigh(part).should_refine() { f32::INFINITY } else { part.error };
        self.level(weight, PatternBudget { triangle_limit, threshold }).0
    }

    /// Returns the coarsest level whose triangles are all within a threshold, and that threshold.
    fn level(&self, weight: impl Fn(&Part) -> f32, budget: PatternBudget) -> (FoundLevel<IndexedMesh>, f32) {
        let scene = PatternScene::new(&self.patterns, &self.mesh.positions);
        let weight_of =
            |overlap: Overlap| weight(&Part { error: overlap.error, ..scene.part(overlap.upper) });
        let BudgetedInstance { instance, threshold, stop_reason } = match budget.triangle_limit {
            // This does not need the weights of all fragments.
            None => {
                let mut instance = PatternInstance::base(&self.patterns);
                instance.adapt(&self.patterns, &|overlap: Overlap| weight_of(overlap) > budget.threshold);
                let (threshold, stop_reason) = (budget.threshold, StopReason::TargetReached);
                BudgetedInstance { instance, threshold, stop_reason }
            }
            Some(_) => {
                let steps = 0..self.patterns.fragment_count() as u32;
                let thresholds = steps.map(|step| weight(&scene.part(step))).collect();
                self.instance_within(thresholds, weight_of, budget)
            }
        };
        let (split_count, error) = (instance.split_count(), scene.error_of(&instance));
        let level = FoundLevel::of_mesh(self.mesh_of(&instance), split_count, error, stop_reason);
        (level, threshold)
    }

    /// Returns the instance for the lowest of the thresholds (at least that of the budget) with few enough
    /// triangles.
    fn instance_within(
        &self,
        mut thresholds: Vec<f32>,
        weight_of: impl Fn(Overlap) -> f32,
        budget: PatternBudget,
    ) -> BudgetedInstance {
        let limit = budget.triangle_limit.unwrap_or(usize::MAX);
        thresholds.retain(|&w| w > budget.threshold && w.is_finite());
        thresholds.push(budget.threshold);
        thresholds.sort_unstable_by(f32::total_cmp);
        thresholds.dedup();
        let mut instance = PatternInstance::base(&self.patterns);
        let mut instance_at = |threshold: f32| {
            instance.adapt(&self.patterns, &|overlap: Overlap| weight_of(overlap) > threshold);
            instance.clone()
        };
        // Binary search: a higher threshold gives fewer triangles.
        let (mut low, mut high) = (0, thresholds.len() - 1);
        while low < high {
            let middle = (low + high) / 2;
            if instance_at(thresholds[middle]).triangle_count() <= limit {
                high = middle
            } else {
                low = middle + 1
            }
        }
        let found = instance_at(thresholds[low]);
        let is_met = found.triangle_count() <= limit;
        let stop_reason = if is_met { StopReason::TargetReached } else { StopReason::BaseReached };
        BudgetedInstance { instance: found, threshold: thresholds[low], stop_reason }
    }

    /// Returns the mesh of an instance.
    fn mesh_of(&self, instance: &PatternInstance) -> IndexedMesh {
        let mut mesh = self.mesh.clone();
        mesh.triangles.clear();
        mesh.triangle_layers.clear();
        for group_index in 0..mesh.groups.len().max(1) {
            let first = mesh.triangles.len();
            instance.group_triangles_into(group_index as u32, &mut mesh.triangles);
            if let Some(group) = mesh.groups.get_mut(group_index) {
                (group.first, group.count) = (first as u32, (mesh.triangles.len() - first) as u32);
            }
        }
        mesh.take_nearest_triangle_layers(&self.mesh);
        mesh.without_unused_vertices()
    }
}
