//! `extract --eye` and `--detail-box` with patterns.
//!
//! Each overlap gets a weight, from the bounds of the upper fragment and the error of the overlap. The result
//! is the coarsest surface without triangles whose weight exceeds a threshold; with a triangle limit, the
//! threshold is the lowest one that respects it.

use std::time::Instant;

use striata::file::StriataFile;
use striata::mesh::IndexedMesh;
use striata::model::{Overlap, PatternInstance, PatternScene, Patterns};
use striata::simplify::StopReason;
use striata::view::{Camera, Criterion, DetailBox, Part};

use super::fan_view::{MIN_PIXELS, ViewLevel};
use striata_command::args::ViewArgs;
use striata_command::failure::Failure;
use striata_command::input::Input;

/// The patterns of a file, with the mesh that they refer to.
pub(crate) struct FilePatterns {
    patterns: Patterns,
    mesh: IndexedMesh,
    /// Whether the patterns were stored in the file, rather than built from its collapses.
    pub are_stored: bool,
}

/// Limits of a level.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Budget {
    /// Largest number of triangles; `None` for no limit.
    pub triangle_limit: Option<usize>,
    /// Fragments whose weight is at most this may be left out.
    pub threshold: f32,
}

/// An instance within a budget.
struct BudgetedInstance {
    instance: PatternInstance,
    /// Fragments whose weight is at most this may be left out.
    threshold: f32,
    stop_reason: StopReason,
}

impl FilePatterns {
    /// Wraps patterns that are in memory, with the mesh that they refer to.
    pub(crate) fn of(patterns: Patterns, mesh: IndexedMesh) -> Self {
        Self { patterns, mesh, are_stored: true }
    }

    /// Reads the patterns of a file, or builds them from its collapses.
    ///
    /// # Errors
    /// If the file is damaged.
    pub(crate) fn read(file: &StriataFile<'_>, input: &Input) -> Result<Self, Failure> {
        let damaged = |error| input.damaged(&error);
        if let Some(stored) = file.patterns() {
            let patterns = stored.map_err(damaged)?;
            return Ok(Self { patterns, mesh: file.mesh().map_err(damaged)?, are_stored: true });
        }
        let fragmented = file.fragmented_mesh().map_err(damaged)?;
        let patterns = Patterns::build(&fragmented)?;
        Ok(Self { patterns, mesh: fragmented.mesh, are_stored: false })
    }

    /// Returns the number of fragments.
    pub(crate) fn step_count(&self) -> usize {
        self.patterns.fragment_count()
    }

    /// Returns the coarsest level within the pixel tolerance or, with a triangle limit, the best-looking
    /// level within it.
    pub(crate) fn level_of_view(
        &self,
        view: &ViewArgs,
        camera: Camera,
        triangle_limit: Option<usize>,
    ) -> ViewLevel {
        // The minimum keeps weights finite.
        let criterion = view.criterion(camera, if triangle_limit.is_some() { MIN_PIXELS } else { 0.0 });
        // Fragments around the eye have infinite weight, but must be removable if there are too many
        // triangles.
        let weight = |part: &Part| criterion.weigh(part).weight.min(f32::MAX);
        let (level, threshold) = self.level(weight, Budget { triangle_limit, threshold: 1.0 });
        let pixels = match triangle_limit {
            None => view.pixels(),
            Some(_) => f64::from(criterion.pixels()) * f64::from(threshold),
        };
        ViewLevel { pixels, ..level }
    }

    /// Returns the level with full detail inside a box, given by its smallest and largest coordinates, and errors
    /// outside of at most the budget's threshold.
    pub(crate) fn level_of_box(&self, [min, max]: [[f32; 3]; 2], budget: Budget) -> ViewLevel {
        let inside = DetailBox { min, max, error_outside: f32::INFINITY };
        let weight =
            |part: &Part| if inside.weigh(part).should_refine() { f32::INFINITY } else { part.error };
        self.level(weight, budget).0
    }

    /// Returns the coarsest level whose triangles are all within a threshold, and that threshold.
    fn level(&self, weight: impl Fn(&Part) -> f32, budget: Budget) -> (ViewLevel, f32) {
        let started = Instant::now();
        let scene = PatternScene::new(&self.patterns, &self.mesh.positions);
        let weight_of =
            |overlap: Overlap| weight(&Part { error: overlap.error, ..scene.part(overlap.upper) });
        let BudgetedInstance { instance, threshold, stop_reason } = match budget.triangle_limit {
            // This does not need the weights of all fragments.
            None => {
                let is_too_coarse = |overlap: Overlap| weight_of(overlap) > budget.threshold;
                let mut instance = PatternInstance::base(&self.patterns);
                instance.adapt(&self.patterns, &is_too_coarse);
                BudgetedInstance {
                    instance,
                    threshold: budget.threshold,
                    stop_reason: StopReason::TargetReached,
                }
            }
            Some(limit) => {
                let steps = 0..self.step_count() as u32;
                let thresholds = steps.map(|step| weight(&scene.part(step))).collect();
                self.instance_within(thresholds, weight_of, Budget { triangle_limit: Some(limit), ..budget })
            }
        };
        let seek_secs = started.elapsed().as_secs_f64();
        let level = ViewLevel {
            mesh: self.mesh_of(&instance),
            split_count: instance.split_count(),
            error: scene.error_of(&instance),
            pixels: 0.0,
            stop_reason,
            seek_secs,
        };
        (level, threshold)
    }

    /// Returns the instance for the lowest of the thresholds (at least that of the budget) with few enough
    /// triangles.
    fn instance_within(
        &self,
        mut thresholds: Vec<f32>,
        weight_of: impl Fn(Overlap) -> f32,
        budget: Budget,
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
