//! Writing of scenes: to glTF as a whole, to other formats as one mesh.

use std::path::Path;

use striata::mesh::IndexedMesh;

use super::{Scene, SceneWriter};
#[cfg(not(target_family = "wasm"))]
use crate::Warning;
use crate::report::Warnings;
use crate::write::packed_for_name;
use crate::write_options::WriteOptions;
use crate::{EncodedMesh, Format, ReadError, Source, WriteError, convert_colors, encode_mesh, read_bytes};

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

/// Encodes a scene as the bytes of a file: glTF and GLB keep everything, 3MF the meshes with
/// their instances and colors; other formats get one mesh, with
/// vertex colors as the format has them.
///
/// # Errors
/// Returns [`WriteError`] if the format cannot store a mesh of the scene.
pub fn scene_to_bytes(format: Format, scene: &Scene, options: &WriteOptions) -> Result<Vec<u8>, WriteError> {
    encode_scene(format, scene, options, None).map(|encoded| encoded.bytes)
}

/// Encodes a scene as the file at `path`, like [`encode_mesh`].
///
/// # Errors
/// Returns [`WriteError`] if the format cannot store a mesh of the scene.
pub fn encode_scene(
    format: Format,
    scene: &Scene,
    options: &WriteOptions,
    path: Option<&Path>,
) -> Result<EncodedMesh, WriteError> {
    if !format.has_scenes() {
        let mut mesh = scene.flattened()?;
        convert_colors(&mut mesh, format);
        return encode_mesh(format, &mesh, options, path);
    }
    #[allow(unused_mut, reason = "only writing 3MF warns")]
    let mut warnings = Warnings::of_file(&path.map_or_else(String::new, |path| path.display().to_string()));
    let bytes = match format {
        #[cfg(feature = "threemf")]
        Format::ThreeMf => {
            let bytes = crate::three_mf::scene_to_bytes(scene, &mut warnings);
            bytes.map_err(|refusal| refusal.in_file(&format.to_string(), format))
        }
        _ => SceneWriter::new(scene).to_bytes(format, options),
    };
    let bytes = match path.map(|path| path.display().to_string()) {
        Some(file) => packed_for_name(bytes.map_err(|error| error.in_file(&file))?, &file)?,
        None => bytes?,
    };
    Ok(EncodedMesh { bytes, warnings: warnings.into_list(), ..EncodedMesh::default() })
}

/// Writes a scene to a file. The extension decides the format; `.gz` or `.zst` after it selects compression.
///
/// The file is written completely or not at all.
///
/// # Errors
/// Returns [`WriteError`] with the file and the reason.
#[cfg(not(target_family = "wasm"))]
pub fn write_scene(path: impl AsRef<Path>, scene: &Scene, options: &WriteOptions) -> Result<(), WriteError> {
    write_scene_with_report(path, scene, options).map(drop)
}

/// Writes a scene like [`write_scene`], and returns remarks on what the format could not store.
///
/// # Errors
/// Returns [`WriteError`] with the file and the reason.
#[cfg(not(target_family = "wasm"))]
pub fn write_scene_with_report(
    path: impl AsRef<Path>,
    scene: &Scene,
    options: &WriteOptions,
) -> Result<Vec<Warning>, WriteError> {
    let path = path.as_ref();
    let Some(format) = Format::from_extension(path) else {
        return Err(WriteError::UnknownFormat { file: path.display().to_string() });
    };
    let encoded = encode_scene(format, scene, options, Some(path))?;
    encoded.write(path)?;
    Ok(encoded.warnings)
}
