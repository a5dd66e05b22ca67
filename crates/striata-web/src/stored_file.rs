//! `.striata` files of meshes and scenes, which are read as a whole.
//!
//! Both become scenes, so that a page shows them in one way: a mesh gets a document with one node.

use striata::file::{DecodeError, StriataFile, Summary};
use striata::mesh::{AttributeLayer, FragmentedMesh, RefinableMesh, Semantic, Steps};
use striata::model::Fans;
use striata_io::Scene;
use striata_scene::file::{SceneFile, is_scene_file};
use striata_scene::scene_around;
use wasm_bindgen::prelude::wasm_bindgen;

use crate::model::Model;
use crate::scene_document::{SceneDocument, SceneImage};
use crate::{Failure, limits, normals};

/// The document of a file, and a [`Model`] for each of its meshes.
#[wasm_bindgen]
#[derive(Debug)]
pub struct StoredFile {
    document: Option<SceneDocument>,
    meshes: Vec<Option<Model>>,
}

#[wasm_bindgen]
impl StoredFile {
    /// Reads an uncompressed file. Takes up to a second per million triangles.
    ///
    /// # Errors
    /// If the bytes are damaged, or the model is too large for a page.
    pub fn read(bytes: &[u8]) -> Result<Self, Failure> {
        limits::check_file(bytes.len())?;
        if is_scene_file(bytes) { scene_file(bytes) } else { mesh_file(bytes) }
    }

    /// Takes the document.
    pub fn take_document(&mut self) -> Option<SceneDocument> {
        self.document.take()
    }

    /// Number of meshes of the document.
    #[wasm_bindgen(getter)]
    pub fn mesh_count(&self) -> usize {
        self.meshes.len()
    }

    /// Takes the model of a mesh; nothing if the mesh has no triangles.
    pub fn take_mesh(&mut self, index: usize) -> Option<Model> {
        self.meshes.get_mut(index)?.take()
    }
}

fn scene_file(bytes: &[u8]) -> Result<StoredFile, Failure> {
    let file = SceneFile::parse_with(bytes, open)?;
    check_sizes(file.meshes().iter().flatten().map(StriataFile::summary))?;
    let model = |file: &StriataFile<'_>| model_of(file, file.steps()?);
    let meshes = file.meshes().iter().map(|file| file.as_ref().map(model).transpose());
    let document = Some(document_of(file.scene_without_meshes()));
    Ok(StoredFile { document, meshes: meshes.collect::<Result<_, _>>()? })
}

fn mesh_file(bytes: &[u8]) -> Result<StoredFile, Failure> {
    let file = open(bytes)?;
    check_sizes([file.summary()])?;
    let mut steps = file.steps()?;
    if steps.mesh().layers.iter().all(|layer| layer.semantic != Semantic::Normal) {
        // A document without normals asks for flat triangles.
        let normals = normals::of_vertices(
            &steps.mesh().positions,
            &steps.mesh().triangles,
            steps.levels().positions().first_vertices(),
        );
        let layer = AttributeLayer::from_f32(Semantic::Normal, 3, normals.into_flattened());
        match &mut steps {
            Steps::Collapses(RefinableMesh { mesh, .. }) | Steps::Fragments(FragmentedMesh { mesh, .. }) => {
                mesh.layers.push(layer)
            }
        }
    }
    let document = Some(document_of(&scene_around(steps.mesh()).map_err(Failure::corrupt)?));
    Ok(StoredFile { document, meshes: vec![Some(model_of(&file, steps)?)] })
}

/// Makes the model of a mesh; fans that its file does not contain are built.
fn model_of(file: &StriataFile<'_>, steps: Steps) -> Result<Model, Failure> {
    let fans = if file.has_collapses() { None } else { file.fans().transpose()? };
    Ok(Model::of_steps(steps, |fragmented| fans.unwrap_or_else(|| Fans::build(fragmented))))
}

/// Opens the file of a mesh. Only the encoder contains the decoder of streams, for scenes of streams; a page
/// finds the stream of a mesh by its own.
pub(crate) fn open(bytes: &[u8]) -> Result<StriataFile<'_>, DecodeError> {
    #[cfg(feature = "encode")]
    return striata_stream::open(bytes);
    #[cfg(not(feature = "encode"))]
    StriataFile::parse(bytes)
}

fn check_sizes(summaries: impl IntoIterator<Item = Summary>) -> Result<(), Failure> {
    let add = |(vertices, triangles): (usize, usize), summary: Summary| {
        (vertices.saturating_add(summary.vertex_count), triangles.saturating_add(summary.triangle_count))
    };
    let (vertices, triangles) = summaries.into_iter().fold((0, 0), add);
    limits::check_counts(vertices, triangles)
}

fn document_of(scene: &Scene) -> SceneDocument {
    let images = scene.images().iter().map(|image| SceneImage {
        is_full: true,
        bytes: image.bytes.clone(),
        mime_type: image.mime_type.clone(),
        uri: image.uri.clone(),
    });
    SceneDocument {
        json: scene.document().to_string(),
        buffer: scene.buffer().to_vec(),
        has_animations: true,
        images: images.collect(),
    }
}
