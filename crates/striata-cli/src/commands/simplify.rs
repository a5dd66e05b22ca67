//! `simplify`: simplifies a mesh to one or more levels, without a .striata file.

use std::time::Instant;

use striata::mesh::{DistanceOptions, IndexedMesh, surface_distance, weld};
use striata::simplify::{Simplified, StopReason, Target, fit_within};

use super::levels_report::{HowMade, MadeLevel, MadeLevels, text_of};
use super::placement::{ChosenPlacement, fitting_limit, placement_name};
use super::scene::{self, check_outputs};
use crate::args::SimplifyArgs;
use striata_command::failure::Failure;
use striata_command::input::Input;
use striata_command::level::{
    CoarseningLimit, FullMesh, LevelRequest, ReachedLevel, WrittenLevel, level_requests,
};
use striata_command::output::Output;
use striata_command::save::{LevelFiles, Primitives, georeference_of, is_stdout};
use striata_command::scene::with_mesh_textures;
use striata_command::sequence::{Limits, SequencePlan, SimplifiedSteps, StepKind, limit_in_units};

/// Sample points on each surface for the distance from the level to the original.
const REVERSE_SAMPLES: usize = 100_000;

/// Reads and simplifies the mesh, writes the levels, and reports.
///
/// # Errors
/// If any of this fails; nothing is written then.
pub(crate) fn run(args: &SimplifyArgs, output: &Output) -> Result<(), Failure> {
    let started = Instant::now();
    output.check_stdout_is_free(is_stdout(&args.output.output))?;
    check_outputs(&args.level, &args.levels, &args.output.output, &args.output.format)?;
    let placement = ChosenPlacement::of(args)?;
    let mut bar = output.bar();
    bar.phase("read");
    let input = Input::open(&args.input)?;
    if (input.scene_kind().is_some() && !args.scene.flat) || args.levels.lod_chain {
        drop(bar);
        return scene::simplify(args, placement, &input, started, output);
    }
    let mesh = with_mesh_textures(input.mesh(output)?, args.textures.options().as_ref(), output)?;
    args.sequence.warn_about_groups(&mesh, output);
    let in_file = |failure: Failure| failure.in_file(&input.name);
    let full = if args.level.has_share() || args.levels.has_share() {
        FullMesh::of(&mesh).map_err(|error| in_file(error.into()))?
    } else {
        FullMesh { diagonal: mesh.diagonal(), ..FullMesh::default() }
    };
    let requests = level_requests(&args.level, &args.levels, full, &args.output.output)?;
    let limits = limits(args, &requests, full.diagonal);
    let plan = args.sequence.plan_for(&mesh, limits)?;
    let simplify_started = Instant::now();
    let welded = weld(&mesh).map_err(|error| in_file(error.into()))?;
    let made = plan.run(welded, &mut |progress| bar.show(progress)).map_err(|error| in_file(error.into()))?;
    let is_fitted = placement.moves(&mesh);
    let coarsening_limit = CoarseningLimit::Simplification(args.sequence.describe_limit(StepKind::Single));
    let mut files = LevelFiles::new(&args.output.format, args.levels.levels.is_some(), output);
    let mut levels = Vec::new();
    let mut simplify_secs = simplify_started.elapsed().as_secs_f64();
    for request in &requests {
        let level_started = Instant::now();
        let (split_count, stop_reason) = resolve(&made, request.target);
        let simplified = match &plan {
            SequencePlan::Quadric { options, .. } if is_fitted => {
                let within = |limit| split_count.max(made.steps.levels().split_count_for_error(limit));
                let level_within = |limit| level_at(&made, within(limit), stop_reason);
                let report = &mut |progress| bar.show(progress);
                fit_within(&mesh, level_within, options, fitting_limit(request), report)
                    .map_err(|error| in_file(error.into()))?
            }
            _ => level_at(&made, split_count, stop_reason),
        };
        simplify_secs += level_started.elapsed().as_secs_f64();
        let mut level = made_level(request, &simplified, &coarsening_limit);
        level.written.check_strict(args.strict)?;
        bar.phase("write");
        files.write(&simplified.mesh, Primitives::Triangles, &request.path)?;
        if plan.guarantees_errors() {
            bar.phase("distance");
            level.reverse_error = Some(reverse_distance(&mesh, &simplified.mesh));
        }
        levels.push(level);
    }
    files.commit()?;
    drop(bar);
    let how = HowMade {
        error_is_guaranteed: plan.guarantees_errors(),
        order: Some(plan.order().as_str()),
        placement: Some(placement_name(is_fitted)),
        georeference: georeference_of(&mesh),
        simplify_secs: Some(simplify_secs),
        secs: started.elapsed().as_secs_f64(),
    };
    let report = MadeLevels::new(levels, args.levels.levels.is_some(), how)?;
    output.summary(&report, &text_of(&report, mesh.triangle_count(), Some(full.diagonal)))
}

/// Returns what is reported of a level.
fn made_level(request: &LevelRequest, simplified: &Simplified, limit: &CoarseningLimit) -> MadeLevel {
    let reached = ReachedLevel {
        vertex_count: simplified.mesh.vertex_count(),
        triangle_count: simplified.mesh.triangle_count(),
        stop_reason: simplified.stop_reason,
    };
    WrittenLevel { error: Some(simplified.error), ..WrittenLevel::new(request, reached, limit) }.into()
}

/// Returns how far the mesh must be simplified for the requested levels.
fn limits(args: &SimplifyArgs, requests: &[LevelRequest], diagonal: f64) -> Limits {
    let mut limits = Limits { max_error: limit_in_units(args.max_error, diagonal), ..Limits::default() };
    let triangles = requests.iter().map(|request| match request.target {
        Some(Target::Triangles(count)) => count,
        _ => 0,
    });
    // No level coarser than the coarsest target is needed.
    limits.base_triangle_count = triangles.min().unwrap_or(0);
    if let [LevelRequest { target: Some(Target::Error(error)), .. }] = requests
        && args.sequence.order.of_removals().is_some()
    {
        // With the error as a limit, the Hausdorff order skips vertices that would exceed it and continues
        // with others.
        limits.max_error = Some(limits.max_error.map_or(*error, |limit| limit.min(*error)));
    }
    limits
}

/// Returns the split count of a level, the coarsest one if there is no target, and how well it meets the target.
fn resolve(sequenced: &SimplifiedSteps, target: Option<Target>) -> (usize, StopReason) {
    let SimplifiedSteps { steps, stop_reason: end_reason, .. } = sequenced;
    let (levels, end_reason) = (steps.levels(), *end_reason);
    match target {
        None => (0, end_reason),
        Some(target) => match (target.resolve_in(levels), target) {
            // Simplification stopped because every further step would exceed the error: the target is
            // reached.
            ((at, StopReason::BaseReached), Target::Error(_)) if end_reason == StopReason::ErrorLimit => {
                (at, StopReason::TargetReached)
            }
            ((at, StopReason::BaseReached), _) => (at, end_reason),
            (resolved, _) => resolved,
        },
    }
}

/// Returns a level of a sequence.
fn level_at(sequenced: &SimplifiedSteps, split_count: usize, stop_reason: StopReason) -> Simplified {
    let steps = &sequenced.steps;
    let error = f64::from(steps.levels().error_at(split_count));
    Simplified { mesh: steps.level(split_count).without_unused_vertices(), error, stop_reason }
}

/// Returns the largest sampled distance from a level to the original; `None` if one of them has no surface.
fn reverse_distance(original: &IndexedMesh, level: &IndexedMesh) -> Option<f64> {
    let options = DistanceOptions::default().with_sample_count(REVERSE_SAMPLES);
    let distance = surface_distance(original, level, &options);
    distance.ok().map(|distance| distance.b_to_a.max)
}
