//! Writes a [`Scene`] as glTF: the document as it was read, with new accessors for its triangles.
//!
//! All primitives of a mesh share one vertex buffer and have the attributes that they had. Meshes with equal
//! vertices share them too, and so do those with equal triangles: one ball in many colors is stored once. A primitive of
//! which a coarse level shows nothing is left out, because glTF has no empty primitives; on request, it gets
//! one triangle without area instead, so that primitives keep their numbers.

use std::collections::{BTreeMap, HashMap, HashSet};
use std::rc::Rc;

use serde_json::{Map, Value, json};
use striata::mesh::{AttributeLayer, IndexedMesh, LayerData, Semantic};
use striata::strip::cache_order;

use super::builder::GltfBuilder;
use super::files::GltfContainer;
use super::passes::GltfParts;
use super::references::{entries, has_triangles};
use super::semantics::{semantic, semantic_in_target};
use super::vertex_pools::{Pool, pools};
use super::write::insert;
use super::write_layers::{SharedAttributes, attributes};
use crate::cache_order::with_triangles_in_cache_order;
use crate::error::Refusal;
use crate::{SceneWriter, WriteOptions};

/// Encodes a scene as a glTF file, quantized and compressed as the options say.
pub(crate) fn scene_to_bytes(
    writer: &SceneWriter<'_>,
    options: &WriteOptions,
    mut container: GltfContainer<'_, '_>,
) -> Result<Vec<u8>, Refusal> {
    let image_uris = container.image_uris(writer.scene.images());
    let mut parts = document(writer, options, image_uris)?;
    parts.apply(options)?;
    container.packed(parts)
}

fn document(
    writer: &SceneWriter<'_>,
    options: &WriteOptions,
    image_uris: Vec<Option<String>>,
) -> Result<GltfParts, Refusal> {
    if options.strips.is_some() || options.fans.is_some() {
        return Err(Refusal::Unsupported("strips and fans are for files with one mesh".to_owned()));
    }
    let scene = writer.scene;
    let mut root = scene.document().clone();
    let mut take = |key: &str| match root.as_object_mut().and_then(|map| map.remove(key)) {
        Some(Value::Array(entries)) => entries,
        _ => Vec::new(),
    };
    let (views, accessors) = (take("bufferViews"), take("accessors"));
    let builder = GltfBuilder::continuing(scene.buffer().to_vec(), views, accessors);
    let mut builder = builder.with_image_uris(image_uris);
    put_meshes(&mut builder, &mut root, writer, options.has_cache_order())?;
    for (index, (entry, image)) in entries(&mut root, "images").zip(scene.images()).enumerate() {
        builder.image_source(index, image, entry);
    }
    // Equal data, such as the streams of equal meshes, are attached once.
    let mut view_of: HashMap<&[u8], usize> = HashMap::new();
    for (pointer, bytes) in &writer.attachments {
        let Some(reference) = root.pointer_mut(pointer) else {
            return Err(Refusal::BadMesh(format!("the document has no value at {pointer}")));
        };
        let view = *view_of.entry(bytes).or_insert_with(|| builder.push_view(bytes, None, None));
        *reference = json!(view);
    }
    builder.fill_free_slots();
    let Value::Object(mut root) = root else {
        return Err(Refusal::BadMesh("the document is not an object".to_owned()));
    };
    insert(&mut root, "accessors", builder.accessors);
    insert(&mut root, "bufferViews", builder.views);
    if !builder.binary.is_empty() {
        insert(&mut root, "buffers", vec![json!({ "byteLength": builder.binary.len() })]);
    }
    Ok(GltfParts { root: Value::Object(root), binary: builder.binary })
}

/// Meshes that were written, so that equal ones have the same accessors.
#[derive(Default)]
struct WrittenMeshes<'m> {
    /// The first mesh with some vertices and its accessors, by fingerprint.
    vertices: HashMap<u64, (usize, &'m IndexedMesh)>,
    /// A mesh with some vertices and triangles, and the accessors of its indices, by fingerprints.
    indices: HashMap<[u64; 2], (&'m IndexedMesh, Vec<Option<usize>>)>,
}

impl<'m> WrittenMeshes<'m> {
    /// Remembers a mesh; returns the mesh that has its vertices, which may be itself, and the accessors of its
    /// indices if they are those of another one.
    fn find(&mut self, index: usize, mesh: &'m IndexedMesh) -> (usize, Option<Vec<Option<usize>>>, [u64; 2]) {
        let key = mesh.fingerprints();
        let has_equal_vertices =
            |other: &IndexedMesh| other.positions == mesh.positions && other.layers == mesh.layers;
        let (first, other) = *self.vertices.entry(key[0]).or_insert((index, mesh));
        if first == index || !has_equal_vertices(other) {
            return (index, None, key);
        }
        let is_equal = |other: &IndexedMesh| {
            let ranges =
                |mesh: &IndexedMesh| mesh.groups_or_whole().iter().map(|g| g.range()).collect::<Vec<_>>();
            has_equal_vertices(other) && other.triangles == mesh.triangles && ranges(other) == ranges(mesh)
        };
        let found = self.indices.get(&key).filter(|(other, _)| is_equal(other));
        (first, found.map(|(_, indices)| indices.clone()), key)
    }
}

/// Finds vertices that meshes have in common; none if other levels of a mesh refer to its vertices.
fn pools_of(writer: &SceneWriter<'_>, meshes: &[Option<IndexedMesh>]) -> Vec<Pool> {
    if !writer.shared.is_empty() {
        return Vec::new();
    }
    let meshes = meshes.iter().enumerate();
    let shown =
        meshes.filter_map(|(index, mesh)| Some((index, mesh.as_ref().filter(|m| !m.triangles.is_empty())?)));
    let mut known = HashSet::new();
    let different: Vec<_> = shown.filter(|(_, mesh)| known.insert(mesh.fingerprints()[0])).collect();
    pools(&different)
}

/// Returns for each triangle primitive of a mesh whether it is blended, with any of its materials, so that the order of
/// its triangles is the order in which they are drawn over each other.
fn are_blended(document: &Value, mesh: usize) -> Vec<bool> {
    let is_blended = |material: &Value| {
        let material = document.pointer(&format!("/materials/{material}"));
        material.and_then(|material| material.get("alphaMode")).is_some_and(|mode| mode == "BLEND")
    };
    let primitives = document.pointer(&format!("/meshes/{mesh}/primitives")).and_then(Value::as_array);
    let with_triangles = primitives.into_iter().flatten().filter(|primitive| has_triangles(primitive));
    let any_is_blended = |primitive: &Value| {
        let variants =
            primitive.pointer("/extensions/KHR_materials_variants/mappings").and_then(Value::as_array);
        let variants = variants.into_iter().flatten().filter_map(|variant| variant.get("material"));
        primitive.get("material").into_iter().chain(variants).any(is_blended)
    };
    with_triangles.map(any_is_blended).collect()
}

/// Returns the meshes with their triangles in cache order, and their vertices too unless other levels use them.
fn in_cache_order(writer: &SceneWriter<'_>) -> Vec<Option<IndexedMesh>> {
    let ordered = |(index, mesh): (usize, &Option<IndexedMesh>)| {
        let are_blended = are_blended(writer.scene.document(), index);
        let mesh = with_triangles_in_cache_order(mesh.as_ref()?, |group| are_blended[group]);
        Some(if writer.shared.is_empty() { mesh.with_vertices_by_first_use() } else { mesh })
    };
    writer.scene.meshes().iter().enumerate().map(ordered).collect()
}

/// Puts the triangles of index lists into cache order.
fn sort_lists(lists: &mut [Vec<u32>], are_blended: &[bool]) {
    for (list, _) in lists.iter_mut().zip(are_blended).filter(|&(_, &is_blended)| !is_blended) {
        let (triangles, _) = list.as_chunks();
        *list = cache_order(triangles).into_iter().flat_map(|t| triangles[t as usize]).collect();
    }
}

/// Adds the triangles of all meshes; first those with vertices of their own.
fn put_meshes(
    builder: &mut GltfBuilder,
    root: &mut Value,
    writer: &SceneWriter<'_>,
    is_sorted: bool,
) -> Result<(), Refusal> {
    let meshes = if is_sorted { &in_cache_order(writer)[..] } else { writer.scene.meshes() };
    let mut vertices: BTreeMap<usize, Rc<SharedAttributes>> = BTreeMap::new();
    let mut written = WrittenMeshes::default();
    let pools = pools_of(writer, meshes);
    let mut pool_of: BTreeMap<usize, (usize, &[u32])> = BTreeMap::new();
    for (number, pool) in pools.iter().enumerate() {
        pool_of.extend(pool.members.iter().map(|(mesh, numbers)| (*mesh, (number, &numbers[..]))));
    }
    let mut pooled: Vec<Option<Rc<SharedAttributes>>> = vec![None; pools.len()];
    for (index, (entry, mesh)) in entries(root, "meshes").zip(meshes).enumerate() {
        let Some(primitives) = primitives_of(entry) else { continue };
        let Some(mesh) = mesh else {
            if !writer.shared.contains_key(&index) && primitives.iter().any(lacks_data) {
                return Err(Refusal::BadMesh(format!("meshes[{index}] has no triangles")));
            }
            continue;
        };
        if mesh.triangles.is_empty() {
            put_nothing(builder, primitives, mesh)?;
            continue;
        }
        let (first, indices, key) = written.find(index, mesh);
        let found = match vertices.get(&first) {
            Some(found) => Rc::clone(found),
            None => match pool_of.get(&first) {
                None => Rc::new(attributes(builder, mesh)?),
                Some(&(number, _)) => match &pooled[number] {
                    Some(found) => Rc::clone(found),
                    None => {
                        let found = Rc::new(attributes(builder, &pools[number].vertices)?);
                        pooled[number] = Some(Rc::clone(&found));
                        found
                    }
                },
            },
        };
        let empty: &[u32] = if writer.keeps_primitives { &[0, 0, 0] } else { &[] };
        let groups = mesh.groups_or_whole();
        let lists = groups.iter().map(|group| match group.count {
            0 => empty,
            _ => mesh.triangles[group.range()].as_flattened(),
        });
        let indices = match (indices, pool_of.get(&first)) {
            (Some(indices), _) => indices,
            (None, None) => builder.push_indices(lists, mesh.positions.len()),
            (None, Some(&(number, numbers))) => {
                let renumbered = |list: &[u32]| list.iter().map(|&v| numbers[v as usize]).collect();
                let lists: Vec<Vec<u32>> = lists.map(renumbered).collect();
                builder.push_indices(lists.iter().map(Vec::as_slice), pools[number].vertices.vertex_count())
            }
        };
        put_primitives(primitives, indices.clone(), &found);
        written.indices.entry(key).or_insert((mesh, indices));
        vertices.insert(index, found);
    }
    for (index, entry) in entries(root, "meshes").enumerate() {
        let (Some(shared), Some(primitives)) = (writer.shared.get(&index), primitives_of(entry)) else {
            continue;
        };
        let vertex_count = shared.check(index, writer.scene, primitives)?;
        let Some(found) = vertices.get(&shared.vertices_of) else {
            return Err(Refusal::BadMesh(format!("meshes[{}] shows nothing", shared.vertices_of)));
        };
        if shared.index_lists.iter().all(Vec::is_empty) {
            let vertices = meshes[shared.vertices_of].as_ref();
            put_nothing(builder, primitives, vertices.unwrap_or(&IndexedMesh::default()))?;
            continue;
        }
        let mut lists = shared.index_lists.clone();
        if is_sorted {
            sort_lists(&mut lists, &are_blended(writer.scene.document(), index));
        }
        let indices = builder.push_indices(lists.iter().map(Vec::as_slice), vertex_count);
        put_primitives(primitives, indices, found);
    }
    Ok(())
}

fn primitives_of(entry: &mut Value) -> Option<&mut Vec<Value>> {
    entry.get_mut("primitives").and_then(Value::as_array_mut)
}

/// Sets the accessors of all triangle primitives; those without indices are removed.
fn put_primitives(primitives: &mut Vec<Value>, indices: Vec<Option<usize>>, found: &SharedAttributes) {
    let mut indices = indices.into_iter();
    primitives.retain_mut(|primitive| {
        if !has_triangles(primitive) {
            return true;
        }
        let Some(accessor) = indices.next().flatten() else { return false };
        primitive["indices"] = json!(accessor);
        refer(primitive, found);
        true
    });
}

/// Sets the accessors of a primitive's attributes and morph targets.
fn refer(primitive: &mut Value, found: &SharedAttributes) {
    if let Some(Value::Object(attributes)) = primitive.get_mut("attributes") {
        set(attributes, |name| found.attributes.get(name).or_else(|| found.of_layer.get(&semantic(name))));
    }
    let targets = primitive.get_mut("targets").and_then(Value::as_array_mut).into_iter().flatten();
    for (number, target) in targets.enumerate() {
        let Some(target) = target.as_object_mut() else { continue };
        let number = u16::try_from(number).unwrap_or(u16::MAX);
        set(target, |name| found.of_layer.get(&semantic_in_target(number, name)));
    }
}

/// Sets each member to its accessor; a member without one is removed.
fn set<'v>(members: &mut Map<String, Value>, accessor: impl Fn(&str) -> Option<&'v Value>) {
    members.retain(|name, value| match accessor(name) {
        Some(found) => {
            *value = found.clone();
            true
        }
        None => false,
    });
}

/// Whether a triangle primitive has an attribute without an accessor.
fn lacks_data(primitive: &Value) -> bool {
    let attributes = primitive.get("attributes").and_then(Value::as_object);
    has_triangles(primitive) && attributes.into_iter().flat_map(Map::values).any(Value::is_null)
}

/// Returns a layer like another one for a single vertex, with a value that is valid for its meaning.
fn layer_of_point(layer: &AttributeLayer) -> AttributeLayer {
    let value: &[f32] = match layer.semantic {
        Semantic::Normal => &[0.0, 0.0, 1.0],
        Semantic::Tangent => &[1.0, 0.0, 0.0, 1.0],
        Semantic::Weights(0) => &[1.0],
        _ => &[],
    };
    let components = (0..usize::from(layer.component_count)).map(|i| value.get(i).copied().unwrap_or(0.0));
    let data = match layer.data {
        LayerData::F32(_) => LayerData::F32(components.collect()),
        LayerData::U8(_) => LayerData::U8(components.map(|x| if x > 0.0 { u8::MAX } else { 0 }).collect()),
        LayerData::U16(_) => LayerData::U16(components.map(|x| if x > 0.0 { u16::MAX } else { 0 }).collect()),
        ref data => {
            let mut zeros = data.empty_like();
            zeros.resize_with_zeros(usize::from(layer.component_count));
            zeros
        }
    };
    AttributeLayer { data, ..layer.clone() }
}

/// Makes the first triangle primitive show one point, and removes the others if it shows nothing at all.
/// The point has the attributes and morph targets of the mesh, which skins and weights of nodes need.
fn put_nothing(
    builder: &mut GltfBuilder,
    primitives: &mut Vec<Value>,
    mesh: &IndexedMesh,
) -> Result<(), Refusal> {
    let mut is_first = primitives.iter().all(has_triangles);
    let mut point = IndexedMesh::new(vec![[0.0; 3]], vec![]);
    point.layers = mesh.layers.iter().map(layer_of_point).collect();
    let point = attributes(builder, &point)?;
    let indices = builder.push_indices([&[0, 0, 0][..]], 1);
    primitives.retain_mut(|primitive| {
        if !has_triangles(primitive) {
            return true;
        }
        if std::mem::take(&mut is_first) {
            primitive["indices"] = json!(indices[0]);
            refer(primitive, &point);
            return true;
        }
        false
    });
    Ok(())
}
