//! Opens an input of any format.

use std::path::{Path, PathBuf};

use super::ply_pieces::PlyPieces;
use super::several::Several;
#[cfg(feature = "stl")]
use super::stl_pieces::StlPieces;
use super::{MeshPieces, PieceOptions, PieceSource};
use crate::ReadError;
use crate::error::Place;

/// Opens a file that is read in pieces.
///
/// Binary PLY and binary STL files are read where they are, whatever their size. Other formats are loaded into
/// memory first.
///
/// # Errors
/// [`ReadError`] with the file, the place and the reason.
pub fn open_pieces(path: &Path, options: &PieceOptions) -> Result<Box<dyn PieceSource>, ReadError> {
    #[cfg(any())]
    if super::terrain::is_raster(path) {
        return Ok(Box::new(super::Terrain::open(&[path.to_owned()], options.z_scale)?));
    }
    match PlyPieces::open(path, options) {
        Ok(pieces) => return Ok(Box::new(pieces)),
        // Neither a binary PLY file nor damaged.
        Err(ReadError::NotInBlocks { .. } | ReadError::Unsupported { .. }) => {}
        Err(error) => return Err(error),
    }
    #[cfg(feature = "stl")]
    if let Some(pieces) = StlPieces::open(path, options)? {
        return Ok(Box::new(pieces));
    }
    let name = path.display().to_string();
    let mesh = crate::read(path)?;
    mesh.check().map_err(|error| ReadError::Malformed {
        file: name.clone(),
        place: Place::File,
        reason: error.to_string(),
    })?;
    Ok(Box::new(MeshPieces::new(&name, mesh, options.piece_triangle_count)))
}

/// Opens several files that are one mesh: layers that all have are kept, groups and materials are collected.
///
/// # Errors
/// [`ReadError`] with the file, the place and the reason.
pub fn open_several(paths: &[PathBuf], options: &PieceOptions) -> Result<Box<dyn PieceSource>, ReadError> {
    #[cfg(any())]
    if !paths.is_empty() && paths.iter().all(|path| super::terrain::is_raster(path)) {
        return Ok(Box::new(super::Terrain::open(paths, options.z_scale)?));
    }
    let sources: Result<Vec<_>, ReadError> = paths.iter().map(|path| open_pieces(path, options)).collect();
    Ok(Box::new(Several::new(sources?)))
}
