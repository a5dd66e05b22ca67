//! `.striata` files of meshes and scenes, which are read as a whole.
//!
//! Both become scenes, so that a page shows them in one way: a mesh gets a document with one node.

use striata::file::{DecodeError, StriataFile, Summary};
use striata::mesh::{AttributeLayer, FragmentedMesh, IndexedMesh, RefinableMesh, Semantic, Steps};
use striata::model::Fans;
use striata_io::Scene;
use striata_scene::file::{SceneFile, is_scene_file};
use striata_scene::scene_around;
use wasm_bindgen::prelude::wasm_bindgen;

use crate::model::Model;
use crate::scene_document::{SceneDocument, SceneImage};
use crate::{Failure, limits, normals};

/// Most triangles of a file whose meshes are shown at once. Of larger ones, a first level is shown while the whole is
/// put in order.
const MAX_TRIANGLES_AT_ONCE: usize = 200_000;
/// Triangles of the first levels of all meshes of a large file.
const FIRST_TRIANGLES: usize = 50_000;
/// Triangles that the first level of each mesh may have in any case.
const MIN_FIRST_TRIANGLES: usize = 500;

/// The document of a file, and a [`Model`] for each of its meshes.
#[wasm_bindgen]
#[derive(Debug)]
pub struct StoredFile {
    document: Option<SceneDocument>,
    meshes: Vec<Option<StoredMesh>>,
    triangle_count: usize,
}

/// A mesh that has been read, but not yet put in the order in which it is shown.
#[derive(Debug)]
struct StoredMesh {
    steps: Steps,
    /// The fans of steps that are no collapses, if they are stored.
    fans: Option<Fans>,
    /// Whether smooth normals are added: those of a file of a mesh that has none.
    is_smoothed: bool,
}

#[wasm_bindgen]
impl StoredFile {
    /// Reads an uncompressed file.
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

    /// Makes a model of the coarse levels of a mesh of a large file, which is ready long before the whole. Nothing if
    /// the whole is as quick, or if the mesh has no triangles.
    pub fn first_levels(&self, index: usize) -> Option<Model> {
        if self.triangle_count <= MAX_TRIANGLES_AT_ONCE {
            return None;
        }
        let mesh = self.meshes.get(index)?.as_ref()?;
        let Steps::Collapses(refinable) = &mesh.steps else { return None };
        let count = refinable.mesh.triangle_count();
        let share = (FIRST_TRIANGLES as u64 * count as u64 / self.triangle_count as u64) as usize;
        let split_count = refinable.sequence.split_count_for_triangles(share.max(MIN_FIRST_TRIANGLES));
        if split_count == refinable.sequence.step_count() {
            return None;
        }
        let mut first = refinable.without_levels_above(split_count);
        if mesh.is_smoothed {
            smooth(&mut first.mesh, first.sequence.positions().first_vertices());
        }
        Model::of_first_levels(first, refinable)
    }

    /// Takes the model of a mesh, which takes up to a second per million triangles; nothing if the mesh has no
    /// triangles.
    pub fn take_mesh(&mut self, index: usize) -> Option<Model> {
        let StoredMesh { mut steps, fans, is_smoothed } = self.meshes.get_mut(index)?.take()?;
        if is_smoothed {
            let (mesh, first_vertices) = parts_of(&mut steps);
            smooth(mesh, first_vertices);
        }
        Some(Model::of_steps(steps, |fragmented| fans.unwrap_or_else(|| Fans::build(fragmented))))
    }
}

fn scene_file(bytes: &[u8]) -> Result<StoredFile, Failure> {
    let file = SceneFile::parse_with(bytes, open)?;
    let triangle_count = check_sizes(file.meshes().iter().flatten().map(StriataFile::summary))?;
    let meshes = file.meshes().iter().map(|file| file.as_ref().map(stored_mesh).transpose());
    let meshes = meshes.collect::<Result<_, _>>()?;
    let document = Some(document_of(file.scene_without_meshes()));
    Ok(StoredFile { document, meshes, triangle_count })
}

fn mesh_file(bytes: &[u8]) -> Result<StoredFile, Failure> {
    let file = open(bytes)?;
    let triangle_count = check_sizes([file.summary()])?;
    let mut stored = stored_mesh(&file)?;
    stored.is_smoothed = stored.steps.mesh().layers.iter().all(|layer| layer.semantic != Semantic::Normal);
    if stored.is_smoothed {
        // A document without normals asks for flat triangles.
        let (mesh, _) = parts_of(&mut stored.steps);
        set_normals(mesh, vec![[0.0, 0.0, 1.0]; mesh.vertex_count()]);
    }
    let document = Some(document_of(&scene_around(stored.steps.mesh()).map_err(Failure::corrupt)?));
    Ok(StoredFile { document, meshes: vec![Some(stored)], triangle_count })
}

fn stored_mesh(file: &StriataFile<'_>) -> Result<StoredMesh, Failure> {
    let fans = if file.has_collapses() { None } else { file.fans().transpose()? };
    Ok(StoredMesh { steps: file.steps()?, fans, is_smoothed: false })
}

/// Gives a mesh smooth normals; its positions begin at these vertices.
fn smooth(mesh: &mut IndexedMesh, first_vertices: &[u32]) {
    set_normals(mesh, normals::of_vertices(&mesh.positions, &mesh.triangles, first_vertices));
}

fn set_normals(mesh: &mut IndexedMesh, normals: Vec<[f32; 3]>) {
    mesh.layers.retain(|layer| layer.semantic != Semantic::Normal);
    mesh.layers.push(AttributeLayer::from_f32(Semantic::Normal, 3, normals.into_flattened()));
}

/// The mesh, which may be changed, and the first vertices of its positions.
fn parts_of(steps: &mut Steps) -> (&mut IndexedMesh, &[u32]) {
    match steps {
        Steps::Collapses(RefinableMesh { mesh, sequence }) => (mesh, sequence.positions().first_vertices()),
        Steps::Fragments(FragmentedMesh { mesh, fragments }) => {
            (mesh, fragments.levels().positions().first_vertices())
        }
    }
}

/// Opens the file of a mesh. Only the encoder contains the decoder of streams, for scenes of streams; a page
/// finds the stream of a mesh by its own.
pub(crate) fn open(bytes: &[u8]) -> Result<StriataFile<'_>, DecodeError> {
    #[cfg(feature = "encode")]
    return striata_stream::open(bytes);
    #[cfg(not(feature = "encode"))]
    StriataFile::parse(bytes)
}

/// Returns the number of triangles.
fn check_sizes(summaries: impl IntoIterator<Item = Summary>) -> Result<usize, Failure> {
    let add = |(vertices, triangles): (usize, usize), summary: Summary| {
        (vertices.saturating_add(summary.vertex_count), triangles.saturating_add(summary.triangle_count))
    };
    let (vertices, triangles) = summaries.into_iter().fold((0, 0), add);
    limits::check_counts(vertices, triangles)?;
    Ok(triangles)
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
