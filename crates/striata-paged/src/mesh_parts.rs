//! Parts of a mesh that is made of pages: groups, attribute layers, materials.

use serde_json::Value;
use striata::mesh::{Appearance, AttributeLayer, Image, Material, TriangleGroup};

use crate::Metadata;
use crate::loaded::{LoadedPages, Place};

/// Sorts triangles by group; returns the groups and the corners.
pub(crate) fn grouped(
    mut triangles: Vec<([u32; 3], u32)>,
    metadata: &Metadata,
) -> (Vec<TriangleGroup>, Vec<[u32; 3]>) {
    let is_plain = metadata.groups.len() < 2
        && metadata.groups.iter().all(|group| group.name.is_empty() && group.material.is_none());
    if is_plain {
        return (Vec::new(), triangles.into_iter().map(|(corners, _)| corners).collect());
    }
    triangles.sort_by_key(|&(_, group)| group);
    let mut groups: Vec<TriangleGroup> = Vec::with_capacity(metadata.groups.len());
    let mut first = 0;
    for (index, group) in (0..).zip(&metadata.groups) {
        let end = triangles.partition_point(|&(_, other)| other <= index) as u32;
        let count = end - first;
        groups.push(TriangleGroup { name: group.name.clone(), material: group.material, first, count });
        first = end;
    }
    (groups, triangles.into_iter().map(|(corners, _)| corners).collect())
}

/// Attribute layers of some vertices, without the layer that only tells materials apart.
pub(crate) fn gathered_layers(
    loaded: &LoadedPages<'_>,
    vertices: &[Place],
    metadata: &Metadata,
) -> Vec<AttributeLayer> {
    let layers = metadata.empty_layers().into_iter().enumerate();
    let layers = layers.filter(|(_, layer)| !Metadata::is_material_layer(layer));
    layers.map(|(index, layer)| gathered(loaded, vertices, (index, layer))).collect()
}

fn gathered(
    loaded: &LoadedPages<'_>,
    vertices: &[Place],
    (index, mut layer): (usize, AttributeLayer),
) -> AttributeLayer {
    let width = layer.component_count as usize;
    for at in vertices {
        let own = &loaded.page(at.slot).layers[index].data;
        let first = at.vertex as usize * width;
        // Pages have the layers of the metadata.
        layer.data.extend_from_range(own, first..first + width);
    }
    layer
}

/// Materials and images of the metadata.
pub(crate) fn appearance(metadata: &Metadata) -> Appearance {
    let list =
        |name: &str| metadata.appearance.get(name).and_then(Value::as_array).cloned().unwrap_or_default();
    let text =
        |value: &Value, name: &str| value.get(name).and_then(Value::as_str).unwrap_or_default().to_owned();
    let material = |value: &Value| Material { name: text(value, "name"), gltf_json: value.to_string() };
    let image =
        |value: &Value| Image { name: text(value, "name"), uri: text(value, "uri"), ..Image::default() };
    Appearance {
        materials: list("materials").iter().map(material).collect(),
        images: list("images").iter().map(image).collect(),
        textures_json: list("textures").iter().map(Value::to_string).collect(),
        samplers_json: list("samplers").iter().map(Value::to_string).collect(),
        ..Appearance::default()
    }
}
