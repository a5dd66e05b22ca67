//! `simplify`, `extract` and `decode` for scenes: levels of a whole scene.

use std::path::Path;
use std::time::Instant;

use striata::mesh::IndexedMesh;
use striata::simplify::{SequenceOptions, StopReason, Target};
use striata_command::args::{FormatArgs, LevelArgs, LevelsArgs};
use striata_command::failure::Failure;
use striata_command::input::Input;
use striata_command::level::{
    CoarseningLimit, LevelRequest, ReachedLevel, WrittenLevel, check_paths, level_requests,
};
use striata_command::output::{Output, format_noun_count};
use striata_command::save::{LevelFiles, display_name, folder_path, format_of, write_encoded};
use striata_command::scene::{
    ReceivedScene, build_scene, edited, flat_scene, full_scene_sizes, with_textures,
};
use striata_command::sequence::{Limits, StepKind, limit_in_units};
use striata_io::{Format, WriteOptions};
use striata_scene::textures::TextureOptions;
use striata_scene::{FittedMeshes, Fitting, LodChainOptions, LodScene, SceneLevel, lod_chain};

use super::super::extract::INPUT_ENDED_TEXT;
use super::super::levels_report::{HowMade, MadeLevels, text_of};
use super::super::placement::{ChosenPlacement, fitting_limit, placement_name};
use super::view::extract_view;
use crate::args::{DecodeArgs, ExtractArgs, SimplifyArgs, TriangleForm};

/// Outputs of levels, and how they are made and written.
struct Destination<'a> {
    level: &'a LevelArgs,
    levels: Option<&'a LevelsArgs>,
    output: &'a Path,
    format: &'a FormatArgs,
    textures: Option<TextureOptions>,
    is_strict: bool,
    /// Why no coarser level exists than the coarsest one.
    limit: CoarseningLimit,
    /// Whether the coarsest level is the last one within an error limit.
    has_error_limit: bool,
    placement: Option<ScenePlacement>,
}

/// Which meshes get vertices that are not those of the input.
struct ScenePlacement {
    chosen: ChosenPlacement,
    /// Constraints on vertices that move.
    options: SequenceOptions,
}

/// Simplifies a scene, writes its levels, and reports.
///
/// # Errors
/// If any of this fails; nothing is written then.
pub(in crate::commands) fn simplify(
    args: &SimplifyArgs,
    chosen: ChosenPlacement,
    input: &Input,
    started: Instant,
    output: &Output,
) -> Result<(), Failure> {
    let mut bar = output.bar();
    bar.phase("read");
    let scene = if args.scene.flat { flat_scene(input, output)? } else { input.scene(output)? };
    let scene = edited(scene, &args.edits, true, output)?;
    let limits = Limits { max_error: limit_in_units(args.max_error, scene.diagonal()), ..Limits::default() };
    let lods = build_scene(input, &scene, &args.sequence, limits, &mut |progress| bar.show(progress))?;
    let options = args.sequence.scene_options(&scene, false)?.sequence;
    drop(bar);
    let destination = Destination {
        level: &args.level,
        levels: Some(&args.levels),
        output: &args.output.output,
        format: &args.output.format,
        textures: args.textures.options(),
        is_strict: args.strict,
        limit: CoarseningLimit::Simplification(args.sequence.describe_limit(StepKind::Single)),
        has_error_limit: args.max_error.is_some(),
        placement: (chosen != ChosenPlacement::Subset).then_some(ScenePlacement { chosen, options }),
    };
    write_levels(&ReceivedScene::complete(lods), &destination, started, output)
}

/// Writes levels of a scene from a file, and reports.
///
/// # Errors
/// If any of this fails; nothing is written then.
pub(in crate::commands) fn extract(
    args: &ExtractArgs,
    input: &Input,
    started: Instant,
    output: &Output,
) -> Result<(), Failure> {
    let flags = [
        ("--model", args.model.is_some()),
        ("--as strips", args.form == TriangleForm::Strips),
        ("--as fans", args.form == TriangleForm::Fans),
        ("--detail-box", args.detail_box.is_some()),
    ];
    if let Some((flag, _)) = flags.into_iter().find(|&(_, is_given)| is_given) {
        return Err(Failure::user(format!("{flag} is for one mesh, but {} is a scene", input.name))
            .with_hint(format!("remove {flag}, or build a file of one mesh with `striata build --flat`")));
    }
    let received = input.received_scene(output)?;
    if args.eye.eye.is_some() {
        return extract_view(args, &received.lods, started, output);
    }
    let destination = Destination {
        level: &args.level,
        levels: Some(&args.levels),
        output: &args.output.output,
        format: &args.output.format,
        textures: args.textures.options(),
        is_strict: args.strict,
        limit: CoarseningLimit::File,
        has_error_limit: false,
        placement: None,
    };
    write_levels(&received, &destination, started, output)
}

/// Decodes the stream of a scene, or a level of it, and reports.
///
/// # Errors
/// If any of this fails.
pub(in crate::commands) fn decode(
    args: &DecodeArgs,
    input: &Input,
    started: Instant,
    output: &Output,
) -> Result<(), Failure> {
    let received = input.received_scene(output)?;
    let destination = Destination {
        level: &args.level.level,
        levels: None,
        output: &args.output.output,
        format: &args.output.format,
        textures: None,
        is_strict: false,
        limit: CoarseningLimit::File,
        has_error_limit: false,
        placement: None,
    };
    write_levels(&received, &destination, started, output)
}

/// Writes the requested levels, or the finest one if none is requested, and reports.
fn write_levels(
    received: &ReceivedScene,
    destination: &Destination<'_>,
    started: Instant,
    output: &Output,
) -> Result<(), Failure> {
    let one = LevelsArgs { levels: None, lod_chain: false };
    let several = destination.levels.unwrap_or(&one);
    let lods = &received.lods;
    let full = full_scene_sizes(received, destination.level.error.is_some());
    let requests = level_requests(destination.level, several, full, destination.output)?;
    let mut reports = Vec::new();
    let mut levels = Vec::new();
    let (mut meshes, mut is_fitted) = (Vec::new(), false);
    for request in &requests {
        let target = request.target.unwrap_or(match destination.limit {
            // Without a target, `simplify` goes as far as its limit, and `decode` gives everything.
            CoarseningLimit::Simplification(_) => Target::Detail(0.0),
            CoarseningLimit::File => Target::Detail(1.0),
        });
        let mut level = lods.level(target);
        level.error = level.error.max(received.error);
        let fitted = match &destination.placement {
            Some(placement) => Some(fitted_meshes(lods, &level, placement, fitting_limit(request), output)?),
            None => None,
        };
        if let Some(fitted) = &fitted {
            level = fitted.level.clone();
        }
        if destination.has_error_limit && level.stop_reason == StopReason::BaseReached {
            level.stop_reason = StopReason::ErrorLimit;
        }
        let mut report = written_level(request, &level, &destination.limit);
        if request.target.is_some_and(|target| ends_before(received, target)) {
            report.shortfall = Some(INPUT_ENDED_TEXT.to_owned());
        }
        report.check_strict(destination.is_strict)?;
        reports.push(report.into());
        levels.push(level);
        is_fitted |= fitted.as_ref().is_some_and(|fitted| fitted.fitted_count > 0);
        meshes.push(fitted.map(|fitted| fitted.meshes));
    }
    if full.triangle_count == 0 {
        output.say("note: the scene shows no triangles; points and lines stay as they are");
    }
    let mut bar = output.bar();
    bar.phase("write");
    if several.lod_chain {
        write_chain(lods, &levels, destination, output)?;
    } else {
        let mut files = LevelFiles::new(destination.format, several.levels.is_some(), output);
        // Images are the same in all levels, and re-encoded once.
        let mut scene = with_textures(lods.scene().clone(), destination.textures.as_ref(), output)?;
        for ((level, fitted), request) in levels.iter().zip(meshes).zip(&requests) {
            let changed = scene.with_meshes(fitted.unwrap_or_else(|| lods.level_meshes(level)));
            scene = changed.map_err(|error| Failure::internal(error.to_string()))?;
            files.write_scene(&scene, &request.path)?;
        }
        files.commit()?;
    }
    drop(bar);
    let placement = destination.placement.is_some().then(|| placement_name(is_fitted));
    let how = HowMade {
        error_is_guaranteed: lods.has_guaranteed_errors(),
        placement,
        secs: started.elapsed().as_secs_f64(),
        ..HowMade::default()
    };
    let report = MadeLevels::new(reports, several.levels.is_some(), how)?;
    output.summary(&report, &text_of(&report, full.triangle_count, None))
}

/// Returns what is reported of a level.
fn written_level(request: &LevelRequest, level: &SceneLevel, limit: &CoarseningLimit) -> WrittenLevel {
    let &SceneLevel { triangle_count, vertex_count, error, stop_reason, .. } = level;
    let reached = ReachedLevel { vertex_count, triangle_count, stop_reason };
    WrittenLevel { error: Some(error), ..WrittenLevel::new(request, reached, limit) }
}

/// Fits the meshes of a level, and says which meshes stay although the user wishes it.
fn fitted_meshes(
    lods: &LodScene,
    level: &SceneLevel,
    placement: &ScenePlacement,
    max_error: f64,
    output: &Output,
) -> Result<FittedMeshes, Failure> {
    let mut bar = output.bar();
    let selects = |mesh: &IndexedMesh| placement.chosen.moves(mesh);
    let fitting = Fitting { selects: &selects, options: &placement.options, max_error };
    let fitted = lods
        .fitted_meshes(level, &fitting, &mut |progress| bar.show(progress))
        .map_err(|error| Failure::user(error.to_string()))?;
    drop(bar);
    let stays = fitted.meshes.iter().flatten().count() - fitted.fitted_count;
    if placement.chosen == ChosenPlacement::Optimal && stays > 0 {
        let count = format_noun_count(stays, "mesh", "meshes");
        output.say(&format!("note: {count} with skins or morph targets: vertices of the input are kept"));
    }
    Ok(fitted)
}

/// Whether a stream that is cut off ends before the level for a target.
fn ends_before(received: &ReceivedScene, target: Target) -> bool {
    let levels = received.lods.levels();
    !received.is_complete
        && match target {
            Target::Triangles(n) => n > levels.triangle_count(),
            Target::Vertices(n) => n > levels.vertex_count(),
            Target::Error(error) => error < received.error,
            Target::SplitCount(n) => n > levels.step_count(),
            _ => false,
        }
}

/// Writes the full scene and all levels as one file, between which engines switch.
fn write_chain(
    lods: &LodScene,
    levels: &[SceneLevel],
    destination: &Destination<'_>,
    output: &Output,
) -> Result<(), Failure> {
    let format = chain_format(destination.output, destination.format)?;
    let frame = with_textures(lods.scene().clone(), destination.textures.as_ref(), output)?;
    let lods = LodScene::from_lods(frame, lods.lods().to_vec());
    let lods = lods.map_err(|error| Failure::internal(error.to_string()))?;
    let write = destination.format.gltf.applied_to(WriteOptions::default());
    let options = LodChainOptions::default().with_format(format).with_write_options(write);
    let encoded = lod_chain(&lods, levels, &options, folder_path(destination.output))?;
    write_encoded(&encoded, destination.output, output)
}

/// Returns the format of a file with several levels.
///
/// # Errors
/// If the format is not glTF.
fn chain_format(path: &Path, args: &FormatArgs) -> Result<Format, Failure> {
    match format_of(path, args)? {
        format @ (Format::Gltf | Format::Glb) => Ok(format),
        format => Err(Failure::user(format!(
            "--lod-chain is for glTF, but {} is written as {format}",
            display_name(path)
        ))
        .with_hint("use the extension .glb or .gltf")),
    }
}

/// Checks output names before the work begins.
///
/// # Errors
/// If a name or its format does not suit the levels.
pub(in crate::commands) fn check_outputs(
    level: &LevelArgs,
    levels: &LevelsArgs,
    output: &Path,
    format: &FormatArgs,
) -> Result<(), Failure> {
    if levels.lod_chain && levels.levels.is_none() {
        return Err(Failure::user("--lod-chain was given without --levels")
            .with_hint("name the coarser levels: --levels 50%,10% --lod-chain"));
    }
    if levels.lod_chain && output.to_string_lossy().contains("{}") {
        let message = format!("{}: --lod-chain writes all levels to one file", output.display());
        return Err(Failure::user(message).with_hint("remove {} from the name"));
    }
    for path in check_paths(level, levels, output)? {
        format_of(&path, format)?;
    }
    if levels.lod_chain {
        chain_format(output, format)?;
    }
    Ok(())
}
