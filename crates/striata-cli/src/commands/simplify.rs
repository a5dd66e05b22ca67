//! `simplify`: one level of a mesh, without a .striata file.

use std::time::Instant;

use serde::Serialize;
use striata::mesh::{DistanceOptions, IndexedMesh, surface_distance, weld};
use striata::simplify::{
    Placement, Simplified, SimplifyError, SimplifyOptions, StopReason, Target, simplify,
};

use crate::args::{OrderArg, PlacementArg, SimplifyArgs};
use crate::failure::Failure;
use crate::input::Input;
use crate::output::{Bar, Output, grouped, lasted, measured};
use crate::save::{Drawn, format_of, is_stdout, save};
use crate::sequence::{Limits, Promise, SequencePlan, Sequenced, limit_in_units};

/// Samples of each surface for the way back.
const REVERSE_SAMPLES: usize = 100_000;

#[derive(Serialize)]
struct Report {
    vertex_count: usize,
    triangle_count: usize,
    error: f64,
    error_is_guaranteed: bool,
    /// Where the error is guaranteed, which says nothing of the way back: the largest distance from the level to the original
    /// at many points; null where one of them has no surface.
    #[serde(skip_serializing_if = "Option::is_none")]
    reverse_error: Option<Option<f64>>,
    order: &'static str,
    stop_reason: &'static str,
    simplify_secs: f64,
    secs: f64,
}

/// Reads, simplifies, writes, reports.
///
/// # Errors
/// Where any of it fails.
pub(crate) fn run(args: &SimplifyArgs, output: &Output) -> Result<(), Failure> {
    let started = Instant::now();
    output.check_stdout_is_free(is_stdout(&args.output.output))?;
    format_of(&args.output.output, &args.output.format)?;
    check_placement(args)?;
    let mut bar = output.bar();
    bar.phase("read");
    let input = Input::open(&args.input)?;
    let mesh = input.mesh(output)?;
    let diagonal = mesh.diagonal();
    let target = args.level.target_if_given(diagonal)?;
    let plan = plan(args, target, diagonal)?;
    let simplify_started = Instant::now();
    let made = match &plan {
        SequencePlan::Quadric { options, promise: Promise::Estimates, .. } => {
            let target = target.ok_or_else(|| Failure::internal("no level was given"))?;
            let options = SimplifyOptions::default()
                .with_target(target)
                .with_placement(args.placement.into())
                .with_sequence(options.clone());
            simplify(&mesh, &options, &mut |progress| bar.show(progress))
        }
        plan => simplify_surely(&mesh, plan, target, &mut bar),
    };
    let simplified = made.map_err(|error| Failure::from(error).in_file(&input.name))?;
    let simplify_secs = simplify_started.elapsed().as_secs_f64();
    bar.phase("write");
    save(&simplified.mesh, Drawn::Triangles, &args.output.output, &args.output.format)?;
    let error_is_guaranteed = plan.guarantees_errors();
    bar.phase("distance");
    let reverse_error = error_is_guaranteed.then(|| farthest_of_level(&mesh, &simplified.mesh));
    drop(bar);
    let report = Report {
        vertex_count: simplified.mesh.vertex_count(),
        triangle_count: simplified.mesh.triangle_count(),
        error: simplified.error,
        error_is_guaranteed,
        reverse_error,
        order: plan.order().as_str(),
        stop_reason: simplified.stop_reason.as_str(),
        simplify_secs,
        secs: started.elapsed().as_secs_f64(),
    };
    output.summary(&report, &report.to_text(mesh.triangle_count(), diagonal))
}

/// # Errors
/// Where vertices may lie anywhere, and something was asked for that is known of the input's vertices only.
fn check_placement(args: &SimplifyArgs) -> Result<(), Failure> {
    if args.placement == PlacementArg::Subset {
        return Ok(());
    }
    let flags = [
        ("--order hausdorff", args.sequence.order == OrderArg::Hausdorff),
        ("--max-error", args.max_error.is_some()),
        ("--certify", args.sequence.certify),
    ];
    match flags.into_iter().find(|&(_, is_given)| is_given) {
        None => Ok(()),
        Some((flag, _)) => {
            Err(Failure::user(format!("{flag} takes vertices of the input, not optimal ones"))
                .with_hint(format!("leave --placement optimal out, or {flag}")))
        }
    }
}

fn plan(args: &SimplifyArgs, target: Option<Target>, diagonal: f64) -> Result<SequencePlan, Failure> {
    let mut limits = Limits { max_error: limit_in_units(args.max_error, diagonal), ..Limits::default() };
    match target {
        // Nothing beyond the target is needed.
        Some(Target::Triangles(count)) => limits.base_triangle_count = count,
        // What would exceed the error is left, and what is left besides goes on.
        Some(Target::Error(error)) if args.sequence.order == OrderArg::Hausdorff => {
            limits.max_error = Some(limits.max_error.map_or(error, |limit| limit.min(error)));
        }
        _ => {}
    }
    args.sequence.plan(diagonal, limits)
}

/// One level whose error is guaranteed; the coarsest where none is asked for.
fn simplify_surely(
    mesh: &IndexedMesh,
    plan: &SequencePlan,
    target: Option<Target>,
    bar: &mut Bar,
) -> Result<Simplified, SimplifyError> {
    let sequenced = plan.run(weld(mesh)?, &mut |progress| bar.show(progress))?;
    let Sequenced { steps, stop_reason: end_reason, .. } = sequenced;
    let levels = steps.levels();
    let (split_count, stop_reason) = match target {
        None => (0, end_reason),
        Some(target) => match (target.resolve_in(levels), target) {
            // That no vertex could go any more without exceeding it is what the target asks for.
            ((at, StopReason::BaseReached), Target::Error(_)) if end_reason == StopReason::ErrorLimit => {
                (at, StopReason::TargetReached)
            }
            ((at, StopReason::BaseReached), _) => (at, end_reason),
            (resolved, _) => resolved,
        },
    };
    let error = f64::from(levels.error_at(split_count));
    Ok(Simplified { mesh: steps.level(split_count).without_unused_vertices(), error, stop_reason })
}

/// The largest distance from a level to the original, at many points; none where one of them has no surface.
fn farthest_of_level(original: &IndexedMesh, level: &IndexedMesh) -> Option<f64> {
    let options = DistanceOptions::default().with_sample_count(REVERSE_SAMPLES);
    let distance = surface_distance(original, level, &options);
    distance.ok().map(|distance| distance.b_to_a.max)
}

impl Report {
    fn to_text(&self, before: usize, diagonal: f64) -> String {
        let share = |error: f64| if diagonal > 0.0 { 100.0 * error / diagonal } else { 0.0 };
        let kind = if self.error_is_guaranteed { "guaranteed " } else { "" };
        let reverse = self.reverse_error.flatten().map_or_else(String::new, |error| {
            format!(", back {} (sampled, {:.4} %)", measured(error), share(error))
        });
        format!(
            "{} -> {} triangles, {kind}error {} ({:.4} % of the diagonal){reverse}, {}, {}",
            grouped(before),
            grouped(self.triangle_count),
            measured(self.error),
            share(self.error),
            self.stop_reason.replace('_', " "),
            lasted(self.secs)
        )
    }
}

impl From<PlacementArg> for Placement {
    fn from(placement: PlacementArg) -> Self {
        match placement {
            PlacementArg::Subset => Self::Subset,
            PlacementArg::Optimal => Self::Optimal,
        }
    }
}
