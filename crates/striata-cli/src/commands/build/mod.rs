//! `build`: a mesh becomes one .striata file that holds every level.

mod build_output;
mod costs;
mod models;
mod report;

pub(crate) use self::build_output::{BuildOutput, BuildPlan, PHASES, build, errors_are_guaranteed};
pub(crate) use self::costs::{ModelCost, model_costs};
pub(crate) use self::models::model_of_name;

use std::path::Path;

use striata::mesh::{IndexedMesh, MeshError};
use striata::model::ModelKind;
use striata::simplify::Retriangulation;

use self::models::takes_strips;
use self::report::Report;
use crate::args::BuildArgs;
use striata_command::clock::Phases;
use striata_command::failure::Failure;
use striata_command::input::Input;
use striata_command::level::{FullMesh, check_strict};
use striata_command::output::Output;
use striata_command::save::{
    check_not_compressed, default_output_path, display_name, is_stdout, write_bytes,
};
use striata_command::sequence::{Limits, SequencePlan, limit_in_units};

/// Reads, builds, writes, reports.
///
/// # Errors
/// Where any of it fails; the output is then as it was.
pub(crate) fn run(args: &BuildArgs, output: &Output) -> Result<(), Failure> {
    let path = match &args.output {
        Some(path) => path.clone(),
        None => default_output_path(&args.input, "striata")?,
    };
    output.check_stdout_is_free(is_stdout(&path))?;
    let models = models_of_names(&args.model_names())?;
    check_stream_flags(args, &models)?;
    check_strip_flags(args, &models)?;
    check_output_name(&path)?;
    let mut phases = Phases::new(&PHASES);
    let mut bar = output.bar();
    phases.enter("read");
    bar.phase("read");
    let input = Input::open(&args.input)?;
    let (mesh, source) = (input.mesh(output)?, input.file_name());
    let diagonal = mesh.diagonal();
    args.sequence.warn_about_groups(&mesh, output);
    let base = base_of(args, &mesh).map_err(|error| Failure::from(error).in_file(&input.name))?;
    let limits = Limits {
        base_triangle_count: base.unwrap_or(0),
        max_error: limit_in_units(args.max_error, diagonal),
    };
    let mut sequence = args.sequence.plan_for(&mesh, limits, output)?;
    if let Some(remark) =
        adapt_retriangulation(&mut sequence, &models, args.sequence.wants_free_retriangulation())?
    {
        output.say(&remark);
    }
    if models.contains(&ModelKind::Fans) {
        sequence.guarantee_any_state();
    }
    if models.contains(&ModelKind::Progressive) {
        sequence.use_batches(args.stream_encoding.batches(&mesh)?)?;
    }
    let stream = args.stream_encoding.options(diagonal);
    let plan = BuildPlan { sequence, strips: args.strip_plan(), models, stream };
    let built = build(&mesh, &plan, &mut phases, &mut bar).map_err(|failure| failure.in_file(&input.name))?;
    let shortfall = base.and_then(|base| built.shortfall(base, &args.sequence));
    check_strict(args.strict, None, shortfall.as_deref())?;
    phases.enter("write");
    bar.phase("write");
    let bytes = built.to_bytes(&source)?;
    write_bytes(&bytes, &path)?;
    phases.leave();
    drop(bar);
    let mut report = Report::new(&mesh, &built, (display_name(&path), bytes.len()), phases);
    report.shortfall = shortfall;
    output.summary(&report, &report.to_text(args, &built, diagonal))
}

/// Triangles that the base is to have at most.
///
/// # Errors
/// If the mesh's parts do not fit together.
fn base_of(args: &BuildArgs, mesh: &IndexedMesh) -> Result<Option<usize>, MeshError> {
    Ok(match args.base {
        Some(share) if share.is_share() => Some(share.of_triangles(FullMesh::of(mesh)?.triangle_count)),
        // No share: what the mesh has does not matter.
        number => number.map(|count| count.of_triangles(0)),
    })
}

/// Lets holes be filled as collapses do where a model asks for it; what is to be said of that.
///
/// # Errors
/// Where they were to be filled freely.
fn adapt_retriangulation(
    sequence: &mut SequencePlan,
    models: &[ModelKind],
    is_free: bool,
) -> Result<Option<String>, Failure> {
    let in_need = models.iter().find(|&&model| model != ModelKind::Patterns);
    let (SequencePlan::Hausdorff(options), Some(model)) = (sequence, in_need) else { return Ok(None) };
    if options.retriangulation == Retriangulation::Collapse {
        return Ok(None);
    }
    if is_free {
        return Err(Failure::user(format!("{model} knows collapses, and not holes that are filled freely"))
            .with_hint("leave --retriangulation out, or the model"));
    }
    options.retriangulation = Retriangulation::Collapse;
    Ok(Some(format!("holes are filled as half-edge collapses do, since {model} knows no other steps")))
}

/// The models of names; there may be blanks behind commas.
///
/// # Errors
/// If a name is none of ours.
fn models_of_names(names: &[String]) -> Result<Vec<ModelKind>, Failure> {
    names.iter().map(|name| model_of_name(name.trim())).collect()
}

/// # Errors
/// Where a stream is described and none is made.
fn check_stream_flags(args: &BuildArgs, models: &[ModelKind]) -> Result<(), Failure> {
    match args.stream_encoding.given() {
        Some(flag) if !models.contains(&ModelKind::Progressive) => {
            Err(Failure::user(format!("{flag} is for streams, and none is made"))
                .with_hint(format!("say --models progressive too, or leave {flag} out")))
        }
        _ => Ok(()),
    }
}

/// # Errors
/// If strips are described and no model has any.
fn check_strip_flags(args: &BuildArgs, models: &[ModelKind]) -> Result<(), Failure> {
    match args.strip_flag() {
        Some(flag) if !models.iter().any(takes_strips) => {
            Err(Failure::user(format!("{flag} is for strips, and no model with strips is built"))
                .with_hint(format!("say --models lodstrips or mts too, or leave {flag} out")))
        }
        _ => Ok(()),
    }
}

/// # Errors
/// Where the name says that the output is something else.
fn check_output_name(path: &Path) -> Result<(), Failure> {
    check_not_compressed(path, ".striata files")?;
    match striata_io::Format::from_extension(path) {
        None | Some(striata_io::Format::Striata) => Ok(()),
        Some(_) => Err(Failure::user(format!("{}: `build` writes .striata files", path.display()))
            .with_hint("`striata simplify` writes one level as a mesh")),
    }
}
