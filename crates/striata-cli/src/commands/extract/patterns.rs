//! `extract` by what patterns are asked: a view, or full detail inside a box.
//!
//! Each fragment gets a weight; those over a threshold have to be there, and the coarsest surface that has them is taken. With a budget
//! of triangles the threshold is the lowest that keeps to it.

use std::time::Instant;

use striata::file::StriataFile;
use striata::mesh::IndexedMesh;
use striata::model::{Overlap, PatternInstance, PatternScene, Patterns};
use striata::simplify::StopReason;
use striata::view::{Camera, Criterion, DetailBox};

use super::view::{LEAST_PIXELS, ViewLevel};
use striata_command::args::{Corners, ViewArgs};
use striata_command::failure::Failure;
use striata_command::input::Input;

/// Patterns of a file, and all that is needed to ask them.
pub(crate) struct PatternsOfFile {
    patterns: Patterns,
    mesh: IndexedMesh,
    /// Whether they were in the file, and not made from its collapses.
    pub(crate) are_stored: bool,
}

/// How many triangles a condition may take.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Budget {
    /// At most so many; as many as it takes where there is none.
    pub(crate) triangle_limit: Option<usize>,
    /// What weighs no more need not be there.
    pub(crate) threshold: f32,
}

/// The instance that keeps to a budget.
struct Found {
    instance: PatternInstance,
    /// What weighs no more need not be there.
    threshold: f32,
    stop_reason: StopReason,
}

impl PatternsOfFile {
    /// Those that the file has, or else those of its collapses.
    ///
    /// # Errors
    /// Where a part of the file is unsound.
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

    /// Fragments.
    pub(crate) fn step_count(&self) -> usize {
        self.patterns.fragment_count()
    }

    /// The coarsest level that shows no error of more pixels than allowed, or the finest of no more than so many triangles.
    pub(crate) fn level_of_view(
        &self,
        view: &ViewArgs,
        camera: Camera,
        triangle_limit: Option<usize>,
    ) -> ViewLevel {
        // Fewer pixels than these are no smaller to a budget, so that weights stay numbers.
        let criterion = view.criterion(camera, if triangle_limit.is_some() { LEAST_PIXELS } else { 0.0 });
        // Even what is around the eye has to go where there are too many triangles.
        let weight = |scene: &PatternScene<'_>, step| criterion.weigh(&scene.part(step)).weight.min(f32::MAX);
        let (level, threshold) = self.level(weight, Budget { triangle_limit, threshold: 1.0 });
        let pixels = match triangle_limit {
            None => view.pixels(),
            Some(_) => f64::from(criterion.pixels()) * f64::from(threshold),
        };
        ViewLevel { pixels, ..level }
    }

    /// Full detail inside a box, and errors outside that are no larger than the budget's threshold.
    pub(crate) fn level_of_box(&self, corners: Corners, budget: Budget) -> ViewLevel {
        let Corners { min, max } = corners;
        let inside = DetailBox { min, max, error_outside: f32::INFINITY };
        let weight = |scene: &PatternScene<'_>, step| {
            let part = scene.part(step);
            if inside.weigh(&part).should_refine() { f32::INFINITY } else { part.error }
        };
        self.level(weight, budget).0
    }

    /// The coarsest level that has all fragments over a threshold, and the threshold.
    fn level(&self, weight: impl Fn(&PatternScene<'_>, u32) -> f32, budget: Budget) -> (ViewLevel, f32) {
        let started = Instant::now();
        let scene = PatternScene::new(&self.patterns, &self.mesh.positions);
        let steps = || 0..self.step_count() as u32;
        let Found { instance, threshold, stop_reason } = match budget.triangle_limit {
            // Not all fragments need to be asked.
            None => {
                let is_too_coarse = |overlap: Overlap| weight(&scene, overlap.upper) > budget.threshold;
                let mut instance = PatternInstance::base(&self.patterns);
                instance.adapt(&self.patterns, &is_too_coarse);
                Found { instance, threshold: budget.threshold, stop_reason: StopReason::TargetReached }
            }
            Some(limit) => {
                let weights: Vec<f32> = steps().map(|step| weight(&scene, step)).collect();
                self.within(&weights, limit, budget.threshold)
            }
        };
        let seek_secs = started.elapsed().as_secs_f64();
        let left_out = steps().filter(|&step| !instance.is_refined(step));
        let level = ViewLevel {
            mesh: self.shown(&instance),
            split_count: instance.split_count(),
            error: left_out.map(|step| scene.part(step).error).fold(0.0, f32::max),
            pixels: 0.0,
            stop_reason,
            seek_secs,
        };
        (level, threshold)
    }

    /// The level of the lowest threshold, but no lower than allowed, that has no more than so many triangles.
    fn within(&self, weights: &[f32], limit: usize, least: f32) -> Found {
        let mut thresholds: Vec<f32> =
            weights.iter().copied().filter(|&w| w > least && w.is_finite()).collect();
        thresholds.push(least);
        thresholds.sort_unstable_by(f32::total_cmp);
        thresholds.dedup();
        let mut instance = PatternInstance::base(&self.patterns);
        let mut go_to = |threshold: f32| {
            instance.adapt(&self.patterns, &|overlap: Overlap| weights[overlap.upper as usize] > threshold);
            instance.clone()
        };
        // A higher threshold wants less.
        let (mut low, mut high) = (0, thresholds.len() - 1);
        while low < high {
            let middle = (low + high) / 2;
            if go_to(thresholds[middle]).triangle_count() <= limit { high = middle } else { low = middle + 1 }
        }
        let found = go_to(thresholds[low]);
        let is_met = found.triangle_count() <= limit;
        let stop_reason = if is_met { StopReason::TargetReached } else { StopReason::BaseReached };
        Found { instance: found, threshold: thresholds[low], stop_reason }
    }

    fn shown(&self, instance: &PatternInstance) -> IndexedMesh {
        let mut mesh = self.mesh.clone();
        mesh.triangles.clear();
        for number in 0..mesh.groups.len().max(1) {
            let first = mesh.triangles.len();
            instance.group_triangles_into(number as u32, &mut mesh.triangles);
            if let Some(group) = mesh.groups.get_mut(number) {
                (group.first, group.count) = (first as u32, (mesh.triangles.len() - first) as u32);
            }
        }
        mesh.without_unused_vertices()
    }
}
