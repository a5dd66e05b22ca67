//! Data shared by all levels and views of one mesh.

use crate::file::{DecodeError, EncodeError, FileModel, StriataFile, WriteOptions, to_striata};
use crate::mesh::RefinableMesh;
use crate::model::{FanOptions, FanScene, Fans};
use crate::view::Sphere;
use crate::{Cancelled, ProgressFn};

/// Metadata key and value by which a file records that its errors are guaranteed bounds.
const GUARANTEED_ERRORS: (&str, &str) = ("errors", "guaranteed");

/// The mesh in refinement order, with its fans.
#[derive(Debug)]
pub(super) struct Tables {
    refinable: RefinableMesh,
    fans: Fans,
    /// Bounding sphere of all positions.
    sphere: Sphere,
    has_guaranteed_errors: bool,
}

impl Tables {
    pub(super) fn new(refinable: RefinableMesh, has_guaranteed_errors: bool) -> Self {
        let fans = Fans::build(&refinable);
        Self::from_parts(refinable, fans, has_guaranteed_errors)
    }

    pub(super) fn new_with_progress(
        refinable: RefinableMesh,
        has_guaranteed_errors: bool,
        progress: &mut ProgressFn<'_>,
    ) -> Result<Self, Cancelled> {
        let fans = Fans::build_with(&refinable, &FanOptions::default(), progress)?;
        Ok(Self::from_parts(refinable, fans, has_guaranteed_errors))
    }

    pub(super) fn from_file(file: &StriataFile<'_>) -> Result<Self, DecodeError> {
        let refinable = file.refinable_mesh()?;
        let (key, value) = GUARANTEED_ERRORS;
        let has_guaranteed_errors = file.metadata()?.iter().any(|(k, v)| k == key && v == value);
        match file.fans() {
            Some(fans) => Ok(Self::from_parts(refinable, fans?, has_guaranteed_errors)),
            None => Ok(Self::new(refinable, has_guaranteed_errors)),
        }
    }

    fn from_parts(refinable: RefinableMesh, fans: Fans, has_guaranteed_errors: bool) -> Self {
        let sphere = FanScene::new(&fans, &refinable.mesh.positions).sphere();
        Self { refinable, fans, sphere, has_guaranteed_errors }
    }

    pub(super) fn to_striata(&self, options: &WriteOptions) -> Result<Vec<u8>, EncodeError> {
        let mut options = options.clone();
        let (key, value) = GUARANTEED_ERRORS;
        if options.metadata.iter().all(|(k, _)| k != key) {
            let value = if self.has_guaranteed_errors { value } else { "estimated" };
            options = options.with_metadata(key, value);
        }
        to_striata(&self.refinable, &[FileModel::Fans(&self.fans)], &options)
    }

    pub(super) fn refinable(&self) -> &RefinableMesh {
        &self.refinable
    }

    pub(super) fn fans(&self) -> &Fans {
        &self.fans
    }

    pub(super) fn scene(&self) -> FanScene<'_> {
        FanScene::new(&self.fans, &self.refinable.mesh.positions)
    }

    pub(super) fn sphere(&self) -> Sphere {
        self.sphere
    }

    pub(super) fn has_guaranteed_errors(&self) -> bool {
        self.has_guaranteed_errors
    }
}
