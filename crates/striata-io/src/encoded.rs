//! Encoded meshes: the bytes of a file, and the files that it refers to.

use std::path::{Path, PathBuf};

use striata::mesh::IndexedMesh;

use crate::report::Warnings;
use crate::write::{named_bytes, packed_for_name};
use crate::{Format, Warning, WriteError, WriteOptions};

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
    let (bytes, companions) = named_bytes((format, &file), mesh, options, folder_path, &mut warnings)?;
    let bytes = if path.is_some() { packed_for_name(bytes, &file)? } else { bytes };
    Ok(EncodedMesh { bytes, companions, warnings: warnings.into_list() })
}
