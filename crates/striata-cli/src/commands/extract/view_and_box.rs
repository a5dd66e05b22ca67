//! `extract --eye` and `--detail-box`: levels whose detail varies over the mesh.

use std::time::Instant;

use striata::file::StriataFile;
use striata::model::{Fans, ModelKind};

use super::fan_view::{ViewLevel, level_of_view};
use super::level_output::{bounds_of, diagonal_of, primitives_of, triangle_limit, view_output_path};
use super::patterns::{Budget, FilePatterns};
use super::report::Report;
use crate::args::ExtractArgs;
use crate::commands::build::{errors_are_guaranteed, model_of_name};
use striata_command::args::{AxisAlignedBox, Point};
use striata_command::failure::Failure;
use striata_command::input::Input;
use striata_command::output::Output;
use striata_command::save::write_mesh;

/// Extracts and writes the level for a view.
///
/// # Errors
/// If the camera is degenerate, the file is damaged, or the output cannot be written.
pub(super) fn run_view(
    args: &ExtractArgs,
    eye: Point,
    input: &Input,
    started: Instant,
    output: &Output,
) -> Result<(), Failure> {
    let file = input.striata()?;
    let center =
        bounds_of(&file, input)?.map_or([0.0; 3], |b| [0, 1, 2].map(|i| (b.min[i] + b.max[i]) / 2.0));
    let origin = file.origin().map_err(|error| input.damaged(&error))?;
    let view = args.view.relative_to(origin);
    let camera = view
        .camera(eye.relative_to(origin), center)
        .map_err(|error| Failure::user(error.to_string()).with_hint("change --eye, --look-at or --up"))?;
    if uses_patterns(args, &file)? {
        let model = FilePatterns::read(&file, input)?;
        let level = model.level_of_view(&view, camera, triangle_limit(args, &file));
        return report_patterns(args, (&model, level), input, started, output);
    }
    let damaged = |error| input.damaged(&error);
    let steps = file.steps().map_err(damaged)?;
    let stored = file.fans().transpose().map_err(damaged)?;
    let fans = if stored.is_some() { "stored" } else { "built" };
    let table = stored.unwrap_or_else(|| Fans::build(&steps));
    let limit = triangle_limit(args, &file);
    let level = level_of_view(&table, &steps, &view, camera, limit);
    let (pixels, primitives) = (level.pixels, primitives_of(args.form, &level.mesh, None)?);
    let report = Report::of_view_or_box(ModelKind::Fans, args, &level, limit, started)?;
    write_mesh(&level.mesh, primitives, &view_output_path(args)?, &args.output.format, output)?;
    let report = Report { fans: Some(fans), pixels: Some(pixels), ..report };
    output.summary(&report, &report.to_text(steps.levels().step_count()))
}

/// Whether a view uses patterns: because the user named them, or because the file has patterns but no fans.
///
/// # Errors
/// If the user named a model without views.
fn uses_patterns(args: &ExtractArgs, file: &StriataFile<'_>) -> Result<bool, Failure> {
    match args.model.as_deref().map(model_of_name).transpose()? {
        Some(ModelKind::Patterns) => Ok(true),
        Some(ModelKind::Fans) => Ok(false),
        Some(kind) => Err(Failure::user(format!("model {kind} does not support views"))
            .with_hint("use --model fans or --model patterns")),
        None => Ok(file.fans().is_none() && file.patterns().is_some()),
    }
}

/// Extracts and writes the level with full detail inside a box.
///
/// # Errors
/// If the user named a model other than patterns, the file is damaged, or the output cannot be written.
pub(super) fn run_box(
    args: &ExtractArgs,
    corners: AxisAlignedBox,
    input: &Input,
    started: Instant,
    output: &Output,
) -> Result<(), Failure> {
    if let Some(name) = args.model.as_deref().filter(|&name| name != ModelKind::Patterns.as_str()) {
        return Err(Failure::user(format!("model {name} does not support --detail-box"))
            .with_hint("remove --model, or use --model patterns"));
    }
    let file = input.striata()?;
    let diagonal = diagonal_of(&args.level, &file, input)?;
    let triangle_limit = triangle_limit(args, &file);
    // The weight of a fragment outside the box is its error. Without a limit, all of these fragments may be
    // left out.
    let threshold = match (args.level.error, triangle_limit) {
        (Some(error), _) => error.in_units(diagonal) as f32,
        (None, Some(_)) => 0.0,
        (None, None) => f32::MAX,
    };
    let model = FilePatterns::read(&file, input)?;
    let origin = file.origin().map_err(|error| input.damaged(&error))?;
    let level = model.level_of_box(corners.relative_to(origin), Budget { triangle_limit, threshold });
    report_patterns(args, (&model, level), input, started, output)
}

/// Writes the level that patterns give for a view or a box, and reports it.
///
/// # Errors
/// If the file is damaged or the output cannot be written.
fn report_patterns(
    args: &ExtractArgs,
    (model, level): (&FilePatterns, ViewLevel),
    input: &Input,
    started: Instant,
    output: &Output,
) -> Result<(), Failure> {
    let file = input.striata()?;
    let report =
        Report::of_view_or_box(ModelKind::Patterns, args, &level, triangle_limit(args, &file), started)?;
    write_mesh(
        &level.mesh,
        primitives_of(args.form, &level.mesh, None)?,
        &view_output_path(args)?,
        &args.output.format,
        output,
    )?;
    let is_guaranteed = errors_are_guaranteed(&file).map_err(|error| input.damaged(&error))?;
    let report = Report {
        patterns: Some(if model.are_stored { "stored" } else { "built" }),
        pixels: args.eye.eye.is_some().then_some(level.pixels),
        // Patterns built from collapses only have errors of levels, which do not bound view-dependent states.
        error_is_guaranteed: is_guaranteed && model.are_stored,
        ..report
    };
    output.summary(&report, &report.to_text(model.step_count()))
}
