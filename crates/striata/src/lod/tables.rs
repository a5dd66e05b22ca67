//! Data shared by all levels and views of one mesh.

use std::sync::{Mutex, OnceLock, PoisonError};

use crate::file::{DecodeError, EncodeError, FileModel, StriataFile, WriteOptions, to_striata};
use crate::mesh::{FragmentedMesh, RefinableMesh};
use crate::model::{FanOptions, FanScene, Fans, LodStrips, ModelError, Mts, Patterns, StageOptions};
use crate::strip::{StripSet, stripify};
use crate::view::Sphere;
use crate::{Cancelled, ProgressFn};

/// The mesh in refinement order, and each model once it is needed.
#[derive(Debug)]
pub(super) struct LodTables {
    refinable: RefinableMesh,
    /// Vertex of the input that each vertex came from; empty if that is unknown.
    source_vertices: Vec<u32>,
    /// With the bounding sphere of all positions.
    fans: OnceLock<(Fans, Sphere)>,
    /// Held by the call that builds the fans and can be cancelled, so that others wait for it.
    preparing: Mutex<()>,
    strips: OnceLock<Result<LodStrips<'static>, ModelError>>,
    mts: OnceLock<Result<Mts<'static>, ModelError>>,
    patterns: OnceLock<Result<Patterns, ModelError>>,
    has_guaranteed_errors: bool,
}

impl LodTables {
    pub(super) fn new(refinable: RefinableMesh, has_guaranteed_errors: bool) -> Self {
        Self {
            refinable,
            source_vertices: Vec::new(),
            fans: OnceLock::new(),
            preparing: Mutex::new(()),
            strips: OnceLock::new(),
            mts: OnceLock::new(),
            patterns: OnceLock::new(),
            has_guaranteed_errors,
        }
    }

    pub(super) fn from_file(file: &StriataFile<'_>) -> Result<Self, DecodeError> {
        let refinable = file.refinable_mesh()?;
        let tables = Self::new(refinable, file.has_guaranteed_errors()?);
        Ok(match file.fans() {
            Some(fans) => tables.with_fans(fans?),
            None => tables,
        })
    }

    pub(super) fn with_source_vertices(self, source_vertices: Vec<u32>) -> Self {
        Self { source_vertices, ..self }
    }

    fn with_fans(mut self, fans: Fans) -> Self {
        self.fans = self.with_sphere(fans).into();
        self
    }

    fn with_sphere(&self, fans: Fans) -> (Fans, Sphere) {
        let sphere = FanScene::new(&fans, &self.refinable.mesh.positions).sphere();
        (fans, sphere)
    }

    pub(super) fn to_striata(&self, options: &WriteOptions) -> Result<Vec<u8>, EncodeError> {
        let options = options.clone().with_guaranteed_errors(self.has_guaranteed_errors);
        let models: Vec<FileModel<'_>> = (built(&self.strips).map(FileModel::LodStrips).into_iter())
            .chain(built(&self.mts).map(FileModel::Mts))
            .chain([FileModel::Fans(self.fans())])
            .chain(built(&self.patterns).map(FileModel::Patterns))
            .collect();
        to_striata(&self.refinable, &models, &options)
    }

    pub(super) fn refinable(&self) -> &RefinableMesh {
        &self.refinable
    }

    pub(super) fn source_vertices(&self) -> &[u32] {
        &self.source_vertices
    }

    fn fans_and_sphere(&self) -> &(Fans, Sphere) {
        self.fans.get_or_init(|| self.with_sphere(Fans::build(&self.refinable)))
    }

    /// Builds the fans, unless they are there.
    ///
    /// # Errors
    /// [`Cancelled`] if the callback cancels; the next call builds them.
    pub(super) fn prepare_fans(&self, progress: &mut ProgressFn<'_>) -> Result<(), Cancelled> {
        let _guard = self.preparing.lock().unwrap_or_else(PoisonError::into_inner);
        if self.fans.get().is_none() {
            let fans = Fans::build_with(&self.refinable, &FanOptions::default(), progress)?;
            let _ = self.fans.set(self.with_sphere(fans));
        }
        Ok(())
    }

    pub(super) fn fans(&self) -> &Fans {
        &self.fans_and_sphere().0
    }

    /// LodStrips, which get new strips where a level would need too many indices.
    pub(super) fn strips(&self) -> Result<&LodStrips<'static>, ModelError> {
        let of_level =
            |level: &_| Ok::<_, ModelError>(stripify(level).expect("a level of a mesh that was checked"));
        let build = || {
            LodStrips::build_staged(&self.refinable, &self.full_strips(), &StageOptions::default(), of_level)
        };
        self.strips.get_or_init(build).as_ref().map_err(Clone::clone)
    }

    /// Takes over a model, unless there is one.
    ///
    /// # Errors
    /// [`ModelError`] if it does not belong to the mesh.
    pub(super) fn set_strips(&self, strips: LodStrips<'static>) -> Result<(), ModelError> {
        strips.check_mesh(&self.refinable)?;
        let _ = self.strips.set(Ok(strips));
        Ok(())
    }

    pub(super) fn mts(&self) -> Result<&Mts<'static>, ModelError> {
        let build = || Mts::build(&self.refinable, &self.full_strips());
        self.mts.get_or_init(build).as_ref().map_err(Clone::clone)
    }

    pub(super) fn patterns(&self) -> Result<&Patterns, ModelError> {
        let build = || Patterns::build(&FragmentedMesh::from_collapses(&self.refinable));
        self.patterns.get_or_init(build).as_ref().map_err(Clone::clone)
    }

    fn full_strips(&self) -> StripSet {
        stripify(&self.refinable.mesh).expect("a mesh that was checked")
    }

    pub(super) fn scene(&self) -> FanScene<'_> {
        FanScene::new(self.fans(), &self.refinable.mesh.positions)
    }

    pub(super) fn sphere(&self) -> Sphere {
        self.fans_and_sphere().1
    }

    pub(super) fn has_guaranteed_errors(&self) -> bool {
        self.has_guaranteed_errors
    }
}

/// Returns a model that was built, or taken over.
fn built<M>(model: &OnceLock<Result<M, ModelError>>) -> Option<&M> {
    model.get()?.as_ref().ok()
}
