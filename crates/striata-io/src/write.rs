//! Writing to a path or to bytes, in any format, with the files that a mesh refers to.

use std::path::{Path, PathBuf};

use striata::mesh::IndexedMesh;

use crate::cache_order::in_cache_order;
use crate::compressed::Compression;
use crate::error::Refusal;
use crate::report::{Warning, Warnings};
use crate::{Format, WriteError, WriteOptions};

/// A mesh as a file, with the files that it refers to and remarks on what the format could not store.
#[derive(Clone, Debug, Default)]
#[non_exhaustive]
pub struct EncodedMesh {
    /// Contents of the file itself.
    pub bytes: Vec<u8>,
    /// Material libraries and images, which belong next to the file. None is there under its name already,
    /// other than a material library that an earlier output of ours has left.
    pub companions: Vec<CompanionFile>,
    /// Remarks on materials, textures and layers that were left out or changed.
    pub warnings: Vec<Warning>,
}

/// A file that an encoded mesh refers to.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct CompanionFile {
    /// Path of the file, in the folder of the mesh.
    pub path: PathBuf,
    /// Contents of the file.
    pub bytes: Vec<u8>,
}

impl EncodedMesh {
    /// Writes the file and its companions: all of them or none. A pipe or device only gets the file.
    ///
    /// # Errors
    /// Returns [`WriteError`] with the file and the reason.
    #[cfg(not(target_family = "wasm"))]
    pub fn write(&self, path: &Path) -> Result<(), WriteError> {
        if self.companions.is_empty() {
            return crate::write_atomically(path, |out| out.write_all(&self.bytes));
        }
        let mut batch = crate::FileBatch::default();
        self.stage(path, &mut batch)?;
        batch.commit()
    }

    /// Adds the file and its companions to files that appear together.
    ///
    /// # Errors
    /// Returns [`WriteError`] with the file and the reason.
    #[cfg(not(target_family = "wasm"))]
    pub fn stage(&self, path: &Path, batch: &mut crate::FileBatch) -> Result<(), WriteError> {
        for companion in &self.companions {
            batch.write_shared(&companion.path, &companion.bytes)?;
        }
        batch.write(path, |out| out.write_all(&self.bytes))
    }
}

/// Whether files can lie next to an output: not if it is a pipe or a device.
pub(crate) fn can_have_companions(path: &Path) -> bool {
    !path.metadata().is_ok_and(|there| !there.is_file() && !there.is_dir())
}

/// Encodes a mesh as the file at `path`, compressed if the name ends in `.gz` or `.zst`, with the material
/// libraries and images that belong next to it.
///
/// The folder of the path is searched for images that are there already, but nothing is written. Without a
/// path, as for [`to_bytes`](crate::to_bytes), there are no companions: an OBJ then names the libraries that
/// the mesh came with, and a PLY its images, by the names that they would get.
///
/// # Errors
/// Returns [`WriteError`] if the mesh is inconsistent or the format cannot store it.
pub fn encode_mesh(
    format: Format,
    mesh: &IndexedMesh,
    options: &WriteOptions,
    path: Option<&Path>,
) -> Result<EncodedMesh, WriteError> {
    let file = path.map_or_else(|| format.to_string(), |path| path.display().to_string());
    let mut warnings = Warnings::of_file(&file);
    let folder_path = path.filter(|path| can_have_companions(path));
    check_parts(mesh).map_err(|refusal| refusal.in_file(&file, format))?;
    crate::lost_data::warn(format, mesh, &mut warnings);
    let is_gltf = matches!(format, Format::Gltf | Format::Glb);
    let mesh = if options.has_cache_order() && !is_gltf { &in_cache_order(mesh) } else { mesh };
    let mut companions = Vec::new();
    #[cfg(any(feature = "ply", feature = "obj", feature = "gltf"))]
    let mut images = crate::image_files::ImageFiles::new(&mesh.appearance.images, folder_path);
    let bytes: Result<Vec<u8>, Refusal> = match format {
        #[cfg(feature = "ply")]
        Format::Ply => crate::ply::to_bytes(mesh, options.ascii, &mut images, &mut warnings),
        #[cfg(feature = "obj")]
        Format::Obj => Ok(crate::obj::to_bytes(mesh, folder_path, &mut images, &mut warnings)),
        #[cfg(feature = "stl")]
        Format::Stl => crate::stl::to_bytes(mesh, &mut warnings),
        #[cfg(feature = "off")]
        Format::Off => Ok(crate::off::to_bytes(mesh, &mut warnings)),
        #[cfg(feature = "gltf")]
        Format::Gltf | Format::Glb => {
            let container =
                crate::gltf::GltfContainer::new(format, options, folder_path, &mut images, &mut warnings);
            crate::gltf::to_bytes(mesh, options, container)
        }
        #[cfg(feature = "vtk")]
        Format::Vtk | Format::Vtp | Format::Vtu => crate::vtk::to_bytes(format, mesh, &mut warnings),
        #[cfg(feature = "threemf")]
        Format::ThreeMf => crate::three_mf::mesh_to_bytes(mesh, &mut warnings),
        Format::Striata | Format::Stream => {
            return Err(WriteError::UnknownFormat { file });
        }
        #[allow(unreachable_patterns, reason = "in a build with all formats")]
        off => {
            let (what, feature) = off.name_and_feature();
            return Err(WriteError::FeatureOff { file, what, feature });
        }
    };
    #[cfg(any(feature = "ply", feature = "obj", feature = "gltf"))]
    companions.extend(images.into_files());
    let bytes = bytes.map_err(|refusal| refusal.in_file(&file, format))?;
    let bytes = if path.is_some() { packed_for_name(bytes, &file)? } else { bytes };
    Ok(EncodedMesh { bytes, companions, warnings: warnings.into_list() })
}

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
