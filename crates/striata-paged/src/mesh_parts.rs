//! Parts of a mesh that is made of pages: groups, attribute layers, materials.

use serde_json::Value;
use striata::mesh::{Appearance, AttributeLayer, ColorSpace, Image, Material, TriangleGroup};

use crate::loaded::{LoadedPages, VertexPlace};
use crate::{Metadata, Page, PagedImage};

/// Triangles of a mesh that is made of pages.
#[derive(Debug, Default)]
pub(crate) struct Triangles {
    /// Corners and group.
    pub list: Vec<([u32; 3], u32)>,
    /// Attribute layers of the triangles.
    pub layers: Vec<AttributeLayer>,
}

impl Triangles {
    /// Adds triangles of a page, with the places where it has them.
    pub(crate) fn extend(&mut self, list: Vec<([u32; 3], u32)>, page: &Page, places: &[u32]) {
        self.list.extend(list);
        let rows = page.triangle_rows(places);
        if self.layers.is_empty() {
            self.layers = rows;
            return;
        }
        for (layer, more) in self.layers.iter_mut().zip(&rows) {
            layer.data.extend_from(&more.data);
        }
    }
}

/// Groups, triangles and their data in the order of a mesh: sorted by group.
pub(crate) fn grouped(
    triangles: Triangles,
    metadata: &Metadata,
) -> (Vec<TriangleGroup>, Vec<[u32; 3]>, Vec<AttributeLayer>) {
    let Triangles { list: mut triangles, mut layers } = triangles;
    let is_plain = metadata.groups.len() < 2
        && metadata.groups.iter().all(|group| group.name.is_empty() && group.material.is_none());
    if is_plain {
        return (Vec::new(), triangles.into_iter().map(|(corners, _)| corners).collect(), layers);
    }
    if !layers.is_empty() {
        let mut order: Vec<u32> = (0..triangles.len() as u32).collect();
        order.sort_by_key(|&t| triangles[t as usize].1);
        layers = layers.iter().map(|layer| layer.gather(&order)).collect();
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
    (groups, triangles.into_iter().map(|(corners, _)| corners).collect(), layers)
}

/// Attribute layers of some vertices, without the layer that only separates materials.
pub(crate) fn gathered_layers(
    loaded: &LoadedPages<'_>,
    vertices: &[VertexPlace],
    metadata: &Metadata,
) -> Vec<AttributeLayer> {
    let layers = metadata.empty_mesh().layers.into_iter().enumerate();
    let layers = layers.filter(|(_, layer)| !Metadata::is_material_layer(layer));
    layers.map(|(index, layer)| gathered(loaded, vertices, index, layer)).collect()
}

fn gathered(
    loaded: &LoadedPages<'_>,
    vertices: &[VertexPlace],
    index: usize,
    mut layer: AttributeLayer,
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
    let image = |image: &PagedImage| {
        let PagedImage { name, uri, mime_type, bytes, .. } = image.clone();
        Image { name, uri, mime_type, bytes }
    };
    Appearance {
        materials: list("materials").iter().map(material).collect(),
        images: metadata.images.iter().map(image).collect(),
        textures_json: list("textures").iter().map(Value::to_string).collect(),
        samplers_json: list("samplers").iter().map(Value::to_string).collect(),
        extensions_used: list("extensions")
            .iter()
            .filter_map(|name| name.as_str().map(str::to_owned))
            .collect(),
        color_space: match text(&metadata.appearance, "color_space").as_str() {
            "linear" => ColorSpace::Linear,
            _ => ColorSpace::Srgb,
        },
        georeference: metadata.georeference.as_ref().map(Value::to_string).unwrap_or_default(),
        ..Appearance::default()
    }
}
