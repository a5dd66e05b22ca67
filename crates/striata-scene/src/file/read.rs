//! Reading of files of scenes.

use striata::Lod;
use striata::file::{Container, DecodeError, SectionKind, StriataFile, Summary, Verify};
use striata_io::{Scene, SceneParts};

use super::SceneDecodeError;
use super::image::image_from_bytes;
use crate::copies::Copies;
use crate::lod_scene::{LodScene, check_groups};

/// Whether bytes are a `.striata` file that contains a scene instead of a single mesh. Only the header and
/// the section table are inspected.
pub fn is_scene_file(bytes: &[u8]) -> bool {
    let container = Container::open(bytes, Verify::WhenRead);
    container.is_ok_and(|container| container.sections().iter().any(|s| s.kind == SectionKind::SCENE))
}

/// A `.striata` file of a scene, in memory or memory-mapped.
#[derive(Clone, Debug)]
pub struct SceneFile<'a> {
    metadata: Vec<(String, String)>,
    scene: Scene,
    meshes: Vec<Option<StriataFile<'a>>>,
    /// Mesh whose levels each mesh has; usually itself.
    sources: Vec<usize>,
}

impl<'a> SceneFile<'a> {
    /// Reads a file and compares all checksums. The document, images and the summaries of all meshes are
    /// checked; the other parts of a mesh are checked when they are read.
    ///
    /// # Errors
    /// [`SceneDecodeError`] if the bytes are not a valid file of a scene.
    pub fn parse(bytes: &'a [u8]) -> Result<Self, SceneDecodeError> {
        Self::parse_with(bytes, striata_stream::open)
    }

    /// Reads a file like [`parse`](Self::parse), and opens the files of its meshes with a function, such as
    /// [`StriataFile::parse`] if their streams are not to be decoded.
    ///
    /// # Errors
    /// As [`parse`](Self::parse).
    pub fn parse_with(
        bytes: &'a [u8],
        open: fn(&'a [u8]) -> Result<StriataFile<'a>, DecodeError>,
    ) -> Result<Self, SceneDecodeError> {
        let container = Container::open(bytes, Verify::All)?;
        let document = serde_json::from_slice(container.get(SectionKind::SCENE)?)?;
        let buffer = container.find(SectionKind::SCENE_BUFFER)?.unwrap_or_default().to_vec();
        let images = container.all(SectionKind::SCENE_IMAGE).enumerate();
        let images =
            images.map(|(image, bytes)| image_from_bytes(image, bytes?)).collect::<Result<_, _>>()?;
        let meshes = container.all(SectionKind::SCENE_MESH).enumerate();
        let meshes = meshes.map(|(mesh, bytes)| mesh_file(mesh, bytes?, open));
        let mut meshes: Vec<Option<StriataFile<'a>>> = meshes.collect::<Result<_, SceneDecodeError>>()?;
        let sources = match container.find(SectionKind::SCENE_SHARING)? {
            Some(bytes) => sources_of(bytes, &meshes)?,
            None => (0..meshes.len()).collect(),
        };
        let mut copies = Copies::default();
        for (mesh, &source) in sources.iter().enumerate().filter(|&(mesh, &source)| source != mesh) {
            let Some(file) = &meshes[source] else { return Err(SceneDecodeError::Sharing) };
            let Summary { vertex_count, triangle_count, .. } = file.summary();
            if !copies.add(vertex_count, triangle_count) {
                return Err(SceneDecodeError::Sharing);
            }
            meshes[mesh] = meshes[source].clone();
        }
        let parts = SceneParts { document, buffer, images, meshes: vec![None; meshes.len()] };
        let scene = Scene::from_parts(parts)?;
        for (mesh, file) in meshes.iter().enumerate() {
            if let Some(file) = file {
                check_groups(&scene, mesh, file.summary().group_count)?;
            }
        }
        Ok(Self { metadata: container.metadata()?, scene, meshes, sources })
    }

    /// Key-value texts about the file; empty if there are none.
    pub fn metadata(&self) -> &[(String, String)] {
        &self.metadata
    }

    /// The scene without triangles.
    pub fn scene_without_meshes(&self) -> &Scene {
        &self.scene
    }

    /// The file of each mesh of the document; [`None`] for meshes without triangles.
    pub fn meshes(&self) -> &[Option<StriataFile<'a>>] {
        &self.meshes
    }

    /// Reads the levels of all meshes.
    ///
    /// # Errors
    /// [`SceneDecodeError`] if a mesh is damaged, or was made by vertex removals instead of collapses.
    pub fn lod_scene(&self) -> Result<LodScene, SceneDecodeError> {
        let mut lods: Vec<Option<Lod>> = Vec::with_capacity(self.meshes.len());
        for (mesh, (file, &source)) in self.meshes.iter().zip(&self.sources).enumerate() {
            let lod = match lods.get(source) {
                Some(lod) => lod.clone(),
                None => {
                    let lod = file.as_ref().map(Lod::from_file).transpose();
                    lod.map_err(|error| SceneDecodeError::Mesh { mesh, error })?
                }
            };
            lods.push(lod);
        }
        Ok(LodScene::from_lods(self.scene.clone(), lods)?)
    }
}

/// Reads the meshes whose levels others have: an earlier mesh for each one that has an empty section of its own.
fn sources_of(bytes: &[u8], meshes: &[Option<StriataFile<'_>>]) -> Result<Vec<usize>, SceneDecodeError> {
    let (words, rest) = bytes.as_chunks::<4>();
    let sources: Vec<usize> = words.iter().map(|&word| u32::from_le_bytes(word) as usize).collect();
    let is_valid =
        |(mesh, &source): (usize, &usize)| source == mesh || (source < mesh && meshes[mesh].is_none());
    let are_valid = sources.len() == meshes.len() && sources.iter().enumerate().all(is_valid);
    if are_valid && rest.is_empty() { Ok(sources) } else { Err(SceneDecodeError::Sharing) }
}

/// Opens the file of a mesh; [`None`] if its section is empty.
pub(super) fn mesh_file<'a>(
    mesh: usize,
    bytes: &'a [u8],
    open: fn(&'a [u8]) -> Result<StriataFile<'a>, DecodeError>,
) -> Result<Option<StriataFile<'a>>, SceneDecodeError> {
    if bytes.is_empty() {
        return Ok(None);
    }
    open(bytes).map(Some).map_err(|error| SceneDecodeError::Mesh { mesh, error })
}
