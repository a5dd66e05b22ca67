//! `build`: builds a .striata file with every level of detail of a mesh.

mod build_output;
mod costs;
mod models;
mod report;
mod strips_from;

pub(crate) use self::build_output::{BuildOutput, PHASES, build};
pub(crate) use self::costs::{ModelCost, model_costs};
pub(crate) use self::models::{BuildPlan, model_of_name, parts_in_file};

use std::path::{Path, PathBuf};

use striata::mesh::{IndexedMesh, MeshError};
use striata::model::ModelKind;
use striata::simplify::Retriangulation;

use self::models::takes_strips;
use self::report::BuildReport;
use self::strips_from::StripsFrom;
use super::{paged, scene};
use crate::args::BuildArgs;
use striata_command::clock::Phases;
use striata_command::failure::Failure;
use striata_command::input::Input;
use striata_command::level::{FullMesh, check_strict};
use striata_command::output::Output;
use striata_command::save::{
    check_not_compressed, check_place, default_output_path, display_name, is_stdout, write_bytes,
};
use striata_command::scene::with_mesh_textures;
use striata_command::sequence::{Limits, SequencePlan, limit_in_units};
use striata_io::Format;
use striata_scene::godot::GodotKind;

/// Reads the mesh, builds and writes the file, and reports.
///
/// # Errors
/// If any of this fails; an existing output is then left unchanged.
pub(crate) fn run(args: &BuildArgs, output: &Output) -> Result<(), Failure> {
    let path = match &args.output {
        Some(path) => path.clone(),
        None => default_output_path(&args.input, "striata")?,
    };
    let format = format_of_output(&path)?;
    scene::check_order_flags(args, &path, format, is_paged(args))?;
    if is_paged(args) {
        let inputs: Vec<PathBuf> = std::iter::once(&args.input).chain(&args.more).cloned().collect();
        check_paged_flags(args)?;
        return paged::build(&inputs, args, &path, output);
    }
    output.check_stdout_is_free(is_stdout(&path))?;
    let models = models_of_names(&args.model_names())?;
    check_stream_flags(args, &models)?;
    check_strip_flags(args, &models)?;
    check_overlap_errors(args, &models)?;
    check_place(&path)?;
    let mut phases = Phases::new(&PHASES);
    let mut bar = output.bar();
    phases.enter("read");
    bar.phase("read");
    let input = Input::open(&args.input)?;
    if format != BuildFormat::Striata || input.scene_kind().is_some() && !args.scene.flat {
        drop(bar);
        return scene::build(args, &input, &BuildFile { path: &path, format }, output);
    }
    let mesh = with_mesh_textures(input.mesh(output)?, args.textures.options().as_ref(), output)?;
    let source = input.file_name();
    let diagonal = mesh.diagonal();
    args.sequence.warn_about_groups(&mesh, output);
    let base = base_of(args, &mesh).map_err(|error| Failure::from(error).in_file(&input.name))?;
    let limits = Limits {
        base_triangle_count: base.unwrap_or(0),
        max_error: limit_in_units(args.limits.max_error, diagonal),
    };
    let mut sequence = args.sequence.plan_for(&mesh, limits)?;
    let remark = adapt_retriangulation(&mut sequence, &models, args.sequence.wants_free_retriangulation())?;
    if models.contains(&ModelKind::Fans) {
        sequence.guarantee_any_state();
    }
    if models.contains(&ModelKind::Progressive) {
        sequence.use_batches(args.stream_encoding.batches(&mesh)?)?;
    }
    if let Some(remark) = remark {
        output.say(&remark);
    }
    let stream = args.stream_encoding.options(diagonal);
    let read_strips = |path: &PathBuf| StripsFrom::read(path, &input, &mesh, args.strips.is_none(), output);
    let strips_from = args.strips_from.as_ref().map(read_strips).transpose()?;
    let plan = BuildPlan {
        sequence,
        strips: args.strip_plan(),
        strips_from,
        stages: args.stages(),
        models,
        stream,
        has_overlap_errors: args.overlap_errors,
    };
    let built = build(&mesh, &plan, &mut phases, &mut bar).map_err(|failure| failure.in_file(&input.name))?;
    args.sequence.warn_about_flat_folds(&built.steps, output);
    let shortfall = base.and_then(|base| built.shortfall(base, &args.sequence));
    check_strict(args.limits.strict, None, shortfall.as_deref())?;
    phases.enter("write");
    bar.phase("write");
    let bytes = built.to_bytes(&source)?;
    write_bytes(&bytes, &path)?;
    phases.leave();
    drop(bar);
    let mut report = BuildReport::new(&mesh, &built, display_name(&path), bytes.len(), phases);
    report.shortfall = shortfall;
    let text = report.to_text(args, &built, diagonal);
    output.summary(&report, &(text + &timings_text(args, &report.phases)))
}

/// The times of all stages, if the user asked for them.
pub(in crate::commands) fn timings_text(args: &BuildArgs, phases: &Phases) -> String {
    if args.timings { format!("\n{}", phases.to_text()) } else { String::new() }
}

/// Whether the result is a paged file: if flags ask for it, or if the input does not fit into memory.
fn is_paged(args: &BuildArgs) -> bool {
    args.paged.is_given()
        || !args.more.is_empty()
        || paged::is_streamed_only(&args.input)
        || paged::is_too_large(&args.input)
}

/// Checks that no flag is given that has no meaning for a paged file.
///
/// # Errors
/// If there is one: what a user asks for must not be dropped in silence.
fn check_paged_flags(args: &BuildArgs) -> Result<(), Failure> {
    let sequence = &args.sequence;
    let is_default = args.model_names() == ["lodstrips"];
    let flags = [
        ("--models", !is_default),
        ("--overlap-errors", args.overlap_errors),
        ("--order", sequence.order.of_removals().is_some()),
        ("--certify", sequence.certify),
        ("--cost", sequence.cost.is_some()),
        ("--pair-distance", sequence.pair_distance.is_some()),
        ("--new-vertices", sequence.new_vertices.is_some()),
    ];
    let given = flags.into_iter().find(|&(_, is_given)| is_given).map(|(flag, _)| flag);
    let given = given
        .or_else(|| sequence.removal.first_given_flag())
        .or_else(|| args.strip_flag())
        .or_else(|| args.stream_encoding.first_given_flag())
        .or_else(|| args.textures.first_given_flag())
        .or_else(|| args.edits.first_given_flag());
    let Some(flag) = given else { return Ok(()) };
    let name = args.input.display();
    let (reason, hint) = if args.paged.is_given() {
        ("", format!("remove {flag}, or the flags of paged files"))
    } else if !args.more.is_empty() {
        (" (several files become one)", format!("remove {flag}, or name one file"))
    } else if paged::is_streamed_only(&args.input) {
        (" (inputs of this kind are built paged)", format!("remove {flag}"))
    } else {
        (" (the input is too large for memory)", format!("remove {flag}"))
    };
    Err(Failure::usage(format!("{name}: a paged file{reason} does not support {flag}")).with_hint(hint))
}

/// Returns the largest number of triangles of the base mesh, if limited.
///
/// # Errors
/// If the mesh is inconsistent.
fn base_of(args: &BuildArgs, mesh: &IndexedMesh) -> Result<Option<usize>, MeshError> {
    Ok(match args.limits.base {
        Some(share) if share.is_share() => Some(share.of_triangles(FullMesh::of(mesh)?.triangle_count)),
        // An absolute count does not depend on the mesh.
        number => number.map(|count| count.of_triangles(0)),
    })
}

/// Switches to retriangulation like that of collapses if a model requires it; returns a message about the
/// switch.
///
/// # Errors
/// If the user requested free retriangulation or new vertices.
fn adapt_retriangulation(
    sequence: &mut SequencePlan,
    models: &[ModelKind],
    is_free: bool,
) -> Result<Option<String>, Failure> {
    let is_demanding = |model: &&ModelKind| !matches!(model, ModelKind::Patterns | ModelKind::Fans);
    let demanding_model = models.iter().find(is_demanding);
    let Some(model) = demanding_model else { return Ok(None) };
    let options = match sequence {
        SequencePlan::Hausdorff(options) => options,
        SequencePlan::Placed(_) => {
            return Err(Failure::usage(format!("model {model} does not support new vertices"))
                .with_hint("use --models patterns,fans, or remove --new-vertices"));
        }
        SequencePlan::Quadric { .. } => return Ok(None),
    };
    if options.retriangulation == Retriangulation::Collapse {
        return Ok(None);
    }
    if is_free {
        return Err(Failure::usage(format!("model {model} does not support free retriangulation"))
            .with_hint("remove --retriangulation, or the model"));
    }
    options.retriangulation = Retriangulation::Collapse;
    Ok(Some(format!("note: using --retriangulation collapse, which model {model} requires")))
}

/// Parses model names, which may have spaces around them.
///
/// # Errors
/// If a name is unknown.
fn models_of_names(names: &[String]) -> Result<Vec<ModelKind>, Failure> {
    names.iter().map(|name| model_of_name(name.trim())).collect()
}

/// Checks that flags of a stream are only given if a stream is made.
///
/// # Errors
/// If they are given without a stream.
fn check_stream_flags(args: &BuildArgs, models: &[ModelKind]) -> Result<(), Failure> {
    match args.stream_encoding.first_given_flag() {
        Some(flag) if !models.contains(&ModelKind::Progressive) => {
            Err(Failure::usage(format!("{flag} has no effect without a stream"))
                .with_hint(format!("add --models progressive, or remove {flag}")))
        }
        _ => Ok(()),
    }
}

/// Checks that errors of overlaps are only requested for patterns.
///
/// # Errors
/// If there are no patterns.
fn check_overlap_errors(args: &BuildArgs, models: &[ModelKind]) -> Result<(), Failure> {
    if args.overlap_errors && !models.contains(&ModelKind::Patterns) {
        return Err(Failure::usage("--overlap-errors has no effect without patterns")
            .with_hint("add --models patterns, or remove --overlap-errors"));
    }
    Ok(())
}

/// Checks that flags of strips are only given if a model has strips.
///
/// # Errors
/// If they are given without such a model.
fn check_strip_flags(args: &BuildArgs, models: &[ModelKind]) -> Result<(), Failure> {
    if args.max_strip_indices.is_some() && !models.contains(&ModelKind::LodStrips) {
        return Err(Failure::usage("--max-strip-indices has no effect without LodStrips")
            .with_hint("add --models lodstrips, or remove --max-strip-indices"));
    }
    match args.strip_flag() {
        Some(flag) if !models.iter().any(takes_strips) => {
            Err(Failure::usage(format!("{flag} has no effect without a model that has strips"))
                .with_hint(format!("add --models lodstrips or mts, or remove {flag}")))
        }
        _ => Ok(()),
    }
}

/// Format of a file with all levels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::commands) enum BuildFormat {
    Striata,
    Glb,
    Godot(GodotKind),
}

/// A file to write.
pub(in crate::commands) struct BuildFile<'p> {
    pub path: &'p Path,
    pub format: BuildFormat,
}

/// Returns the format that the name of the output requests.
///
/// # Errors
/// If the extension belongs to another format or to a compressed file.
fn format_of_output(path: &Path) -> Result<BuildFormat, Failure> {
    check_not_compressed(path, "files of `build`")?;
    if let Some(kind) = GodotKind::from_extension(path) {
        return Ok(BuildFormat::Godot(kind));
    }
    match Format::from_extension(path) {
        None | Some(Format::Striata) => Ok(BuildFormat::Striata),
        Some(Format::Glb) => Ok(BuildFormat::Glb),
        Some(_) => {
            let what = "`build` writes .striata and .glb files, and .tscn and .tres for Godot";
            Err(Failure::usage(format!("{}: {what}", path.display()))
                .with_hint("`striata simplify` writes one level as a mesh"))
        }
    }
}
