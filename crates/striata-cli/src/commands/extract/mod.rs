//! `extract`: writes one or more levels of a .striata file as meshes.

mod fan_view;
mod from_paged;
mod from_stream;
mod level_output;
mod patterns;
mod report;
mod stream_level;
mod uniform_levels;
mod view_and_box;

pub(crate) use self::fan_view::{MIN_PIXELS, ViewLevel, level_of_view};
pub(crate) use self::patterns::FilePatterns;
pub(super) use self::stream_level::{
    INPUT_ENDED_TEXT, StreamStopReason, detail_to_splits, full_mesh, has_level, resolve, stream_of,
};

use std::time::Instant;

use striata::model::ModelKind;

use self::level_output::{diagonal_of, no_level, primitives_of};
use self::report::{ExtractedList, LevelMesh, Report, report_levels};
use self::uniform_levels::{ExtractedLevel, Model, each_level, each_level_of_strips, read_model};
use self::view_and_box::{run_box, run_view};
use super::paged::is_paged_file;
use super::scene::{self, check_outputs};
use crate::args::{ExtractArgs, TriangleForm};
use crate::commands::build::errors_are_guaranteed;
use crate::strip_lists::{check_form_fits, without_unused_vertices};
use striata_command::failure::Failure;
use striata_command::input::Input;
use striata_command::level::{FullMesh, LevelRequest, check_paths, level_requests};
use striata_command::output::Output;
use striata_command::save::{LevelFiles, format_of, is_stdout};

/// Opens the file, extracts the requested levels, writes them, and reports.
///
/// # Errors
/// If any of this fails.
pub(crate) fn run(args: &ExtractArgs, output: &Output) -> Result<(), Failure> {
    let started = Instant::now();
    output.check_stdout_is_free(is_stdout(&args.output.output))?;
    check_outputs(&args.level, &args.levels, &args.output.output, &args.output.format)?;
    check_form(args)?;
    if is_paged_file(&args.input) {
        return from_paged::run(args, started, output);
    }
    let input = Input::open(&args.input)?;
    if args.view.is_given() && args.eye.eye.is_none() {
        return Err(Failure::user("flags of a view were given without --eye")
            .with_hint("use --eye instead of the other level, or remove these flags"));
    }
    if input.scene_kind().is_some() || args.levels.lod_chain {
        return scene::extract(args, &input, started, output);
    }
    if let Some(flag) = args.textures.first_given_flag() {
        return Err(Failure::user(format!("{flag}: {} is not a scene", input.name))
            .with_hint(format!("remove {flag}, or re-encode textures with `striata build` or `convert`")));
    }
    let file = input.striata()?;
    // Damage that the report would find must be known before an output gets its name.
    let error_is_guaranteed = errors_are_guaranteed(&file).map_err(|error| input.damaged(&error))?;
    let is_named = args.model.as_deref() == Some(ModelKind::Progressive.as_str());
    let is_view_or_box = args.eye.eye.is_some() || args.detail_box.is_some();
    if !is_view_or_box && !args.view.is_given() && (is_named || args.model.is_none() && file.is_stream_only())
    {
        return from_stream::run(args, (&file, &input), (started, error_is_guaranteed), output);
    }
    input.remark_on(&file, output)?;
    if let Some(eye) = args.eye.eye {
        return run_view(args, eye, &input, started, output);
    }
    if let Some(corners) = args.detail_box {
        return run_box(args, corners, &input, started, output);
    }
    let levels = file.levels().map_err(|error| input.damaged(&error))?;
    let full = FullMesh::of_levels(&levels, diagonal_of(&args.level, &file, &input)?);
    let requests = level_requests(&args.level, &args.levels, full, &args.output.output)?;
    let resolve = |request: &LevelRequest| -> Result<_, Failure> {
        Ok(request.target.ok_or_else(no_level)?.resolve_in(&levels))
    };
    let resolved = requests.iter().map(resolve).collect::<Result<Vec<_>, _>>()?;
    let split_counts: Vec<usize> = resolved.iter().map(|&(split_count, _)| split_count).collect();
    let mut files = LevelFiles::new(&args.output.format, args.levels.levels.is_some(), output);
    let mut reports: Vec<Option<Report>> = requests.iter().map(|_| None).collect();
    let mut sink = |index: usize, extracted: ExtractedLevel| -> Result<(), Failure> {
        let ExtractedLevel { model, mesh, strips, seek_secs } = extracted;
        let (mesh, strips) = without_unused_vertices(mesh, strips);
        let (request, (split_count, stop_reason)) = (&requests[index], resolved[index]);
        let shown = LevelMesh { mesh: &mesh, split_count, stop_reason };
        let report = Report::of_level(model, request, shown, [seek_secs, seconds(started)])
            .with_error(levels.error_at(split_count));
        let report = Report { error_is_guaranteed, ..report };
        report.written.check_strict(args.strict)?;
        files.write(&mesh, primitives_of(args.form, &mesh, strips)?, &request.path)?;
        reports[index] = Some(report);
        Ok(())
    };
    let (origin, split_counts) = ((&file, &input), &split_counts[..]);
    match read_model(&file, args.model.as_deref(), &input)? {
        Model::LodStrips(model) => {
            each_level_of_strips(ModelKind::LodStrips, &model, split_counts, origin, &mut sink)
        }
        Model::Mts(model) => each_level_of_strips(ModelKind::Mts, &model, split_counts, origin, &mut sink),
        Model::Fans(model) => {
            each_level(ModelKind::Fans, &model, split_counts, (origin, &|_| None), &mut sink)
        }
        Model::Patterns(model) => {
            each_level(ModelKind::Patterns, &model, split_counts, (origin, &|_| None), &mut sink)
        }
    }?;
    files.commit()?;
    let common = ExtractedList { step_count: levels.step_count(), secs: seconds(started) };
    report_levels(reports.into_iter().flatten().collect(), args.levels.levels.is_some(), common, output)
}

fn seconds(started: Instant) -> f64 {
    started.elapsed().as_secs_f64()
}

/// Checks that the output format supports the requested primitives.
///
/// # Errors
/// If the format of an output does not support the form.
fn check_form(args: &ExtractArgs) -> Result<(), Failure> {
    for path in check_paths(&args.level, &args.levels, &args.output.output)? {
        let format = format_of(&path, &args.output.format)?;
        match args.form {
            TriangleForm::List => {}
            TriangleForm::Strips => check_form_fits("strips", &path, format, "use --as list")?,
            TriangleForm::Fans => check_form_fits("fans", &path, format, "use --as list")?,
        }
    }
    Ok(())
}
