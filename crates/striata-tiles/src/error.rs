//! Errors of writing tiles.

use std::path::PathBuf;

use striata::Cancelled;
use striata_io::WriteError;
use striata_paged::PagedError;

/// Error of writing tiles.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum TilesError {
    /// A page cannot be read.
    #[error(transparent)]
    Paged(#[from] PagedError),
    /// A tile cannot be encoded.
    #[error(transparent)]
    Write(#[from] WriteError),
    /// A file cannot be written.
    #[error("{}: {source}", path.display())]
    Io {
        /// The output.
        path: PathBuf,
        /// Error of the system.
        source: std::io::Error,
    },
    /// A file or folder that is no tileset has the name of the tileset.
    #[error("{}: {reason}", path.display())]
    Place {
        /// The output.
        path: PathBuf,
        /// Reason in words.
        reason: &'static str,
    },
    /// The mesh has no triangles.
    #[error("{name}: the mesh has no triangles, so there are no tiles")]
    Empty {
        /// The input.
        name: String,
    },
    /// A segment cannot be written.
    #[error("segment {id}: {reason}")]
    Segment {
        /// Identifier of the segment.
        id: u64,
        /// Reason in words.
        reason: &'static str,
    },
    /// Skirts were asked for, but the mesh is not flat.
    #[error("{name}: skirts are for terrains, but this mesh turns over or is as high as it is wide")]
    Skirts {
        /// The input.
        name: String,
    },
    /// The coordinate system is not known.
    #[error("the coordinate system EPSG:{epsg} of the mesh is not known")]
    CoordinateSystem {
        /// The code.
        epsg: u64,
    },
    /// Coordinates have no place on the Earth.
    #[error("the mesh is outside of the coordinate system EPSG:{epsg}")]
    OffTheMap {
        /// The code.
        epsg: u64,
    },
    /// The caller asked to stop.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
}
