//! Writing of scenes: to glTF as a whole, to other formats as one mesh.

use std::path::Path;

use striata::mesh::IndexedMesh;

use super::{Scene, SceneWriter};
#[cfg(not(target_family = "wasm"))]
use crate::Warning;
use crate::error::Refusal;
use crate::gltf::GltfContainer;
use crate::image_files::ImageFiles;
use crate::lost_data::scene_losses;
use crate::report::Warnings;
use crate::write::{can_have_companions, packed_for_name};
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

impl SceneWriter<'_> {
    /// Encodes the file as glTF with everything embedded, or as GLB.
    ///
    /// # Errors
    /// [`WriteError`] if the format is another one, a mesh contains numbers that glTF cannot store, a shared
    /// mesh does not fit its vertices, or the file would be too large.
    pub fn to_bytes(&self, format: Format, options: &WriteOptions) -> Result<Vec<u8>, WriteError> {
        self.encode(format, options, None).map(|encoded| encoded.bytes)
    }

    /// Encodes the file at a path, like [`encode_scene`](crate::encode_scene): a `.gltf` with its buffer and images
    /// in files next to it, unless [`WriteOptions::embed`] is set.
    ///
    /// # Errors
    /// As [`to_bytes`](Self::to_bytes).
    pub fn encode(
        &self,
        format: Format,
        options: &WriteOptions,
        path: Option<&Path>,
    ) -> Result<EncodedMesh, WriteError> {
        let file = path.map_or_else(|| format.to_string(), |path| path.display().to_string());
        let mut warnings = Warnings::of_file(&file);
        let beside = path.filter(|path| can_have_companions(path));
        let mut images = ImageFiles::new(self.scene.images(), beside);
        let bytes = match format {
            Format::Gltf | Format::Glb => {
                warnings.append(Warnings::of_list(&file, scene_losses(format, self.scene, &file)));
                let container = GltfContainer::new(format, options, beside, &mut images, &mut warnings);
                crate::gltf::scene_to_bytes(self, options, container)
            }
            _ => Err(Refusal::Unsupported("the format has no scenes".to_owned())),
        };
        let bytes = bytes.map_err(|refusal| refusal.in_file(&file, format))?;
        let bytes = if path.is_some() { packed_for_name(bytes, &file)? } else { bytes };
        Ok(EncodedMesh { bytes, companions: images.into_files(), warnings: warnings.into_list() })
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
        let mut encoded = encode_mesh(format, &mesh, options, path)?;
        let file = path.map_or_else(|| format.to_string(), |path| path.display().to_string());
        encoded.warnings.extend(scene_losses(format, scene, &file));
        return Ok(encoded);
    }
    #[cfg(feature = "threemf")]
    if format == Format::ThreeMf {
        let file = path.map_or_else(|| format.to_string(), |path| path.display().to_string());
        let mut warnings = Warnings::of_file(&file);
        let bytes = crate::three_mf::scene_to_bytes(scene, &mut warnings);
        let bytes = bytes.map_err(|refusal| refusal.in_file(&file, format))?;
        let bytes = if path.is_some() { packed_for_name(bytes, &file)? } else { bytes };
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
