//! Writes a scene as glTF together with parts that a scene does not contain: several index lists over one
//! vertex buffer, and attached data.

use std::borrow::Cow;
use std::collections::BTreeMap;
use std::path::Path;

use serde_json::Value;

use super::Scene;
use crate::encoded::can_have_companions;
use crate::error::Refusal;
use crate::gltf::{Container, has_triangles, scene_to_bytes};
use crate::image_files::ImageFiles;
use crate::report::Warnings;
use crate::write::packed_for_name;
use crate::{EncodedMesh, Format, WriteError, WriteOptions};

/// Triangles of a glTF mesh over the vertices of another one.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SharedMesh {
    /// Index of the mesh whose vertices are used; it must have triangles of its own.
    pub vertices_of: usize,
    /// Number of vertices that may be used, from the start of the vertex buffer; indices are written with
    /// 16 bits if they suffice for this number.
    pub vertex_count: usize,
    /// Vertex indices of each triangle primitive, three per triangle. A primitive without indices is left
    /// out.
    pub index_lists: Vec<Vec<u32>>,
}

impl SharedMesh {
    /// Checks the lists, and returns the number of vertices that they may use.
    pub(crate) fn check(&self, mesh: usize, scene: &Scene, primitives: &[Value]) -> Result<usize, Refusal> {
        let fail = |reason: String| Err(Refusal::BadMesh(format!("meshes[{mesh}]: {reason}")));
        let available = scene.meshes().get(self.vertices_of).and_then(Option::as_ref);
        let vertex_count = self.vertex_count.min(available.map_or(0, |mesh| mesh.vertex_count()));
        let expected = primitives.iter().filter(|primitive| has_triangles(primitive)).count();
        let found = self.index_lists.len();
        if found != expected {
            return fail(format!("{found} index lists for {expected} triangle primitives"));
        }
        for list in &self.index_lists {
            if !list.len().is_multiple_of(3) {
                return fail(format!("{} indices do not form triangles", list.len()));
            }
            if let Some(vertex) = list.iter().find(|&&vertex| vertex as usize >= vertex_count) {
                return fail(format!("vertex {vertex} of {vertex_count}"));
            }
        }
        Ok(vertex_count)
    }
}

/// Writes a scene as glTF or GLB, with additions.
///
/// The binary data consist of the scene's own buffer, vertices and indices, then images, then attachments.
#[derive(Clone, Debug)]
pub struct SceneWriter<'a> {
    pub(crate) scene: &'a Scene,
    pub(crate) shared: BTreeMap<usize, SharedMesh>,
    pub(crate) keeps_primitives: bool,
    /// JSON pointers with their data.
    pub(crate) attachments: Vec<(String, Cow<'a, [u8]>)>,
}

impl<'a> SceneWriter<'a> {
    /// Creates a writer without additions.
    pub fn new(scene: &'a Scene) -> Self {
        Self { scene, shared: BTreeMap::new(), keeps_primitives: false, attachments: Vec::new() }
    }

    /// Draws an entry of `meshes` for which the scene has no triangles over the vertices of another entry.
    #[must_use]
    pub fn with_shared_mesh(mut self, mesh: usize, shared: SharedMesh) -> Self {
        self.shared.insert(mesh, shared);
        self
    }

    /// Writes primitives that show nothing as one triangle whose corners are the same vertex, instead of
    /// leaving them out, so that all primitives keep their numbers. Does not apply to shared meshes.
    #[must_use]
    pub fn keeping_primitives(self) -> Self {
        Self { keeps_primitives: true, ..self }
    }

    /// Adds a buffer view with these bytes, and sets the value at a JSON pointer of the document (such as
    /// `/extensions/VENDOR_data/bufferView`), which must exist, to its index.
    #[must_use]
    pub fn with_attachment(mut self, pointer: impl Into<String>, bytes: impl Into<Cow<'a, [u8]>>) -> Self {
        self.attachments.push((pointer.into(), bytes.into()));
        self
    }

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
                let container = Container::new(format, options, beside, (&mut images, &mut warnings));
                scene_to_bytes(self, options, container)
            }
            _ => Err(Refusal::Unsupported("the format has no scenes".to_owned())),
        };
        let bytes = bytes.map_err(|refusal| refusal.in_file(&file, format))?;
        let bytes = if path.is_some() { packed_for_name(bytes, &file)? } else { bytes };
        Ok(EncodedMesh { bytes, companions: images.into_files(), warnings: warnings.into_list() })
    }
}
