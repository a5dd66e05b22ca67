//! `simplify`: simplifies a mesh to one or more levels, without a .striata file.

use std::time::Instant;

use serde::Serialize;
use serde_json::Value;
use striata::mesh::{DistanceOptions, IndexedMesh, surface_distance, weld};
use striata::simplify::{Placement, Simplified, StopReason, Target, fit_within};

use super::scene::{self, check_outputs};
use crate::args::{PlacementArg, SimplifyArgs};
use striata_command::args::OrderArg;
use striata_command::failure::Failure;
use striata_command::input::Input;
use striata_command::level::{
    CoarseningLimit, FullMesh, LevelRequest, LevelRow, ReachedLevel, check_strict, level_requests, shortfall,
    shortfall_note, table_of_levels,
};
use striata_command::output::{Output, format_count, format_duration, format_length};
use striata_command::save::{LevelFiles, Primitives, display_name, georeference_of, is_stdout};
use striata_command::scene::with_mesh_textures;
use striata_command::sequence::{Limits, SequencePlan, SimplifiedSteps, StepKind, limit_in_units};

/// Sample points on each surface for the distance from the level to the original.
const REVERSE_SAMPLES: usize = 100_000;

#[derive(Serialize)]
struct Report {
    #[serde(flatten)]
    level: LevelReport,
    error_is_guaranteed: bool,
    order: &'static str,
    placement: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    georeference: Option<Value>,
    simplify_secs: f64,
    secs: f64,
}

/// Report on several levels.
#[derive(Serialize)]
struct LevelsReport {
    levels: Vec<LevelReport>,
    error_is_guaranteed: bool,
    order: &'static str,
    placement: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    georeference: Option<Value>,
    simplify_secs: f64,
    secs: f64,
}

#[derive(Serialize)]
struct LevelReport {
    /// The text that the user wrote for the level, if there are several.
    #[serde(skip_serializing_if = "Option::is_none")]
    level: Option<String>,
    path: String,
    vertex_count: usize,
    triangle_count: usize,
    error: f64,
    /// Largest sampled distance from the level to the original; null if one of them has no surface. Only
    /// reported if errors are guaranteed, since that guarantee covers only distances from the original to the
    /// level.
    #[serde(skip_serializing_if = "Option::is_none")]
    reverse_error: Option<Option<f64>>,
    stop_reason: &'static str,
    /// How the level misses its target; null if it does not.
    shortfall: Option<String>,
}

/// Reads and simplifies the mesh, writes the levels, and reports.
///
/// # Errors
/// If any of this fails; nothing is written then.
pub(crate) fn run(args: &SimplifyArgs, output: &Output) -> Result<(), Failure> {
    let started = Instant::now();
    output.check_stdout_is_free(is_stdout(&args.output.output))?;
    check_outputs(&args.level, &args.levels, (&args.output.output, &args.output.format))?;
    let placement = ChosenPlacement::of(args)?;
    let mut bar = output.bar();
    bar.phase("read");
    let input = Input::open(&args.input)?;
    if (input.scene_kind().is_some() && !args.scene.flat) || args.levels.lod_chain {
        drop(bar);
        return scene::simplify((args, placement), &input, started, output);
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
        let resolved = resolve(&made, request.target);
        let simplified = match &plan {
            SequencePlan::Quadric { options, .. } if is_fitted => {
                let split_count = |limit| resolved.0.max(made.steps.levels().split_count_for_error(limit));
                let level_within = |limit| level_at(&made, (split_count(limit), resolved.1));
                let report = &mut |progress| bar.show(progress);
                fit_within(&mesh, level_within, options, fitting_limit(request), report)
                    .map_err(|error| in_file(error.into()))?
            }
            _ => level_at(&made, resolved),
        };
        simplify_secs += level_started.elapsed().as_secs_f64();
        let mut level = LevelReport::new(request, &simplified, &coarsening_limit);
        check_strict(args.strict, request.name.as_deref(), level.shortfall.as_deref())?;
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
    let (error_is_guaranteed, order) = (plan.guarantees_errors(), plan.order().as_str());
    let placement = placement_name(is_fitted);
    let georeference = georeference_of(&mesh);
    let secs = started.elapsed().as_secs_f64();
    if args.levels.levels.is_some() {
        let report =
            LevelsReport { levels, error_is_guaranteed, order, placement, georeference, simplify_secs, secs };
        return output.summary(&report, &report.to_text(mesh.triangle_count()));
    }
    let level = levels.pop().ok_or_else(|| Failure::internal("no level was given"))?;
    let report = Report { level, error_is_guaranteed, order, placement, georeference, simplify_secs, secs };
    output.summary(&report, &report.to_text(mesh.triangle_count(), full.diagonal))
}

/// Which meshes get vertices that are not those of the input.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum ChosenPlacement {
    /// None.
    Subset,
    /// Those in which nothing refers to vertices: see [`Placement::for_one_level`].
    Suitable,
    /// All that can.
    Optimal,
}

impl ChosenPlacement {
    /// Returns what the user chose, or what suits the arguments.
    ///
    /// # Errors
    /// If there is a flag that does not work with `--placement optimal`.
    fn of(args: &SimplifyArgs) -> Result<Self, Failure> {
        let sequence = &args.sequence;
        let fixed = [
            ("--order", sequence.order != OrderArg::Quadric),
            ("--new-vertices", sequence.new_vertices.is_some()),
            ("--max-error", args.max_error.is_some()),
            ("--certify", sequence.certify),
            ("--lod-chain", args.levels.lod_chain),
        ];
        let fixed = fixed.into_iter().find(|&(_, is_given)| is_given);
        match (args.placement, fixed) {
            (Some(PlacementArg::Subset), _) => Ok(Self::Subset),
            (Some(PlacementArg::Optimal), Some((flag, _))) => {
                Err(Failure::user(format!("{flag} does not work with --placement optimal"))
                    .with_hint(format!("remove --placement optimal or {flag}")))
            }
            (Some(PlacementArg::Optimal), None) => Ok(Self::Optimal),
            (None, Some(_)) => Ok(Self::Subset),
            (None, None) => {
                let has_locks = sequence.lock_boundary || sequence.lock_groups || sequence.keep_height_field;
                let stays = has_locks || args.levels.levels.is_some();
                Ok(if stays { Self::Subset } else { Self::Suitable })
            }
        }
    }

    /// Whether the vertices of a mesh may move.
    pub(super) fn moves(self, mesh: &IndexedMesh) -> bool {
        match self {
            Self::Subset => false,
            Self::Suitable => Placement::for_one_level(mesh) == Placement::Optimal,
            Self::Optimal => true,
        }
    }
}

/// Name of the placement in reports.
pub(super) fn placement_name(is_optimal: bool) -> &'static str {
    if is_optimal { "optimal" } else { "subset" }
}

/// Note on the placement for a report in words; none for the vertices of the input.
pub(super) fn placement_note(placement: &str) -> &'static str {
    if placement == placement_name(true) { ", optimal placement" } else { "" }
}

/// Largest error that moved vertices may have.
pub(super) fn fitting_limit(request: &LevelRequest) -> f64 {
    match request.target {
        Some(Target::Error(error)) => error,
        _ => f64::INFINITY,
    }
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
fn level_at(sequenced: &SimplifiedSteps, (split_count, stop_reason): (usize, StopReason)) -> Simplified {
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

impl LevelReport {
    fn new(request: &LevelRequest, simplified: &Simplified, coarsening_limit: &CoarseningLimit) -> Self {
        let reached = ReachedLevel {
            vertex_count: simplified.mesh.vertex_count(),
            triangle_count: simplified.mesh.triangle_count(),
            stop_reason: simplified.stop_reason,
        };
        Self {
            level: request.name.clone(),
            path: display_name(&request.path),
            vertex_count: reached.vertex_count,
            triangle_count: reached.triangle_count,
            error: simplified.error,
            reverse_error: None,
            stop_reason: simplified.stop_reason.as_str(),
            shortfall: request.target.and_then(|target| shortfall(target, reached, coarsening_limit)),
        }
    }
}

impl Report {
    fn to_text(&self, before: usize, diagonal: f64) -> String {
        let level = &self.level;
        let share = |error: f64| if diagonal > 0.0 { 100.0 * error / diagonal } else { 0.0 };
        let kind = if self.error_is_guaranteed { "guaranteed " } else { "" };
        let reverse = level.reverse_error.flatten().map_or_else(String::new, |error| {
            format!(", reverse error {} (sampled, {:.4} %)", format_length(error), share(error))
        });
        let shortfall =
            level.shortfall.as_ref().map(|shortfall| format!("\n{}", shortfall_note(None, shortfall)));
        format!(
            "{} -> {} triangles, {kind}error {} ({:.4} % of the diagonal){reverse}{}, {}, {}{}",
            format_count(before),
            format_count(level.triangle_count),
            format_length(level.error),
            share(level.error),
            placement_note(self.placement),
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
        format!("{}from {} triangles, errors {kind}, {secs}", table_of_levels(&rows), format_count(before))
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
