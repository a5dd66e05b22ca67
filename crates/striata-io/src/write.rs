//! Writing to a path or to bytes, in any format.

#[cfg(not(target_family = "wasm"))]
use std::path::Path;

use striata::mesh::IndexedMesh;

#[cfg(not(target_family = "wasm"))]
use crate::compressed::Compression;
use crate::error::Refusal;
use crate::report::Warnings;
#[cfg(not(target_family = "wasm"))]
use crate::write_atomically;
use crate::write_options::WriteOptions;
use crate::{Format, WriteError};

/// Writes a mesh to a file. The extension decides the format; `.gz` or `.zst` after it selects compression.
///
/// The file is written completely or not at all.
///
/// # Errors
/// Returns [`WriteError`] with the file and the reason.
#[cfg(not(target_family = "wasm"))]
pub fn write(path: impl AsRef<Path>, mesh: &IndexedMesh, options: &WriteOptions) -> Result<(), WriteError> {
    let path = path.as_ref();
    let Some(format) = Format::from_extension(path) else {
        return Err(WriteError::UnknownFormat { file: path.display().to_string() });
    };
    let bytes = to_file_bytes(path, format, mesh, options)?;
    write_atomically(path, |out| out.write_all(&bytes))
}

/// Returns the bytes that [`write()`] puts into a file, in any format: compressed if the name ends in `.gz`
/// or `.zst`.
///
/// # Errors
/// Returns the errors of [`to_bytes`], with the name of the file.
#[cfg(not(target_family = "wasm"))]
pub fn to_file_bytes(
    path: &Path,
    format: Format,
    mesh: &IndexedMesh,
    options: &WriteOptions,
) -> Result<Vec<u8>, WriteError> {
    let file = path.display().to_string();
    packed_for_name(named_bytes(format, mesh, options, &file)?, &file)
}

/// Compresses the bytes of a file if its name ends in `.gz` or `.zst`.
#[cfg(not(target_family = "wasm"))]
pub(crate) fn packed_for_name(bytes: Vec<u8>, file: &str) -> Result<Vec<u8>, WriteError> {
    match Compression::from_extension(file) {
        Some(compression) => compress(&bytes, compression, file),
        None => Ok(bytes),
    }
}

/// Encodes a mesh as the bytes of a file: binary little-endian PLY (or ASCII), OBJ, binary STL, OFF, GLB,
/// or glTF with everything embedded.
///
/// # Errors
/// Returns [`WriteError`] if the mesh is inconsistent or the format cannot store it.
pub fn to_bytes(format: Format, mesh: &IndexedMesh, options: &WriteOptions) -> Result<Vec<u8>, WriteError> {
    named_bytes(format, mesh, options, &format.to_string())
}

fn named_bytes(
    format: Format,
    mesh: &IndexedMesh,
    options: &WriteOptions,
    file: &str,
) -> Result<Vec<u8>, WriteError> {
    let mut warnings = Warnings::of_file(file);
    check_parts(mesh).map_err(|refusal| refusal.in_file(file, format))?;
    let bytes: Result<Vec<u8>, Refusal> = match format {
        #[cfg(feature = "ply")]
        Format::Ply => crate::ply::to_bytes(mesh, options.ascii, &mut warnings),
        #[cfg(feature = "obj")]
        Format::Obj => Ok(crate::obj::to_bytes(mesh)),
        #[cfg(feature = "stl")]
        Format::Stl => crate::stl::to_bytes(mesh),
        #[cfg(feature = "off")]
        Format::Off => Ok(crate::off::to_bytes(mesh, &mut warnings)),
        #[cfg(feature = "gltf")]
        Format::Gltf => crate::gltf::to_json_bytes(mesh, options),
        #[cfg(feature = "gltf")]
        Format::Glb => crate::gltf::to_glb_bytes(mesh, options),
        Format::Striata | Format::Stream => {
            return Err(WriteError::UnknownFormat { file: file.to_owned() });
        }
        #[cfg(not(all(
            feature = "ply",
            feature = "obj",
            feature = "stl",
            feature = "off",
            feature = "gltf"
        )))]
        off => {
            let (what, feature) = crate::format::feature_of(off);
            return Err(WriteError::FeatureOff { file: file.to_owned(), what, feature });
        }
    };
    bytes.map_err(|refusal| refusal.in_file(file, format))
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

#[cfg(all(not(feature = "compressed"), not(target_family = "wasm")))]
fn compress(_bytes: &[u8], compression: Compression, file: &str) -> Result<Vec<u8>, WriteError> {
    let (file, what) = (file.to_owned(), compression.as_str());
    Err(WriteError::FeatureOff { file, what, feature: "compressed" })
}
