//! The loaded mesh with its steps, and the models that were stored with it or have been built since.

use std::sync::OnceLock;

use striata::mesh::{Bounds, FragmentedMesh, RefinableMesh};
use striata::model::{FanScene, Fans, LodStrips, Mts, PatternScene, Patterns};
use striata::strip::{StripSet, stripify};
use striata::view::Sphere;
use striata_strip::{LiveStrips, RepairOptions};

use super::args::ShownModel;
use super::subject::Origin;
use striata::mesh::Steps;
use striata_command::failure::Failure;

/// One mesh and its models. Missing models are built on demand, once, on a background thread.
#[derive(Debug)]
pub(super) struct MeshSubject {
    pub origin: Origin,
    pub steps: Steps,
    /// Models that the file contained.
    pub stored: Vec<ShownModel>,
    pub bounds: Bounds,
    /// Bounding sphere of all positions.
    pub sphere: Sphere,
    strips: OnceLock<StripSet>,
    lod_strips: OnceLock<LodStrips<'static>>,
    /// Strips of the full mesh, which instances copy.
    live_strips: OnceLock<LiveStrips<'static>>,
    mts: OnceLock<Mts<'static>>,
    fans: OnceLock<Fans>,
    patterns: OnceLock<Patterns>,
}

/// Models read from a file.
#[derive(Debug, Default)]
pub(super) struct StoredModels {
    pub strips: Option<StripSet>,
    pub lod_strips: Option<LodStrips<'static>>,
    pub mts: Option<Mts<'static>>,
    pub fans: Option<Fans>,
    pub patterns: Option<Patterns>,
}

impl MeshSubject {
    /// Creates a subject from a mesh and its models.
    pub(super) fn new(origin: Origin, steps: Steps, models: StoredModels) -> Self {
        let bounds = steps.mesh().bounds().unwrap_or(Bounds { min: [0.0; 3], max: [0.0; 3] });
        let sphere = sphere_around(&steps.mesh().positions, &bounds);
        let is_stored = [
            (ShownModel::LodStrips, models.lod_strips.is_some()),
            (ShownModel::Mts, models.mts.is_some()),
            (ShownModel::Fans, models.fans.is_some()),
            (ShownModel::Patterns, models.patterns.is_some()),
        ];
        let stored =
            is_stored.into_iter().filter(|&(_, is_stored)| is_stored).map(|(kind, _)| kind).collect();
        Self {
            origin,
            steps,
            stored,
            bounds,
            sphere,
            strips: once_lock(models.strips),
            lod_strips: once_lock(models.lod_strips),
            live_strips: OnceLock::new(),
            mts: once_lock(models.mts),
            fans: once_lock(models.fans),
            patterns: once_lock(models.patterns),
        }
    }

    /// Whether the mesh has collapses, which models of strips need.
    pub(super) fn has_collapses(&self) -> bool {
        matches!(self.steps, Steps::Collapses(_))
    }

    /// The mesh with its collapses, if it has any.
    pub(super) fn refinable(&self) -> Option<&RefinableMesh> {
        match &self.steps {
            Steps::Collapses(refinable) => Some(refinable),
            Steps::Fragments(_) => None,
        }
    }

    /// Whether a model is available.
    pub(super) fn has(&self, kind: ShownModel) -> bool {
        match kind {
            ShownModel::List => true,
            ShownModel::LodStrips => self.lod_strips.get().is_some(),
            ShownModel::LiveStrips => self.live_strips.get().is_some(),
            ShownModel::Mts => self.mts.get().is_some(),
            ShownModel::Fans | ShownModel::FansGpu => self.fans.get().is_some(),
            ShownModel::Patterns => self.patterns.get().is_some(),
        }
    }

    /// The LodStrips model, if available.
    pub(super) fn lod_strips(&self) -> Option<&LodStrips<'static>> {
        self.lod_strips.get()
    }

    /// Live strips at the full mesh, if available.
    pub(super) fn live_strips(&self) -> Option<&LiveStrips<'static>> {
        self.live_strips.get()
    }

    /// The MTS model, if available.
    pub(super) fn mts(&self) -> Option<&Mts<'static>> {
        self.mts.get()
    }

    /// The fans and the data to refine them for a view, if available.
    pub(super) fn fan_scene(&self) -> Option<FanScene<'_>> {
        Some(FanScene::new(self.fans.get()?, &self.steps.mesh().positions))
    }

    /// The patterns and the data to refine them for a view, if available.
    pub(super) fn pattern_scene(&self) -> Option<PatternScene<'_>> {
        Some(PatternScene::new(self.patterns.get()?, &self.steps.mesh().positions))
    }

    /// Builds a model if it is missing. If two threads build the same model, one result is dropped.
    ///
    /// # Errors
    /// If the model needs collapses and the mesh has none, or building fails.
    pub(super) fn build(&self, kind: ShownModel) -> Result<(), Failure> {
        if self.has(kind) {
            return Ok(());
        }
        match (kind, &self.steps) {
            (ShownModel::List, _) => {}
            (ShownModel::LodStrips, Steps::Collapses(refinable)) => {
                let model = LodStrips::build(refinable, self.strips(refinable)?)?;
                let _ = self.lod_strips.set(model);
            }
            (ShownModel::LiveStrips, Steps::Collapses(refinable)) => {
                let (full, strips) = (refinable.sequence.step_count(), self.strips(refinable)?);
                let live = LiveStrips::new(refinable, full, strips, &RepairOptions::default());
                let live = live.map_err(|error| {
                    Failure::user(format!("{}: {error}", self.origin.name))
                        .with_hint("the strips in the file are damaged; build it again")
                })?;
                let _ = self.live_strips.set(live.into_owned());
            }
            (ShownModel::Mts, Steps::Collapses(refinable)) => {
                let model = Mts::build(refinable, self.strips(refinable)?)?;
                let _ = self.mts.set(model);
            }
            (ShownModel::Fans | ShownModel::FansGpu, Steps::Collapses(refinable)) => {
                let _ = self.fans.set(Fans::build(refinable));
            }
            (ShownModel::Fans | ShownModel::FansGpu, Steps::Fragments(fragmented)) => {
                let _ = self.fans.set(Fans::build(fragmented));
            }
            (ShownModel::Patterns, Steps::Collapses(refinable)) => {
                self.set_patterns(&FragmentedMesh::from_collapses(refinable))?;
            }
            (ShownModel::Patterns, Steps::Fragments(fragmented)) => self.set_patterns(fragmented)?,
            (kind, Steps::Fragments(_)) => {
                let message = format!(
                    "{}: the model {} needs collapses, but this file has none",
                    self.origin.name,
                    kind.title()
                );
                return Err(Failure::user(message).with_hint("choose Fans, Patterns or List"));
            }
        }
        Ok(())
    }

    fn set_patterns(&self, fragmented: &FragmentedMesh) -> Result<(), Failure> {
        let _ = self.patterns.set(Patterns::build(fragmented)?);
        Ok(())
    }

    /// The strips of the file, or strips computed by the default stripifier.
    fn strips(&self, refinable: &RefinableMesh) -> Result<&StripSet, Failure> {
        if self.strips.get().is_none() {
            let _ = self.strips.set(stripify(&refinable.mesh)?);
        }
        self.strips.get().ok_or_else(|| Failure::internal("the strips are missing after they were set"))
    }
}

fn once_lock<T>(value: Option<T>) -> OnceLock<T> {
    value.map_or_else(OnceLock::new, OnceLock::from)
}

fn sphere_around(positions: &[[f32; 3]], bounds: &Bounds) -> Sphere {
    let center = std::array::from_fn(|k| bounds.min[k] / 2.0 + bounds.max[k] / 2.0);
    positions.iter().fold(Sphere::point(center), |sphere, &position| sphere.with_point(position))
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;
    use striata::mesh::{IndexedMesh, shapes, weld};
    use striata_command::sequence::SequencePlan;

    pub(in super::super) fn subject_of(mesh: &IndexedMesh) -> MeshSubject {
        let welded = weld(mesh).expect("a sound mesh");
        let sequenced =
            SequencePlan::default().run(welded, &mut striata::ignore_progress).expect("sound options");
        let origin = Origin { name: "a shape".to_owned(), kind: "shape", ..Origin::default() };
        MeshSubject::new(origin, sequenced.steps, StoredModels::default())
    }

    #[test]
    fn every_model_can_be_built_and_stays() {
        let subject = subject_of(&shapes::torus(24, 12, 1.0, 0.4));
        let available: Vec<ShownModel> =
            ShownModel::ALL.into_iter().filter(|&kind| subject.has(kind)).collect();
        assert_eq!(available, [ShownModel::List]);
        for kind in ShownModel::ALL {
            subject.build(kind).expect("all models can be built from collapses");
            assert!(subject.has(kind));
        }
        assert!(subject.fan_scene().is_some() && subject.pattern_scene().is_some());
        assert!(subject.sphere.radius as f64 <= subject.bounds.diagonal() / 2.0 + 1e-4);
    }

    #[test]
    fn fragments_support_fans_and_patterns() {
        let refinable = subject_of(&shapes::icosphere(2, 1.0));
        let refinable = refinable.refinable().expect("collapses");
        let steps = Steps::Fragments(FragmentedMesh::from_collapses(refinable));
        let origin = Origin { name: "a".to_owned(), kind: "striata", ..Origin::default() };
        let subject = MeshSubject::new(origin, steps, StoredModels::default());
        assert!(!subject.has_collapses());
        assert!(subject.build(ShownModel::Mts).is_err() && subject.build(ShownModel::LodStrips).is_err());
        for kind in [ShownModel::Fans, ShownModel::FansGpu, ShownModel::Patterns, ShownModel::List] {
            subject.build(kind).expect("these can be built from fragments");
        }
        assert!(subject.fan_scene().is_some() && subject.pattern_scene().is_some());
    }
}
