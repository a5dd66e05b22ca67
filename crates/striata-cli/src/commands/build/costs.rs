//! Sizes and build times of every model of a mesh, for `info --models`.
//!
//! Each model is built from the steps that a build of this model alone would use.

use std::time::Instant;

use serde::Serialize;
use striata::mesh::{IndexedMesh, weld};
use striata::model::{FanInstance, LodModel, ModelKind, PartBytes, PatternInstance};

use super::build_output::stream_of;
use super::models::BuildPlan;
use super::models::Models;
use striata_command::args::StreamArgs;
use striata_command::failure::Failure;
use striata_command::output::Bar;
use striata_command::sequence::{SequencePlan, SimplifiedSteps};

/// Size and build time of one model.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct ModelCost {
    /// Name of the model.
    pub name: &'static str,
    /// Size of all its parts.
    pub bytes: usize,
    /// Size per vertex of the welded mesh.
    pub bytes_per_vertex: f64,
    /// Additional size of each instance; `None` for a stream, which is decoded once for all instances.
    pub instance_bytes: Option<usize>,
    /// Time to build the model from existing steps and strips, seconds.
    pub build_secs: f64,
}

/// Builds every model of a mesh with default options.
///
/// # Errors
/// If the mesh is inconsistent.
pub(crate) fn model_costs(mesh: &IndexedMesh, bar: &mut Bar) -> Result<Vec<ModelCost>, Failure> {
    let plan = BuildPlan::with_defaults();
    bar.phase("simplify");
    let sequenced = steps(mesh, &plan.sequence, bar)?;
    bar.phase("strip");
    let stripped = plan.strips.run(sequenced.steps.mesh(), &mut |share| bar.share("strip", share))?;
    bar.phase("models");
    let mut costs = Vec::new();
    for kind in ModelKind::ALL.into_iter().filter(|&kind| kind != ModelKind::Progressive) {
        let started = Instant::now();
        let strips = Some(plan.strip_source(&stripped.strips));
        let plan = BuildPlan { models: vec![kind], ..plan.clone() };
        let models = Models::build(&plan, &sequenced, strips, None, bar)?;
        costs.extend(costs_of(&models, &sequenced, started.elapsed().as_secs_f64()));
    }
    // A stream needs collapses in batches, so the mesh is simplified again.
    bar.phase("simplify");
    let mut plan = BuildPlan { models: vec![ModelKind::Progressive], ..plan };
    plan.sequence.use_batches(StreamArgs::default().batches(mesh)?)?;
    let mut sequenced = steps(mesh, &plan.sequence, bar)?;
    bar.phase("encode");
    let started = Instant::now();
    let stream = stream_of(&mut sequenced, &plan)?;
    let build_secs = started.elapsed().as_secs_f64();
    let models = Models::build(&plan, &sequenced, None, stream, bar)?;
    costs.extend(costs_of(&models, &sequenced, build_secs));
    Ok(costs)
}

fn steps(mesh: &IndexedMesh, plan: &SequencePlan, bar: &mut Bar) -> Result<SimplifiedSteps, Failure> {
    Ok(plan.run(weld(mesh)?, &mut |progress| bar.show(progress))?)
}

fn costs_of(models: &Models, sequenced: &SimplifiedSteps, build_secs: f64) -> Vec<ModelCost> {
    let vertex_count = sequenced.steps.mesh().vertex_count().max(1);
    let cost = |(kind, parts): (ModelKind, Vec<PartBytes>)| {
        let bytes = parts.iter().map(|part| part.bytes).sum::<usize>();
        ModelCost {
            name: kind.as_str(),
            bytes,
            bytes_per_vertex: bytes as f64 / vertex_count as f64,
            instance_bytes: instance_bytes(models, kind),
            build_secs,
        }
    };
    models.parts().into_iter().map(cost).collect()
}

/// Returns the size of an instance at full detail; for fans and patterns, of an instance that supports views.
fn instance_bytes(models: &Models, kind: ModelKind) -> Option<usize> {
    fn of_state<M: LodModel>(model: &M) -> usize {
        model.state_bytes(&model.new_state())
    }
    match kind {
        ModelKind::LodStrips => models.lod_strips.as_ref().map(of_state),
        ModelKind::Mts => models.mts.as_ref().map(of_state),
        ModelKind::Fans => models.fans.as_ref().map(|fans| FanInstance::full(fans).bytes()),
        ModelKind::Patterns => {
            models.patterns.as_ref().map(|patterns| PatternInstance::full(patterns).bytes())
        }
        _ => None,
    }
}
