//! Data shared by all levels and views of one mesh.

use std::sync::OnceLock;

use crate::file::{DecodeError, EncodeError, FileModel, StriataFile, WriteOptions, to_striata};
use crate::mesh::RefinableMesh;
use crate::model::{FanOptions, FanScene, Fans};
use crate::view::Sphere;
use crate::{Cancelled, ProgressFn};

/// Metadata key and value by which a file records that its errors are guaranteed bounds.
const GUARANTEED_ERRORS: (&str, &str) = ("errors", "guaranteed");

/// The mesh in refinement order, and its fans once they are needed.
#[derive(Debug)]
pub(super) struct Tables {
    refinable: RefinableMesh,
    /// With the bounding sphere of all positions.
    fans: OnceLock<(Fans, Sphere)>,
    has_guaranteed_errors: bool,
}

impl Tables {
    pub(super) fn new(refinable: RefinableMesh, has_guaranteed_errors: bool) -> Self {
        Self { refinable, fans: OnceLock::new(), has_guaranteed_errors }
    }

    pub(super) fn new_with_progress(
        refinable: RefinableMesh,
        has_guaranteed_errors: bool,
        progress: &mut ProgressFn<'_>,
    ) -> Result<Self, Cancelled> {
        let fans = Fans::build_with(&refinable, &FanOptions::default(), progress)?;
        Ok(Self::new(refinable, has_guaranteed_errors).with_fans(fans))
    }

    pub(super) fn from_file(file: &StriataFile<'_>) -> Result<Self, DecodeError> {
        let refinable = file.refinable_mesh()?;
        let (key, value) = GUARANTEED_ERRORS;
        let has_guaranteed_errors = file.metadata()?.iter().any(|(k, v)| k == key && v == value);
        let tables = Self::new(refinable, has_guaranteed_errors);
        Ok(match file.fans() {
            Some(fans) => tables.with_fans(fans?),
            None => tables,
        })
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
        let mut options = options.clone();
        let (key, value) = GUARANTEED_ERRORS;
        if options.metadata.iter().all(|(k, _)| k != key) {
            let value = if self.has_guaranteed_errors { value } else { "estimated" };
            options = options.with_metadata(key, value);
        }
        to_striata(&self.refinable, &[FileModel::Fans(self.fans())], &options)
    }

    pub(super) fn refinable(&self) -> &RefinableMesh {
        &self.refinable
    }

    fn fans_and_sphere(&self) -> &(Fans, Sphere) {
        self.fans.get_or_init(|| self.with_sphere(Fans::build(&self.refinable)))
    }

    pub(super) fn fans(&self) -> &Fans {
        &self.fans_and_sphere().0
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
