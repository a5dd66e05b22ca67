//! Writes a scene as glTF together with parts that a scene does not contain: several index lists over one
//! vertex buffer, and attached data.

use std::borrow::Cow;
use std::collections::BTreeMap;

use serde_json::Value;

use super::Scene;
use crate::error::Refusal;
use crate::gltf::has_triangles;

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

/// Primitive that shows the first of its indices only.
#[derive(Clone, Debug)]
pub(crate) struct IndexPrefix {
    pub primitive: String,
    pub count: usize,
    /// Pointer to the place of the accessor of all indices.
    pub all: String,
}

/// Writes a scene as glTF or GLB, with additions.
///
/// The binary data consist of the scene's own buffer, vertices and indices, then images, then attachments.
#[derive(Clone, Debug)]
pub struct SceneWriter<'a> {
    pub(crate) scene: &'a Scene,
    pub(crate) shared: BTreeMap<usize, SharedMesh>,
    pub(crate) keeps_primitives: bool,
    pub(crate) keeps_vertices: bool,
    /// JSON pointers with their numbers.
    pub(crate) numbers: Vec<(String, Cow<'a, [u32]>)>,
    pub(crate) prefixes: Vec<IndexPrefix>,
    /// JSON pointers with their data.
    pub(crate) attachments: Vec<(String, Cow<'a, [u8]>)>,
}

impl<'a> SceneWriter<'a> {
    /// Creates a writer without additions.
    pub fn new(scene: &'a Scene) -> Self {
        Self {
            scene,
            shared: BTreeMap::new(),
            keeps_primitives: false,
            keeps_vertices: false,
            numbers: Vec::new(),
            prefixes: Vec::new(),
            attachments: Vec::new(),
        }
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

    /// Gives each mesh all of its vertices in their order, even if other meshes have some of them, or if another order
    /// would be better for caches.
    #[must_use]
    pub fn keeping_vertices(self) -> Self {
        Self { keeps_vertices: true, ..self }
    }

    /// Whether something refers to vertices by their numbers.
    pub(crate) fn has_fixed_vertices(&self) -> bool {
        self.keeps_vertices || !self.shared.is_empty()
    }

    /// Adds an accessor of unsigned 32-bit integers, and sets the value at a JSON pointer of the document, which must
    /// exist, to its index. Equal lists are stored once.
    #[must_use]
    pub fn with_numbers(mut self, pointer: impl Into<String>, numbers: impl Into<Cow<'a, [u32]>>) -> Self {
        self.numbers.push((pointer.into(), numbers.into()));
        self
    }

    /// Shows only the first `count` indices of the primitive at a JSON pointer, and sets the value at the pointer
    /// `all` to an accessor of all of them.
    #[must_use]
    pub fn with_index_prefix(
        mut self,
        primitive: impl Into<String>,
        count: usize,
        all: impl Into<String>,
    ) -> Self {
        self.prefixes.push(IndexPrefix { primitive: primitive.into(), count, all: all.into() });
        self
    }

    /// Adds a buffer view with these bytes, and sets the value at a JSON pointer of the document (such as
    /// `/extensions/VENDOR_data/bufferView`), which must exist, to its index.
    #[must_use]
    pub fn with_attachment(mut self, pointer: impl Into<String>, bytes: impl Into<Cow<'a, [u8]>>) -> Self {
        self.attachments.push((pointer.into(), bytes.into()));
        self
    }
}
