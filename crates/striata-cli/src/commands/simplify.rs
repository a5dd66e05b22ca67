//! `simplify`: one level of a mesh, or several, without a .striata file.

use std::time::Instant;

use serde::Serialize;
use striata::mesh::{DistanceOptions, IndexedMesh, surface_distance, weld};
use striata::simplify::{
    Placement, SequenceOptions, Simplified, SimplifyError, SimplifyOptions, StopReason, Target,
    simplify_with_progress,
};

use crate::args::{PlacementArg, SimplifyArgs};
use striata_command::args::OrderArg;
use striata_command::failure::Failure;
use striata_command::input::Input;
use striata_command::level::{
    Floor, FullMesh, LevelRow, Reached, Wanted, check_paths, check_strict, remark, shortfall,
    table_of_levels, wanted_levels,
};
use striata_command::output::{Bar, Output, format_count, format_duration, format_length};
use striata_command::save::{Drawn, LevelFiles, format_of, is_stdout, name_of};
use striata_command::sequence::{Limits, SequencePlan, SimplifiedSteps, StepKind, limit_in_units};

/// Samples of each surface for the way back.
const REVERSE_SAMPLES: usize = 100_000;

#[derive(Serialize)]
struct Report {
    #[serde(flatten)]
    level: LevelReport,
    error_is_guaranteed: bool,
    order: &'static str,
    simplify_secs: f64,
    secs: f64,
}

/// Of several levels.
#[derive(Serialize)]
struct LevelsReport {
    levels: Vec<LevelReport>,
    error_is_guaranteed: bool,
    order: &'static str,
    simplify_secs: f64,
    secs: f64,
}

#[derive(Serialize)]
struct LevelReport {
    /// As the user wrote it, if it is one of several.
    #[serde(skip_serializing_if = "Option::is_none")]
    level: Option<String>,
    path: String,
    vertex_count: usize,
    triangle_count: usize,
    error: f64,
    /// Where the error is guaranteed, which says nothing of the way back: the largest distance from the level to the original
    /// at many points; null where one of them has no surface.
    #[serde(skip_serializing_if = "Option::is_none")]
    reverse_error: Option<Option<f64>>,
    stop_reason: &'static str,
    /// Why the level is not what was asked for; null if it is.
    shortfall: Option<String>,
}

/// Reads, simplifies, writes, reports.
///
/// # Errors
/// Where any of it fails; nothing is written then.
pub(crate) fn run(args: &SimplifyArgs, output: &Output) -> Result<(), Failure> {
    let started = Instant::now();
    output.check_stdout_is_free(is_stdout(&args.output.output))?;
    for path in check_paths(&args.level, &args.levels, &args.output.output)? {
        format_of(&path, &args.output.format)?;
    }
    check_placement(args)?;
    let mut bar = output.bar();
    bar.phase("read");
    let input = Input::open(&args.input)?;
    let mesh = input.mesh(output)?;
    args.sequence.remark_on(&mesh, output);
    let in_file = |failure: Failure| failure.in_file(&input.name);
    let full = if args.level.has_share() || args.levels.has_share() {
        FullMesh::of(&mesh).map_err(|error| in_file(error.into()))?
    } else {
        FullMesh { diagonal: mesh.diagonal(), ..FullMesh::default() }
    };
    let wanted = wanted_levels(&args.level, &args.levels, full, &args.output.output)?;
    let limits = limits(args, &wanted, full.diagonal);
    let plan = args.sequence.plan_for(&mesh, limits, output)?;
    let simplify_started = Instant::now();
    let maker = Maker::new(args, &plan, &mesh, &mut bar).map_err(|error| in_file(error.into()))?;
    let kind = match args.placement {
        PlacementArg::Subset => StepKind::Single,
        PlacementArg::Optimal => StepKind::Optimal,
    };
    let floor = Floor::Simplified(args.sequence.what_forbids_more(kind));
    let mut files = LevelFiles::new(&args.output.format, args.levels.levels.is_some());
    let mut levels = Vec::new();
    let mut simplify_secs = simplify_started.elapsed().as_secs_f64();
    for wanted in &wanted {
        let level_started = Instant::now();
        let made = maker.level(wanted.target, &mut bar).map_err(|error| in_file(error.into()))?;
        simplify_secs += level_started.elapsed().as_secs_f64();
        let mut level = LevelReport::new(wanted, &made, &floor);
        check_strict(args.strict, wanted.name.as_deref(), level.shortfall.as_deref())?;
        bar.phase("write");
        files.save(&made.mesh, Drawn::Triangles, &wanted.path)?;
        if plan.guarantees_errors() {
            bar.phase("distance");
            level.reverse_error = Some(farthest_of_level(&mesh, &made.mesh));
        }
        levels.push(level);
    }
    files.commit()?;
    drop(bar);
    let (error_is_guaranteed, order) = (plan.guarantees_errors(), plan.order().as_str());
    let secs = started.elapsed().as_secs_f64();
    if args.levels.levels.is_some() {
        let report = LevelsReport { levels, error_is_guaranteed, order, simplify_secs, secs };
        return output.summary(&report, &report.to_text(mesh.triangle_count()));
    }
    let level = levels.pop().ok_or_else(|| Failure::internal("no level was given"))?;
    let report = Report { level, error_is_guaranteed, order, simplify_secs, secs };
    output.summary(&report, &report.to_text(mesh.triangle_count(), full.diagonal))
}

/// # Errors
/// Where vertices may lie anywhere, and something was asked for that is known of the input's vertices only.
fn check_placement(args: &SimplifyArgs) -> Result<(), Failure> {
    if args.placement == PlacementArg::Subset {
        return Ok(());
    }
    let weight = args.sequence.weights.given();
    let flags = [
        ("--order hausdorff", args.sequence.order == OrderArg::Hausdorff),
        ("--max-error", args.max_error.is_some()),
        ("--certify", args.sequence.certify),
        ("--cost", args.sequence.cost.is_some()),
        (weight.unwrap_or_default(), weight.is_some()),
        ("--pair-distance", args.sequence.pair_distance.is_some()),
    ];
    match flags.into_iter().find(|&(_, is_given)| is_given) {
        None => Ok(()),
        Some((flag, _)) => {
            Err(Failure::user(format!("{flag} takes vertices of the input, not optimal ones"))
                .with_hint(format!("leave --placement optimal out, or {flag}")))
        }
    }
}

/// How far any of the wanted levels needs the simplification to go.
fn limits(args: &SimplifyArgs, wanted: &[Wanted], diagonal: f64) -> Limits {
    let mut limits = Limits { max_error: limit_in_units(args.max_error, diagonal), ..Limits::default() };
    let triangles = wanted.iter().map(|wanted| match wanted.target {
        Some(Target::Triangles(count)) => count,
        _ => 0,
    });
    // Nothing beyond the coarsest target is needed.
    limits.base_triangle_count = triangles.min().unwrap_or(0);
    if let ([Wanted { target: Some(Target::Error(error)), .. }], OrderArg::Hausdorff) =
        (wanted, args.sequence.order)
    {
        // What would exceed the error is left, and what is left besides goes on.
        limits.max_error = Some(limits.max_error.map_or(*error, |limit| limit.min(*error)));
    }
    limits
}

/// Makes levels of a mesh.
enum Maker<'a> {
    /// The mesh has been simplified once, as far as any level needs.
    Sequenced(Box<SimplifiedSteps>),
    /// Vertices may lie anywhere: each level is a simplification of its own.
    Optimal(&'a IndexedMesh, SequenceOptions),
}

impl<'a> Maker<'a> {
    /// # Errors
    /// If the mesh's parts do not fit together or an option is out of range.
    fn new(
        args: &SimplifyArgs,
        plan: &SequencePlan,
        mesh: &'a IndexedMesh,
        bar: &mut Bar,
    ) -> Result<Self, SimplifyError> {
        match (args.placement, plan) {
            (PlacementArg::Optimal, SequencePlan::Quadric { options, .. }) => {
                // The target is the level's own.
                Ok(Self::Optimal(mesh, options.clone().with_base_triangle_count(0)))
            }
            _ => {
                let sequenced = plan.run(weld(mesh)?, &mut |progress| bar.show(progress))?;
                Ok(Self::Sequenced(Box::new(sequenced)))
            }
        }
    }

    /// One level; the coarsest if none is asked for.
    ///
    /// # Errors
    /// If an option is out of range.
    fn level(&self, target: Option<Target>, bar: &mut Bar) -> Result<Simplified, SimplifyError> {
        match self {
            Self::Sequenced(sequenced) => Ok(level_of(sequenced, target)),
            Self::Optimal(mesh, options) => {
                let options = SimplifyOptions::default()
                    .with_target(target.unwrap_or(Target::Detail(0.0)))
                    .with_placement(Placement::Optimal)
                    .with_sequence(options.clone());
                simplify_with_progress(mesh, &options, &mut |progress| bar.show(progress))
            }
        }
    }
}

/// One level of a sequence; the coarsest if none is asked for.
fn level_of(sequenced: &SimplifiedSteps, target: Option<Target>) -> Simplified {
    let SimplifiedSteps { steps, stop_reason: end_reason, .. } = sequenced;
    let (levels, end_reason) = (steps.levels(), *end_reason);
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
    Simplified { mesh: steps.level(split_count).without_unused_vertices(), error, stop_reason }
}

/// The largest distance from a level to the original, at many points; none where one of them has no surface.
fn farthest_of_level(original: &IndexedMesh, level: &IndexedMesh) -> Option<f64> {
    let options = DistanceOptions::default().with_sample_count(REVERSE_SAMPLES);
    let distance = surface_distance(original, level, &options);
    distance.ok().map(|distance| distance.b_to_a.max)
}

impl LevelReport {
    fn new(wanted: &Wanted, made: &Simplified, floor: &Floor) -> Self {
        let reached = Reached {
            vertex_count: made.mesh.vertex_count(),
            triangle_count: made.mesh.triangle_count(),
            stop_reason: made.stop_reason,
        };
        Self {
            level: wanted.name.clone(),
            path: name_of(&wanted.path),
            vertex_count: reached.vertex_count,
            triangle_count: reached.triangle_count,
            error: made.error,
            reverse_error: None,
            stop_reason: made.stop_reason.as_str(),
            shortfall: wanted.target.and_then(|target| shortfall(target, reached, floor)),
        }
    }
}

impl Report {
    fn to_text(&self, before: usize, diagonal: f64) -> String {
        let level = &self.level;
        let share = |error: f64| if diagonal > 0.0 { 100.0 * error / diagonal } else { 0.0 };
        let kind = if self.error_is_guaranteed { "guaranteed " } else { "" };
        let reverse = level.reverse_error.flatten().map_or_else(String::new, |error| {
            format!(", back {} (sampled, {:.4} %)", format_length(error), share(error))
        });
        let shortfall = level.shortfall.as_ref().map(|shortfall| format!("\n{}", remark(None, shortfall)));
        format!(
            "{} -> {} triangles, {kind}error {} ({:.4} % of the diagonal){reverse}, {}, {}{}",
            format_count(before),
            format_count(level.triangle_count),
            format_length(level.error),
            share(level.error),
            level.stop_reason.replace('_', " "),
            format_duration(self.secs),
            shortfall.unwrap_or_default()
        )
    }
}

impl LevelsReport {
    fn to_text(&self, before: usize) -> String {
        let rows: Vec<LevelRow<'_>> = self.levels.iter().map(LevelReport::row).collect();
        let kind = if self.error_is_guaranteed { "guaranteed" } else { "estimated" };
        let secs = format_duration(self.secs);
        format!("{}{} triangles in all, errors {kind}, {secs}", table_of_levels(&rows), format_count(before))
    }
}

impl LevelReport {
    fn row(&self) -> LevelRow<'_> {
        LevelRow {
            name: self.level.as_deref().unwrap_or_default(),
            triangle_count: self.triangle_count,
            vertex_count: self.vertex_count,
            error: self.error,
            path: &self.path,
            shortfall: self.shortfall.as_deref(),
        }
    }
}
