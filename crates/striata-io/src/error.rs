//! Errors of reading and writing: every error names the file, the place in it and the reason.

use std::fmt;
use std::io;

use crate::Format;
use crate::format::mesh_extensions;

/// Location of an error within a file.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Place {
    /// Line of a text file, counted from 1.
    Line(u64),
    /// Byte of a binary file, counted from 0.
    Byte(u64),
    /// Line of a part of an archive, counted from 1.
    Part {
        /// Name of the part.
        part: String,
        /// The line.
        line: u64,
    },
    /// Path of a value in a JSON document, such as `accessors[3].count`.
    Json(String),
    /// Vertex, in the order of the file, counted from 0.
    Vertex(u64),
    /// Triangle, in the order of the file after polygons are divided, counted from 0.
    Triangle(u64),
    /// Piece of a file that is read in pieces, counted from 0.
    Piece(u64),
    /// The file as a whole.
    File,
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Line(line) => write!(f, "line {line}"),
            Self::Byte(byte) => write!(f, "byte {byte}"),
            Self::Part { part, line } => write!(f, "{part}, line {line}"),
            Self::Json(path) => f.write_str(path),
            Self::Vertex(vertex) => write!(f, "vertex {vertex}"),
            Self::Triangle(triangle) => write!(f, "triangle {triangle}"),
            Self::Piece(piece) => write!(f, "piece {piece}"),
            Self::File => f.write_str("whole file"),
        }
    }
}

/// Reason why a file could not be read.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ReadError {
    /// The file could not be opened or read.
    #[error("{file}: {source}")]
    Io {
        /// Name of the file.
        file: String,
        /// Error of the operating system.
        source: io::Error,
    },
    /// Neither the content nor the extension identifies the file.
    #[error("{file}: neither the content nor the extension is that of a mesh file ({})", mesh_extensions())]
    UnknownFormat {
        /// Name of the file.
        file: String,
    },
    /// The file contains no triangles that can be read, but another program can make some of it.
    #[error("{file}: {found}")]
    NeedsConversion {
        /// Name of the file.
        file: String,
        /// Description of what the file is.
        found: String,
        /// How to convert it.
        hint: String,
    },
    /// The format is supported, but this build does not include it.
    #[error("{file}: this build cannot read {what}: the feature `{feature}` is off")]
    FeatureOff {
        /// Name of the file.
        file: String,
        /// Name of the format or compression.
        what: &'static str,
        /// Cargo feature of `striata-io` that includes it.
        feature: &'static str,
    },
    /// The file is a striata container: it contains models, not a plain mesh.
    #[error("{file}: a .striata file contains multiresolution models, not one mesh: extract a level from it")]
    StriataContainer {
        /// Name of the file.
        file: String,
    },
    /// A glTF file requires an extension that is not supported.
    #[error("{file}: requires the glTF extension {extension}, which cannot be read")]
    UnsupportedExtension {
        /// Name of the file.
        file: String,
        /// Name of the extension.
        extension: String,
    },
    /// The file is valid, but uses something that is not supported.
    #[error("{file}: {place}: {what} cannot be read")]
    Unsupported {
        /// Name of the file.
        file: String,
        /// Location in the file.
        place: Place,
        /// The unsupported feature.
        what: String,
    },
    /// The file cannot be read block by block.
    #[error("{file}: {found} cannot be read block by block")]
    NotInBlocks {
        /// Name of the file.
        file: String,
        /// Description of the file or of what it contains.
        found: String,
    },
    /// The file has no bytes.
    #[error("{file}: the file is empty")]
    Empty {
        /// Name of the file.
        file: String,
    },
    /// The file has points, lines or curves, but no triangles.
    #[error("{file}: the file has {found} and no triangles; striata simplifies triangle meshes")]
    NoTriangles {
        /// Name of the file.
        file: String,
        /// Content that it has instead, such as `1,000 points`.
        found: String,
    },
    /// Every triangle had to be left out.
    #[error("{file}: none of the triangles can be used: {reason}")]
    NothingLeft {
        /// Name of the file.
        file: String,
        /// Parts that were left out, and the reasons.
        reason: String,
    },
    /// The file violates the rules of its format.
    #[error("{file}: {place}: {reason}")]
    Malformed {
        /// Name of the file.
        file: String,
        /// Location in the file.
        place: Place,
        /// Description of what was found and what was expected.
        reason: String,
    },
}

impl ReadError {
    /// Returns the error for a file whose format [`Format::detect`] does not know: [`Self::NeedsConversion`] if it is
    /// recognized as a file of another program, otherwise [`Self::UnknownFormat`].
    ///
    /// `bytes` and `inner_name` are the content and the name without compression.
    pub fn unrecognized(file: &str, bytes: &[u8], inner_name: &str) -> Self {
        #[cfg(not(target_family = "wasm"))]
        if let Some(error) = crate::foreign::error_of(file, bytes, inner_name) {
            return error;
        }
        Self::UnknownFormat { file: file.to_owned() }
    }

    /// Returns how to make the file readable, if that is known.
    pub fn hint(&self) -> Option<&str> {
        match self {
            Self::NeedsConversion { hint, .. } => Some(hint),
            _ => None,
        }
    }
}

/// A [`ReadError`] without a file name.
#[derive(Debug)]
pub(crate) enum Fault {
    Malformed(Place, String),
    Unsupported(Place, String),
    #[cfg_attr(not(feature = "gltf"), expect(dead_code, reason = "only glTF has extensions"))]
    Extension(String),
    /// The file has no triangles; the text names the content that it has instead.
    NoTriangles(String),
    /// The file has no triangles, but another program can make some of it.
    NeedsConversion {
        found: String,
        hint: &'static str,
    },
    #[cfg_attr(not(feature = "gltf"), expect(dead_code, reason = "only glTF has parts behind features"))]
    FeatureOff {
        what: &'static str,
        feature: &'static str,
    },
}

impl Fault {
    /// Creates a fault at a line, counted from 1.
    pub(crate) fn at_line(line: u64, reason: impl Into<String>) -> Self {
        Self::Malformed(Place::Line(line), reason.into())
    }

    /// Creates a fault at a byte, counted from 0.
    pub(crate) fn at_byte(byte: usize, reason: impl Into<String>) -> Self {
        Self::Malformed(Place::Byte(byte as u64), reason.into())
    }

    pub(crate) fn in_file(self, file: &str) -> ReadError {
        let file = file.to_owned();
        match self {
            Self::Malformed(place, reason) => ReadError::Malformed { file, place, reason },
            Self::Unsupported(place, what) => ReadError::Unsupported { file, place, what },
            Self::NoTriangles(found) => ReadError::NoTriangles { file, found },
            Self::NeedsConversion { found, hint } => {
                ReadError::NeedsConversion { file, found, hint: hint.to_owned() }
            }
            Self::Extension(extension) => ReadError::UnsupportedExtension { file, extension },
            Self::FeatureOff { what, feature } => ReadError::FeatureOff { file, what, feature },
        }
    }
}

/// Reason why a mesh could not be written.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum WriteError {
    /// The file could not be created or written.
    #[error("{file}: {source}")]
    Io {
        /// Name of the file.
        file: String,
        /// Error of the operating system.
        source: io::Error,
    },
    /// The extension belongs to no format that can be written.
    #[error("{file}: the extension names no mesh format ({})", mesh_extensions())]
    UnknownFormat {
        /// Name of the file.
        file: String,
    },
    /// The format is supported, but this build does not include it.
    #[error("{file}: this build cannot write {what}: the feature `{feature}` is off")]
    FeatureOff {
        /// Name of the file, or of the format if there is no file yet.
        file: String,
        /// Name of the format or compression.
        what: &'static str,
        /// Cargo feature of `striata-io` that includes it.
        feature: &'static str,
    },
    /// The format cannot store this mesh.
    #[error("{file}: {format} cannot store this mesh: {reason}")]
    Unsupported {
        /// Name of the file, or of the format if there is no file yet.
        file: String,
        /// The format.
        format: Format,
        /// Description of what the format cannot store.
        reason: String,
    },
    /// The mesh is inconsistent.
    #[error("{file}: the mesh is inconsistent: {reason}")]
    BadMesh {
        /// Name of the file, or of the format if there is no file yet.
        file: String,
        /// Description of the inconsistency and its location.
        reason: String,
    },
}

/// A [`WriteError`] without a file name and a format.
#[derive(Debug)]
pub(crate) enum Refusal {
    Unsupported(String),
    BadMesh(String),
}

impl Refusal {
    /// Returns the reason alone.
    #[cfg(feature = "blocks")]
    pub(crate) fn into_reason(self) -> String {
        let (Self::Unsupported(reason) | Self::BadMesh(reason)) = self;
        reason
    }

    pub(crate) fn in_file(self, file: &str, format: Format) -> WriteError {
        let file = file.to_owned();
        match self {
            Self::Unsupported(reason) => WriteError::Unsupported { file, format, reason },
            Self::BadMesh(reason) => WriteError::BadMesh { file, reason },
        }
    }
}
