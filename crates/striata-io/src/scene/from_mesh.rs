//! Scene of a single mesh, from a format without scenes.

use std::collections::BTreeMap;

use serde_json::{Map, Value, json};
use striata::mesh::{IndexedMesh, Material, TriangleGroup};

use super::{Scene, SceneError, SceneParts};
use crate::gltf::{
    add_georeference, attribute_name, image_entry, insert, is_terrain, looks, place_node, target_of,
};
use crate::{Format, convert_colors};

impl Scene {
    /// Creates a scene with one node that shows a mesh, moved by the mesh's origin; triangles of one material
    /// become one primitive, and colors become linear.
    ///
    /// # Errors
    /// [`SceneError`] if the mesh is inconsistent, or the JSON of its materials is broken.
    pub fn from_mesh(mut mesh: IndexedMesh) -> Result<Self, SceneError> {
        mesh.check().map_err(|error| SceneError::at("meshes[0]", error.to_string()))?;
        convert_colors(&mut mesh, Format::Glb);
        let appearance = std::mem::take(&mut mesh.appearance);
        let mut root = Map::new();
        root.insert("asset".to_owned(), json!({ "version": "2.0", "generator": "striata" }));
        root.insert("scene".to_owned(), json!(0));
        let extensions = looks(&appearance, &mut root).map_err(SceneError::from)?;
        insert(&mut root, "images", appearance.images.iter().map(image_entry).collect());
        insert(&mut root, "extensionsUsed", extensions.into_iter().map(Value::String).collect());
        let mut meshes = Vec::new();
        if mesh.triangles.is_empty() {
            root.insert("scenes".to_owned(), json!([{}]));
        } else {
            group_by_material(&mut mesh);
            let primitives: Vec<Value> = mesh.groups.iter().map(|group| primitive(&mesh, group)).collect();
            root.insert("meshes".to_owned(), json!([{ "primitives": primitives }]));
            let mut node = json!({ "mesh": 0 });
            place_node(&mut node, std::mem::take(&mut mesh.origin), is_terrain(&appearance));
            // Nodes place meshes; their vertices have no coordinates of their own in the file.
            mesh.exact_positions.clear();
            root.insert("nodes".to_owned(), json!([node]));
            let mut scene = json!({ "nodes": [0] });
            add_georeference(&mut scene, &appearance);
            root.insert("scenes".to_owned(), json!([scene]));
            number_materials(&mut mesh);
            meshes.push(Some(mesh));
        }
        let document = Value::Object(root);
        Self::from_parts(SceneParts { document, buffer: Vec::new(), images: appearance.images, meshes })
    }
}

/// Sorts triangles by material, in the order in which the materials occur first, and joins their groups.
fn group_by_material(mesh: &mut IndexedMesh) {
    let mut groups: Vec<TriangleGroup> = Vec::new();
    let mut triangles: Vec<Vec<u32>> = Vec::new();
    let mut group_of = BTreeMap::new();
    for group in mesh.groups_or_whole().iter() {
        let index = *group_of.entry(group.material).or_insert_with(|| {
            groups.push(TriangleGroup { material: group.material, ..TriangleGroup::default() });
            triangles.push(Vec::new());
            groups.len() - 1
        });
        triangles[index].extend(group.first..group.first + group.count);
    }
    let old = std::mem::take(&mut mesh.triangles);
    for (group, own) in groups.iter_mut().zip(&triangles) {
        (group.first, group.count) = (mesh.triangles.len() as u32, own.len() as u32);
        mesh.triangles.extend(own.iter().map(|&triangle| old[triangle as usize]));
    }
    let order = triangles.concat();
    mesh.triangle_layers = mesh.triangle_layers.iter().map(|layer| layer.gather(&order)).collect();
    mesh.groups = groups;
}

/// Returns the entry of a group, whose attributes have no accessors yet.
pub(crate) fn primitive(mesh: &IndexedMesh, group: &TriangleGroup) -> Value {
    let mut attributes = Map::from_iter([("POSITION".to_owned(), Value::Null)]);
    let mut targets: Vec<Value> = Vec::new();
    for layer in &mesh.layers {
        match target_of(&layer.semantic, layer.component_count) {
            Some((target, key)) => {
                targets.resize(targets.len().max(target as usize + 1), json!({}));
                targets[target as usize][key] = Value::Null;
            }
            None => {
                attributes.insert(attribute_name(mesh, layer), Value::Null);
            }
        }
    }
    let mut primitive = json!({ "attributes": attributes });
    if !targets.is_empty() {
        primitive["targets"] = json!(targets);
    }
    if let Some(material) = group.material {
        primitive["material"] = json!(material);
    }
    primitive
}

/// Numbers the materials of a mesh from 0, because the mesh does not contain those of other meshes.
pub(crate) fn number_materials(mesh: &mut IndexedMesh) {
    let mut used: Vec<u32> = mesh.groups.iter().filter_map(|group| group.material).collect();
    used.sort_unstable();
    used.dedup();
    for material in mesh.groups.iter_mut().filter_map(|group| group.material.as_mut()) {
        *material = used.partition_point(|&other| other < *material) as u32;
    }
    mesh.appearance.materials = vec![Material::default(); used.len()];
}
