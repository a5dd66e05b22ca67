//! Writing of scenes: to glTF as a whole, to other formats as one mesh.

use std::path::Path;

use striata::mesh::IndexedMesh;

use super::{Scene, SceneWriter};
#[cfg(not(target_family = "wasm"))]
use crate::Warning;
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

/// Encodes a scene as the bytes of a file: glTF and GLB keep everything, 3MF the meshes with their instances and
/// colors; other formats get one mesh, with vertex colors as the format has them.
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
    #[cfg(feature = "threemf")]
    if format == Format::ThreeMf {
        let file = path.map_or_else(|| format.to_string(), |path| path.display().to_string());
        let mut warnings = crate::report::Warnings::of_file(&file);
        let bytes = crate::three_mf::scene_to_bytes(scene, &mut warnings);
        let bytes = bytes.map_err(|refusal| refusal.in_file(&file, format))?;
        let bytes = if path.is_some() { crate::write::packed_for_name(bytes, &file)? } else { bytes };
        return Ok(EncodedMesh { bytes, warnings: warnings.into_list(), ..EncodedMesh::default() });
    }
    SceneWriter::new(scene).encode(format, options, path)
}

/// Writes a scene to a file. The extension decides the format; `.gz` or `.zst` after it selects compression.
///
/// A `.gltf` gets its buffer and images next to it. All files are written completely, or none.
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
