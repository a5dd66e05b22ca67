//! `extract`: writes one or more levels of a file, a stream, pages or a scene.

use std::time::Instant;

use striata::model::ModelKind;
use striata::simplify::Target;

use super::levels::{
    FileSource, LevelJob, LevelSource, LevelsReport, PagedSource, SceneSource, StreamSource, VaryingJob,
    check_outputs, extracted_text, full_of, write_box, write_levels, write_view,
};
use super::paged::is_paged_file;
use crate::args::{ExtractArgs, TriangleForm};
use crate::strip_lists::check_form_fits;
use striata_command::failure::Failure;
use striata_command::input::Input;
use striata_command::level::{check_paths, level_requests};
use striata_command::output::Output;
use striata_command::save::{format_of, is_stdout};

/// Opens the input, writes the requested levels, and reports.
///
/// # Errors
/// If any of this fails.
pub(crate) fn run(args: &ExtractArgs, output: &Output) -> Result<(), Failure> {
    let started = Instant::now();
    output.check_stdout_is_free(is_stdout(args.output.path()))?;
    check_outputs(&args.level, &args.levels, &args.output)?;
    check_form(args)?;
    let report = if is_paged_file(&args.input) {
        if let Some(name) = &args.model {
            return Err(Failure::user(format!("--model {name}: paged files have no models"))
                .with_hint("remove --model; levels, views and boxes are made from the pages"));
        }
        extract(&mut PagedSource::open(&args.input, args.form, args.output.path())?, args, started, output)?
    } else {
        of_input(&Input::open(&args.input)?, args, started, output)?
    };
    output.summary(&report, &extracted_text(&report))
}

/// Extracts levels of a file, a stream or a scene.
fn of_input(
    input: &Input,
    args: &ExtractArgs,
    started: Instant,
    output: &Output,
) -> Result<LevelsReport, Failure> {
    if args.view.is_given() && args.eye.eye.is_none() {
        return Err(Failure::usage("flags of a view were given without --eye")
            .with_hint("use --eye instead of the other level, or remove these flags"));
    }
    if input.scene_kind().is_some() || args.levels.lod_chain {
        check_scene_flags(input, args)?;
        let received = input.received_scene(output)?;
        let mut source = SceneSource::new(received, args.textures.options().as_ref(), output)?;
        if args.levels.lod_chain {
            source = source.in_one_file(args.output.path(), &args.output.format);
        }
        return extract(&mut source, args, started, output);
    }
    if let Some(flag) = args.textures.first_given_flag() {
        return Err(Failure::user(format!("{flag}: {} is not a scene", input.name))
            .with_hint(format!("remove {flag}, or re-encode textures with `striata build` or `convert`")));
    }
    let file = input.striata()?;
    let model = args.model.as_deref();
    let is_varying = args.eye.eye.is_some() || args.detail_box.is_some();
    let is_streamed =
        model == Some(ModelKind::Progressive.as_str()) || model.is_none() && file.is_stream_only();
    if is_streamed && !is_varying {
        return extract(&mut StreamSource::new(&file, args.form, input)?, args, started, output);
    }
    input.remark_on(&file, output)?;
    if let Some(name) =
        model.filter(|&name| args.detail_box.is_some() && name != ModelKind::Patterns.as_str())
    {
        return Err(Failure::usage(format!("model {name} does not support --detail-box"))
            .with_hint("remove --model, or use --model patterns"));
    }
    let mut source = FileSource::new(file, model, args.form, input)?;
    if is_varying {
        source.check_views()?;
    } else {
        source.check_model(model)?;
    }
    extract(&mut source, args, started, output)
}

/// Writes what the user asks for: levels, a view, or a box.
fn extract<S: LevelSource>(
    source: &mut S,
    args: &ExtractArgs,
    started: Instant,
    output: &Output,
) -> Result<LevelsReport, Failure> {
    let varying = VaryingJob {
        level: &args.level,
        levels: &args.levels,
        output: &args.output,
        is_strict: args.strict,
        started,
    };
    if let Some(eye) = args.eye.eye {
        return write_view(source, &varying, eye, &args.view, output);
    }
    if let Some(corners) = args.detail_box {
        return write_box(source, &varying, corners, output);
    }
    let full = full_of(source, &args.level)?;
    let requests = level_requests(&args.level, &args.levels, full, args.output.path())?;
    let job = LevelJob {
        requests,
        is_list: args.levels.levels.is_some(),
        default_target: Target::Detail(1.0),
        is_strict: args.strict,
        format: &args.output.format,
        max_error: None,
        started,
    };
    write_levels(source, &job, output)
}

/// Checks that the output format supports the requested primitives.
///
/// # Errors
/// If the format of an output does not support the form.
fn check_form(args: &ExtractArgs) -> Result<(), Failure> {
    for path in check_paths(&args.level, &args.levels, args.output.path())? {
        let format = format_of(&path, &args.output.format)?;
        match args.form {
            TriangleForm::List => {}
            TriangleForm::Strips => check_form_fits("strips", &path, format, "use --as list")?,
            TriangleForm::Fans => check_form_fits("fans", &path, format, "use --as list")?,
        }
    }
    Ok(())
}

/// Checks that no flag was given that only has a meaning for one mesh.
///
/// # Errors
/// If there is such a flag.
fn check_scene_flags(input: &Input, args: &ExtractArgs) -> Result<(), Failure> {
    let flags = [
        ("--model", args.model.is_some()),
        ("--as strips", args.form == TriangleForm::Strips),
        ("--as fans", args.form == TriangleForm::Fans),
        ("--detail-box", args.detail_box.is_some()),
    ];
    match flags.into_iter().find(|&(_, is_given)| is_given) {
        None => Ok(()),
        Some((flag, _)) => {
            Err(Failure::user(format!("{flag} is for one mesh, but {} is a scene", input.name))
                .with_hint(format!("remove {flag}, or build a file of one mesh with `striata build --flat`")))
        }
    }
}
