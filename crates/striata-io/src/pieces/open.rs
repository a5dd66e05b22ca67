//! Opens files of any format in pieces.

use std::path::Path;

use super::gltf::GltfPieces;
use super::input::PieceInput;
use super::obj::ObjPieces;
use super::off::OffPieces;
use super::ply::PlyPieces;
use super::repaired::Repaired;
use super::stl::StlPieces;
use super::{MeshPieces, PieceOptions, PieceSource};
use crate::{Format, ReadError, read_bytes_with_report};

/// Opens a file in pieces: the content decides the format, then the extension.
///
/// Files may be larger than the memory. Binary files and the buffers of glTF are mapped into it, text and
/// compressed files are converted to temporary files first. Only PLY files with triangle strips, with lists
/// among the properties of vertices, or with texture coordinates of faces are read at once.
///
/// glTF is what its default scene shows, at rest. Some of it is read in full when a piece needs it: buffer
/// views and primitives that are compressed, and primitives without normals if others have some, which take
/// 24 bytes per vertex then. The JSON and the images are always kept.
///
/// # Errors
/// [`ReadError`] with the file, the place and the reason.
pub fn open_pieces(path: &Path, options: &PieceOptions) -> Result<Box<dyn PieceSource>, ReadError> {
    #[cfg(feature = "terrain")]
    if super::terrain::is_raster(path) {
        return Ok(Box::new(super::Terrain::open(&[path.to_owned()], options)?));
    }
    let mut input = PieceInput::open(path, options)?;
    match Format::detect(&input.bytes, &input.inner_name) {
        Some(Format::Ply) => match PlyPieces::open(input, options)? {
            Ok(pieces) => return repaired(pieces),
            Err(unsuited) => input = unsuited,
        },
        Some(Format::Stl) => return repaired(StlPieces::open(input, options)?),
        Some(Format::Obj) => return repaired(ObjPieces::open(input, options)?),
        Some(Format::Off) => return repaired(OffPieces::open(input, options)?),
        Some(format @ (Format::Gltf | Format::Glb)) => {
            return repaired(GltfPieces::open(input, format, options)?);
        }
        _ => {}
    }
    in_memory(&input, options)
}

fn repaired(source: impl PieceSource + 'static) -> Result<Box<dyn PieceSource>, ReadError> {
    Ok(Box::new(Repaired::new(source)))
}

/// Reads a whole file with the reader for meshes in memory.
fn in_memory(input: &PieceInput, options: &PieceOptions) -> Result<Box<dyn PieceSource>, ReadError> {
    let mut report = read_bytes_with_report(&input.bytes, &input.source())?;
    if let Some(origin) = options.origin {
        report.mesh.set_origin(origin);
    }
    let pieces = MeshPieces::new(report.mesh)
        .with_name(&input.name)
        .with_piece_triangle_count(options.piece_triangle_count)
        .with_file(input, report.warnings);
    pieces.check()?;
    Ok(Box::new(pieces))
}

/// Opens files that are one mesh, or rasters that are one terrain.
///
/// # Errors
/// [`ReadError`] with the file, the place and the reason.
pub fn open_all(
    paths: &[std::path::PathBuf],
    options: &PieceOptions,
) -> Result<Box<dyn PieceSource>, ReadError> {
    #[cfg(feature = "terrain")]
    if !paths.is_empty() && paths.iter().all(|path| super::terrain::is_raster(path)) {
        return Ok(Box::new(super::Terrain::open(paths, options)?));
    }
    Ok(Box::new(super::open_several(paths, options)?))
}
