//! Error of a scene whose parts do not match.

use crate::error::{Fault, Refusal};
use crate::{Place, ReadError};

/// Inconsistency between the parts of a [`Scene`](crate::Scene).
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{place}: {reason}")]
pub struct SceneError {
    /// Location in the document.
    pub place: Place,
    /// Description of what was found and what was expected.
    pub reason: String,
}

impl SceneError {
    pub(crate) fn at(place: impl Into<String>, reason: impl Into<String>) -> Self {
        Self { place: Place::Json(place.into()), reason: reason.into() }
    }
}

impl SceneError {
    pub(crate) fn in_file(self, file: &str) -> ReadError {
        ReadError::Malformed { file: file.to_owned(), place: self.place, reason: self.reason }
    }
}

impl From<Refusal> for SceneError {
    fn from(refusal: Refusal) -> Self {
        match refusal {
            Refusal::Unsupported(reason) | Refusal::BadMesh(reason) => Self { place: Place::File, reason },
        }
    }
}

impl From<Fault> for SceneError {
    fn from(fault: Fault) -> Self {
        match fault {
            Fault::Malformed(place, reason) => Self { place, reason },
            Fault::Unsupported(place, what) => Self { place, reason: format!("{what} cannot be read") },
            Fault::NoTriangles(found) => {
                Self { place: Place::File, reason: format!("{found} and no triangles") }
            }
            Fault::Extension(name) => Self { place: Place::File, reason: format!("requires {name}") },
            Fault::NeedsConversion { found, .. } => Self { place: Place::File, reason: found },
            Fault::FeatureOff { what, .. } => Self { place: Place::File, reason: what.to_owned() },
        }
    }
}
