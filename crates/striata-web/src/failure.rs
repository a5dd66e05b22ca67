//! The error type of this crate: a code for programs, a message for people, and a hint if a remedy is known.

use striata::file::DecodeError;
#[cfg(feature = "encode")]
use striata::model::ModelError;
#[cfg(feature = "build")]
use striata::simplify::SimplifyError;
#[cfg(feature = "encode")]
use striata_io::ReadError;
#[cfg(feature = "files")]
use striata_scene::file::SceneDecodeError;
#[cfg(feature = "stream")]
use striata_scene::stream::SceneStreamError;
use striata_stream::StreamDefect;
use wasm_bindgen::prelude::wasm_bindgen;

/// An error; JavaScript catches it as an object with `code`, `message` and `hint`.
#[wasm_bindgen]
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Failure {
    code: &'static str,
    message: String,
    hint: Option<&'static str>,
}

#[wasm_bindgen]
impl Failure {
    /// Kind of error: `format`, `corrupt`, `too-large` or `unsupported`.
    #[wasm_bindgen(getter)]
    pub fn code(&self) -> String {
        self.code.to_owned()
    }

    /// Description of the error.
    #[wasm_bindgen(getter)]
    pub fn message(&self) -> String {
        self.message.clone()
    }

    /// How to fix the problem, if known.
    #[wasm_bindgen(getter)]
    pub fn hint(&self) -> Option<String> {
        self.hint.map(str::to_owned)
    }
}

impl Failure {
    fn new(code: &'static str, message: impl ToString) -> Self {
        Self { code, message: message.to_string(), hint: None }
    }

    /// The format of the bytes is unknown.
    pub(crate) fn format(message: impl ToString) -> Self {
        Self::new("format", message)
    }

    /// The format is known, but the bytes are damaged.
    pub(crate) fn corrupt(message: impl ToString) -> Self {
        Self::new("corrupt", message)
    }

    /// The model does not fit into a page's memory.
    pub(crate) fn too_large(message: impl ToString) -> Self {
        Self::new("too-large", message)
    }

    /// The input is valid but not supported here.
    pub(crate) fn unsupported(message: impl ToString) -> Self {
        Self::new("unsupported", message)
    }

    pub(crate) fn with_hint(self, hint: &'static str) -> Self {
        Self { hint: Some(hint), ..self }
    }
}

impl From<DecodeError> for Failure {
    fn from(error: DecodeError) -> Self {
        match &error {
            DecodeError::Magic { .. } => Self::format(error),
            DecodeError::Version { found, supported } if found < supported => Self::unsupported(error),
            DecodeError::Version { .. } | DecodeError::UnknownSection { .. } => {
                Self::unsupported(error).with_hint("a newer version of the viewer may read it")
            }
            DecodeError::FileLength { found, expected } if found < expected => {
                Self::corrupt(error).with_hint("the file is truncated; check that it was copied completely")
            }
            _ => Self::corrupt(error),
        }
    }
}

impl From<striata_stream::DecodeError> for Failure {
    fn from(error: striata_stream::DecodeError) -> Self {
        DecodeError::from(error).into()
    }
}

impl From<StreamDefect> for Failure {
    fn from(defect: StreamDefect) -> Self {
        DecodeError::from(defect).into()
    }
}

#[cfg(feature = "stream")]
impl From<SceneStreamError> for Failure {
    fn from(error: SceneStreamError) -> Self {
        match &error {
            SceneStreamError::Magic { .. } => Self::format(error),
            SceneStreamError::Version { .. } => {
                Self::unsupported(error).with_hint("a newer version of the viewer may read it")
            }
            _ => Self::corrupt(error),
        }
    }
}

#[cfg(feature = "files")]
impl From<SceneDecodeError> for Failure {
    fn from(error: SceneDecodeError) -> Self {
        match error {
            SceneDecodeError::Container(error) => error.into(),
            error => Self::corrupt(error),
        }
    }
}

#[cfg(feature = "encode")]
impl From<ReadError> for Failure {
    fn from(error: ReadError) -> Self {
        match &error {
            ReadError::UnknownFormat { .. } => Self::format(error).with_hint(
                "supported: .stri, .striata, .ply, .obj, .stl, .off, .gltf and .glb, optionally .gz or .zst",
            ),
            ReadError::FeatureOff { feature: "meshopt" | "draco", .. } => {
                Self::unsupported(error).with_hint("`striata convert IN OUT.glb` decompresses the file")
            }
            ReadError::FeatureOff { .. }
            | ReadError::NeedsConversion { .. }
            | ReadError::NoTriangles { .. }
            | ReadError::UnsupportedExtension { .. }
            | ReadError::Unsupported { .. } => Self::unsupported(error),
            _ => Self::corrupt(error),
        }
    }
}

#[cfg(feature = "encode")]
impl From<ModelError> for Failure {
    fn from(error: ModelError) -> Self {
        Self::unsupported(error)
    }
}

#[cfg(feature = "build")]
impl From<SimplifyError> for Failure {
    fn from(error: SimplifyError) -> Self {
        Self::corrupt(error)
    }
}
