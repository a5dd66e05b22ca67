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
use super::component_type::GltfComponentType;
use super::files::GltfContainer;
use super::passes::GltfParts;
use super::references::{entries, has_triangles};
use super::semantics::{semantic, semantic_in_target};
use super::vertex_pools::{Pool, pools};
use super::write::insert;
use super::write_layers::{SharedAttributes, attributes};
use crate::error::Refusal;
use crate::scene::IndexPrefix;
use crate::{SceneWriter, WriteOptions};

/// Encodes a scene as a glTF file, quantized and compressed as the options say.
pub(crate) fn scene_to_bytes(
    writer: &SceneWriter<'_>,
    options: &WriteOptions,
    mut container: GltfContainer<'_, '_>,
) -> Result<Vec<u8>, Refusal> {
    let image_uris = container.image_uris(writer.scene.images());
    container.packed(document(writer, options, image_uris)?, options)
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
    put_numbers(&mut builder, &mut root, writer)?;
    for (index, (entry, image)) in entries(&mut root, "images").zip(scene.images()).enumerate() {
        builder.image_source(index, image, entry);
    }
    // Equal data, such as the streams of equal meshes, are attached once.
    let mut view_of: HashMap<&[u8], usize> = HashMap::new();
    for (pointer, bytes) in &writer.attachments {
        let reference = value_at(&mut root, pointer)?;
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
    Ok(GltfParts { root: Value::Object(root), binary: builder.binary, ..GltfParts::default() })
}

fn value_at<'v>(root: &'v mut Value, pointer: &str) -> Result<&'v mut Value, Refusal> {
    let missing = || Refusal::BadMesh(format!("the document has no value at {pointer}"));
    root.pointer_mut(pointer).ok_or_else(missing)
}

/// Adds the accessors of numbers, and makes primitives show only the first of their indices.
fn put_numbers(builder: &mut GltfBuilder, root: &mut Value, writer: &SceneWriter<'_>) -> Result<(), Refusal> {
    let mut accessor_of: HashMap<&[u32], usize> = HashMap::new();
    for (pointer, numbers) in &writer.numbers {
        let reference = value_at(root, pointer)?;
        let accessor = *accessor_of.entry(numbers).or_insert_with(|| {
            let view = builder.push_view(bytemuck::cast_slice(numbers), None, None);
            let component = GltfComponentType::U32.number();
            let count = numbers.len();
            let accessor =
                json!({ "bufferView": view, "componentType": component, "count": count, "type": "SCALAR" });
            builder.push_accessor(accessor)
        });
        *reference = json!(accessor);
    }
    let mut shown_of: BTreeMap<(usize, usize), usize> = BTreeMap::new();
    for IndexPrefix { primitive, count, all } in &writer.prefixes {
        let indices = value_at(root, &format!("{primitive}/indices"))?;
        let whole = indices.as_u64().map_or(usize::MAX, |index| index as usize);
        let Some(accessor) = builder.accessors.get(whole).cloned() else {
            return Err(Refusal::BadMesh(format!("{primitive} shows nothing")));
        };
        let shown = *shown_of.entry((whole, *count)).or_insert_with(|| {
            let mut accessor = accessor;
            accessor["count"] = json!(count);
            builder.push_accessor(accessor)
        });
        *indices = json!(shown);
        *value_at(root, all)? = json!(whole);
    }
    Ok(())
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

/// Finds vertices that meshes have in common; none if levels of a mesh refer to its vertices.
fn pools_of(writer: &SceneWriter<'_>, meshes: &[Option<IndexedMesh>]) -> Vec<Pool> {
    if writer.has_fixed_vertices() {
        return Vec::new();
    }
    let meshes = meshes.iter().enumerate();
    let shown =
        meshes.filter_map(|(index, mesh)| Some((index, mesh.as_ref().filter(|m| !m.triangles.is_empty())?)));
    let mut known = HashSet::new();
    let different: Vec<_> = shown.filter(|(_, mesh)| known.insert(mesh.fingerprints()[0])).collect();
    pools(&different)
}

/// Returns the meshes with their triangles in cache order, and their vertices too unless other levels use them.
fn in_cache_order(writer: &SceneWriter<'_>) -> Vec<Option<IndexedMesh>> {
    let meshes = writer.scene.meshes_in_cache_order().into_iter();
    if writer.has_fixed_vertices() {
        return meshes.collect();
    }
    meshes.map(|mesh| Some(mesh?.with_vertices_by_first_use())).collect()
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
            sort_lists(&mut lists, &writer.scene.are_blended(index));
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
