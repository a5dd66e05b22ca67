//! Extensions that compress geometry, and the features of this crate that decode them.

use serde_json::{Map, Value};

use super::json::JsonNode;
use crate::error::Fault;

/// Compression of geometry in glTF files.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum GeometryCompression {
    /// Buffer views by `EXT_meshopt_compression` or `KHR_meshopt_compression`.
    Meshopt,
    /// Primitives by `KHR_draco_mesh_compression`.
    Draco,
}

const MESHOPT: [&str; 2] = ["KHR_meshopt_compression", "EXT_meshopt_compression"];
const DRACO: &str = "KHR_draco_mesh_compression";

impl GeometryCompression {
    /// Returns the compression that an extension defines.
    pub(super) fn of_extension(name: &str) -> Option<Self> {
        if MESHOPT.contains(&name) { Some(Self::Meshopt) } else { (name == DRACO).then_some(Self::Draco) }
    }

    /// Whether this build decodes it.
    pub(super) const fn is_on(self) -> bool {
        match self {
            Self::Meshopt => cfg!(feature = "meshopt"),
            Self::Draco => cfg!(feature = "draco"),
        }
    }

    /// Returns the fault of a build that cannot decode it.
    pub(super) const fn feature_off(self) -> Fault {
        let (what, feature) = match self {
            Self::Meshopt => ("glTF compressed with meshoptimizer", "meshopt"),
            Self::Draco => ("glTF compressed with Draco", "draco"),
        };
        Fault::FeatureOff { what, feature }
    }
}

/// Returns the extension object of a compressed buffer view, or of a buffer that is only a fallback.
pub(super) fn meshopt<'a>(at: &JsonNode<'a>) -> Option<JsonNode<'a>> {
    let extensions = at.get("extensions")?;
    MESHOPT.iter().find_map(|name| extensions.get(name))
}

/// Removes the extensions of compressed geometry from an object.
pub(super) fn remove_from(object: &mut Map<String, Value>) {
    let Some(Value::Object(extensions)) = object.get_mut("extensions") else { return };
    for name in MESHOPT.iter().chain([&DRACO]) {
        extensions.remove(*name);
    }
    if extensions.is_empty() {
        object.remove("extensions");
    }
}

/// Returns the extension object of a compressed primitive.
pub(super) fn draco<'a>(primitive: &JsonNode<'a>) -> Option<JsonNode<'a>> {
    primitive.get("extensions")?.get(DRACO)
}

/// Runs a decoder of another crate, and returns an error if it panics on damaged data.
#[cfg(any(feature = "meshopt", feature = "draco"))]
pub(super) fn contained<T>(decode: impl FnOnce() -> Result<T, String>) -> Result<T, String> {
    let result = std::panic::catch_unwind(std::panic::AssertUnwindSafe(decode));
    result.unwrap_or_else(|_| Err("the decoder failed".to_owned()))
}
