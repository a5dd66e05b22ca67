//! Writing of scenes: to glTF as a whole, to other formats as one mesh.

#[cfg(not(target_family = "wasm"))]
use std::path::Path;

use striata::mesh::IndexedMesh;

use super::{Scene, SceneWriter};
#[cfg(not(target_family = "wasm"))]
use crate::write::packed_for_name;
use crate::write_options::WriteOptions;
use crate::{Format, ReadError, Source, WriteError, convert_colors, read_bytes, to_bytes};

impl Scene {
    /// Returns one mesh of everything that the default scene shows, with all transforms applied, as
    /// [`read`](crate::read) returns it.
    ///
    /// # Errors
    /// [`WriteError`] if a mesh contains numbers that glTF cannot store.
    pub fn flattened(&self) -> Result<IndexedMesh, WriteError> {
        let bytes = scene_to_bytes(Format::Glb, self, &WriteOptions::default())?;
        read_bytes(&bytes, &Source::new("scene.glb")).map_err(|error| match error {
            ReadError::Malformed { file, reason, .. } => WriteError::BadMesh { file, reason },
            other => WriteError::BadMesh { file: "scene.glb".to_owned(), reason: other.to_string() },
        })
    }
}

/// Encodes a scene as the bytes of a file: glTF and GLB keep everything; other formats get one mesh, with
/// vertex colors as the format has them.
///
/// # Errors
/// Returns [`WriteError`] if the format cannot store a mesh of the scene.
pub fn scene_to_bytes(format: Format, scene: &Scene, options: &WriteOptions) -> Result<Vec<u8>, WriteError> {
    match format {
        Format::Gltf | Format::Glb => SceneWriter::new(scene).to_bytes(format, options),
        _ => {
            let mut mesh = scene.flattened()?;
            convert_colors(&mut mesh, Format::Glb, format);
            to_bytes(format, &mesh, options)
        }
    }
}

/// Writes a scene to a file. The extension decides the format; `.gz` or `.zst` after it selects compression.
///
/// The file is written completely or not at all.
///
/// # Errors
/// Returns [`WriteError`] with the file and the reason.
#[cfg(not(target_family = "wasm"))]
pub fn write_scene(path: impl AsRef<Path>, scene: &Scene, options: &WriteOptions) -> Result<(), WriteError> {
    let path = path.as_ref();
    let Some(format) = Format::from_extension(path) else {
        return Err(WriteError::UnknownFormat { file: path.display().to_string() });
    };
    let bytes = scene_to_file_bytes(path, format, scene, options)?;
    crate::write_atomically(path, |out| out.write_all(&bytes))
}

/// Returns the bytes that [`write_scene`] puts into a file, in any format: compressed if the name ends in
/// `.gz` or `.zst`.
///
/// # Errors
/// Returns the errors of [`scene_to_bytes`], with the name of the file.
#[cfg(not(target_family = "wasm"))]
pub fn scene_to_file_bytes(
    path: &Path,
    format: Format,
    scene: &Scene,
    options: &WriteOptions,
) -> Result<Vec<u8>, WriteError> {
    let file = path.display().to_string();
    let bytes = scene_to_bytes(format, scene, options).map_err(|error| error.in_file(&file))?;
    packed_for_name(bytes, &file)
}
