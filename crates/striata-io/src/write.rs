//! Writing to a path or to bytes, in any format.

use std::path::Path;

use striata::mesh::IndexedMesh;

use crate::cache_order::in_cache_order;
use crate::compressed::Compression;
use crate::encoded::{CompanionFile, encode_mesh};
use crate::error::Refusal;
#[cfg(not(target_family = "wasm"))]
use crate::report::Warning;
use crate::report::Warnings;
use crate::write_options::WriteOptions;
use crate::{Format, WriteError};

/// Writes a mesh to a file. The extension decides the format; `.gz` or `.zst` after it selects compression.
///
/// OBJ gets a material library next to it, `.gltf` a buffer, and all three of OBJ, PLY and `.gltf` the images of
/// their materials, unless they are there already. All files are written completely, or none.
///
/// # Errors
/// Returns [`WriteError`] with the file and the reason.
#[cfg(not(target_family = "wasm"))]
pub fn write(path: impl AsRef<Path>, mesh: &IndexedMesh, options: &WriteOptions) -> Result<(), WriteError> {
    write_with_report(path, mesh, options).map(drop)
}

/// Writes a mesh like [`write()`], and returns remarks on what the format could not store.
///
/// # Errors
/// Returns [`WriteError`] with the file and the reason.
#[cfg(not(target_family = "wasm"))]
pub fn write_with_report(
    path: impl AsRef<Path>,
    mesh: &IndexedMesh,
    options: &WriteOptions,
) -> Result<Vec<Warning>, WriteError> {
    let path = path.as_ref();
    let Some(format) = Format::from_extension(path) else {
        return Err(WriteError::UnknownFormat { file: path.display().to_string() });
    };
    let encoded = encode_mesh(format, mesh, options, Some(path))?;
    encoded.write(path)?;
    Ok(encoded.warnings)
}

/// Compresses the bytes of a file if its name ends in `.gz` or `.zst`.
pub(crate) fn packed_for_name(bytes: Vec<u8>, file: &str) -> Result<Vec<u8>, WriteError> {
    match Compression::from_extension(file) {
        Some(compression) => compress(&bytes, compression, file),
        None => Ok(bytes),
    }
}

/// Encodes a mesh as the bytes of a file: binary little-endian PLY (or ASCII), OBJ, binary STL, OFF, GLB,
/// glTF with everything embedded, binary VTK, VTP or VTU, or 3MF in millimeters.
///
/// OBJ and PLY name libraries and images, which are not written; [`encode_mesh`] returns them.
///
/// # Errors
/// Returns [`WriteError`] if the mesh is inconsistent or the format cannot store it.
pub fn to_bytes(format: Format, mesh: &IndexedMesh, options: &WriteOptions) -> Result<Vec<u8>, WriteError> {
    encode_mesh(format, mesh, options, None).map(|encoded| encoded.bytes)
}

/// Returns the bytes of a file before compression, and the files that belong next to `path`.
pub(crate) fn named_bytes(
    (format, file): (Format, &str),
    mesh: &IndexedMesh,
    options: &WriteOptions,
    path: Option<&Path>,
    warnings: &mut Warnings,
) -> Result<(Vec<u8>, Vec<CompanionFile>), WriteError> {
    check_parts(mesh).map_err(|refusal| refusal.in_file(file, format))?;
    crate::lost_data::warn(format, mesh, warnings);
    let is_gltf = matches!(format, Format::Gltf | Format::Glb);
    let mesh = if options.has_cache_order() && !is_gltf { &in_cache_order(mesh) } else { mesh };
    let mut companions = Vec::new();
    #[cfg(any(feature = "ply", feature = "obj", feature = "gltf"))]
    let mut images = crate::image_files::ImageFiles::new(&mesh.appearance.images, path);
    let bytes: Result<Vec<u8>, Refusal> = match format {
        #[cfg(feature = "ply")]
        Format::Ply => crate::ply::to_bytes(mesh, options.ascii, &mut images, warnings),
        #[cfg(feature = "obj")]
        Format::Obj => Ok(crate::obj::to_bytes(mesh, path, &mut images, warnings)),
        #[cfg(feature = "stl")]
        Format::Stl => crate::stl::to_bytes(mesh, warnings),
        #[cfg(feature = "off")]
        Format::Off => Ok(crate::off::to_bytes(mesh, warnings)),
        #[cfg(feature = "gltf")]
        Format::Gltf | Format::Glb => {
            let container = crate::gltf::Container::new(format, options, path, (&mut images, warnings));
            crate::gltf::to_bytes(mesh, options, container)
        }
        #[cfg(feature = "vtk")]
        Format::Vtk | Format::Vtp | Format::Vtu => crate::vtk::to_bytes(format, mesh, warnings),
        #[cfg(feature = "threemf")]
        Format::ThreeMf => crate::three_mf::mesh_to_bytes(mesh, warnings),
        Format::Striata | Format::Stream => {
            return Err(WriteError::UnknownFormat { file: file.to_owned() });
        }
        #[allow(unreachable_patterns, reason = "in a build with all formats")]
        off => {
            let (what, feature) = off.name_and_feature();
            return Err(WriteError::FeatureOff { file: file.to_owned(), what, feature });
        }
    };
    #[cfg(any(feature = "ply", feature = "obj", feature = "gltf"))]
    companions.extend(images.into_files());
    bytes.map(|bytes| (bytes, companions)).map_err(|refusal| refusal.in_file(file, format))
}

/// Checks what the writers rely on; coordinates may have any value, as in [`IndexedMesh`] itself.
fn check_parts(mesh: &IndexedMesh) -> Result<(), Refusal> {
    use striata::mesh::MeshError;
    match mesh.check() {
        // This is checked last except for the groups, and text and binary formats can store such values.
        Err(MeshError::NonFinitePosition { .. }) => {
            let finite = IndexedMesh { positions: vec![[0.0; 3]; mesh.positions.len()], ..mesh.clone() };
            finite.check()
        }
        other => other,
    }
    .map_err(|error| Refusal::BadMesh(error.to_string()))
}

#[cfg(all(feature = "compressed", not(target_family = "wasm")))]
fn compress(bytes: &[u8], compression: Compression, file: &str) -> Result<Vec<u8>, WriteError> {
    crate::compressed::packed(bytes, compression)
        .map_err(|source| WriteError::Io { file: file.to_owned(), source })
}

#[cfg(any(not(feature = "compressed"), target_family = "wasm"))]
fn compress(_bytes: &[u8], compression: Compression, file: &str) -> Result<Vec<u8>, WriteError> {
    let (file, what) = (file.to_owned(), compression.as_str());
    Err(WriteError::FeatureOff { file, what, feature: "compressed" })
}
