//! Binary data of a document other than triangles and images: animations, skins, points and lines.
//!
//! The data are collected in one buffer. Usually each accessor that is still referred to is copied and
//! renumbered. If an unknown extension might contain indices of accessors or buffer views, all of them keep
//! their numbers instead, and the slots of triangle data stay empty (`null`).

use std::collections::{BTreeMap, BTreeSet, HashMap};
use std::hash::{DefaultHasher, Hash, Hasher};
use std::ops::Range;

use serde_json::{Map, Value, json};

use super::accessor::{Sparse, accessor};
use super::compression;
use super::document::GltfDocument;
use super::json::JsonNode;
use super::references::{Referent, Use, entries, for_each_carried, has_triangles, of_primitive};
use crate::error::Fault;

const ARRAY_BUFFER: u32 = 34962;
const ELEMENT_ARRAY_BUFFER: u32 = 34963;

/// Replaces the accessors, buffer views and buffers of `root`, a copy of the document, by those that are
/// carried; returns the buffer.
///
/// `is_geometry` says for each mesh whether its triangle primitives are left out.
pub(super) fn carry(
    document: &GltfDocument<'_>,
    root: &mut Map<String, Value>,
    is_geometry: &[bool],
    keeps_numbers: bool,
) -> Result<Vec<u8>, Fault> {
    let mut value = Value::Object(std::mem::take(root));
    let carried = if keeps_numbers {
        with_same_numbers(document, &mut value, is_geometry)?
    } else {
        renumbered(document, &mut value, is_geometry)?
    };
    if let Value::Object(map) = value {
        *root = map;
    }
    for (key, entries) in [("accessors", carried.accessors), ("bufferViews", carried.views)] {
        root.remove(key);
        if entries.iter().any(|entry| !entry.is_null()) {
            root.insert(key.to_owned(), Value::Array(entries));
        }
    }
    root.remove("buffers");
    Ok(carried.buffer)
}

#[derive(Default)]
struct Carried {
    accessors: Vec<Value>,
    views: Vec<Value>,
    buffer: Vec<u8>,
}

impl Carried {
    /// Appends bytes, aligned to 4, and returns their offset.
    fn append(&mut self, bytes: &[u8]) -> usize {
        self.buffer.resize(self.buffer.len().next_multiple_of(4), 0);
        let offset = self.buffer.len();
        self.buffer.extend_from_slice(bytes);
        offset
    }
}

/// Bytes of accessors that share a buffer view.
#[derive(Default)]
struct SharedView {
    accessors: Vec<usize>,
    bytes: Vec<u8>,
    /// Accessors with their bytes, by a hash of both: equal ones are stored once, such as the times of channels.
    known: HashMap<u64, (usize, Range<usize>)>,
}

fn renumbered(document: &GltfDocument<'_>, root: &mut Value, is_geometry: &[bool]) -> Result<Carried, Fault> {
    let mut carried = Carried::default();
    let mut number_of: BTreeMap<(u64, Use), usize> = BTreeMap::new();
    let mut shared: BTreeMap<Use, SharedView> = BTreeMap::new();
    for_each_carried(root, |mesh| is_geometry[mesh], &mut |referent, reference| {
        let Referent::Accessor(usage) = referent else { return Ok(()) };
        let from = JsonNode { value: reference, path: format!("{usage:?}") };
        let index = from.as_unsigned()?;
        let number = match number_of.get(&(index, usage)) {
            Some(&number) => number,
            None => carried.copy(document, index, usage, &mut shared)?,
        };
        number_of.insert((index, usage), number);
        *reference = json!(number);
        Ok(())
    })?;
    for SharedView { accessors, bytes, .. } in shared.into_values() {
        let offset = carried.append(&bytes);
        let view = carried.views.len();
        carried.views.push(json!({ "buffer": 0, "byteOffset": offset, "byteLength": bytes.len() }));
        for accessor in accessors {
            carried.accessors[accessor]["bufferView"] = json!(view);
        }
    }
    Ok(carried)
}

impl Carried {
    /// Copies an accessor, and returns its number: vertex data to a view of its own, other data to the view of its
    /// use.
    fn copy(
        &mut self,
        document: &GltfDocument<'_>,
        index: u64,
        usage: Use,
        shared: &mut BTreeMap<Use, SharedView>,
    ) -> Result<usize, Fault> {
        let at = document.item("accessors", index, &document.root)?;
        let source = accessor(document, index, &document.root)?;
        let mut copy = at.value.clone();
        if let Some(map) = copy.as_object_mut() {
            for key in ["bufferView", "byteOffset", "sparse"] {
                map.remove(key);
            }
        }
        let is_zero = at.get("bufferView").is_none() && at.get("sparse").is_none();
        if is_zero {
            self.accessors.push(copy);
            return Ok(self.accessors.len() - 1);
        }
        if usage == Use::Vertices
            && let Some(sparse) = source.sparse.as_ref().filter(|_| source.bytes.is_none())
            && sparse.is_smaller_than(&source)
        {
            copy["sparse"] = self.copy_sparse(sparse);
            self.accessors.push(copy);
            return Ok(self.accessors.len() - 1);
        }
        let packed = source.packed_bytes();
        document.unpacked.claim(packed.len() as u64, document.input_bytes, &at)?;
        if matches!(usage, Use::Vertices | Use::Indices) {
            copy["bufferView"] = json!(self.views.len());
            let element_bytes = source.component_count * source.component.bytes();
            self.add_view_for_drawing(packed, usage, element_bytes);
        } else {
            let shared = shared.entry(usage).or_default();
            let mut hasher = DefaultHasher::new();
            (copy.to_string(), &packed).hash(&mut hasher);
            let key = hasher.finish();
            if let Some((number, range)) = shared.known.get(&key)
                && shared.bytes[range.clone()] == packed
                && is_equal_but_for_place(&self.accessors[*number], &copy)
            {
                return Ok(*number);
            }
            shared.bytes.resize(shared.bytes.len().next_multiple_of(4), 0);
            let offset = shared.bytes.len();
            shared.known.insert(key, (self.accessors.len(), offset..offset + packed.len()));
            copy["byteOffset"] = json!(offset);
            shared.bytes.extend_from_slice(&packed);
            shared.accessors.push(self.accessors.len());
        }
        self.accessors.push(copy);
        Ok(self.accessors.len() - 1)
    }

    /// Copies the elements that are not zero, each part to a view of its own.
    fn copy_sparse(&mut self, sparse: &Sparse<'_>) -> Value {
        let mut view = |bytes: &[u8]| {
            let offset = self.append(bytes);
            self.views.push(json!({ "buffer": 0, "byteOffset": offset, "byteLength": bytes.len() }));
            self.views.len() - 1
        };
        let (indices, values) = (view(sparse.index_bytes()), view(sparse.value_bytes()));
        json!({
            "count": sparse.count,
            "indices": { "bufferView": indices, "componentType": sparse.index_type.number() },
            "values": { "bufferView": values },
        })
    }

    /// Adds a view of vertices or indices.
    fn add_view_for_drawing(&mut self, packed: Vec<u8>, usage: Use, element_bytes: usize) {
        // Vertices must be aligned to 4 bytes.
        let stride = element_bytes.next_multiple_of(4);
        let bytes = if usage == Use::Vertices && stride != element_bytes {
            let pad = [0; 4];
            let widened = packed.chunks_exact(element_bytes);
            widened.flat_map(|element| [element, &pad[..stride - element_bytes]].concat()).collect()
        } else {
            packed
        };
        let offset = self.append(&bytes);
        let mut view = json!({ "buffer": 0, "byteOffset": offset, "byteLength": bytes.len() });
        if usage == Use::Vertices {
            view["byteStride"] = json!(stride);
            view["target"] = json!(ARRAY_BUFFER);
        } else {
            view["target"] = json!(ELEMENT_ARRAY_BUFFER);
        }
        self.views.push(view);
    }
}

/// Whether an accessor that has a place differs from another one in nothing else.
fn is_equal_but_for_place(stored: &Value, other: &Value) -> bool {
    let mut stored = stored.clone();
    stored.as_object_mut().map(|members| members.remove("byteOffset"));
    stored == *other
}

fn with_same_numbers(
    document: &GltfDocument<'_>,
    root: &mut Value,
    is_geometry: &[bool],
) -> Result<Carried, Fault> {
    let mut left_out = triangle_accessors(document, is_geometry);
    for_each_carried(root, |mesh| is_geometry[mesh], &mut |referent, reference| {
        if matches!(referent, Referent::Accessor(_)) {
            left_out.remove(&reference.as_u64().unwrap_or(u64::MAX));
        }
        Ok::<(), Fault>(())
    })?;
    let (mut carried, mut needed, mut unneeded) =
        (Carried::default(), BTreeSet::new(), unneeded_views(document.root.value));
    for (index, at) in document.root.entries("accessors")?.iter().enumerate() {
        let is_left_out = left_out.contains(&(index as u64));
        let views = [at.value.get("bufferView"), at.value.pointer("/sparse/indices/bufferView")];
        let views = views.into_iter().chain([at.value.pointer("/sparse/values/bufferView")]);
        let found = views.flatten().filter_map(Value::as_u64);
        if is_left_out {
            unneeded.extend(found)
        } else {
            needed.extend(found)
        }
        carried.accessors.push(if is_left_out { Value::Null } else { at.value.clone() });
    }
    for (index, at) in document.root.entries("bufferViews")?.iter().enumerate() {
        let index = index as u64;
        if unneeded.contains(&index) && !needed.contains(&index) {
            carried.views.push(Value::Null);
            continue;
        }
        let (bytes, _) = document.view(index, at)?;
        document.unpacked.claim(bytes.len() as u64, document.input_bytes, at)?;
        let offset = carried.append(bytes);
        let mut view = at.value.clone();
        if let Some(map) = view.as_object_mut() {
            map.insert("buffer".to_owned(), json!(0));
            map.insert("byteOffset".to_owned(), json!(offset));
            map.insert("byteLength".to_owned(), json!(bytes.len()));
            compression::remove_from(map);
        }
        carried.views.push(view);
    }
    Ok(carried)
}

/// Returns the accessors that triangle primitives refer to, whose data become meshes, and the buffer views
/// of their compressed data.
fn triangle_accessors(document: &GltfDocument<'_>, is_geometry: &[bool]) -> BTreeSet<u64> {
    let mut root = document.root.value.clone();
    let mut found = BTreeSet::new();
    for (mesh, &is_geometry) in entries(&mut root, "meshes").zip(is_geometry) {
        for primitive in entries(mesh, "primitives").filter(|p| is_geometry && has_triangles(p)) {
            let visited = of_primitive(primitive, &mut |referent, reference| {
                found.extend(reference.as_u64().filter(|_| matches!(referent, Referent::Accessor(_))));
                Ok::<(), Fault>(())
            });
            debug_assert!(visited.is_ok(), "collecting does not fail");
        }
    }
    found
}

/// Returns the buffer views that contain images, compressed data of primitives, or streams of meshes.
fn unneeded_views(root: &Value) -> BTreeSet<u64> {
    let list = |key: &str| root.get(key).and_then(Value::as_array).into_iter().flatten();
    let images = list("images").filter_map(|image| image.get("bufferView"));
    let primitives = list("meshes").filter_map(|mesh| mesh.get("primitives")?.as_array()).flatten();
    let draco = "/extensions/KHR_draco_mesh_compression/bufferView";
    let compressed = primitives.filter_map(|primitive| primitive.pointer(draco));
    let streams = list("meshes").filter_map(|mesh| mesh.pointer("/extensions/STRIATA_lod/bufferView"));
    images.chain(compressed).chain(streams).filter_map(Value::as_u64).collect()
}
