//! `simplify`: simplifies a mesh to one or more levels, without a .striata file.

use std::time::Instant;

use striata::mesh::weld;
use striata::simplify::Target;

use super::levels::{
    HowMade, LevelJob, ScenePlacement, SceneSource, SimplifiedMesh, check_outputs, full_of, simplified_text,
    write_levels,
};
use super::paged::open_input;
use super::placement::{ChosenPlacement, placement_name};
use crate::args::SimplifyArgs;
use striata_command::failure::Failure;
use striata_command::input::Input;
use striata_command::level::{CoarseningLimit, FullMesh, LevelRequest, level_requests};
use striata_command::output::Output;
use striata_command::save::{georeference_of, is_stdout};
use striata_command::scene::{ReceivedScene, build_scene, edited, flat_scene, with_mesh_textures};
use striata_command::sequence::{Limits, StepKind, limit_in_units};

/// Reads and simplifies the mesh, writes the levels, and reports.
///
/// # Errors
/// If any of this fails; nothing is written then.
pub(crate) fn run(args: &SimplifyArgs, output: &Output) -> Result<(), Failure> {
    let started = Instant::now();
    output.check_stdout_is_free(is_stdout(args.output.path()))?;
    check_outputs(&args.level, &args.levels, &args.output)?;
    let placement = ChosenPlacement::of(args)?;
    let mut bar = output.bar();
    bar.phase("read");
    let input = open_input(&args.input, usize::MAX)?.with_raster(args.raster)?;
    if (input.scene_kind().is_some() && !args.scene.flat) || args.levels.lod_chain {
        drop(bar);
        return simplify_scene(args, placement, &input, started, output);
    }
    let mesh = with_mesh_textures(input.mesh(output)?, args.textures.options().as_ref(), output)?;
    args.sequence.warn_about_groups(&mesh, output);
    let in_file = |failure: Failure| failure.in_file(&input.name);
    let full = if args.level.has_share() || args.levels.has_share() {
        FullMesh::of(&mesh).map_err(|error| in_file(error.into()))?
    } else {
        FullMesh { diagonal: mesh.diagonal(), ..FullMesh::default() }
    };
    let requests = level_requests(&args.level, &args.levels, full, args.output.path())?;
    let limits = limits(args, &requests, full.diagonal);
    let plan = args.sequence.plan_for(&mesh, limits)?;
    let simplifying = Instant::now();
    let welded = weld(&mesh).map_err(|error| in_file(error.into()))?;
    let made = plan.run(welded, &mut |progress| bar.show(progress)).map_err(|error| in_file(error.into()))?;
    args.sequence.warn_about_flat_folds(&made.steps, output);
    let is_fitted = placement.moves(&mesh);
    let mut source = SimplifiedMesh {
        mesh: &mesh,
        plan: &plan,
        made,
        is_fitted,
        limit: CoarseningLimit::Simplification(args.sequence.describe_limit(StepKind::Single)),
        name: &input.name,
        simplify_secs: simplifying.elapsed().as_secs_f64(),
        bar,
    };
    let report = write_levels(&mut source, &job(args, requests, started), output)?;
    let how = HowMade {
        order: Some(plan.order().as_str()),
        placement: Some(placement_name(is_fitted)),
        georeference: georeference_of(&mesh),
        simplify_secs: Some(source.simplify_secs),
    };
    drop(source);
    let report = report.with_how(how);
    output.summary(&report, &simplified_text(&report, mesh.triangle_count(), Some(full.diagonal)))
}

fn job(args: &SimplifyArgs, requests: Vec<LevelRequest>, started: Instant) -> LevelJob<'_> {
    LevelJob {
        requests,
        is_list: args.levels.levels.is_some(),
        // As far as possible.
        default_target: Target::Detail(-1.0),
        is_strict: args.strict,
        format: &args.output.format,
        max_error: args.max_error,
        started,
    }
}

/// Simplifies a scene, writes its levels, and reports.
///
/// # Errors
/// If any of this fails; nothing is written then.
fn simplify_scene(
    args: &SimplifyArgs,
    chosen: ChosenPlacement,
    input: &Input,
    started: Instant,
    output: &Output,
) -> Result<(), Failure> {
    let mut bar = output.bar();
    bar.phase("read");
    let is_mesh = args.scene.flat || input.scene_kind().is_none();
    let scene = if is_mesh { flat_scene(input, &input.name, output)? } else { input.scene(output)? };
    let scene = edited(scene, &args.edits, true, output)?;
    let limits = Limits { max_error: limit_in_units(args.max_error, scene.diagonal()), ..Limits::default() };
    let lods = build_scene(input, &scene, &args.sequence, limits, &mut |progress| bar.show(progress))?;
    let options = args.sequence.scene_options(&scene, false)?.sequence;
    drop(bar);
    let limit = CoarseningLimit::Simplification(args.sequence.describe_limit(StepKind::Single));
    let placement = (chosen != ChosenPlacement::Subset).then_some(ScenePlacement { chosen, options });
    let is_placed = placement.is_some();
    let textures = args.textures.options();
    let source = SceneSource::new(ReceivedScene::complete(lods), textures.as_ref(), output)?;
    let mut source = source.simplified(limit, args.max_error.is_some(), placement);
    if args.levels.lod_chain {
        source = source.in_one_file(args.output.path(), &args.output.format);
    }
    let full = full_of(&mut source, &args.level)?;
    let requests = level_requests(&args.level, &args.levels, full, args.output.path())?;
    let report = write_levels(&mut source, &job(args, requests, started), output)?;
    let placement = is_placed.then(|| placement_name(source.is_fitted()));
    let report = report.with_how(HowMade { placement, ..HowMade::default() });
    output.summary(&report, &simplified_text(&report, full.triangle_count, None))
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
