//! glTF writer: one vertex buffer for all groups, one primitive per group or fan, and unchanged materials.
//!
//! Consecutive groups with the same name become one mesh and one node of that name. A mesh without
//! triangles is written without its vertices, because glTF has no empty primitives.

use std::collections::{BTreeSet, HashMap};

use serde_json::{Map, Value, json};
use striata::mesh::{Appearance, Image, IndexedMesh, TriangleGroup};

use super::builder::{GltfBuilder, TRIANGLE_STRIP};
use super::component_type::GltfComponentType;
use super::files::GltfContainer;
use super::georeference::{add_georeference, is_terrain, place_node};
use super::passes::{GltfParts, WrittenArray};
use super::shading::shaded;
use super::write_layers::{SharedAttributes, attributes};
use crate::WriteOptions;
use crate::cache_order::in_cache_order;
use crate::error::Refusal;
use crate::gltf_json::extensions_in;

const TRIANGLES: u32 = 4;
const TRIANGLE_FAN: u32 = 6;

/// Encodes a mesh as a glTF file, quantized and compressed as the options say.
pub(crate) fn to_bytes(
    mesh: &IndexedMesh,
    options: &WriteOptions,
    mut container: GltfContainer<'_, '_>,
) -> Result<Vec<u8>, Refusal> {
    let image_uris = container.image_uris(&mesh.appearance.images);
    container.packed(document(mesh, options, image_uris)?, options)
}

fn document(
    mesh: &IndexedMesh,
    options: &WriteOptions,
    image_uris: Vec<Option<String>>,
) -> Result<GltfParts, Refusal> {
    let keeps_vertices = options.strips.is_some() || options.fans.is_some();
    let mesh = if options.shading && !keeps_vertices { &*shaded(mesh) } else { mesh };
    // Shading divides vertices, so the order comes after it.
    let mesh = if options.has_cache_order() { &in_cache_order(mesh) } else { mesh };
    let mut builder = GltfBuilder::default().with_image_uris(image_uris);
    let mut root = Map::new();
    root.insert("asset".to_owned(), json!({ "version": "2.0", "generator": "striata" }));
    root.insert("scene".to_owned(), json!(0));
    let (meshes, nodes) = builder.meshes(mesh, options)?;
    let roots: Vec<usize> = (0..nodes.len).collect();
    let mut scene = if roots.is_empty() { json!({}) } else { json!({ "nodes": roots }) };
    add_georeference(&mut scene, &mesh.appearance);
    insert(&mut root, "scenes", vec![scene]);
    let extensions = builder.looks(mesh, &mut root)?;
    insert(&mut root, "extensionsUsed", extensions.into_iter().map(Value::String).collect());
    insert(&mut root, "accessors", builder.accessors);
    insert(&mut root, "bufferViews", builder.views);
    if !builder.binary.is_empty() {
        insert(&mut root, "buffers", vec![json!({ "byteLength": builder.binary.len() })]);
    }
    let written = vec![("meshes", meshes), ("nodes", nodes)];
    Ok(GltfParts { root: Value::Object(root), binary: builder.binary, written })
}

/// Adds an array to the document unless it is empty, because glTF does not allow empty arrays.
pub(crate) fn insert(root: &mut Map<String, Value>, key: &str, entries: Vec<Value>) {
    if !entries.is_empty() {
        root.insert(key.to_owned(), Value::Array(entries));
    }
}

impl GltfBuilder {
    /// Adds the vertices and triangles of a mesh, and returns the entries of its meshes and nodes.
    fn meshes(
        &mut self,
        mesh: &IndexedMesh,
        options: &WriteOptions,
    ) -> Result<(WrittenArray, WrittenArray), Refusal> {
        let groups = mesh.groups_or_whole();
        let lists = index_lists(mesh, &groups, options)?;
        let (mut meshes, mut nodes) = (WrittenArray::default(), WrittenArray::default());
        if lists.iter().all(|list| list.indices.is_empty()) {
            return Ok((meshes, nodes));
        }
        let attributes = attributes(self, mesh)?;
        let indices = self.push_indices(lists.iter().map(|list| &list.indices[..]), mesh.positions.len());
        let shown: Vec<_> = lists
            .iter()
            .zip(indices)
            .filter_map(|(list, accessor)| Some((&groups[list.group], list.mode, accessor?)))
            .collect();
        for alike in shown.chunk_by(|(a, ..), (b, ..)| a.name == b.name) {
            let primitives: Vec<Value> = alike
                .iter()
                .map(|&(group, mode, accessor)| primitive(&attributes, accessor, mode, group.material))
                .collect();
            let name = &alike[0].0.name;
            let mut node = json!({ "mesh": meshes.len });
            place_node(&mut node, mesh.origin, options.z_up || is_terrain(&mesh.appearance));
            let mut entry = json!({ "primitives": primitives });
            if !name.is_empty() {
                node["name"] = json!(name);
                entry["name"] = json!(name);
            }
            meshes.push(&entry);
            nodes.push(&node);
        }
        Ok((meshes, nodes))
    }

    /// Adds all index lists to one view, with an accessor for each list that is not empty.
    pub(super) fn push_indices<'l>(
        &mut self,
        lists: impl IntoIterator<Item = &'l [u32]>,
        vertex_count: usize,
    ) -> Vec<Option<usize>> {
        // The largest 16-bit value is left for primitive restart.
        let component =
            if vertex_count <= u16::MAX as usize { GltfComponentType::U16 } else { GltfComponentType::U32 };
        let (mut bytes, mut accessors) = (Vec::new(), Vec::new());
        let mut offset_of: HashMap<&[u32], usize> = HashMap::new();
        for list in lists {
            // Primitives that show the same triangles, in other materials, share them.
            let next = bytes.len();
            let offset = *offset_of.entry(list).or_insert(next);
            match component {
                _ if offset < next => {}
                GltfComponentType::U16 => bytes.extend(list.iter().flat_map(|&v| (v as u16).to_le_bytes())),
                _ => bytes.extend_from_slice(bytemuck::cast_slice(list)),
            }
            let accessor = json!({
                "byteOffset": offset,
                "componentType": component.number(),
                "count": list.len(),
                "type": "SCALAR",
            });
            accessors.push((!list.is_empty()).then_some(accessor));
        }
        let view = self.push_index_data(&bytes);
        let numbered = accessors.into_iter().map(|accessor| {
            accessor.map(|mut accessor| {
                accessor["bufferView"] = json!(view);
                self.push_shared_accessor("indices", accessor)
            })
        });
        numbered.collect()
    }

    /// Adds materials, textures, samplers and images, and returns the extensions that they use.
    fn looks(
        &mut self,
        mesh: &IndexedMesh,
        root: &mut Map<String, Value>,
    ) -> Result<BTreeSet<String>, Refusal> {
        let extensions = looks(&mesh.appearance, root)?;
        let images = mesh.appearance.images.iter().enumerate();
        let images: Result<_, Refusal> = images.map(|(index, image)| self.image(image, index)).collect();
        insert(root, "images", images?);
        Ok(extensions)
    }

    fn image(&mut self, image: &Image, index: usize) -> Result<Value, Refusal> {
        let mut value = image_entry(image);
        self.image_source(index, image, &mut value);
        if value.get("bufferView").is_none() && value.get("uri").is_none() {
            return Err(Refusal::BadMesh(format!("image {index} has neither typed bytes nor a URI")));
        }
        Ok(value)
    }

    /// Adds the bytes of an image, or its URI if there are none, to its entry.
    pub(super) fn image_source(&mut self, index: usize, image: &Image, value: &mut Value) {
        if !image.mime_type.is_empty() {
            value["mimeType"] = json!(image.mime_type);
        }
        if let Some(Some(uri)) = self.image_uris.get(index) {
            value["uri"] = json!(uri);
        } else if !image.bytes.is_empty() && !image.mime_type.is_empty() {
            value["bufferView"] = json!(self.push_view(&image.bytes, None, None));
        } else if !image.uri.is_empty() {
            value["uri"] = json!(image.uri);
        }
    }
}

/// Adds materials, textures and samplers, and returns the extensions that they use.
pub(crate) fn looks(looks: &Appearance, root: &mut Map<String, Value>) -> Result<BTreeSet<String>, Refusal> {
    let mut materials = Vec::new();
    for (index, material) in looks.materials.iter().enumerate() {
        let mut value = match material.gltf_json.as_str() {
            "" => json!({}),
            text => object(text, "material", index)?,
        };
        if !material.name.is_empty() {
            value["name"] = json!(material.name);
        }
        materials.push(value);
    }
    let parsed = |texts: &[String], what: &str| -> Result<Vec<Value>, Refusal> {
        texts.iter().enumerate().map(|(index, text)| object(text, what, index)).collect()
    };
    let textures = parsed(&looks.textures_json, "texture")?;
    let samplers = parsed(&looks.samplers_json, "sampler")?;
    let mut extensions = BTreeSet::new();
    for value in materials.iter().chain(&textures).chain(&samplers) {
        extensions_in(value, &mut extensions);
    }
    insert(root, "materials", materials);
    insert(root, "textures", textures);
    insert(root, "samplers", samplers);
    Ok(extensions)
}

/// Returns the entry of an image, without its source.
pub(crate) fn image_entry(image: &Image) -> Value {
    let mut value = json!({});
    if !image.name.is_empty() {
        value["name"] = json!(image.name);
    }
    value
}

/// Parses a JSON object that the mesh carries as text.
fn object(text: &str, what: &str, index: usize) -> Result<Value, Refusal> {
    match serde_json::from_str(text) {
        Ok(value @ Value::Object(_)) => Ok(value),
        Ok(_) => Err(Refusal::BadMesh(format!("the JSON of {what} {index} is not an object"))),
        Err(error) => Err(Refusal::BadMesh(format!("the JSON of {what} {index} is broken: {error}"))),
    }
}

fn primitive(attributes: &SharedAttributes, indices: usize, mode: u32, material: Option<u32>) -> Value {
    let mut primitive = json!({ "attributes": attributes.attributes, "indices": indices, "mode": mode });
    if !attributes.targets.is_empty() {
        primitive["targets"] = Value::Array(attributes.targets.clone());
    }
    if let Some(material) = material {
        primitive["material"] = json!(material);
    }
    primitive
}

/// Indices of a primitive.
struct PrimitiveIndices {
    /// Primitive mode of glTF.
    mode: u32,
    group: usize,
    indices: Vec<u32>,
}

/// Returns one list for each group, of its triangles or of the caller's strips, or one for each fan.
fn index_lists(
    mesh: &IndexedMesh,
    groups: &[TriangleGroup],
    options: &WriteOptions,
) -> Result<Vec<PrimitiveIndices>, Refusal> {
    if let Some(fans) = &options.fans {
        check_groups("groups of fans", fans.len(), groups)?;
        let of_group = |(group, fans): (usize, &Vec<Vec<u32>>)| {
            let list = |fan: &Vec<u32>| PrimitiveIndices { mode: TRIANGLE_FAN, group, indices: fan.clone() };
            fans.iter().map(list).collect::<Vec<_>>()
        };
        let lists: Vec<PrimitiveIndices> = fans.iter().enumerate().flat_map(of_group).collect();
        check_lists("fan", lists.iter().map(|list| &list.indices[..]), mesh)?;
        return Ok(lists);
    }
    if let Some(strips) = &options.strips {
        check_lists("strip", strips.iter().map(|strip| &strip[..]), mesh)?;
        check_groups("strips", strips.len(), groups)?;
    }
    let strip_of =
        |group: usize| options.strips.as_ref().map(|strips| &strips[group]).filter(|s| !s.is_empty());
    let lists = groups.iter().enumerate().map(|(group, triangles)| match strip_of(group) {
        Some(strip) => PrimitiveIndices { mode: TRIANGLE_STRIP, group, indices: strip.clone() },
        None => {
            let indices = mesh.triangles[triangles.range()].as_flattened().to_vec();
            PrimitiveIndices { mode: TRIANGLES, group, indices }
        }
    });
    Ok(lists.collect())
}

fn check_groups(what: &str, found: usize, groups: &[TriangleGroup]) -> Result<(), Refusal> {
    if found == groups.len() {
        return Ok(());
    }
    Err(Refusal::BadMesh(format!("{found} {what} for {} triangle groups", groups.len())))
}

fn check_lists<'a>(
    what: &str,
    lists: impl Iterator<Item = &'a [u32]>,
    mesh: &IndexedMesh,
) -> Result<(), Refusal> {
    let vertex_count = mesh.positions.len();
    for (number, list) in lists.enumerate() {
        if let Some(place) = list.iter().position(|&v| v as usize >= vertex_count) {
            let vertex = list[place];
            let reason = format!("{what} {number}, index {place}: vertex {vertex} of {vertex_count}");
            return Err(Refusal::BadMesh(reason));
        }
        if matches!(list.len(), 1 | 2) {
            return Err(Refusal::BadMesh(format!("{what} {number} has only {} indices", list.len())));
        }
    }
    Ok(())
}
