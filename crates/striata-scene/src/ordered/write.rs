//! Writing: a plain glTF file at full detail with the extension `STRIATA_order`.

use serde_json::Value;
use striata_io::{Format, Scene, SceneParts, SceneWriter, WriteError, WriteOptions};

use super::OrderedMesh;
use crate::document::{array, extension_slot, has_triangles, use_extension};
use crate::lod_scene::LodScene;

/// Name of the extension.
pub const ORDER_EXTENSION: &str = "STRIATA_order";

/// A GLB file with the extension `STRIATA_order`, and what is in it.
#[derive(Clone, Debug, PartialEq)]
pub struct OrderedGlb {
    /// The file.
    pub bytes: Vec<u8>,
    /// Size of the file without the extension.
    pub plain_bytes: usize,
    /// Bytes of the targets and the tables of levels.
    pub order_bytes: usize,
    /// Bytes of the index ranges; 0 without any.
    pub range_bytes: usize,
    /// Meshes of the document, as [`LodScene::ordered`] makes them.
    pub meshes: Vec<Option<OrderedMesh>>,
}

impl LodScene {
    /// Encodes the full scene as a GLB file that any viewer opens, and from which ten lines of code make every level:
    /// the vertices of each mesh are in refinement order, and the extension `STRIATA_order` of each triangle primitive has
    /// the targets of the vertices, a table of levels and, if `range_count` is not 0, that many index ranges.
    ///
    /// Primitives without triangles of any area are left out; points and lines stay as they are.
    ///
    /// # Errors
    /// [`WriteError`] if a mesh contains numbers that glTF cannot store, or the file would be larger than 4 GiB.
    pub fn to_ordered_glb(&self, range_count: usize) -> Result<OrderedGlb, WriteError> {
        let meshes = self.ordered(range_count);
        let bytes = self.glb_of(&meshes, OrderContents::Ranges)?;
        let plain_bytes = self.glb_of(&meshes, OrderContents::Plain)?.len();
        let ordered =
            if range_count == 0 { bytes.len() } else { self.glb_of(&meshes, OrderContents::Order)?.len() };
        Ok(OrderedGlb {
            plain_bytes,
            order_bytes: ordered - plain_bytes,
            range_bytes: bytes.len() - ordered,
            bytes,
            meshes,
        })
    }

    fn glb_of(&self, meshes: &[Option<OrderedMesh>], contents: OrderContents) -> Result<Vec<u8>, WriteError> {
        let mut parts = self.scene().clone().into_parts();
        parts.meshes = vec![None; meshes.len()];
        let mut additions = OrderAdditions::default();
        for (index, mesh) in meshes.iter().enumerate() {
            if let Some(mesh) = mesh {
                additions.put_mesh(&mut parts, index, mesh, contents);
            }
        }
        if !additions.numbers.is_empty() {
            use_extension(&mut parts.document, ORDER_EXTENSION);
        }
        let refused = |error: striata_io::SceneError| WriteError::BadMesh {
            file: "scene.glb".to_owned(),
            reason: error.to_string(),
        };
        let scene = Scene::from_parts(parts).map_err(refused)?;
        let mut writer = SceneWriter::new(&scene).keeping_vertices();
        for (pointer, targets) in additions.numbers {
            writer = writer.with_numbers(format!("{pointer}/extensions/{ORDER_EXTENSION}/targets"), targets);
        }
        for (pointer, count) in additions.prefixes {
            let all = format!("{pointer}/extensions/{ORDER_EXTENSION}/indices");
            writer = writer.with_index_prefix(pointer, count, all);
        }
        writer.to_bytes(Format::Glb, &WriteOptions::default().with_cache_order(false))
    }
}

/// Parts of the extension that are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum OrderContents {
    Plain,
    Order,
    Ranges,
}

/// Data of the extension, by pointers to the primitives.
#[derive(Default)]
struct OrderAdditions<'m> {
    numbers: Vec<(String, &'m [u32])>,
    /// Numbers of indices that primitives show, of those that they have.
    prefixes: Vec<(String, usize)>,
}

impl<'m> OrderAdditions<'m> {
    /// Puts a mesh into the parts of a scene, with its triangles or all of its index ranges, and describes it.
    fn put_mesh(
        &mut self,
        parts: &mut SceneParts,
        index: usize,
        ordered: &'m OrderedMesh,
        contents: OrderContents,
    ) {
        let mut mesh = ordered.mesh.clone();
        let mut groups = mesh.groups_or_whole();
        (mesh.triangles, mesh.triangle_layers) = (Vec::new(), Vec::new());
        let mut ordered_groups = ordered.primitives.iter().zip(&mut groups);
        let Some(primitives) = array(&mut parts.document["meshes"][index], "primitives") else { return };
        let is_shown = !ordered.mesh.triangles.is_empty();
        let mut place = 0;
        primitives.retain_mut(|primitive| {
            let found = if has_triangles(primitive) { ordered_groups.next() } else { None };
            let Some((levels, group)) = found.filter(|_| is_shown) else {
                place += 1;
                return true;
            };
            let full = &ordered.mesh.triangles[group.range()];
            let has_place = primitive.get("extensions").is_none_or(Value::is_object);
            let has_ranges = contents == OrderContents::Ranges && has_place && !levels.ranges.is_empty();
            let shown = if has_ranges { levels.indices.as_chunks().0 } else { full };
            (group.first, group.count) = (mesh.triangles.len() as u32, shown.len() as u32);
            mesh.triangles.extend_from_slice(shown);
            if full.is_empty() {
                // glTF has no empty primitives.
                return false;
            }
            let pointer = format!("/meshes/{index}/primitives/{place}");
            place += 1;
            if contents == OrderContents::Plain {
                return true;
            }
            let Some(slot) = extension_slot(primitive, ORDER_EXTENSION) else { return true };
            *slot = levels.to_json();
            slot["targets"] = Value::Null;
            if has_ranges {
                slot["indices"] = Value::Null;
                self.prefixes.push((pointer.clone(), 3 * full.len()));
            } else if let Some(slot) = slot.as_object_mut() {
                slot.remove("ranges");
            }
            self.numbers.push((pointer, &ordered.targets));
            true
        });
        if is_shown {
            groups.retain(|group| group.count > 0);
        }
        mesh.groups = groups;
        parts.meshes[index] = Some(mesh);
    }
}
