//! Multiresolution models side by side: all are built from one sequence and one set of strips, held to the oracle,
//! and then timed at the same work.

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

use super::contenders::{Entry, Given, Unbuilt, entries};
use super::contest::{Contestant, hold};
use super::oracle::{Checked, check};
use super::walks::{Pace, WalkReport};
use crate::args::ModelArgs;
use striata_command::failure::Failure;
use striata_command::output::{Bar, format_count, format_duration};
use striata_command::strip_chain::TimedStrips;
use striata_command::strip_report::StripReport;

/// Bytes of a position: what the papers count for a vertex.
pub(super) const POSITION_BYTES: usize = 12;

/// What all models of a mesh were built from, and the models.
#[derive(Clone, Debug, Serialize)]
pub(super) struct ModelsReport {
    /// What they were built from.
    #[serde(rename = "models_of")]
    pub(super) basis: Basis,
    /// A row for each.
    #[serde(rename = "models")]
    pub(super) rows: Vec<ModelRow>,
    /// Those whose published form cannot hold the mesh.
    #[serde(rename = "models_refused")]
    refused: Vec<Refusal>,
}

/// A model whose published form cannot hold the mesh.
#[derive(Clone, Debug, Serialize)]
struct Refusal {
    name: &'static str,
    cannot_be_built: String,
}

/// What all models of a mesh were built from.
#[derive(Clone, Debug, Serialize)]
pub(super) struct Basis {
    /// Vertices after welding.
    pub(super) vertex_count: usize,
    /// Triangles after welding.
    pub(super) triangle_count: usize,
    step_count: usize,
    base_triangle_count: usize,
    /// Strips of the full mesh.
    pub(super) strips: StripReport,
    /// Positions, and the indices of those strips: a mesh without levels.
    pub(super) plain_bytes: usize,
    /// Seconds that the sequence took.
    pub(super) sequence_secs: f64,
    /// Of each way of a walk.
    pub(super) frames: usize,
    /// That the models took turns in.
    pub(super) rounds: usize,
}

/// What was measured of one model.
#[derive(Clone, Debug, Serialize)]
pub(super) struct ModelRow {
    /// The model.
    pub(super) name: &'static str,
    /// Of the static half, without positions.
    bytes: usize,
    bytes_per_vertex: f64,
    parts: Map<String, Value>,
    /// With positions.
    pub(super) total_bytes: usize,
    /// Of `total_bytes`.
    pub(super) ratio_to_plain: f64,
    /// With positions, as the papers count.
    pub(super) paper_bytes: usize,
    /// The same where an integer takes 2 bytes.
    pub(super) short_paper_bytes: usize,
    paper_bytes_per_vertex: f64,
    /// Of `paper_bytes`.
    pub(super) paper_ratio_to_plain: f64,
    /// Of an instance that shows the full mesh.
    state_bytes: usize,
    /// From the sequence and the strips.
    pub(super) build_secs: f64,
    /// None where the model has too few levels for steps.
    sweep_ns_per_step: Option<f64>,
    swept_step_count: usize,
    seek_secs: f64,
    /// Else it draws single triangles.
    #[serde(skip)]
    pub(super) draws_strips: bool,
    /// By pace.
    walks: BTreeMap<&'static str, WalkReport>,
}

/// A mesh with its sequence, which all models are built from.
#[derive(Debug)]
pub(super) struct Sequenced {
    /// The welded mesh with its sequence.
    pub(super) refinable: RefinableMesh,
    /// Seconds that it took.
    pub(super) secs: f64,
}

impl Sequenced {
    /// Welds and builds the sequence; with errors that hold in any state if asked to.
    ///
    /// # Errors
    /// Where the mesh does not hang together.
    pub(super) fn build(
        mesh: &IndexedMesh,
        is_certified: bool,
        bar: &mut Bar,
        say: &dyn Fn(&str),
    ) -> Result<Self, Failure> {
        say("the sequence");
        let started = Instant::now();
        // Published models are for manifolds and for steps that keep them: all models get what all can hold.
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

/// Builds the strips and the models, checks and times them.
///
/// # Errors
/// Where a name is no model, or a model shows something else than the sequence.
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
    let given =
        Given { refinable, fragmented: &fragmented, strips: &stripped.strips, level_strips: &level_strips };
    let (mut contestants, mut refused) = (Vec::new(), Vec::new());
    for entry in entries {
        say(entry.name);
        match entry.build(given) {
            Ok(contender) => contestants.push(Contestant::new(entry, contender, step_count, frames)),
            Err(Unbuilt::Refused(why)) => refused.push(Refusal { name: entry.name, cannot_be_built: why }),
            Err(Unbuilt::Failed(failure)) => return Err(failure),
        }
    }
    drop(fragmented);
    bar.phase("check");
    let mut checked: Vec<Checked<'_>> = contestants.iter_mut().map(Contestant::checked).collect();
    check(&mut checked, refinable)?;
    say("all models in turn");
    let rounds = hold(&mut contestants, step_count, &mut |share| bar.share("timing", share));
    let strips = StripReport::new(plan.chain.to_string(), &refinable.mesh, &stripped, plan.cache_size())?;
    let basis = Basis::new(refinable, (&stripped, strips), *sequence_secs, (frames, rounds));
    let rows = contestants.iter_mut().map(|contestant| ModelRow::new(contestant, refinable, &basis));
    Ok(ModelsReport { rows: rows.collect(), basis, refused })
}

impl Contestant {
    fn checked(&mut self) -> Checked<'_> {
        let Entry { name, has_few_levels, .. } = *self.entry;
        Checked { name, has_few_levels, contender: &mut *self.contender }
    }
}

impl Basis {
    fn new(
        refinable: &RefinableMesh,
        (stripped, strips): (&TimedStrips, StripReport),
        sequence_secs: f64,
        (frames, rounds): (usize, usize),
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

    /// What models are built from, in a sentence.
    pub(super) fn summary(&self) -> String {
        format!(
            "{} steps from {} triangles down to {}; {} strips ({}) of {} indices; positions and these take {:.1} bytes a vertex",
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
    fn new(contestant: &mut Contestant, refinable: &RefinableMesh, basis: &Basis) -> Self {
        contestant.contender.move_to(basis.step_count);
        let contender = &*contestant.contender;
        let parts = contender.bytes();
        let bytes: usize = parts.iter().map(|part| part.bytes).sum();
        let positions = POSITION_BYTES * basis.vertex_count;
        let (total_bytes, paper_bytes) =
            (bytes + positions, contender.paper_bytes(Accounting::Words) + positions);
        let ratio = |bytes: usize| bytes as f64 / basis.plain_bytes.max(1) as f64;
        let per_vertex = |bytes: usize| bytes as f64 / basis.vertex_count.max(1) as f64;
        let reports = contestant.walks().iter().map(|walk| {
            let report = walk.report(&refinable.sequence);
            (walk.pace().as_str(), report)
        });
        Self {
            name: contestant.entry.name,
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
            sweep_ns_per_step: contestant.sweep().ns_per_step(),
            swept_step_count: contestant.sweep().step_count(),
            seek_secs: contestant.seek_secs(),
            draws_strips: contender.topology() == Topology::Strips,
            walks: reports.collect(),
        }
    }

    /// What one of its walks took.
    pub(super) fn walk(&self, pace: Pace) -> &WalkReport {
        &self.walks[pace.as_str()]
    }
}

impl ModelsReport {
    /// Which models cannot be built, and why, in sentences; nothing where all can.
    pub(super) fn refusals(&self) -> String {
        let why =
            |refusal: &Refusal| format!(" {} cannot be built: {}.", refusal.name, refusal.cannot_be_built);
        self.refused.iter().map(why).collect()
    }
}

/// Head and rows: what models take, and how quickly they move.
pub(super) fn table(report: &ModelsReport) -> Vec<Vec<String>> {
    let head = [
        "model",
        "bytes a vertex",
        "with positions",
        "x plain",
        "as the papers count",
        "x plain",
        "instance",
        "build",
        "ns a step",
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
            precisely(row.seek_secs),
        ]);
    }
    table
}

/// Head and rows of one walk.
pub(super) fn walk_table(report: &ModelsReport, pace: Pace) -> Vec<Vec<String>> {
    let head = ["model", "extraction", "with sending", "indices", "strips", "triangles"];
    let mut table = vec![head.map(str::to_owned).to_vec()];
    let rounded = |number: f64| format_count(number.round() as usize);
    for row in &report.rows {
        let walk = row.walk(pace);
        table.push(vec![
            row.name.to_owned(),
            precisely(walk.extract_secs),
            precisely(walk.extract_and_send_secs),
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

/// A duration with digits that tell quick models apart.
fn precisely(secs: f64) -> String {
    if secs < 1e-4 { format!("{:.2} µs", secs * 1e6) } else { format_duration(secs) }
}

/// The tables for people, with what is to be known about them.
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
