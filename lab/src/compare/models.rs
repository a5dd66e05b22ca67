//! Compares multiresolution models: all are built from one sequence and one set of strips, checked against
//! the oracle, and timed on the same work.

use std::collections::BTreeMap;
use std::time::Instant;

use serde::Serialize;
use serde_json::{Map, Value};
use striata::mesh::{FragmentedMesh, IndexedMesh, RefinableMesh, weld};
use striata::model::Topology;
use striata::simplify::{
    SequenceOptions, SimplifyError, TopologyRule, build_welded_sequence_with_progress,
    certify_collapses_in_any_state_with_progress,
};
use striata_lab::Accounting;

use super::contenders::{BuildFailure, Entry, ModelInputs, entries};
use super::oracle::{Checked, check};
use super::timed_model::{TimedModel, run_rounds};
use super::walks::WalkReport;
use crate::args::ModelArgs;
use crate::pace::Pace;
use striata_command::failure::Failure;
use striata_command::output::{Bar, format_count, format_duration};
use striata_command::strip_chain::TimedStrips;
use striata_command::strip_report::StripReport;

/// Bytes of a position, which the papers count per vertex.
pub(super) const POSITION_BYTES: usize = 12;

/// All models of a mesh, and what they were built from.
#[derive(Clone, Debug, Serialize)]
pub(super) struct ModelsReport {
    /// The data that the models were built from.
    #[serde(rename = "models_of")]
    pub basis: Basis,
    /// One row per model.
    #[serde(rename = "models")]
    pub rows: Vec<ModelRow>,
    /// Models whose published form cannot represent the mesh.
    #[serde(rename = "models_refused")]
    refused: Vec<RefusedModel>,
}

/// A model whose published form cannot represent the mesh.
#[derive(Clone, Debug, Serialize)]
struct RefusedModel {
    name: &'static str,
    cannot_be_built: String,
}

/// The data that all models of a mesh are built from.
#[derive(Clone, Debug, Serialize)]
pub(super) struct Basis {
    /// Number of vertices after welding.
    pub vertex_count: usize,
    /// Number of triangles after welding.
    pub triangle_count: usize,
    step_count: usize,
    base_triangle_count: usize,
    /// Strips of the full mesh.
    pub strips: StripReport,
    /// Bytes of positions and strip indices: a mesh without levels.
    pub plain_bytes: usize,
    /// Seconds to build the sequence.
    pub sequence_secs: f64,
    /// Frames in each direction of a walk.
    pub frames: usize,
    /// Number of rounds in which the models took turns.
    pub rounds: usize,
}

/// Measurements of one model.
#[derive(Clone, Debug, Serialize)]
pub(super) struct ModelRow {
    /// Name of the model.
    pub name: &'static str,
    /// Bytes of the static half, without positions.
    bytes: usize,
    bytes_per_vertex: f64,
    parts: Map<String, Value>,
    /// Including positions.
    pub total_bytes: usize,
    /// Ratio of `total_bytes` to the plain mesh.
    pub ratio_to_plain: f64,
    /// Including positions, as the papers count.
    pub paper_bytes: usize,
    /// Like `paper_bytes`, but with 2 bytes per integer.
    pub short_paper_bytes: usize,
    paper_bytes_per_vertex: f64,
    /// Ratio of `paper_bytes` to the plain mesh.
    pub paper_ratio_to_plain: f64,
    /// Bytes of an instance that shows the full mesh.
    state_bytes: usize,
    /// Seconds to build the model from the sequence and the strips.
    pub build_secs: f64,
    /// None if the model has too few levels for single steps.
    sweep_ns_per_step: Option<f64>,
    swept_step_count: usize,
    seek_secs: f64,
    /// Whether it draws strips instead of single triangles.
    #[serde(skip)]
    pub draws_strips: bool,
    /// Reports of the walks, by pace.
    walks: BTreeMap<&'static str, WalkReport>,
}

/// A mesh with the sequence that all models are built from.
#[derive(Debug)]
pub(super) struct Sequenced {
    /// The welded mesh with its sequence.
    pub refinable: RefinableMesh,
    /// Seconds to build the sequence.
    pub secs: f64,
}

impl Sequenced {
    /// Welds the mesh and builds its sequence, with certified errors for any state if `is_certified`.
    ///
    /// # Errors
    /// If the mesh is inconsistent.
    pub(super) fn build(
        mesh: &IndexedMesh,
        is_certified: bool,
        bar: &mut Bar,
        say: &dyn Fn(&str),
    ) -> Result<Self, Failure> {
        say("the sequence");
        let started = Instant::now();
        // Published models require manifolds and steps that preserve the topology, so all models get what
        // all can represent.
        let options = SequenceOptions::default().with_topology(TopologyRule::Keep);
        let built =
            build_welded_sequence_with_progress(weld(mesh)?, &options, &mut |progress| bar.show(progress))?;
        let refinable = match is_certified {
            true => certify_collapses_in_any_state_with_progress(&built.refinable, &mut |progress| {
                bar.show(progress)
            })
            .map_err(SimplifyError::from)?,
            false => built.refinable,
        };
        Ok(Self { refinable, secs: started.elapsed().as_secs_f64() })
    }
}

/// Builds the strips and the models, then checks and times them.
///
/// # Errors
/// If a name is not a model, or a model shows wrong triangles.
pub(super) fn measure(
    sequenced: &Sequenced,
    args: &ModelArgs,
    bar: &mut Bar,
    say: &dyn Fn(&str),
) -> Result<ModelsReport, Failure> {
    let entries = entries(&args.names())?;
    let Sequenced { refinable, secs: sequence_secs } = sequenced;
    let plan = args.strip_plan();
    say(&format!("strips for models, {}", plan.chain));
    let stripped = plan.run(&refinable.mesh, &mut |share| bar.share("strip", share))?;
    let (frames, step_count) = (args.frames as usize, refinable.sequence.step_count());
    let level_strips = plan.search.options(plan.chain.last());
    let fragmented = FragmentedMesh::from_collapses(refinable);
    let inputs = ModelInputs {
        refinable,
        fragmented: &fragmented,
        strips: &stripped.strips,
        level_strips: &level_strips,
    };
    let (mut timed_models, mut refused) = (Vec::new(), Vec::new());
    for entry in entries {
        say(entry.name);
        match entry.build(inputs) {
            Ok(contender) => timed_models.push(TimedModel::new(entry, contender, step_count, frames)),
            Err(BuildFailure::Unsupported(why)) => {
                refused.push(RefusedModel { name: entry.name, cannot_be_built: why })
            }
            Err(BuildFailure::Failed(failure)) => return Err(failure),
        }
    }
    drop(fragmented);
    bar.phase("check");
    let mut checked: Vec<Checked<'_>> = timed_models.iter_mut().map(TimedModel::checked).collect();
    check(&mut checked, refinable)?;
    say("all models in turn");
    let rounds = run_rounds(&mut timed_models, step_count, &mut |share| bar.share("timing", share));
    let strips = StripReport::new(plan.chain.to_string(), &refinable.mesh, &stripped, plan.cache_size())?;
    let counts = TimingCounts { frames, rounds };
    let basis = Basis::new(refinable, &stripped, strips, *sequence_secs, counts);
    let rows = timed_models.iter_mut().map(|timed_model| ModelRow::new(timed_model, refinable, &basis));
    Ok(ModelsReport { rows: rows.collect(), basis, refused })
}

impl TimedModel {
    fn checked(&mut self) -> Checked<'_> {
        let Entry { name, has_few_levels, .. } = *self.entry;
        Checked { name, has_few_levels, contender: &mut *self.contender }
    }
}

/// How often models are timed.
struct TimingCounts {
    frames: usize,
    rounds: usize,
}

impl Basis {
    fn new(
        refinable: &RefinableMesh,
        stripped: &TimedStrips,
        strips: StripReport,
        sequence_secs: f64,
        TimingCounts { frames, rounds }: TimingCounts,
    ) -> Self {
        let vertex_count = refinable.mesh.vertex_count();
        let index_count = stripped.strips.to_restart_indices().indices.len();
        Self {
            vertex_count,
            triangle_count: refinable.mesh.triangle_count(),
            step_count: refinable.sequence.step_count(),
            base_triangle_count: refinable.sequence.triangle_count_at(0),
            strips,
            plain_bytes: POSITION_BYTES * vertex_count + 4 * index_count,
            sequence_secs,
            frames,
            rounds,
        }
    }

    /// Describes the data that models are built from in one sentence.
    pub(super) fn summary(&self) -> String {
        format!(
            "{} steps from {} triangles down to {}; {} strips ({}) of {} indices; positions and \
             strips take {:.1} bytes per vertex",
            format_count(self.step_count),
            format_count(self.triangle_count),
            format_count(self.base_triangle_count),
            format_count(self.strips.strip_count),
            self.strips.algorithm,
            format_count(self.strips.index_count),
            self.plain_bytes as f64 / self.vertex_count.max(1) as f64,
        )
    }
}

impl ModelRow {
    fn new(timed_model: &mut TimedModel, refinable: &RefinableMesh, basis: &Basis) -> Self {
        timed_model.contender.move_to(basis.step_count);
        let contender = &*timed_model.contender;
        let parts = contender.bytes();
        let bytes: usize = parts.iter().map(|part| part.bytes).sum();
        let positions = POSITION_BYTES * basis.vertex_count;
        let (total_bytes, paper_bytes) =
            (bytes + positions, contender.paper_bytes(Accounting::Words) + positions);
        let ratio = |bytes: usize| bytes as f64 / basis.plain_bytes.max(1) as f64;
        let per_vertex = |bytes: usize| bytes as f64 / basis.vertex_count.max(1) as f64;
        let reports = timed_model.walks().iter().map(|walk| {
            let report = walk.report(&refinable.sequence);
            (walk.pace().as_str(), report)
        });
        Self {
            name: timed_model.entry.name,
            bytes,
            bytes_per_vertex: per_vertex(bytes),
            parts: parts.iter().map(|part| (part.name.to_owned(), part.bytes.into())).collect(),
            total_bytes,
            ratio_to_plain: ratio(total_bytes),
            paper_bytes,
            short_paper_bytes: contender.paper_bytes(Accounting::ShortIntegers) + positions,
            paper_bytes_per_vertex: per_vertex(paper_bytes),
            paper_ratio_to_plain: ratio(paper_bytes),
            state_bytes: contender.state_bytes(),
            build_secs: contender.build_secs(),
            sweep_ns_per_step: timed_model.sweep().ns_per_step(),
            swept_step_count: timed_model.sweep().step_count(),
            seek_secs: timed_model.seek_secs(),
            draws_strips: contender.topology() == Topology::Strips,
            walks: reports.collect(),
        }
    }

    /// The report of one of its walks.
    pub(super) fn walk(&self, pace: Pace) -> &WalkReport {
        &self.walks[pace.as_str()]
    }
}

impl ModelsReport {
    /// Sentences naming the models that cannot be built, with reasons; empty if there are none.
    pub(super) fn refusals(&self) -> String {
        let why = |refusal: &RefusedModel| {
            format!(" {} cannot be built: {}.", refusal.name, refusal.cannot_be_built)
        };
        self.refused.iter().map(why).collect()
    }
}

/// Header and rows: memory and speed of the models.
pub(super) fn table(report: &ModelsReport) -> Vec<Vec<String>> {
    let head = [
        "model",
        "bytes per vertex",
        "with positions",
        "x plain",
        "as the papers count",
        "x plain",
        "instance",
        "build",
        "ns per step",
        "random access",
    ];
    let mut table = vec![head.map(str::to_owned).to_vec()];
    let per_vertex = |bytes: usize| format!("{:.1}", bytes as f64 / report.basis.vertex_count.max(1) as f64);
    for row in &report.rows {
        table.push(vec![
            row.name.to_owned(),
            format!("{:.1}", row.bytes_per_vertex),
            per_vertex(row.total_bytes),
            format!("{:.2}", row.ratio_to_plain),
            per_vertex(row.paper_bytes),
            format!("{:.2}", row.paper_ratio_to_plain),
            per_vertex(row.state_bytes),
            format_duration(row.build_secs),
            row.sweep_ns_per_step.map_or_else(|| "-".to_owned(), nanos),
            precise_duration(row.seek_secs),
        ]);
    }
    table
}

/// Header and rows of one walk.
pub(super) fn walk_table(report: &ModelsReport, pace: Pace) -> Vec<Vec<String>> {
    let head = ["model", "extraction", "with sending", "indices", "strips", "triangles"];
    let mut table = vec![head.map(str::to_owned).to_vec()];
    let rounded = |number: f64| format_count(number.round() as usize);
    for row in &report.rows {
        let walk = row.walk(pace);
        table.push(vec![
            row.name.to_owned(),
            precise_duration(walk.extract_secs),
            precise_duration(walk.extract_and_send_secs),
            rounded(walk.index_count),
            if row.draws_strips { rounded(walk.strip_count) } else { "-".to_owned() },
            rounded(walk.triangle_count),
        ]);
    }
    table
}

fn nanos(ns: f64) -> String {
    if ns < 1000.0 { format!("{ns:.1}") } else { format_count(ns.round() as usize) }
}

/// Formats a duration with enough digits to distinguish fast models.
fn precise_duration(secs: f64) -> String {
    if secs < 1e-4 { format!("{:.2} µs", secs * 1e6) } else { format_duration(secs) }
}

/// The tables, with explanations of their columns.
pub(super) fn to_text(report: &ModelsReport, text_of: impl Fn(Vec<Vec<String>>) -> String) -> String {
    let mut text =
        format!("Models: {}.{}\n{}", report.basis.summary(), report.refusals(), text_of(table(report)));
    for pace in Pace::ALL {
        let frames = report.basis.frames;
        text.push_str(&format!("\n{} walk, {frames} frames away and {frames} back: means\n", pace.title()));
        text.push_str(&text_of(walk_table(report, pace)));
    }
    text
}
