//! Merging of equal parts of a scene.

use std::collections::{BTreeSet, HashMap};
use std::hash::Hash;

use serde_json::{Value, json};
use striata::mesh::IndexedMesh;

use super::{Scene, number_materials};
use crate::gltf::{are_all_known, entries};

/// How many parts of a scene were left out because others are equal.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct MergedParts {
    /// Images with the same bytes.
    pub images: usize,
    /// Textures with equal images and samplers; names do not count.
    pub textures: usize,
    /// Materials of the same name with equal values.
    pub materials: usize,
    /// Vertices with equal positions and attributes.
    pub vertices: usize,
    /// Meshes of the same name with equal triangles and materials.
    pub meshes: usize,
}

/// Receives each reference to a part; it may change them.
type Visit<'v> = dyn FnMut(&mut Value) + 'v;

impl Scene {
    /// Merges equal images, samplers, textures, materials, vertices and meshes, in this order, and reports how many
    /// were left out.
    ///
    /// Materials and meshes with different names stay apart, because programs find them by their names, and so do
    /// those that an animation changes. A scene with an unknown extension, which may refer to any part by its
    /// number, stays as it is.
    #[must_use]
    pub fn deduplicated(mut self) -> (Self, MergedParts) {
        let mut merged = MergedParts::default();
        if !are_all_known(&self.document) || uses(&self.document, "KHR_texture_procedurals") {
            return (self, merged);
        }
        let document = &mut self.document;
        let images = &self.images;
        let bytes_of = |number: usize, _: &Value| {
            images.get(number).map(|image| &image.bytes).filter(|bytes| !bytes.is_empty()).cloned()
        };
        let found = merge(document, "images", bytes_of, of_images);
        found.retain(&mut self.images);
        merged.images = found.left_out();
        merge(document, "samplers", |_, sampler| Some(without(sampler, "name")), of_samplers);
        let textures = |_, texture: &Value| Some(without(texture, "name"));
        merged.textures = merge(document, "textures", textures, of_textures).left_out();
        let materials = |_, material: &Value| Some(material.to_string());
        merged.materials = merge(document, "materials", materials, of_materials).left_out();
        if merged.materials > 0 {
            self.number_groups();
        }
        for mesh in self.meshes.iter_mut().flatten() {
            let before = mesh.vertex_count();
            *mesh = with_merged_vertices(mesh);
            merged.vertices += before - mesh.vertex_count();
        }
        merged.meshes = self.merge_meshes();
        (self, merged)
    }

    /// Numbers the materials of all meshes anew, by those of their primitives.
    fn number_groups(&mut self) {
        for index in 0..self.meshes.len() {
            let materials = self.primitive_materials(index);
            let Some(mesh) = &mut self.meshes[index] else { continue };
            for (group, material) in mesh.groups.iter_mut().zip(materials) {
                group.material = material.map(|material| material as u32);
            }
            number_materials(mesh);
        }
    }

    /// Returns the number of meshes that were left out.
    fn merge_meshes(&mut self) -> usize {
        // The first mesh of each fingerprint; others of it are compared as a whole.
        let mut first_of: HashMap<[u64; 2], usize> = HashMap::new();
        let meshes = &self.meshes;
        let alike: Vec<usize> = (0..meshes.len())
            .map(|index| {
                let Some(mesh) = &meshes[index] else { return usize::MAX };
                let first = *first_of.entry(mesh.fingerprints()).or_insert(index);
                if meshes[first] == meshes[index] { first } else { index }
            })
            .collect();
        let key = |number: usize, entry: &Value| Some((alike.get(number).copied(), entry.to_string()));
        let found = merge(&mut self.document, "meshes", key, of_meshes);
        found.retain(&mut self.meshes);
        for instance in &mut self.instances {
            instance.mesh = found.numbers[instance.mesh];
        }
        found.left_out()
    }
}

/// Merges vertices that are equal in every bit. Triangles keep their order.
fn with_merged_vertices(mesh: &IndexedMesh) -> IndexedMesh {
    let rows: Vec<(&[u8], usize)> = mesh
        .layers
        .iter()
        .map(|layer| (layer.data.as_bytes(), layer.component_count as usize * layer.data.component_bytes()))
        .chain((!mesh.exact_positions.is_empty()).then(|| (bytemuck::cast_slice(&mesh.exact_positions), 24)))
        .collect();
    let mut first_of: HashMap<Vec<u8>, u32> = HashMap::new();
    let (mut numbers, mut kept) = (Vec::with_capacity(mesh.vertex_count()), Vec::new());
    for (vertex, position) in mesh.positions.iter().enumerate() {
        let mut row = bytemuck::bytes_of(position).to_vec();
        for (bytes, size) in &rows {
            row.extend_from_slice(&bytes[vertex * size..][..*size]);
        }
        let number = *first_of.entry(row).or_insert(kept.len() as u32);
        if number as usize == kept.len() {
            kept.push(vertex as u32);
        }
        numbers.push(number);
    }
    IndexedMesh {
        positions: kept.iter().map(|&vertex| mesh.positions[vertex as usize]).collect(),
        exact_positions: mesh.gathered_exact_positions(&kept),
        layers: mesh.layers.iter().map(|layer| layer.gather(&kept)).collect(),
        triangles: mesh.triangles.iter().map(|triangle| triangle.map(|v| numbers[v as usize])).collect(),
        ..mesh.clone()
    }
}

/// Result of merging the equal entries of a list.
struct Merged {
    /// New number of each entry: that of the first equal one.
    numbers: Vec<usize>,
    /// Whether each is the first of its kind.
    is_kept: Vec<bool>,
}

impl Merged {
    /// Leaves out what belongs to the entries that were merged into others.
    fn retain<T>(&self, list: &mut Vec<T>) {
        let mut is_kept = self.is_kept.iter();
        list.retain(|_| is_kept.next() != Some(&false));
    }

    fn left_out(&self) -> usize {
        self.is_kept.iter().filter(|&&is_kept| !is_kept).count()
    }
}

/// Merges entries of a list with equal keys into the first of them. Entries without a key stay.
fn merge<K: Hash + Eq>(
    document: &mut Value,
    list: &str,
    key: impl Fn(usize, &Value) -> Option<K>,
    for_each: fn(&mut Value, &mut Visit<'_>),
) -> Merged {
    let animated = animated_entries(document, list);
    let mut found = Merged { numbers: Vec::new(), is_kept: Vec::new() };
    let Some(Value::Array(all)) = document.get_mut(list) else { return found };
    let (mut first_of, mut next) = (HashMap::new(), 0usize);
    for (number, entry) in all.iter().enumerate() {
        let key = key(number, entry).filter(|_| !animated.contains(&number));
        let own = key.map_or(next, |key| *first_of.entry(key).or_insert(next));
        found.is_kept.push(own == next);
        found.numbers.push(own);
        next += usize::from(own == next);
    }
    if found.left_out() == 0 {
        return found;
    }
    found.retain(all);
    let new_number = |old: Option<usize>| old.and_then(|old| found.numbers.get(old));
    for_each(document, &mut |number| {
        let old = number.as_u64().and_then(|old| usize::try_from(old).ok());
        if let Some(new) = new_number(old) {
            *number = json!(new);
        }
    });
    for pointer in pointers(document) {
        let moved = pointed(pointer, list).and_then(|(old, rest)| Some((new_number(Some(old))?, rest)));
        if let Some(moved) = moved.map(|(new, rest)| format!("/{list}/{new}{rest}")) {
            *pointer = json!(moved);
        }
    }
    found
}

/// Pointers of animations (`KHR_animation_pointer`).
fn pointers(document: &mut Value) -> impl Iterator<Item = &mut Value> {
    let channels = entries(document, "animations").flat_map(|animation| entries(animation, "channels"));
    channels.filter_map(|channel| channel.pointer_mut("/target/extensions/KHR_animation_pointer/pointer"))
}

/// Splits a pointer into an entry of a list.
fn pointed<'p>(pointer: &'p Value, list: &str) -> Option<(usize, &'p str)> {
    let rest = pointer.as_str()?.strip_prefix('/')?.strip_prefix(list)?.strip_prefix('/')?;
    let end = rest.find('/').unwrap_or(rest.len());
    Some((rest[..end].parse().ok()?, &rest[end..]))
}

fn animated_entries(document: &mut Value, list: &str) -> BTreeSet<usize> {
    pointers(document).filter_map(|pointer| Some(pointed(pointer, list)?.0)).collect()
}

fn without(entry: &Value, key: &str) -> String {
    let mut entry = entry.clone();
    entry.as_object_mut().map(|members| members.remove(key));
    entry.to_string()
}

fn uses(document: &Value, extension: &str) -> bool {
    let used = document.get("extensionsUsed").and_then(Value::as_array).into_iter().flatten();
    used.filter_map(Value::as_str).any(|name| name == extension)
}

fn of_images(document: &mut Value, visit: &mut Visit<'_>) {
    for texture in entries(document, "textures") {
        texture.get_mut("source").map(&mut *visit);
        let extensions = texture.get_mut("extensions").and_then(Value::as_object_mut);
        for extension in extensions.into_iter().flat_map(|map| map.values_mut()) {
            extension.get_mut("source").map(&mut *visit);
        }
    }
    if let Some(lights) = document.pointer_mut("/extensions/EXT_lights_image_based") {
        for light in entries(lights, "lights") {
            for level in entries(light, "specularImages") {
                level.as_array_mut().into_iter().flatten().for_each(&mut *visit);
            }
        }
    }
}

fn of_samplers(document: &mut Value, visit: &mut Visit<'_>) {
    entries(document, "textures").filter_map(|texture| texture.get_mut("sampler")).for_each(visit);
}

fn of_textures(document: &mut Value, visit: &mut Visit<'_>) {
    entries(document, "materials").for_each(|material| of_texture_infos(material, visit));
    for mesh in entries(document, "meshes") {
        entries(mesh, "primitives")
            .filter_map(|primitive| primitive.get_mut("extensions"))
            .for_each(|extensions| of_texture_infos(extensions, visit));
    }
    if let Some(metadata) = document.pointer_mut("/extensions/EXT_structural_metadata") {
        for textures in entries(metadata, "propertyTextures") {
            let properties = textures.get_mut("properties").and_then(Value::as_object_mut);
            let properties = properties.into_iter().flat_map(|map| map.values_mut());
            properties.filter_map(|property| property.get_mut("index")).for_each(&mut *visit);
        }
    }
}

/// Visits the numbers of textures in all members whose names end in "texture".
fn of_texture_infos(value: &mut Value, visit: &mut Visit<'_>) {
    match value {
        Value::Object(members) => {
            for (key, member) in members.iter_mut().filter(|(key, _)| *key != "extras") {
                if key.ends_with("Texture") || key == "texture" {
                    member.get_mut("index").map(&mut *visit);
                }
                of_texture_infos(member, visit);
            }
        }
        Value::Array(members) => members.iter_mut().for_each(|member| of_texture_infos(member, visit)),
        _ => {}
    }
}

fn of_materials(document: &mut Value, visit: &mut Visit<'_>) {
    for mesh in entries(document, "meshes") {
        for primitive in entries(mesh, "primitives") {
            primitive.get_mut("material").map(&mut *visit);
            if let Some(variants) = primitive.pointer_mut("/extensions/KHR_materials_variants") {
                let mappings = entries(variants, "mappings");
                mappings.filter_map(|mapping| mapping.get_mut("material")).for_each(&mut *visit);
            }
        }
    }
    for material in entries(document, "materials") {
        if let Some(levels) = material.pointer_mut("/extensions/MSFT_lod") {
            entries(levels, "ids").for_each(&mut *visit);
        }
    }
}

fn of_meshes(document: &mut Value, visit: &mut Visit<'_>) {
    entries(document, "nodes").filter_map(|node| node.get_mut("mesh")).for_each(visit);
}
