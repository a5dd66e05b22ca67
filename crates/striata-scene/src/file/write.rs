//! Writing of files of scenes.

use std::borrow::Cow;
use std::collections::HashMap;
use std::io::Write;

use striata::file::{Section, SectionKind, Summary, WriteOptions, metadata_to_bytes, write_sections};
use striata_io::Scene;

use super::SceneEncodeError;
use super::image::image_to_bytes;
use crate::copies::Copies;
use crate::error::SceneMismatch;
use crate::lod_scene::{LodScene, check_groups};

/// Writes a scene as a `.striata` file, with the bytes of a complete `.striata` file for each mesh of the
/// document; [`None`] for meshes without triangles. Meshes with equal bytes are stored once. Triangles of the scene
/// itself are not written.
///
/// The files of the meshes can contain any models, but not a scene.
///
/// # Errors
/// [`SceneEncodeError`] if a mesh is not a valid file or does not belong to the document, a part is too
/// large for the format, or writing fails.
pub fn write_scene_file(
    scene: &Scene,
    meshes: &[Option<Cow<'_, [u8]>>],
    options: &WriteOptions,
    out: &mut dyn Write,
) -> Result<(), SceneEncodeError> {
    let (found, expected) = (meshes.len(), scene.meshes().len());
    if found != expected {
        return Err(SceneMismatch::MeshCount { found, expected }.into());
    }
    let optional = |kind, bytes| Section { kind, is_required: false, bytes };
    let document = scene.document().to_string().into_bytes();
    let mut sections = vec![Section { kind: SectionKind::SCENE, is_required: true, bytes: document.into() }];
    if !options.metadata.is_empty() {
        sections.push(optional(SectionKind::METADATA, metadata_to_bytes(&options.metadata)?.into()));
    }
    if !scene.buffer().is_empty() {
        sections.push(optional(SectionKind::SCENE_BUFFER, scene.buffer().into()));
    }
    let mut first_of: HashMap<&[u8], u32> = HashMap::new();
    let mut copies = Copies::default();
    let (mut sources, mut files) = (Vec::new(), Vec::new());
    for (mesh, bytes) in (0..).zip(meshes) {
        let bytes = bytes.as_deref().unwrap_or_default();
        let mut source = mesh as u32;
        if !bytes.is_empty() {
            let file = striata_stream::open(bytes);
            let file = file.map_err(|error| SceneEncodeError::MeshFile { mesh, error })?;
            check_groups(scene, mesh, file.summary().group_count)?;
            source = *first_of.entry(bytes).or_insert(source);
            let Summary { vertex_count, triangle_count, .. } = file.summary();
            if source as usize != mesh && !copies.add(vertex_count, triangle_count) {
                source = mesh as u32;
            }
        }
        files.push(if source as usize == mesh { bytes } else { &[] });
        sources.push(source);
    }
    if sources.iter().enumerate().any(|(mesh, &source)| source as usize != mesh) {
        let bytes = sources.iter().flat_map(|source| source.to_le_bytes()).collect::<Vec<u8>>().into();
        sections.push(Section { kind: SectionKind::SCENE_SHARING, is_required: true, bytes });
    }
    sections.extend(files.into_iter().map(|bytes| optional(SectionKind::SCENE_MESH, bytes.into())));
    // Images are large and needed last.
    for image in scene.images() {
        sections.push(optional(SectionKind::SCENE_IMAGE, image_to_bytes(image)?.into()));
    }
    Ok(write_sections(&sections, out)?)
}

impl LodScene {
    /// Encodes the scene and the levels of all meshes as a `.striata` file, which
    /// [`SceneFile`](super::SceneFile) reads.
    ///
    /// # Errors
    /// [`SceneEncodeError`] if a part is too large for the format.
    pub fn to_striata(&self, options: &WriteOptions) -> Result<Vec<u8>, SceneEncodeError> {
        let mut meshes = Vec::with_capacity(self.lods().len());
        for (mesh, lod) in self.lods().iter().enumerate() {
            let bytes = lod.as_ref().map(|lod| lod.to_striata(&WriteOptions::default())).transpose();
            let bytes = bytes.map_err(|error| SceneEncodeError::Mesh { mesh, error })?;
            meshes.push(bytes.map(Cow::Owned));
        }
        let mut out = Vec::new();
        write_scene_file(self.scene(), &meshes, options, &mut out)?;
        Ok(out)
    }
}
