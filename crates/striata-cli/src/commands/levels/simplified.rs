//! A mesh that was simplified for its levels.

use std::path::Path;
use std::time::Instant;

use striata::levels::{FoundLevel, Levels, LevelsFacts, fan_level};
use striata::mesh::{Bounds, DistanceOptions, IndexedMesh, Steps, surface_distance};
use striata::model::Fans;
use striata::simplify::{Simplified, SimplifyError, StopReason, Target, fit_within};
use striata::view::ScreenError;

use super::super::placement::fitting_limit;
use super::LevelSource;
use super::report::LevelDetails;
use striata_command::failure::Failure;
use striata_command::level::CoarseningLimit;
use striata_command::output::Bar;
use striata_command::save::{LevelFiles, Primitives};
use striata_command::sequence::{SequencePlan, SimplifiedSteps};

/// Sample points on each surface for the distance from the level to the original.
const REVERSE_SAMPLES: usize = 100_000;

/// The mesh, its simplification, and how vertices of a level move.
pub(in crate::commands) struct SimplifiedMesh<'a> {
    pub mesh: &'a IndexedMesh,
    pub plan: &'a SequencePlan,
    pub made: SimplifiedSteps,
    /// Whether the vertices of levels move.
    pub is_fitted: bool,
    pub limit: CoarseningLimit,
    /// Name of the input, for messages.
    pub name: &'a str,
    /// Time spent on simplification so far.
    pub simplify_secs: f64,
    pub bar: Bar,
}

impl SimplifiedMesh<'_> {
    /// Returns the split count of a level, and how well it meets the target.
    fn resolve(&self, target: Target) -> (usize, StopReason) {
        let end_reason = self.made.stop_reason;
        match (target.resolve_in(self.made.steps.levels()), target) {
            // Simplification stopped because every further step would exceed the error: the target is
            // reached.
            ((at, StopReason::BaseReached), Target::Error(_)) if end_reason == StopReason::ErrorLimit => {
                (at, StopReason::TargetReached)
            }
            ((at, StopReason::BaseReached), _) => (at, end_reason),
            (resolved, _) => resolved,
        }
    }
}

fn level_at(steps: &Steps, split_count: usize, stop_reason: StopReason) -> Simplified {
    let error = f64::from(steps.levels().error_at(split_count));
    Simplified { mesh: steps.level(split_count).without_unused_vertices(), error, stop_reason }
}

impl Levels for SimplifiedMesh<'_> {
    type Shape = IndexedMesh;
    type Error = SimplifyError;

    fn facts(&self) -> LevelsFacts {
        LevelsFacts::of(self.mesh, self.made.steps.levels(), self.plan.guarantees_errors())
    }

    fn bounds(&mut self) -> Result<Option<Bounds>, SimplifyError> {
        Ok(self.mesh.bounds())
    }

    fn find(&mut self, target: Target) -> Result<FoundLevel<IndexedMesh>, SimplifyError> {
        let started = Instant::now();
        let (split_count, stop_reason) = self.resolve(target);
        let steps = &self.made.steps;
        let simplified = match self.plan {
            SequencePlan::Quadric { options, .. } if self.is_fitted => {
                let within = |limit| split_count.max(steps.levels().split_count_for_error(limit));
                let level_within = |limit| level_at(steps, within(limit), stop_reason);
                let report = &mut |progress| self.bar.show(progress);
                fit_within(self.mesh, level_within, options, fitting_limit(target), report)?
            }
            _ => level_at(steps, split_count, stop_reason),
        };
        self.simplify_secs += started.elapsed().as_secs_f64();
        let Simplified { mesh, error, stop_reason } = simplified;
        let (vertex_count, triangle_count) = (mesh.vertex_count(), mesh.triangle_count());
        let (error, relaxation) = (Some(error), 1.0);
        Ok(FoundLevel {
            shape: mesh,
            split_count,
            vertex_count,
            triangle_count,
            error,
            stop_reason,
            relaxation,
        })
    }

    fn find_for_view(
        &mut self,
        criterion: &ScreenError,
        triangle_limit: Option<usize>,
    ) -> Result<FoundLevel<IndexedMesh>, SimplifyError> {
        let steps = &self.made.steps;
        Ok(fan_level(&Fans::build(steps), steps, criterion, triangle_limit))
    }
}

impl LevelSource for SimplifiedMesh<'_> {
    type Source = Self;

    fn levels(&mut self) -> &mut Self {
        self
    }

    fn failure(&self, error: SimplifyError) -> Failure {
        Failure::from(error).in_file(self.name)
    }

    fn limit(&self) -> CoarseningLimit {
        self.limit.clone()
    }

    fn write(
        &mut self,
        found: &FoundLevel<IndexedMesh>,
        files: &mut LevelFiles<'_>,
        path: &Path,
    ) -> Result<(), Failure> {
        self.bar.phase("write");
        files.write(&found.shape, Primitives::Triangles, path)
    }

    fn describe(&mut self, found: &FoundLevel<IndexedMesh>, details: &mut LevelDetails) {
        (details.split_count, details.step_count) = (None, None);
        if self.plan.guarantees_errors() {
            self.bar.phase("distance");
            let options = DistanceOptions::default().with_sample_count(REVERSE_SAMPLES);
            let distance = surface_distance(self.mesh, &found.shape, &options);
            details.reverse_error = Some(distance.ok().map(|distance| distance.b_to_a.max));
        }
    }
}
