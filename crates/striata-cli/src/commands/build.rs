//! `build`: a mesh becomes one .striata file that holds every level.

use std::path::Path;

use serde::Serialize;
use serde_json::{Map, Value, json};
use striata::file::{DecodeError, FileModel, StriataFile, WriteOptions, to_striata, write_fragments};
use striata::mesh::{IndexedMesh, MeshError, RefinableMesh, weld};
use striata::model::{Fans, LodModel, LodStrips, ModelKind, Mts, PartBytes, Patterns};
use striata::simplify::{Retriangulation, StopReason, Target};
use striata::strip::StripSet;
use striata_stream::{EncodedStream, StreamFacts, StreamOptions, encode_stream, file_model};

use crate::args::BuildArgs;
use striata_command::args::{OrderArg, SequenceArgs};
use striata_command::clock::{Phases, peak_rss_bytes};
use striata_command::failure::{Failure, unknown_name};
use striata_command::input::Input;
use striata_command::level::{Floor, FullMesh, Reached, check_strict, shortfall};
use striata_command::output::{Bar, Output, Table, grouped, lasted, measured, sized};
use striata_command::save::{CHOSEN_NAME, beside, check_not_packed, is_stdout, name_of, put};
use striata_command::sequence::{Limits, SequencePlan, Sequenced, StepKind, Steps, limit_in_units};
use striata_command::stream::facts_in_json;
use striata_command::strip_chain::StripPlan;
use striata_command::strip_report::StripReport;

/// The phases that a build reports.
pub(crate) const PHASES: [&str; 6] = ["read", "weld", "simplify", "strip", "models", "write"];

/// The key by which a file says of which kind its errors are, and the kind that holds for the whole surface.
const ERRORS: &str = "errors";
const GUARANTEED: &str = "guaranteed";

/// Whether a file says that no point of the original is farther from a level than its error.
///
/// # Errors
/// Where what the file says of itself is damaged.
pub(crate) fn errors_are_guaranteed(file: &StriataFile<'_>) -> Result<bool, DecodeError> {
    let is_said = |(key, value): &(String, String)| key == ERRORS && value == GUARANTEED;
    Ok(file.metadata()?.iter().any(is_said))
}

/// The model of a name.
///
/// # Errors
/// If the name is none of ours.
pub(crate) fn model_of_name(name: &str) -> Result<ModelKind, Failure> {
    name.parse().map_err(|_| unknown_name("model", name, &ModelKind::ALL.map(ModelKind::as_str)))
}

/// Reads, builds, writes, reports.
///
/// # Errors
/// Where any of it fails; the output is then as it was.
pub(crate) fn run(args: &BuildArgs, output: &Output) -> Result<(), Failure> {
    let path = match &args.output {
        Some(path) => path.clone(),
        None => beside(&args.input, "striata")?,
    };
    output.check_stdout_is_free(is_stdout(&path))?;
    let models = models_of_names(&args.model_names())?;
    check_stream_terms(args, &models)?;
    check_strip_terms(args, &models)?;
    check_output_name(&path)?;
    let mut phases = Phases::new(&PHASES);
    let mut bar = output.bar();
    phases.enter("read");
    bar.phase("read");
    let input = Input::open(&args.input)?;
    let (mesh, source) = (input.mesh(output)?, input.file_name());
    let diagonal = mesh.diagonal();
    args.sequence.remark_on(&mesh, output);
    let base = base_of(args, &mesh).map_err(|error| Failure::from(error).in_file(&input.name))?;
    let limits = Limits {
        base_triangle_count: base.unwrap_or(0),
        max_error: limit_in_units(args.max_error, diagonal),
    };
    let mut sequence = args.sequence.plan_for(&mesh, limits, output)?;
    if let Some(remark) = fill_as_models_need(&mut sequence, &models, args.sequence.is_free())? {
        output.say(&remark);
    }
    if models.contains(&ModelKind::Fans) {
        sequence.hold_in_any_state();
    }
    if models.contains(&ModelKind::Progressive) {
        sequence.come_in_batches(args.stream_terms.batches(&mesh)?)?;
    }
    let stream = args.stream_terms.options(diagonal);
    let plan = BuildPlan { sequence, strips: args.strip_plan(), models, stream };
    let built = build(&mesh, &plan, &mut phases, &mut bar).map_err(|failure| failure.in_file(&input.name))?;
    let shortfall = base.and_then(|base| built.shortfall(base, &args.sequence));
    check_strict(args.strict, None, shortfall.as_deref())?;
    phases.enter("write");
    bar.phase("write");
    let bytes = built.to_bytes(&source)?;
    put(&bytes, &path)?;
    phases.leave();
    drop(bar);
    let report = Report { shortfall, ..Report::new(&mesh, &built, (name_of(&path), bytes.len()), phases) };
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

/// What a build is to make.
#[derive(Clone, Debug)]
pub(crate) struct BuildPlan {
    /// How the mesh is simplified.
    pub(crate) sequence: SequencePlan,
    /// How its strips are made.
    pub(crate) strips: StripPlan,
    /// The models.
    pub(crate) models: Vec<ModelKind>,
    /// How a stream is coded, where one is among them.
    pub(crate) stream: StreamOptions,
}

impl BuildPlan {
    /// What is built where nothing is asked for.
    pub(crate) fn usual() -> Self {
        Self {
            sequence: SequencePlan::default(),
            strips: BuildArgs::usual_strip_plan(),
            models: vec![ModelKind::LodStrips],
            stream: StreamOptions::default(),
        }
    }
}

/// A mesh with all that a .striata file holds.
#[derive(Debug)]
pub(crate) struct Built {
    steps: Steps,
    models: Models,
    order: OrderArg,
    stop_reason: StopReason,
    error_is_guaranteed: bool,
    /// Where a model needs strips.
    strip_report: Option<StripReport>,
}

/// The models that were asked for.
#[derive(Debug)]
struct Models {
    lod_strips: Option<LodStrips<'static>>,
    mts: Option<Mts<'static>>,
    fans: Option<Fans>,
    patterns: Option<Patterns>,
    /// The mesh is in its order.
    stream: Option<EncodedStream>,
}

impl Models {
    /// Models of strips are built where there are strips.
    ///
    /// # Errors
    /// Where the strips are not those of the mesh, or there are too many fragments.
    fn build(
        kinds: &[ModelKind],
        sequenced: &Sequenced,
        (strips, stream): (Option<&StripSet>, Option<EncodedStream>),
        bar: &mut Bar,
    ) -> Result<Self, Failure> {
        let is_wanted = |kind: ModelKind| kinds.contains(&kind);
        let mut models = Self { lod_strips: None, mts: None, fans: None, patterns: None, stream };
        if let Steps::Collapses(refinable) = &sequenced.steps {
            let strips_for = |kind| strips.filter(|_| is_wanted(kind));
            models.lod_strips =
                strips_for(ModelKind::LodStrips).map(|s| LodStrips::build(refinable, s)).transpose()?;
            models.mts = strips_for(ModelKind::Mts).map(|s| Mts::build(refinable, s)).transpose()?;
            models.fans = is_wanted(ModelKind::Fans).then(|| Fans::build(refinable));
        }
        if is_wanted(ModelKind::Patterns) {
            let fragmented = sequenced.fragments(&mut |progress| bar.show(progress))?;
            models.patterns = Some(Patterns::build(&fragmented)?);
        }
        Ok(models)
    }

    fn in_file(&self) -> Result<Vec<FileModel<'_>>, Failure> {
        let lod_strips = self.lod_strips.iter().map(FileModel::LodStrips);
        let fans = self.fans.iter().map(FileModel::Fans);
        let patterns = self.patterns.iter().map(FileModel::Patterns);
        let stream = self.stream.as_ref().map(|stream| file_model(&stream.bytes)).transpose()?;
        let of_strips = lod_strips.chain(self.mts.iter().map(FileModel::Mts));
        Ok(of_strips.chain(fans).chain(patterns).chain(stream).collect())
    }

    /// Each model with its parts.
    fn parts(&self) -> Vec<(ModelKind, Vec<PartBytes>)> {
        let lod_strips = self.lod_strips.iter().map(|model| (ModelKind::LodStrips, model.bytes()));
        let mts = self.mts.iter().map(|model| (ModelKind::Mts, model.bytes()));
        let fans = self.fans.iter().map(|model| (ModelKind::Fans, model.bytes()));
        let patterns = self.patterns.iter().map(|model| (ModelKind::Patterns, model.bytes()));
        let parts_of_stream = |s: &EncodedStream| vec![PartBytes { name: "stream", bytes: s.bytes.len() }];
        let streams = self.stream.iter().map(|stream| (ModelKind::Progressive, parts_of_stream(stream)));
        lod_strips.chain(mts).chain(fans).chain(patterns).chain(streams).collect()
    }
}

/// Builds the sequence, the strips and the models of a mesh.
///
/// # Errors
/// Where the mesh does not hang together or an option is out of range.
pub(crate) fn build(
    mesh: &IndexedMesh,
    plan: &BuildPlan,
    phases: &mut Phases,
    bar: &mut Bar,
) -> Result<Built, Failure> {
    phases.enter("weld");
    bar.phase("weld");
    let welded = weld(mesh)?;
    phases.enter("simplify");
    let mut sequenced = plan.sequence.run(welded, &mut |progress| bar.show(progress))?;
    phases.enter("models");
    bar.phase("models");
    let stream = stream_of(&mut sequenced, plan)?;
    phases.enter("strip");
    let has_strips = plan.models.iter().any(takes_strips);
    let full = sequenced.steps.mesh();
    let mut strip = || plan.strips.run(full, &mut |share| bar.share("strip", share));
    let stripped = if has_strips { Some(strip()?) } else { None };
    let report = |stripped| -> Result<StripReport, Failure> {
        let report =
            StripReport::new(plan.strips.chain.to_string(), full, stripped, plan.strips.cache_size())?;
        Ok(report.with_bound(&plan.strips.chain, full))
    };
    let strip_report = stripped.as_ref().map(report).transpose()?;
    phases.enter("models");
    bar.phase("models");
    let strips = stripped.as_ref().map(|stripped| &stripped.strips);
    let models = Models::build(&plan.models, &sequenced, (strips, stream), bar)?;
    let order = plan.sequence.order();
    let Sequenced { steps, stop_reason, error_is_guaranteed, .. } = sequenced;
    Ok(Built { steps, models, order, stop_reason, error_is_guaranteed, strip_report })
}

/// The stream, where it is asked for; the mesh is in its order afterwards, so that all models number levels as it does.
fn stream_of(sequenced: &mut Sequenced, plan: &BuildPlan) -> Result<Option<EncodedStream>, Failure> {
    let (Steps::Collapses(refinable), Some(batches)) = (&mut sequenced.steps, &sequenced.batches) else {
        return Ok(None);
    };
    let stream = encode_stream(refinable, batches, &plan.stream)?;
    *refinable = stream.reorder(refinable);
    Ok(Some(stream))
}

impl Built {
    /// Why the base has more triangles than asked for, if it has.
    fn shortfall(&self, base: usize, sequence: &SequenceArgs) -> Option<String> {
        let levels = self.steps.levels();
        let reached = Reached {
            vertex_count: levels.base_vertex_count(),
            triangle_count: levels.triangle_count_at(0),
            stop_reason: self.stop_reason,
        };
        let kind = if self.models.stream.is_some() { StepKind::Batches } else { StepKind::Single };
        let why = sequence.what_forbids_more(kind);
        shortfall(Target::Triangles(base), reached, &Floor::Simplified(why))
    }

    /// The mesh in refinement order, and its steps.
    ///
    /// # Panics
    /// If they are no collapses.
    pub(crate) fn refinable(&self) -> &RefinableMesh {
        match &self.steps {
            Steps::Collapses(refinable) => refinable,
            Steps::Fragments(_) => panic!("built with collapses"),
        }
    }

    /// The LodStrips.
    ///
    /// # Panics
    /// If they were not asked for.
    pub(crate) fn lod_strips(&self) -> &LodStrips<'static> {
        self.models.lod_strips.as_ref().expect("built with LodStrips")
    }

    /// The .striata file, with the name of the mesh that it was made from.
    ///
    /// # Errors
    /// Where the parts cannot be encoded.
    pub(crate) fn to_bytes(&self, source: &str) -> Result<Vec<u8>, Failure> {
        let options = WriteOptions::default()
            .with_metadata("creator", concat!("striata ", env!("CARGO_PKG_VERSION")))
            .with_metadata("source", source)
            .with_metadata("order", self.order.as_str())
            .with_metadata(ERRORS, if self.error_is_guaranteed { GUARANTEED } else { "estimated" });
        match (&self.steps, &self.models.patterns) {
            (Steps::Collapses(refinable), _) => Ok(to_striata(refinable, &self.models.in_file()?, &options)?),
            (Steps::Fragments(fragmented), Some(patterns)) => {
                let mut bytes = Vec::new();
                write_fragments(fragmented, patterns, &options, &mut bytes)?;
                Ok(bytes)
            }
            (Steps::Fragments(_), None) => Err(Failure::internal("only patterns know what is no collapse")),
        }
    }
}

#[derive(Serialize)]
struct Report {
    path: String,
    input: Value,
    step_count: usize,
    base: Value,
    error_max: f32,
    error_is_guaranteed: bool,
    order: &'static str,
    stop_reason: &'static str,
    /// Why the base has more triangles than `--base` says; null if it has not.
    shortfall: Option<String>,
    models: Map<String, Value>,
    strips: Value,
    #[serde(skip_serializing_if = "Option::is_none")]
    stream: Option<Value>,
    output_bytes: usize,
    phases: Phases,
    secs: f64,
    peak_rss_bytes: Option<u64>,
}

impl Report {
    fn new(mesh: &IndexedMesh, built: &Built, (path, output_bytes): (String, usize), phases: Phases) -> Self {
        let sequence = built.steps.levels();
        let vertex_count = built.steps.mesh().vertex_count().max(1);
        let mut models = Map::new();
        for (kind, parts) in built.models.parts() {
            let bytes = parts.iter().map(|part| part.bytes).sum::<usize>();
            let per_vertex = bytes as f64 / vertex_count as f64;
            models.insert(kind.to_string(), json!({ "bytes": bytes, "bytes_per_vertex": per_vertex }));
        }
        let mut strips = json!(built.strip_report);
        if !strips.is_null() {
            strips["secs"] = json!(phases.secs_of("strip"));
        }
        let facts = built.models.stream.as_ref().and_then(|s| StreamFacts::read(&s.bytes).ok().flatten());
        Self {
            path,
            shortfall: None,
            stream: facts.as_ref().map(facts_in_json),
            input: json!({
                "vertex_count": mesh.vertex_count(),
                "triangle_count": mesh.triangle_count(),
                "position_count": sequence.positions().position_count(),
            }),
            step_count: sequence.step_count(),
            base: json!({
                "vertex_count": sequence.base_vertex_count(),
                "triangle_count": sequence.triangle_count_at(0),
            }),
            error_max: sequence.error_at(0),
            error_is_guaranteed: built.error_is_guaranteed,
            order: built.order.as_str(),
            stop_reason: built.stop_reason.as_str(),
            models,
            strips,
            output_bytes,
            secs: phases.total_secs(),
            phases,
            peak_rss_bytes: peak_rss_bytes(),
        }
    }

    fn to_text(&self, args: &BuildArgs, built: &Built, diagonal: f64) -> String {
        let sequence = built.steps.levels();
        let last = sequence.step_count();
        let error = f64::from(sequence.error_at(0));
        let share = if diagonal > 0.0 { 100.0 * error / diagonal } else { 0.0 };
        let mut table = Table::default();
        let mut row = |name: &str, value: String| table.row(vec![name.to_owned(), value]);
        let triangles = |at| grouped(sequence.triangle_count_at(at));
        row("triangles", format!("{} down to {}", triangles(last), triangles(0)));
        row("levels", grouped(last + 1));
        let kind = if self.error_is_guaranteed { "guaranteed" } else { "estimated" };
        row("error of the base", format!("{} ({share:.3} % of the diagonal), {kind}", measured(error)));
        if let Some(StripReport { algorithm, strip_count, indices_per_triangle, .. }) = &built.strip_report {
            let strips = format!("{} ({algorithm})", grouped(*strip_count));
            row("strips", format!("{strips}, {indices_per_triangle:.3} indices a triangle"));
        }
        for (name, model) in &self.models {
            let bytes = model["bytes"].as_u64().unwrap_or(0) as usize;
            let per_vertex = model["bytes_per_vertex"].as_f64().unwrap_or(0.0);
            row(name, format!("{}, {per_vertex:.1} bytes a vertex", sized(bytes)));
        }
        let chosen = if args.output.is_none() { CHOSEN_NAME } else { "" };
        row("file", format!("{} ({}){chosen}", self.path, sized(self.output_bytes)));
        row("time", lasted(self.secs));
        let shortfall =
            self.shortfall.as_ref().map(|shortfall| format!("the base was not reached: {shortfall}"));
        table.to_text() + &shortfall.unwrap_or_default()
    }
}

/// Lets holes be filled as collapses do where a model asks for it; what is to be said of that.
///
/// # Errors
/// Where they were to be filled freely.
fn fill_as_models_need(
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
fn check_stream_terms(args: &BuildArgs, models: &[ModelKind]) -> Result<(), Failure> {
    match args.stream_terms.given() {
        Some(flag) if !models.contains(&ModelKind::Progressive) => {
            Err(Failure::user(format!("{flag} is for streams, and none is made"))
                .with_hint(format!("say --models progressive too, or leave {flag} out")))
        }
        _ => Ok(()),
    }
}

/// Whether a model is made of strips.
fn takes_strips(model: &ModelKind) -> bool {
    matches!(model, ModelKind::LodStrips | ModelKind::Mts)
}

/// # Errors
/// If strips are described and no model has any.
fn check_strip_terms(args: &BuildArgs, models: &[ModelKind]) -> Result<(), Failure> {
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
    check_not_packed(path, ".striata files")?;
    match striata_io::Format::from_extension(path) {
        None | Some(striata_io::Format::Striata) => Ok(()),
        Some(_) => Err(Failure::user(format!("{}: `build` writes .striata files", path.display()))
            .with_hint("`striata simplify` writes one level as a mesh")),
    }
}
