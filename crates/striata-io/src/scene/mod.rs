//! Scenes: a glTF document with nodes, materials, images, skins and animations, and its triangle meshes.
//!
//! [`read_scene`] keeps a file as it is. Only triangles are taken out of the document: each glTF mesh becomes
//! one [`IndexedMesh`] with a group for each triangle primitive, so that a simplifier sees all materials of
//! a mesh at once. Node transforms are not applied, and instances share their mesh. Files without a scene
//! become one with a single node.
//!
//! | part | what it contains |
//! | --- | --- |
//! | [`Scene::document`] | the JSON of the document, without the accessors of triangles and without buffers |
//! | [`Scene::buffer`] | the data of animations, skins, points and lines, which the document refers to |
//! | [`Scene::images`] | the bytes of all images, unchanged |
//! | [`Scene::meshes`] | the triangles of each glTF mesh |
//!
//! In the document, the attributes of triangle primitives have the value `null`, and they have no `indices`;
//! images have neither `uri` nor `bufferView`; every buffer view lies in [`Scene::buffer`].
//!
//! # Example
//! ```no_run
//! let scene = striata_io::read_scene("robot.glb")?;
//! println!("{} triangles in {} meshes", scene.triangle_count(), scene.meshes().len());
//! striata_io::write_scene("copy.glb", &scene, &striata_io::WriteOptions::default())?;
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod dedup;
mod error;
mod from_mesh;
mod instances;
mod mesh_data;
mod read;
mod write;
mod writer;

pub use dedup::MergedParts;
pub use error::SceneError;
pub(crate) use from_mesh::{number_materials, primitive};
pub use instances::SceneInstance;
pub use mesh_data::{MeshData, mesh_data};
#[cfg(not(target_family = "wasm"))]
pub use read::read_scene;
pub use read::read_scene_bytes;
pub use write::{encode_scene, scene_to_bytes};
#[cfg(not(target_family = "wasm"))]
pub use write::{write_scene, write_scene_with_report};
pub(crate) use writer::IndexPrefix;
pub use writer::{SceneWriter, SharedMesh};

use serde_json::Value;
use striata::mesh::{Bounds, Image, IndexedMesh};

use crate::Warning;
use crate::cache_order::with_triangles_in_cache_order;
use crate::gltf::{georeference_in, has_triangles, is_blended, shown_meshes};

/// A glTF document with its triangle meshes and images apart.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Scene {
    document: Value,
    buffer: Vec<u8>,
    images: Vec<Image>,
    meshes: Vec<Option<IndexedMesh>>,
    instances: Vec<SceneInstance>,
    warnings: Vec<Warning>,
}

/// The parts of a [`Scene`], for files that store them separately.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SceneParts {
    /// The document; see [`Scene::document`].
    pub document: Value,
    /// Data that the document's buffer views refer to.
    pub buffer: Vec<u8>,
    /// Images in the order of the document.
    pub images: Vec<Image>,
    /// Triangles of each glTF mesh; [`None`] for meshes without triangles.
    pub meshes: Vec<Option<IndexedMesh>>,
}

impl Scene {
    /// Creates a scene from its parts.
    ///
    /// # Errors
    /// [`SceneError`] if the parts do not match: a wrong number of meshes, groups or images, a buffer view
    /// outside the buffer, or nodes that do not form a tree.
    pub fn from_parts(parts: SceneParts) -> Result<Self, SceneError> {
        let SceneParts { document, buffer, images, mut meshes } = parts;
        instances::check_parts(&document, buffer.len(), images.len(), &meshes)?;
        let instances = shown_meshes(&document, &buffer)?;
        if let Some(georeference) = georeference_in(&document) {
            instances::mark_terrains(&mut meshes, &instances, &georeference.to_string());
        }
        Ok(Self { document, buffer, images, meshes, instances, warnings: Vec::new() })
    }

    /// Takes the scene apart.
    pub fn into_parts(self) -> SceneParts {
        let Self { document, buffer, images, meshes, .. } = self;
        SceneParts { document, buffer, images, meshes }
    }

    /// Replaces the meshes, such as by those of a level of detail.
    ///
    /// # Errors
    /// [`SceneError`] if the number of meshes or of their groups differs.
    pub fn with_meshes(self, meshes: Vec<Option<IndexedMesh>>) -> Result<Self, SceneError> {
        instances::check_meshes(&self.document, &meshes)?;
        Ok(Self { meshes, ..self })
    }

    /// Returns a copy without triangles, for code that keeps the meshes in another form.
    ///
    /// The document still has an entry for each mesh, so [`with_meshes`](Self::with_meshes) can give them
    /// triangles again; without them, the copy cannot be written.
    pub fn without_meshes(&self) -> Self {
        Self {
            document: self.document.clone(),
            buffer: self.buffer.clone(),
            images: self.images.clone(),
            meshes: vec![None; self.meshes.len()],
            instances: self.instances.clone(),
            warnings: self.warnings.clone(),
        }
    }

    pub(crate) fn with_warnings(self, warnings: Vec<Warning>) -> Self {
        Self { warnings, ..self }
    }

    /// The glTF document without the data of triangles and images.
    pub fn document(&self) -> &Value {
        &self.document
    }

    /// Data of animations, skins, points and lines, which the document's buffer views refer to.
    pub fn buffer(&self) -> &[u8] {
        &self.buffer
    }

    /// Images in the order of the document; an image that could not be found has no bytes.
    pub fn images(&self) -> &[Image] {
        &self.images
    }

    /// Triangles of each glTF mesh, with a group for each triangle primitive; [`None`] for meshes without
    /// triangles.
    ///
    /// The materials of each mesh are numbered from 0 in the order of the document; their descriptions are
    /// in the document.
    pub fn meshes(&self) -> &[Option<IndexedMesh>] {
        &self.meshes
    }

    /// Meshes that the default scene shows, in tree order: one entry for each node, or one for each of its
    /// instances by `EXT_mesh_gpu_instancing`.
    pub fn instances(&self) -> &[SceneInstance] {
        &self.instances
    }

    /// Warnings about parts that were missing when the scene was read, such as an image file; empty if nothing was.
    pub fn warnings(&self) -> &[Warning] {
        &self.warnings
    }

    /// Number of triangles that the default scene shows, with those of a mesh counted for each instance.
    pub fn triangle_count(&self) -> usize {
        let shown = self.instances.iter().filter_map(|instance| self.meshes[instance.mesh].as_ref());
        shown.map(IndexedMesh::triangle_count).sum()
    }

    /// Bounding box of all instances, in units of the scene; skinned meshes count in their bind pose.
    /// [`None`] if nothing is shown.
    pub fn bounds(&self) -> Option<Bounds> {
        instances::bounds_of(&self.meshes, &self.instances)
    }

    /// Length of the diagonal of [`bounds`](Self::bounds); 0 if nothing is shown.
    pub fn diagonal(&self) -> f64 {
        self.bounds().map_or(0.0, |bounds| bounds.diagonal())
    }

    /// Reads an accessor of the document, such as the times of an animation: the numbers, and how many of
    /// them each element has. Normalized integers become fractions.
    ///
    /// # Errors
    /// [`SceneError`] if there is no such accessor, or it is malformed.
    pub fn numbers(&self, accessor: u64) -> Result<(Vec<f32>, usize), SceneError> {
        Ok(crate::gltf::numbers_of(&self.document, &self.buffer, accessor)?)
    }

    /// Place of a terrain on the Earth, which the default scene has in its extras.
    pub fn georeference(&self) -> Option<&Value> {
        georeference_in(&self.document)
    }

    /// Name of a glTF mesh; empty if it has none.
    pub fn mesh_name(&self, mesh: usize) -> &str {
        self.mesh_entry(mesh).and_then(|entry| entry.get("name")?.as_str()).unwrap_or("")
    }

    /// Material of each triangle primitive of a glTF mesh, as an index into the materials of the document;
    /// there is one entry for each group of the mesh. Empty if there is no such mesh.
    pub fn primitive_materials(&self, mesh: usize) -> Vec<Option<usize>> {
        let primitives = self.mesh_entry(mesh).and_then(|entry| entry.get("primitives")?.as_array());
        let with_triangles = primitives.into_iter().flatten().filter(|primitive| has_triangles(primitive));
        let material = |primitive: &Value| primitive.get("material")?.as_u64()?.try_into().ok();
        with_triangles.map(material).collect()
    }

    /// Whether each triangle primitive of a glTF mesh is blended, with any of its materials, so that the order of its
    /// triangles is the order in which they are drawn over each other. Empty if there is no such mesh.
    pub fn are_blended(&self, mesh: usize) -> Vec<bool> {
        let primitives = self.mesh_entry(mesh).and_then(|entry| entry.get("primitives")?.as_array());
        let with_triangles = primitives.into_iter().flatten().filter(|primitive| has_triangles(primitive));
        with_triangles.map(|primitive| is_blended(&self.document, primitive)).collect()
    }

    /// Returns the meshes with the triangles of each group in cache order; groups that are blended keep theirs.
    pub fn meshes_in_cache_order(&self) -> Vec<Option<IndexedMesh>> {
        let ordered = |(index, mesh): (usize, &Option<IndexedMesh>)| {
            let are_blended = self.are_blended(index);
            Some(with_triangles_in_cache_order(mesh.as_ref()?, |group| are_blended[group]))
        };
        self.meshes.iter().enumerate().map(ordered).collect()
    }

    fn mesh_entry(&self, mesh: usize) -> Option<&Value> {
        self.document.get("meshes")?.as_array()?.get(mesh)
    }
}
