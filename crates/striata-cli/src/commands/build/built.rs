//! A mesh with its steps and models: all that a .striata file holds.

use striata::file::{DecodeError, StriataFile, WriteOptions, to_striata, write_fragments};
use striata::mesh::{IndexedMesh, RefinableMesh, weld};
use striata::model::{LodStrips, ModelKind};
use striata::simplify::{StopReason, Target};
use striata_stream::{EncodedStream, StreamOptions, encode_stream};

use super::models::{Models, takes_strips};
use crate::args::BuildArgs;
use striata_command::args::{OrderArg, SequenceArgs};
use striata_command::clock::Phases;
use striata_command::failure::Failure;
use striata_command::level::{Floor, Reached, shortfall};
use striata_command::output::Bar;
use striata_command::sequence::{SequencePlan, SimplifiedSteps, StepKind, Steps};
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
    pub(super) steps: Steps,
    pub(super) models: Models,
    pub(super) order: OrderArg,
    pub(super) stop_reason: StopReason,
    pub(super) error_is_guaranteed: bool,
    /// Where a model needs strips.
    pub(super) strip_report: Option<StripReport>,
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
    let SimplifiedSteps { steps, stop_reason, error_is_guaranteed, .. } = sequenced;
    Ok(Built { steps, models, order, stop_reason, error_is_guaranteed, strip_report })
}

/// The stream, where it is asked for; the mesh is in its order afterwards, so that all models number levels as it does.
pub(super) fn stream_of(
    sequenced: &mut SimplifiedSteps,
    plan: &BuildPlan,
) -> Result<Option<EncodedStream>, Failure> {
    let (Steps::Collapses(refinable), Some(batches)) = (&mut sequenced.steps, &sequenced.batches) else {
        return Ok(None);
    };
    let stream = encode_stream(refinable, batches, &plan.stream)?;
    *refinable = stream.reorder(refinable);
    Ok(Some(stream))
}

impl Built {
    /// Why the base has more triangles than asked for, if it has.
    pub(super) fn shortfall(&self, base: usize, sequence: &SequenceArgs) -> Option<String> {
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
