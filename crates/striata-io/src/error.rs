//! What can go wrong with a mesh file: always the file, the place in it and the reason.

use std::fmt;
use std::io;

use crate::Format;

/// Where in a file something was found.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Place {
    /// A line of a text file, counted from 1.
    Line(u64),
    /// A byte of a binary file, counted from 0.
    Byte(u64),
    /// A value of a JSON document, as `accessors[3].count`.
    Json(String),
    /// The file as a whole.
    File,
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Line(line) => write!(f, "line {line}"),
            Self::Byte(byte) => write!(f, "byte {byte}"),
            Self::Json(path) => f.write_str(path),
            Self::File => f.write_str("whole file"),
        }
    }
}

/// Why a file could not be read.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ReadError {
    /// The file could not be opened or read.
    #[error("{file}: {source}")]
    Io {
        /// The file.
        file: String,
        /// What the system says.
        source: io::Error,
    },
    /// Neither content nor extension tells what the file is.
    #[error(
        "{file}: neither the content nor the extension is that of a mesh file \
         (.ply .obj .stl .off .gltf .glb)"
    )]
    UnknownFormat {
        /// The file.
        file: String,
    },
    /// The format is known, but this build leaves it out.
    #[error("{file}: this build reads no {what}: the feature `{feature}` is off")]
    FeatureOff {
        /// The file.
        file: String,
        /// The format or compression.
        what: &'static str,
        /// The feature of `striata-io` that would bring it.
        feature: &'static str,
    },
    /// The file is a striata container: it holds models, not a plain mesh.
    #[error("{file}: a .striata file holds multiresolution models, not one mesh: extract a level from it")]
    StriataContainer {
        /// The file.
        file: String,
    },
    /// A glTF requires an extension that is not understood.
    #[error("{file}: requires the glTF extension {extension}, which cannot be read")]
    UnsupportedExtension {
        /// The file.
        file: String,
        /// The extension.
        extension: String,
    },
    /// The file is legal, but uses what is not supported.
    #[error("{file}: {place}: {what} cannot be read")]
    Unsupported {
        /// The file.
        file: String,
        /// Where.
        place: Place,
        /// What it uses.
        what: String,
    },
    /// The file cannot be read in pieces.
    #[error("{file}: is {found}; only binary PLY files are read block by block")]
    NotInBlocks {
        /// The file.
        file: String,
        /// What it is instead.
        found: String,
    },
    /// The file breaks its format's rules.
    #[error("{file}: {place}: {reason}")]
    Malformed {
        /// The file.
        file: String,
        /// Where.
        place: Place,
        /// What was found and what was expected.
        reason: String,
    },
}

/// A [`ReadError`] that does not know its file yet.
#[derive(Debug)]
pub(crate) enum Fault {
    Malformed(Place, String),
    Unsupported(Place, String),
    #[cfg_attr(not(feature = "gltf"), expect(dead_code, reason = "only glTF has extensions"))]
    Extension(String),
}

impl Fault {
    pub(crate) fn at_line(line: u64, reason: impl Into<String>) -> Self {
        Self::Malformed(Place::Line(line), reason.into())
    }

    pub(crate) fn at_byte(byte: usize, reason: impl Into<String>) -> Self {
        Self::Malformed(Place::Byte(byte as u64), reason.into())
    }

    pub(crate) fn in_file(self, file: &str) -> ReadError {
        let file = file.to_owned();
        match self {
            Self::Malformed(place, reason) => ReadError::Malformed { file, place, reason },
            Self::Unsupported(place, what) => ReadError::Unsupported { file, place, what },
            Self::Extension(extension) => ReadError::UnsupportedExtension { file, extension },
        }
    }
}

/// Why a mesh could not be written.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum WriteError {
    /// The system refused.
    #[error("{file}: {source}")]
    Io {
        /// The file.
        file: String,
        /// What the system says.
        source: io::Error,
    },
    /// The extension names no format that can be written.
    #[error("{file}: the extension names no mesh format (.ply .obj .stl .off .gltf .glb)")]
    UnknownFormat {
        /// The file.
        file: String,
    },
    /// The format is known, but this build leaves it out.
    #[error("{file}: this build writes no {what}: the feature `{feature}` is off")]
    FeatureOff {
        /// The file, or the format where there is no file yet.
        file: String,
        /// The format or compression.
        what: &'static str,
        /// The feature of `striata-io` that would bring it.
        feature: &'static str,
    },
    /// The mesh holds what the format cannot.
    #[error("{file}: {format} cannot hold this mesh: {reason}")]
    Unsupported {
        /// The file, or the format where there is no file yet.
        file: String,
        /// The format.
        format: Format,
        /// What does not fit.
        reason: String,
    },
    /// The mesh's own parts do not fit together.
    #[error("{file}: the mesh is not whole: {reason}")]
    BadMesh {
        /// The file, or the format where there is no file yet.
        file: String,
        /// The misfit, with its place.
        reason: String,
    },
}

/// A [`WriteError`] that knows neither its file nor its format yet.
#[derive(Debug)]
pub(crate) enum Refusal {
    Unsupported(String),
    BadMesh(String),
}

impl Refusal {
    pub(crate) fn in_file(self, file: &str, format: Format) -> WriteError {
        let file = file.to_owned();
        match self {
            Self::Unsupported(reason) => WriteError::Unsupported { file, format, reason },
            Self::BadMesh(reason) => WriteError::BadMesh { file, reason },
        }
    }
}
