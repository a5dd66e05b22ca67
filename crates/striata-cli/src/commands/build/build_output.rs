//! Builds everything that a .striata file contains: the steps of a mesh and its models.

use striata::file::{WriteOptions, to_striata, write_fragments};
use striata::mesh::{IndexedMesh, RefinableMesh, weld};
use striata::model::LodStrips;
use striata::simplify::{StopReason, Target};
use striata_stream::{EncodedStream, encode_stream};

use super::models::{BuildPlan, Models, takes_strips};
use striata::mesh::Steps;
use striata_command::args::{OrderArg, SequenceArgs};
use striata_command::clock::Phases;
use striata_command::failure::Failure;
use striata_command::level::{CoarseningLimit, ReachedLevel, shortfall};
use striata_command::output::Bar;
use striata_command::sequence::{SimplifiedSteps, StepKind};
use striata_command::strip_report::StripReport;

/// Phases of a build whose times are reported.
pub(crate) const PHASES: [&str; 6] = ["read", "weld", "simplify", "strip", "models", "write"];

/// The contents of a .striata file.
#[derive(Debug)]
pub(crate) struct BuildOutput {
    pub steps: Steps,
    pub(super) models: Models,
    pub order: OrderArg,
    pub stop_reason: StopReason,
    pub error_is_guaranteed: bool,
    /// Report on the strips, if a model needs strips.
    pub strip_report: Option<StripReport>,
}

/// Builds the sequence, the strips and the models of a mesh.
///
/// # Errors
/// If the mesh is inconsistent or an option is out of range.
pub(crate) fn build(
    mesh: &IndexedMesh,
    plan: &BuildPlan,
    phases: &mut Phases,
    bar: &mut Bar,
) -> Result<BuildOutput, Failure> {
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
    let stripped = if has_strips { Some(plan.strips_of(full, bar)?) } else { None };
    let report = |stripped| -> Result<StripReport, Failure> {
        let report = StripReport::new(plan.algorithm(), full, stripped, plan.strips.cache_size())?;
        Ok(report.with_strip_count_bound(&plan.strips.chain, full))
    };
    let strip_report = stripped.as_ref().map(report).transpose()?;
    phases.enter("models");
    bar.phase("models");
    let strips = stripped.as_ref().map(|stripped| plan.strip_source(&stripped.strips));
    let models = Models::build(plan, &sequenced, strips, stream, bar)?;
    let order = plan.sequence.order();
    let SimplifiedSteps { steps, stop_reason, error_is_guaranteed, .. } = sequenced;
    Ok(BuildOutput { steps, models, order, stop_reason, error_is_guaranteed, strip_report })
}

/// Encodes the stream if the collapses are in batches, and reorders the mesh like the stream, so that split
/// counts mean the same in all models.
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

impl BuildOutput {
    /// Explains why the base mesh has more triangles than requested, if it does.
    pub(super) fn shortfall(&self, base: usize, sequence: &SequenceArgs) -> Option<String> {
        let levels = self.steps.levels();
        let reached = ReachedLevel {
            vertex_count: levels.base_vertex_count(),
            triangle_count: levels.triangle_count_at(0),
            stop_reason: self.stop_reason,
        };
        let kind = if self.models.stream.is_some() { StepKind::Batches } else { StepKind::Single };
        let why = sequence.describe_limit(kind);
        shortfall(Target::Triangles(base), reached, &CoarseningLimit::Simplification(why))
    }

    /// Returns the mesh in refinement order with its collapses.
    ///
    /// # Panics
    /// If the steps are not collapses.
    pub(crate) fn refinable(&self) -> &RefinableMesh {
        match &self.steps {
            Steps::Collapses(refinable) => refinable,
            Steps::Fragments(_) => panic!("built with collapses"),
        }
    }

    /// Returns the LodStrips model.
    ///
    /// # Panics
    /// If it was not built.
    pub(crate) fn lod_strips(&self) -> &LodStrips<'static> {
        self.models.lod_strips.as_ref().expect("built with LodStrips")
    }

    /// Encodes the .striata file; `source` is the name of the input, stored as metadata.
    ///
    /// # Errors
    /// If a part cannot be encoded.
    pub(crate) fn to_bytes(&self, source: &str) -> Result<Vec<u8>, Failure> {
        let options = WriteOptions::default()
            .with_metadata("creator", concat!("striata ", env!("CARGO_PKG_VERSION")))
            .with_metadata("source", source)
            .with_metadata("order", self.order.as_str())
            .with_guaranteed_errors(self.error_is_guaranteed);
        let models = self.models.in_file()?;
        match &self.steps {
            Steps::Collapses(refinable) => Ok(to_striata(refinable, &models, &options)?),
            Steps::Fragments(fragmented) => {
                let mut bytes = Vec::new();
                write_fragments(fragmented, &models, &options, &mut bytes)?;
                Ok(bytes)
            }
        }
    }
}
