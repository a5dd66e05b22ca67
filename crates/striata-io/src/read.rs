//! Reading from a path or from bytes, in any format.

use std::borrow::Cow;
#[cfg(not(target_family = "wasm"))]
use std::fs;
#[cfg(not(target_family = "wasm"))]
use std::path::Path;

use striata::mesh::IndexedMesh;

use crate::error::Fault;
use crate::repair::{check_triangles, repair};
use crate::report::{ReadReport, Warnings};
use crate::source::Source;
use crate::{Format, ReadError, decompressed};

/// Reads a mesh file of any known format.
///
/// The content decides the format; the extension is only used if the content is inconclusive. Buffers, images
/// and material libraries are read from the folders that the file names, next to it or above it. With the
/// feature `terrain`, a raster of heights (`.tif`, `.hgt`, gray `.png`) is a mesh as well.
///
/// # Errors
/// Returns [`ReadError`] with the file, the place and the reason.
#[cfg(not(target_family = "wasm"))]
pub fn read(path: impl AsRef<Path>) -> Result<IndexedMesh, ReadError> {
    read_with_report(path).map(|report| report.mesh)
}

/// Reads a mesh file like [`read`], and reports what was left out, such as missing textures.
///
/// # Errors
/// Returns [`ReadError`] with the file, the place and the reason.
#[cfg(not(target_family = "wasm"))]
pub fn read_with_report(path: impl AsRef<Path>) -> Result<ReadReport, ReadError> {
    let path = path.as_ref();
    #[cfg(feature = "terrain")]
    if crate::pieces::is_raster(path) {
        use crate::pieces::PieceSource as _;
        let terrain = crate::pieces::Terrain::open(&[path.to_owned()], &Default::default())?;
        let (mesh, warnings) = (terrain.mesh()?, terrain.warnings());
        return Ok(ReadReport { mesh, warnings });
    }
    with_file(path, read_bytes_with_report)
}

/// Calls a reader with the bytes of a file.
#[cfg(not(target_family = "wasm"))]
pub(crate) fn with_file<T>(
    path: &Path,
    read: impl FnOnce(&[u8], &Source<'_>) -> Result<T, ReadError>,
) -> Result<T, ReadError> {
    let name = path.display().to_string();
    let bytes = fs::read(path).map_err(|source| ReadError::Io { file: name.clone(), source })?;
    read(&bytes, &Source::of_path(&name, path))
}

/// Reads a mesh from the bytes of a file.
///
/// # Errors
/// Returns [`ReadError`] with the source's name, the place and the reason.
pub fn read_bytes(bytes: &[u8], source: &Source<'_>) -> Result<IndexedMesh, ReadError> {
    read_bytes_with_report(bytes, source).map(|report| report.mesh)
}

/// Reads a mesh from the bytes of a file, and reports what was left out, such as missing textures.
///
/// # Errors
/// Returns [`ReadError`] with the source's name, the place and the reason.
pub fn read_bytes_with_report(bytes: &[u8], source: &Source<'_>) -> Result<ReadReport, ReadError> {
    let (bytes, name) = decompressed(Cow::Borrowed(bytes), source.name)?;
    let file = || source.name.to_owned();
    let Some(format) = Format::detect(&bytes, &name) else {
        return Err(ReadError::unrecognized(source.name, &bytes, &name));
    };
    let mut warnings = Warnings::of_file(source.name);
    let mesh: Result<IndexedMesh, Fault> = match format {
        #[cfg(feature = "ply")]
        Format::Ply => crate::ply::read(&bytes, source, &mut warnings),
        #[cfg(feature = "obj")]
        Format::Obj => crate::obj::read(&bytes, source, &mut warnings),
        #[cfg(feature = "stl")]
        Format::Stl => crate::stl::read(&bytes, &mut warnings),
        #[cfg(feature = "off")]
        Format::Off => crate::off::read(&bytes, &mut warnings),
        #[cfg(feature = "vtk")]
        Format::Vtk | Format::Vtp | Format::Vtu => crate::vtk::read(&bytes, &mut warnings),
        #[cfg(feature = "gltf")]
        Format::Gltf | Format::Glb => crate::gltf::read(&bytes, format, source, &mut warnings),
        #[cfg(feature = "threemf")]
        Format::ThreeMf => crate::three_mf::read(&bytes, &mut warnings),
        Format::Striata | Format::Stream => return Err(ReadError::StriataContainer { file: file() }),
        #[allow(unreachable_patterns, reason = "in a build with all formats")]
        off => {
            let (what, feature) = off.name_and_feature();
            return Err(ReadError::FeatureOff { file: file(), what, feature });
        }
    };
    let mut mesh = mesh.map_err(|fault| fault.in_file(source.name))?;
    // Primitives of points and lines are counted in warnings; others may be empty.
    let is_gltf = matches!(format, Format::Gltf | Format::Glb);
    let found = [if is_gltf { 0 } else { mesh.vertex_count() }, mesh.triangle_count()];
    repair(&mut mesh, &mut warnings);
    check_triangles(found, mesh.triangle_count(), &warnings)?;
    Ok(ReadReport { mesh, warnings: warnings.into_list() })
}
