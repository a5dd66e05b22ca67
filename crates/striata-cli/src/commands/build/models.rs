//! Builds models by name and prepares them for a .striata file.

use std::time::Instant;

use striata::file::FileModel;
use striata::mesh::{IndexedMesh, RefinableMesh};
use striata::model::{Fans, LodModel, LodStrips, ModelKind, Mts, PartBytes, Patterns, StageOptions};
use striata::simplify::{SimplifyError, certify_faces_with_progress};
use striata::strip::StripSet;
use striata_stream::{EncodedStream, StreamOptions, file_model};

use super::strips_from::StripsFrom;
use crate::args::BuildArgs;
use striata::mesh::Steps;
use striata_command::failure::{Failure, unknown_name};
use striata_command::output::Bar;
use striata_command::sequence::{SequencePlan, SimplifiedSteps};
use striata_command::strip_chain::{StripPlan, TimedStrips};

/// Parses the name of a model.
///
/// # Errors
/// If the name is unknown.
pub(crate) fn model_of_name(name: &str) -> Result<ModelKind, Failure> {
    name.parse().map_err(|_| unknown_name("model", name, &ModelKind::ALL.map(ModelKind::as_str)))
}

/// The parts that a file has, without what is made of them in memory.
pub(crate) fn parts_in_file(mut parts: Vec<PartBytes>) -> Vec<PartBytes> {
    parts.retain(|part| ![Fans::MADE_RECORDS, LodStrips::LATER_STRIPS].contains(&part.name));
    parts
}

/// Options of a build.
#[derive(Clone, Debug)]
pub(crate) struct BuildPlan {
    /// How the mesh is simplified.
    pub sequence: SequencePlan,
    /// How its strips are made.
    pub strips: StripPlan,
    /// Strips of the full mesh to begin with.
    pub strips_from: Option<StripsFrom>,
    /// When LodStrips begin a stage with new strips.
    pub stages: StageOptions,
    /// The models to build.
    pub models: Vec<ModelKind>,
    /// How the stream is encoded, if there is one.
    pub stream: StreamOptions,
    /// Whether patterns store an error for each overlap.
    pub has_overlap_errors: bool,
}

impl BuildPlan {
    /// Returns the plan that is used without any flags.
    pub(crate) fn with_defaults() -> Self {
        Self {
            sequence: SequencePlan::default(),
            strips: BuildArgs::default_strip_plan(),
            strips_from: None,
            stages: StageOptions::default(),
            models: vec![ModelKind::LodStrips],
            stream: StreamOptions::default(),
            has_overlap_errors: false,
        }
    }

    /// Makes the strips of the full mesh.
    pub(super) fn strips_of(&self, full: &IndexedMesh, bar: &mut Bar) -> Result<TimedStrips, Failure> {
        let started = Instant::now();
        let start = self.strips_from.as_ref().map(|from| from.strips_of(full)).transpose()?;
        if self.strips_from.as_ref().is_some_and(|from| from.are_final) {
            let strips = start.unwrap_or_default();
            return Ok(TimedStrips { strips, secs: started.elapsed().as_secs_f64() });
        }
        Ok(self.strips.run_from(full, start.unwrap_or_default(), &mut |share| bar.share("strip", share))?)
    }

    /// Returns the name of how the strips are made.
    pub(super) fn algorithm(&self) -> String {
        match &self.strips_from {
            Some(from) if from.are_final => from.name().to_owned(),
            Some(from) => format!("{}+{}", from.name(), self.strips.chain),
            None => self.strips.chain.to_string(),
        }
    }

    /// Returns strips of the full mesh together with how those of later stages are made.
    pub(super) fn strip_source<'a>(&'a self, full: &'a StripSet) -> StripSource<'a> {
        StripSource { full, plan: &self.strips, stages: self.stages }
    }
}

/// Whether a model is built from strips.
pub(super) fn takes_strips(model: &ModelKind) -> bool {
    matches!(model, ModelKind::LodStrips | ModelKind::Mts)
}

/// The strips that models are built from.
#[derive(Clone, Copy, Debug)]
pub(super) struct StripSource<'a> {
    /// Strips of the full mesh.
    pub full: &'a StripSet,
    /// How they were made, and how those of later stages are.
    pub plan: &'a StripPlan,
    /// When LodStrips begin a stage.
    pub stages: StageOptions,
}

impl StripSource<'_> {
    /// Builds LodStrips, with new strips for each stage.
    fn lod_strips(&self, refinable: &RefinableMesh) -> Result<LodStrips<'static>, Failure> {
        let full_count = refinable.mesh.triangle_count();
        LodStrips::build_staged(refinable, self.full, &self.stages, |level| {
            Ok(self.plan.run_for_level(level, full_count)?)
        })
    }
}

/// The requested models.
#[derive(Debug)]
pub(super) struct Models {
    pub lod_strips: Option<LodStrips<'static>>,
    pub mts: Option<Mts<'static>>,
    pub fans: Option<Fans>,
    pub patterns: Option<Patterns>,
    /// The progressive stream; the mesh is in its order.
    pub stream: Option<EncodedStream>,
}

impl Models {
    /// Builds the models; those with strips only if strips are given.
    ///
    /// # Errors
    /// If the strips do not belong to the mesh, or there are too many fragments.
    pub(super) fn build(
        plan: &BuildPlan,
        sequenced: &SimplifiedSteps,
        strips: Option<StripSource<'_>>,
        stream: Option<EncodedStream>,
        bar: &mut Bar,
    ) -> Result<Self, Failure> {
        let is_wanted = |kind: ModelKind| plan.models.contains(&kind);
        let mut models = Self { lod_strips: None, mts: None, fans: None, patterns: None, stream };
        if let Steps::Collapses(refinable) = &sequenced.steps {
            let strips_for = |kind| strips.filter(|_| is_wanted(kind));
            models.lod_strips =
                strips_for(ModelKind::LodStrips).map(|strips| strips.lod_strips(refinable)).transpose()?;
            models.mts =
                strips_for(ModelKind::Mts).map(|strips| Mts::build(refinable, strips.full)).transpose()?;
        }
        models.fans = is_wanted(ModelKind::Fans).then(|| Fans::build(&sequenced.steps));
        if is_wanted(ModelKind::Patterns) {
            let fragmented = sequenced.fragments(&mut |progress| bar.show(progress))?;
            models.patterns = Some(if plan.has_overlap_errors {
                let certified = certify_faces_with_progress(&fragmented, &mut |progress| bar.show(progress))
                    .map_err(SimplifyError::from)?;
                Patterns::build_with_overlap_errors(&certified.fragmented, &certified.face_errors)?
            } else {
                Patterns::build(&fragmented)?
            });
        }
        Ok(models)
    }

    /// Returns the models in the form in which a file stores them.
    pub(super) fn in_file(&self) -> Result<Vec<FileModel<'_>>, Failure> {
        let lod_strips = self.lod_strips.iter().map(FileModel::LodStrips);
        let fans = self.fans.iter().map(FileModel::Fans);
        let patterns = self.patterns.iter().map(FileModel::Patterns);
        let stream = self.stream.as_ref().map(|stream| file_model(&stream.bytes)).transpose()?;
        let of_strips = lod_strips.chain(self.mts.iter().map(FileModel::Mts));
        Ok(of_strips.chain(fans).chain(patterns).chain(stream).collect())
    }

    /// Returns the sizes of the parts of each model.
    pub(super) fn parts(&self) -> Vec<(ModelKind, Vec<PartBytes>)> {
        let in_file = |kind: ModelKind, parts| (kind, parts_in_file(parts));
        let lod_strips = self.lod_strips.iter().map(|model| in_file(ModelKind::LodStrips, model.bytes()));
        let mts = self.mts.iter().map(|model| (ModelKind::Mts, model.bytes()));
        let fans = self.fans.iter().map(|model| in_file(ModelKind::Fans, model.bytes()));
        let patterns = self.patterns.iter().map(|model| (ModelKind::Patterns, model.bytes()));
        let parts_of_stream = |s: &EncodedStream| vec![PartBytes { name: "stream", bytes: s.bytes.len() }];
        let streams = self.stream.iter().map(|stream| (ModelKind::Progressive, parts_of_stream(stream)));
        lod_strips.chain(mts).chain(fans).chain(patterns).chain(streams).collect()
    }
}
