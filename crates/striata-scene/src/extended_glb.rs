//! GLB files whose primitives have more triangles than they show, with an extension that explains the others.

use std::borrow::Cow;

use serde_json::Value;
use striata::mesh::IndexedMesh;
use striata_io::{Format, Scene, SceneParts, SceneWriter, WriteError, WriteOptions};

use crate::document::{array, extension_slot, has_triangles, use_extension};

/// A primitive of an extended file.
pub(crate) struct ExtendedPrimitive<'m> {
    /// Triangles of the primitive, of which the first are shown.
    pub triangles: Cow<'m, [[u32; 3]]>,
    /// Number of triangles that are shown.
    pub shown: usize,
    /// Members of the extension. One named `indices` becomes the accessor of all triangles.
    pub extension: Option<Value>,
    /// Further members of the extension, which are accessors of numbers.
    pub numbers: Vec<(&'static str, Cow<'m, [u32]>)>,
}

impl<'m> ExtendedPrimitive<'m> {
    /// Shows other triangles, if any are shown, whose order must stay. All triangles then have an accessor of their own.
    pub(crate) fn showing(mut self, triangles: &'m [[u32; 3]]) -> Self {
        if self.shown == 0 {
            return self;
        }
        let all = std::mem::replace(&mut self.triangles, Cow::Borrowed(triangles));
        self.shown = triangles.len();
        if let Some(members) = self.extension.as_mut().and_then(Value::as_object_mut) {
            members.remove("indices");
            self.numbers.push(("indices", Cow::Owned(all.as_flattened().to_vec())));
        }
        self
    }
}

/// A file in the making.
pub(crate) struct ExtendedGlb<'m> {
    parts: SceneParts,
    extension: &'static str,
    /// Accessors of numbers, by pointers into the document.
    numbers: Vec<(String, Cow<'m, [u32]>)>,
    /// Primitives that show only the first of their indices, and how many.
    prefixes: Vec<(String, usize)>,
}

impl<'m> ExtendedGlb<'m> {
    /// A file of the scene, without its triangles.
    pub(crate) fn new(scene: &Scene, extension: &'static str) -> Self {
        let mut parts = scene.clone().into_parts();
        parts.meshes = vec![None; parts.meshes.len()];
        Self { parts, extension, numbers: Vec::new(), prefixes: Vec::new() }
    }

    /// The place of the extension in the mesh with this index, if it has one.
    pub(crate) fn mesh_extension(&mut self, index: usize) -> Option<&mut Value> {
        extension_slot(&mut self.parts.document["meshes"][index], self.extension)
    }

    /// Puts the vertices of a mesh into the file, with triangles for each of its groups. Primitives that show none are
    /// left out: glTF has no empty primitives.
    pub(crate) fn put_mesh(
        &mut self,
        index: usize,
        vertices: &IndexedMesh,
        primitives: Vec<ExtendedPrimitive<'m>>,
    ) {
        let mut mesh = IndexedMesh { triangles: Vec::new(), triangle_layers: Vec::new(), ..vertices.clone() };
        let mut groups = mesh.groups_or_whole();
        groups.iter_mut().for_each(|group| (group.first, group.count) = (0, 0));
        let is_shown = primitives.iter().any(|primitive| primitive.shown > 0);
        let mut own = primitives.into_iter().zip(&mut groups);
        let Some(entries) = array(&mut self.parts.document["meshes"][index], "primitives") else { return };
        let mut place = 0;
        entries.retain_mut(|entry| {
            let found = if has_triangles(entry) { own.next() } else { None };
            let Some((own, group)) = found.filter(|_| is_shown) else {
                place += 1;
                return true;
            };
            let slot = match own.extension.is_some() && own.shown > 0 {
                true => extension_slot(entry, self.extension),
                false => None,
            };
            let has_all =
                slot.is_some() && own.extension.as_ref().is_some_and(|all| all.get("indices").is_some());
            let triangles = if has_all { &own.triangles[..] } else { &own.triangles[..own.shown] };
            (group.first, group.count) = (mesh.triangles.len() as u32, triangles.len() as u32);
            mesh.triangles.extend_from_slice(triangles);
            if own.shown == 0 {
                return false;
            }
            let pointer = format!("/meshes/{index}/primitives/{place}");
            place += 1;
            if let Some((slot, extension)) = slot.zip(own.extension) {
                *slot = extension;
                for (member, numbers) in own.numbers {
                    slot[member] = Value::Null;
                    self.numbers.push((format!("{pointer}/extensions/{}/{member}", self.extension), numbers));
                }
                if has_all {
                    self.prefixes.push((pointer, 3 * own.shown));
                }
            }
            true
        });
        if is_shown {
            groups.retain(|group| group.count > 0);
        }
        mesh.groups = groups;
        self.parts.meshes[index] = Some(mesh);
    }

    /// Encodes the file.
    ///
    /// # Errors
    /// [`WriteError`] if a mesh contains numbers that glTF cannot store, or the file would be larger than 4 GiB.
    pub(crate) fn into_glb(mut self) -> Result<Vec<u8>, WriteError> {
        if !self.numbers.is_empty() {
            use_extension(&mut self.parts.document, self.extension);
        }
        let refused = |error: striata_io::SceneError| WriteError::BadMesh {
            file: "scene.glb".to_owned(),
            reason: error.to_string(),
        };
        let scene = Scene::from_parts(self.parts).map_err(refused)?;
        let mut writer = SceneWriter::new(&scene).keeping_vertices();
        for (pointer, numbers) in self.numbers {
            writer = writer.with_numbers(pointer, numbers);
        }
        for (pointer, count) in self.prefixes {
            let all = format!("{pointer}/extensions/{}/indices", self.extension);
            writer = writer.with_index_prefix(pointer, count, all);
        }
        writer.to_bytes(Format::Glb, &WriteOptions::default().with_cache_order(false))
    }
}
