//! Scene of the build items of a file.

use std::collections::BTreeMap;
use std::rc::Rc;

use serde_json::{Map, Value, json};
use striata::mesh::{
    Appearance, AttributeLayer, Image, IndexedMesh, LayerData, Material, Semantic, TriangleGroup,
};

use super::broken;
use super::model::{self, Component, Object, PartModel};
use super::package::ThreeMfPackage;
use super::property::PropertyGroup;
use crate::color_space::srgb_to_linear;
use crate::error::{Fault, Place};
use crate::gltf::{image_entry, insert, looks};
use crate::images::{ImageBudget, media_type};
use crate::report::Warnings;
use crate::scene::{number_materials, primitive};
use crate::wedges::number_wedges;
use crate::{Scene, SceneParts, srgb_to_linear_colors};

/// Deepest nesting of components.
const MAX_DEPTH: usize = 64;
/// Largest number of nodes, so that components that use each other twice cannot fill the memory.
const MAX_NODE_COUNT: usize = 200_000;

/// Marks a corner without a property.
const NONE: u32 = u32::MAX;

/// Object of a part: the part's number and the identifier.
type ObjectKey = (usize, u32);

/// Source of a material.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum MaterialSource {
    /// Entry of base materials: part, group, entry.
    Base(usize, u32, u32),
    /// Image of a texture group: part and image.
    Texture(usize, u32),
}

/// Scene that is being built.
struct SceneBuilder<'p, 'a, 'w> {
    package: &'p mut ThreeMfPackage<'a>,
    warnings: &'w mut Warnings,
    parts: Vec<(String, PartModel)>,
    nodes: Vec<Value>,
    meshes: Vec<Value>,
    triangles: Vec<Option<IndexedMesh>>,
    mesh_of: BTreeMap<ObjectKey, Option<usize>>,
    appearance: Appearance,
    material_of: BTreeMap<MaterialSource, u32>,
    image_of: BTreeMap<String, Option<usize>>,
    budget: ImageBudget,
}

/// Returns the scene of the build items.
pub(super) fn scene_of(package: &mut ThreeMfPackage<'_>, warnings: &mut Warnings) -> Result<Scene, Fault> {
    let budget = ImageBudget::new(package.input_bytes());
    let root = package.root_name()?;
    let mut builder = SceneBuilder {
        package,
        warnings,
        parts: Vec::new(),
        nodes: Vec::new(),
        meshes: Vec::new(),
        triangles: Vec::new(),
        mesh_of: BTreeMap::new(),
        appearance: Appearance::default(),
        material_of: BTreeMap::new(),
        image_of: BTreeMap::new(),
        budget,
    };
    builder.part(&root, &Place::File)?;
    let items = std::mem::take(&mut builder.parts[0].1.items);
    let mut roots = Vec::new();
    for item in &items {
        roots.push(builder.node(item, 0, 0)?);
    }
    builder.finish(&roots)
}

impl SceneBuilder<'_, '_, '_> {
    /// Returns the number of a part, which is read at first use.
    fn part(&mut self, name: &str, place: &Place) -> Result<usize, Fault> {
        let name = name.trim_start_matches('/');
        if let Some(known) = self.parts.iter().position(|(known, _)| known.eq_ignore_ascii_case(name)) {
            return Ok(known);
        }
        let Some(bytes) = self.package.part(name)? else {
            return Err(Fault::Malformed(place.clone(), format!("the part `{name}` does not exist")));
        };
        let model = model::read(name, &bytes, self.warnings)?;
        self.parts.push((name.to_owned(), model));
        Ok(self.parts.len() - 1)
    }

    /// Adds the node of a build item or a component, with those of its components, and returns its index.
    fn node(&mut self, component: &Component, part: usize, depth: usize) -> Result<usize, Fault> {
        let fail = |reason: String| Err(Fault::Malformed(component.place.clone(), reason));
        let part = match &component.path {
            Some(path) => self.part(path, &component.place)?,
            None => part,
        };
        let id = component.object;
        if depth > MAX_DEPTH {
            return fail(format!(
                "object {id}: components nest deeper than {MAX_DEPTH}, or contain themselves"
            ));
        }
        if self.nodes.len() >= MAX_NODE_COUNT {
            return fail(format!("the build consists of more than {MAX_NODE_COUNT} objects"));
        }
        let Some(object) = self.parts[part].1.objects.get(&id) else {
            return fail(format!("object {id} does not exist"));
        };
        let mut node = Map::new();
        if !object.name.is_empty() {
            node.insert("name".to_owned(), json!(object.name));
        }
        if component.transform != super::model::IDENTITY {
            node.insert("matrix".to_owned(), json!(component.transform));
        }
        let components = Rc::clone(&object.components);
        let index = self.nodes.len();
        self.nodes.push(Value::Null);
        let mut children = Vec::new();
        for child in components.iter() {
            children.push(self.node(child, part, depth + 1)?);
        }
        if let Some(mesh) = self.mesh((part, id)) {
            node.insert("mesh".to_owned(), json!(mesh));
        }
        insert(&mut node, "children", children.into_iter().map(Value::from).collect());
        self.nodes[index] = Value::Object(node);
        Ok(index)
    }

    /// Returns the mesh of an object, which is made at first use; [`None`] if it has no triangles.
    fn mesh(&mut self, key: ObjectKey) -> Option<usize> {
        if let Some(&known) = self.mesh_of.get(&key) {
            return known;
        }
        let object = self.parts[key.0].1.objects.get_mut(&key.1).map(std::mem::take).unwrap_or_default();
        let name = object.name.clone();
        // Other uses of the object need its components and its name.
        if let Some(kept) = self.parts[key.0].1.objects.get_mut(&key.1) {
            kept.name.clone_from(&name);
            kept.components = Rc::clone(&object.components);
        }
        let index = (!object.triangles.is_empty()).then(|| {
            let mut mesh = self.triangles_of(key.0, object);
            let primitives: Vec<Value> =
                mesh.groups_or_whole().iter().map(|group| primitive(&mesh, group)).collect();
            let mut entry = json!({ "primitives": primitives });
            if !name.is_empty() {
                entry["name"] = json!(name);
            }
            number_materials(&mut mesh);
            self.meshes.push(entry);
            self.triangles.push(Some(mesh));
            self.triangles.len() - 1
        });
        self.mesh_of.insert(key, index);
        index
    }

    /// Returns the mesh of an object, with triangles sorted by material.
    fn triangles_of(&mut self, part: usize, object: Object) -> IndexedMesh {
        let mut by_material: BTreeMap<Option<u32>, Vec<usize>> = BTreeMap::new();
        let mut corners: Vec<[u32; 3]> = Vec::with_capacity(object.triangles.len() * 3);
        let mut entries = Entries::default();
        for (number, (triangle, property)) in
            object.triangles.iter().zip(&object.triangle_properties).enumerate()
        {
            let (mut material, mut words) = (None, [[NONE; 2]; 3]);
            if let Some((group, numbers)) = *property {
                material = self.look(part, group, numbers[0]);
                let found = self.parts[part].1.properties.get(&group);
                words = entries.words(group, found, numbers, self.warnings);
            }
            by_material.entry(material).or_default().push(number);
            let corner = |(&vertex, [color, texcoord]): (&u32, [u32; 2])| [vertex, color, texcoord];
            corners.extend(triangle.iter().zip(words).map(corner));
        }
        let order = by_material.values().flatten();
        let sorted: Vec<[u32; 3]> =
            order.flat_map(|&n| [corners[3 * n], corners[3 * n + 1], corners[3 * n + 2]]).collect();
        let mut mesh = split(object.positions, &sorted, &entries);
        if by_material.keys().any(Option::is_some) {
            let mut first = 0;
            for (&material, list) in &by_material {
                let count = list.len() as u32;
                mesh.groups.push(TriangleGroup { material, first, count, ..TriangleGroup::default() });
                first += count;
            }
            mesh.appearance.materials = vec![Material::default(); self.appearance.materials.len()];
        }
        srgb_to_linear_colors(&mut mesh);
        mesh
    }

    /// Returns the material of a property of triangles, if it has one.
    fn look(&mut self, part: usize, group: u32, entry: u32) -> Option<u32> {
        let properties = &self.parts[part].1.properties;
        let (look, material) = match properties.get(&group)? {
            PropertyGroup::Materials(entries) => {
                let look = MaterialSource::Base(part, group, entry);
                if let Some(&known) = self.material_of.get(&look) {
                    return Some(known);
                }
                let Some((name, color)) = entries.get(entry as usize) else {
                    warn_missing(self.warnings);
                    return None;
                };
                (look, material_of(name, *color))
            }
            PropertyGroup::Texture(texture) => {
                let look = MaterialSource::Texture(part, texture.texture);
                if let Some(&known) = self.material_of.get(&look) {
                    return Some(known);
                }
                let (path, wraps) = match properties.get(&texture.texture) {
                    Some(PropertyGroup::Image { path, wraps }) => (path.clone(), wraps.clone()),
                    _ => return None,
                };
                (look, self.textured(&path, &wraps)?)
            }
            PropertyGroup::Colors(_) | PropertyGroup::Image { .. } => return None,
        };
        let name = material.get("name").and_then(Value::as_str).unwrap_or("").to_owned();
        self.appearance.materials.push(Material { name, gltf_json: material.to_string() });
        let index = self.appearance.materials.len() as u32 - 1;
        self.material_of.insert(look, index);
        Some(index)
    }

    /// Returns a material that shows the image of a part.
    fn textured(&mut self, path: &str, wraps: &[String; 2]) -> Option<Value> {
        let image = match self.image_of.get(path) {
            Some(&known) => known?,
            None => {
                let read = self.image(path);
                if let Err(reason) = &read {
                    self.warnings.push(Place::File, format!("texture `{path}`: {reason}"));
                }
                let index = read.ok().map(|image| {
                    self.appearance.images.push(image);
                    self.appearance.images.len() - 1
                });
                self.image_of.insert(path.to_owned(), index);
                index?
            }
        };
        let wrap = |name: &String| match name.as_str() {
            "clamp" | "none" => 33071,
            "mirror" => 33648,
            _ => 10497,
        };
        let sampler = json!({ "wrapS": wrap(&wraps[0]), "wrapT": wrap(&wraps[1]) }).to_string();
        let samplers = &mut self.appearance.samplers_json;
        let sampler = samplers.iter().position(|known| *known == sampler).unwrap_or_else(|| {
            samplers.push(sampler);
            samplers.len() - 1
        });
        self.appearance.textures_json.push(json!({ "source": image, "sampler": sampler }).to_string());
        let texture = self.appearance.textures_json.len() - 1;
        Some(
            json!({ "pbrMetallicRoughness": { "baseColorTexture": { "index": texture }, "metallicFactor": 0 } }),
        )
    }

    fn image(&mut self, path: &str) -> Result<Image, String> {
        let found = self.package.part(path);
        let bytes = match found {
            Ok(Some(bytes)) => bytes,
            Ok(None) => return Err("not found".to_owned()),
            Err(_) => return Err("damaged".to_owned()),
        };
        self.budget.take(bytes.len() as u64).map_err(|error| error.to_string())?;
        let mime_type = media_type(&bytes).to_owned();
        if mime_type.is_empty() {
            return Err("not PNG or JPEG".to_owned());
        }
        let name = path.rsplit('/').next().unwrap_or(path).to_owned();
        Ok(Image { name, mime_type, bytes, ..Image::default() })
    }

    fn finish(self, roots: &[usize]) -> Result<Scene, Fault> {
        let mut root = Map::new();
        let model = &self.parts[0].1;
        let mut extras = json!({ "unit": model.unit });
        if !model.metadata.is_empty() {
            let metadata = model.metadata.iter().map(|(name, value)| (name.clone(), json!(value)));
            extras["metadata"] = Value::Object(metadata.collect());
        }
        root.insert(
            "asset".to_owned(),
            json!({ "version": "2.0", "generator": "striata", "extras": extras }),
        );
        root.insert("scene".to_owned(), json!(0));
        let extensions = looks(&self.appearance, &mut root).map_err(|refusal| broken(refusal.into()))?;
        insert(&mut root, "images", self.appearance.images.iter().map(image_entry).collect());
        insert(&mut root, "extensionsUsed", extensions.into_iter().map(Value::String).collect());
        insert(&mut root, "meshes", self.meshes);
        insert(&mut root, "nodes", self.nodes);
        let scene = if roots.is_empty() { json!({}) } else { json!({ "nodes": roots }) };
        root.insert("scenes".to_owned(), json!([scene]));
        let (document, images) = (Value::Object(root), self.appearance.images);
        Scene::from_parts(SceneParts { document, buffer: Vec::new(), images, meshes: self.triangles })
            .map_err(broken)
    }
}

/// Colors and texture coordinates of the groups that an object uses.
#[derive(Default)]
struct Entries {
    colors: Vec<[u8; 4]>,
    texcoords: Vec<[f32; 2]>,
    /// Number of the first entry of each group.
    starts: BTreeMap<u32, u32>,
}

impl Entries {
    /// Returns the numbers of the color and of the texture coordinates of each corner of a triangle.
    fn words(
        &mut self,
        group: u32,
        property: Option<&PropertyGroup>,
        numbers: [u32; 3],
        warnings: &mut Warnings,
    ) -> [[u32; 2]; 3] {
        let (place, count) = match property {
            Some(PropertyGroup::Colors(list)) => (0, list.len()),
            Some(PropertyGroup::Texture(list)) => (1, list.coordinates.len()),
            Some(PropertyGroup::Materials(_)) => return [[NONE; 2]; 3],
            Some(PropertyGroup::Image { .. }) | None => {
                let reason = format!("the properties {group} of triangles are of a kind that is left out");
                warnings.push(Place::File, reason);
                return [[NONE; 2]; 3];
            }
        };
        let start = *self.starts.entry(group).or_insert_with(|| match property {
            Some(PropertyGroup::Colors(list)) => {
                self.colors.extend_from_slice(list);
                (self.colors.len() - list.len()) as u32
            }
            Some(PropertyGroup::Texture(list)) => {
                self.texcoords.extend_from_slice(&list.coordinates);
                (self.texcoords.len() - list.coordinates.len()) as u32
            }
            _ => 0,
        });
        numbers.map(|number| {
            let mut word = [NONE; 2];
            if (number as usize) < count {
                word[place] = start + number;
            } else {
                warn_missing(warnings);
            }
            word
        })
    }
}

fn warn_missing(warnings: &mut Warnings) {
    warnings.push(Place::File, "some triangles use properties that do not exist; they have none");
}

/// Splits vertices whose corners have different colors or texture coordinates.
fn split(positions: Vec<[f32; 3]>, corners: &[[u32; 3]], entries: &Entries) -> IndexedMesh {
    let has = |word: usize| corners.iter().any(|corner| corner[word] != NONE);
    let (has_color, has_texcoord) = (has(1), has(2));
    if !has_color && !has_texcoord {
        let triangles = corners.chunks_exact(3).map(|t| [t[0][0], t[1][0], t[2][0]]).collect();
        return IndexedMesh::new(positions, triangles);
    }
    let (vertices, triangles) = number_wedges(positions.len(), corners);
    let mut mesh = IndexedMesh::new(vertices.iter().map(|v| positions[v[0] as usize]).collect(), triangles);
    if has_texcoord {
        // The origin of 3MF is at the bottom left.
        let texcoord =
            |v: &[u32; 3]| entries.texcoords.get(v[2] as usize).map_or([0.0, 1.0], |&[u, v]| [u, 1.0 - v]);
        let data = vertices.iter().flat_map(texcoord).collect();
        mesh.layers.push(AttributeLayer::from_f32(Semantic::TexCoord(0), 2, data));
    }
    if has_color {
        // Vertices without a color are white, which leaves the color of their material.
        let color = |v: &[u32; 3]| entries.colors.get(v[1] as usize).copied().unwrap_or([255; 4]);
        let width = if vertices.iter().all(|v| color(v)[3] == 255) { 3 } else { 4 };
        let data = vertices.iter().flat_map(|v| color(v).into_iter().take(width)).collect();
        mesh.layers.push(AttributeLayer {
            semantic: Semantic::Color(0),
            component_count: width as u8,
            normalized: true,
            data: LayerData::U8(data),
        });
    }
    mesh
}

/// Returns a base material as a glTF material.
fn material_of(name: &str, color: [u8; 4]) -> Value {
    let [r, g, b, a] = color.map(|byte| f32::from(byte) / 255.0);
    let factor: Vec<Value> =
        [srgb_to_linear(r), srgb_to_linear(g), srgb_to_linear(b), a].map(crate::gltf_json::number).to_vec();
    let mut material = json!({ "pbrMetallicRoughness": { "baseColorFactor": factor, "metallicFactor": 0 } });
    if !name.is_empty() {
        material["name"] = json!(name);
    }
    if color[3] < 255 {
        material["alphaMode"] = json!("BLEND");
    }
    material
}
