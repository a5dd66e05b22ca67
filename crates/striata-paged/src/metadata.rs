//! Metadata of a paged file, which describe the whole mesh.

use std::collections::HashMap;

use serde::{Deserialize, Deserializer, Serialize, Serializer};
use striata::mesh::{AttributeLayer, LayerData, Semantic};
use striata::simplify::cells::CellMesh;

/// Regular positions: `origin + step * i` for integers `i`, computed in f64 and rounded to f32.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct PagedGrid {
    /// Position of the integers 0, in mesh units.
    pub origin: [f64; 3],
    /// Distance of neighboring positions along each axis, in mesh units.
    #[serde(serialize_with = "one_if_equal", deserialize_with = "one_or_three")]
    pub step: [f64; 3],
}

/// Writes a single number if all axes have the same one.
fn one_if_equal<S: Serializer>(step: &[f64; 3], serializer: S) -> Result<S::Ok, S::Error> {
    if step[0] == step[1] && step[1] == step[2] {
        return serializer.serialize_f64(step[0]);
    }
    step.serialize(serializer)
}

fn one_or_three<'de, D: Deserializer<'de>>(deserializer: D) -> Result<[f64; 3], D::Error> {
    #[derive(Deserialize)]
    #[serde(untagged)]
    enum Steps {
        One(f64),
        Three([f64; 3]),
    }
    Ok(match Steps::deserialize(deserializer)? {
        Steps::One(step) => [step; 3],
        Steps::Three(steps) => steps,
    })
}

/// Kind of an attribute layer, and how its values are rounded.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct PagedLayer {
    /// Meaning, as [`Semantic`](striata::mesh::Semantic) is displayed: `normal`, `texcoord_0`.
    pub semantic: String,
    /// Number of values per vertex.
    pub component_count: u8,
    /// Whether integers stand for fractions.
    pub normalized: bool,
    /// `f32`, `u8`, `u16` or `u32`.
    pub component_type: String,
    /// Floats are multiples of this; `None` if they are stored exactly, and for integers.
    pub step: Option<f64>,
}

/// A group of triangles.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct PagedGroup {
    /// Name of the group; may be empty.
    pub name: String,
    /// Index of its material, or `None`.
    pub material: Option<u32>,
}

/// An image of the materials. Its contents follow the pages, or are an object of their own.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default)]
pub struct PagedImage {
    /// Name of the image; may be empty.
    pub name: String,
    /// Location relative to the input; empty if it was embedded there.
    pub uri: String,
    /// MIME type such as `image/png`; may be empty if only `uri` is known.
    pub mime_type: String,
    /// First byte, counted from the first byte of the first page.
    pub offset: u64,
    /// Number of bytes; 0 if the image was missing in the input.
    pub byte_count: u64,
    /// CRC-32 of the bytes.
    pub crc: u32,
    /// Contents, if they have been read.
    #[serde(skip)]
    pub bytes: Vec<u8>,
}

/// Name of a page: the level and the cell whose steps it contains.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
pub struct PageId {
    /// Level of the cell, 0 for the finest. The base page has the number of levels.
    pub level: u8,
    /// Index of the cell in its level.
    pub cell: u32,
}

/// Counts, bounds, layers, groups and materials of the whole mesh of a paged file, stored as JSON.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Metadata {
    /// Name of the input.
    pub source: String,
    /// Number of triangles at full detail.
    pub triangle_count: u64,
    /// Number of positions at full detail.
    pub position_count: u64,
    /// Number of vertices at full detail.
    pub vertex_count: u64,
    /// Origin of all positions in the coordinates of the input, in mesh units.
    pub origin: [f64; 3],
    /// Smallest coordinates relative to the origin, in mesh units.
    pub min: [f32; 3],
    /// Largest coordinates relative to the origin, in mesh units.
    pub max: [f32; 3],
    /// Grid of the positions; `None` if they are stored exactly.
    pub grid: Option<PagedGrid>,
    /// Attribute layers.
    pub layers: Vec<PagedLayer>,
    /// Attribute layers of the triangles; all are exact.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub triangle_layers: Vec<PagedLayer>,
    /// Groups that triangles refer to.
    pub groups: Vec<PagedGroup>,
    /// glTF materials as JSON objects, one per material, with textures by index.
    pub appearance: serde_json::Value,
    /// Images that the textures refer to by index.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub images: Vec<PagedImage>,
    /// Number of cells per level, finest first.
    pub cell_counts: Vec<u32>,
    /// Georeference of a terrain.
    pub georeference: Option<serde_json::Value>,
    /// Options of the build, for reference.
    pub options: serde_json::Value,
}

/// Largest magnitude of a grid index: differences of indices stay exact.
const MAX_INDEX: f64 = (1u64 << 48) as f64;
/// Largest multiple of the step of a layer.
const LARGEST_MULTIPLE: f64 = (1u64 << 52) as f64;
/// The multiple of a step that is nearest to a value; very large ones are clamped.
pub(crate) fn index_of(value: f32, step: f64) -> i64 {
    ((f64::from(value) / step).round()).clamp(-LARGEST_MULTIPLE, LARGEST_MULTIPLE) as i64
}

/// Name of the layer that separates wedges of different materials.
const MATERIAL: &str = "generic_material";

impl PagedGrid {
    /// A grid that covers a box, with a step for each axis; a step of 0 becomes the smallest one possible.
    /// `None` if a step is too fine for the box.
    pub fn of(min: [f32; 3], max: [f32; 3], step: [f64; 3]) -> Option<Self> {
        let finest = |axis: usize| {
            let extent = f64::from(max[axis]) - f64::from(min[axis]);
            (extent / MAX_INDEX).max(f64::from(f32::MIN_POSITIVE)).log2().ceil().exp2()
        };
        let is_possible = (0..3).all(|axis| step[axis] == 0.0 || step[axis] >= finest(axis));
        let step: [f64; 3] = std::array::from_fn(|axis| step[axis].max(finest(axis)));
        let origin = std::array::from_fn(|axis| (f64::from(min[axis]) / step[axis]).floor() * step[axis]);
        is_possible.then_some(Self { origin, step })
    }

    /// Indices of the nearest grid position.
    pub fn index_of(&self, position: [f32; 3]) -> [i64; 3] {
        std::array::from_fn(|a| ((f64::from(position[a]) - self.origin[a]) / self.step[a]).round() as i64)
    }

    /// The position with these indices, in mesh units.
    pub fn position_of(&self, index: [i64; 3]) -> [f32; 3] {
        std::array::from_fn(|a| (self.origin[a] + self.step[a] * index[a] as f64) as f32)
    }

    /// The nearest grid position, in mesh units.
    pub fn snap(&self, position: [f32; 3]) -> [f32; 3] {
        self.position_of(self.index_of(position))
    }
}

impl PagedLayer {
    /// Describes a layer; floats of known meaning are rounded unless `exact`.
    pub fn of(layer: &AttributeLayer, exact: bool) -> Self {
        let component_type = layer.data.type_name();
        let step = match layer.semantic {
            _ if exact || component_type != "f32" => None,
            Semantic::Normal | Semantic::Tangent | Semantic::Color(_) | Semantic::Weights(_) => {
                Some(1.0 / 1024.0)
            }
            Semantic::TexCoord(_) => Some(1.0 / 16_384.0),
            _ => None,
        };
        Self {
            semantic: layer.semantic.to_string(),
            component_count: layer.component_count,
            normalized: layer.normalized,
            component_type: component_type.to_owned(),
            step,
        }
    }

    /// A layer of this kind without values. An unknown type counts as floats.
    pub fn empty_layer(&self) -> AttributeLayer {
        let data = LayerData::empty_named(&self.component_type).unwrap_or(LayerData::F32(Vec::new()));
        AttributeLayer {
            semantic: semantic_of(&self.semantic),
            component_count: self.component_count,
            normalized: self.normalized,
            data,
        }
    }

    /// Rounds the values of a layer to multiples of the step; values that are not finite become 0.
    pub fn round(&self, layer: &mut AttributeLayer) {
        let LayerData::F32(values) = &mut layer.data else { return };
        for value in values {
            let rounded = match self.step {
                Some(step) => (index_of(*value, step) as f64 * step) as f32,
                None => *value,
            };
            *value = if rounded.is_finite() { rounded + 0.0 } else { 0.0 };
        }
    }
}

/// The semantic that is displayed like this; unknown ones are generic.
fn semantic_of(name: &str) -> Semantic {
    let number = |prefix: &str| name.strip_prefix(prefix).and_then(|rest| rest.parse::<u8>().ok());
    let target = |suffix: &str| name.strip_prefix("morph_")?.strip_suffix(suffix)?.parse::<u16>().ok();
    match name {
        "normal" => return Semantic::Normal,
        "tangent" => return Semantic::Tangent,
        _ => {}
    }
    if let Some(set) = number("texcoord_") {
        return Semantic::TexCoord(set);
    }
    if let Some(set) = number("color_") {
        return Semantic::Color(set);
    }
    if let Some(set) = number("joints_") {
        return Semantic::Joints(set);
    }
    if let Some(set) = number("weights_") {
        return Semantic::Weights(set);
    }
    if let Some(target) = target("_position") {
        return Semantic::MorphPosition(target);
    }
    if let Some(target) = target("_normal") {
        return Semantic::MorphNormal(target);
    }
    if let Some(target) = target("_tangent") {
        return Semantic::MorphTangent(target);
    }
    Semantic::Generic(name.strip_prefix("generic_").unwrap_or(name).to_owned())
}

impl Metadata {
    /// Diagonal of the bounding box, in mesh units.
    pub fn diagonal(&self) -> f64 {
        (0..3).map(|a| (f64::from(self.max[a]) - f64::from(self.min[a])).powi(2)).sum::<f64>().sqrt()
    }

    /// Checks the counts from which sizes are computed.
    pub(crate) fn check(&self) -> Result<(), String> {
        if let Some(grid) = &self.grid
            && !(grid.step.iter().all(|&step| step > 0.0 && step.is_finite())
                && grid.origin.iter().all(|x| x.is_finite()))
        {
            return Err("the grid has a step or origin that is not a positive number".to_owned());
        }
        if self.cell_counts.is_empty() || self.cell_counts.len() > 64 {
            return Err(format!("{} levels", self.cell_counts.len()));
        }
        for layer in self.layers.iter().chain(&self.triangle_layers) {
            if layer.component_count == 0 || layer.step.is_some_and(|step| !(step > 0.0 && step.is_finite()))
            {
                return Err(format!("layer {} has no components or an impossible step", layer.semantic));
            }
        }
        if !self.min.iter().chain(&self.max).all(|x| x.is_finite()) {
            return Err("the bounds are not finite".to_owned());
        }
        Ok(())
    }

    /// A mesh without vertices and triangles, but with all layers.
    pub fn empty_mesh(&self) -> CellMesh {
        let empty = |layers: &[PagedLayer]| layers.iter().map(PagedLayer::empty_layer).collect();
        CellMesh {
            layers: empty(&self.layers),
            triangle_layers: empty(&self.triangle_layers),
            ..CellMesh::default()
        }
    }

    /// Whether a layer exists only to separate wedges of different materials.
    pub fn is_material_layer(layer: &AttributeLayer) -> bool {
        layer.semantic == semantic_of(MATERIAL)
    }

    /// Whether vertices of different materials must be kept separate.
    fn has_materials(&self) -> bool {
        self.groups.windows(2).any(|pair| pair[0].material != pair[1].material)
    }

    /// Adds the layer that separates wedges of different materials, if there are several materials.
    pub fn declare_material_layer(&mut self) {
        if self.has_materials() {
            self.layers.push(PagedLayer {
                semantic: MATERIAL.to_owned(),
                component_count: 1,
                normalized: false,
                component_type: "u32".to_owned(),
                step: None,
            });
        }
    }

    /// Adds that layer to a mesh; a vertex that several materials use is repeated for each.
    pub fn add_material_layer(&self, mesh: &mut CellMesh) {
        if !self.has_materials() {
            return;
        }
        let mut number = HashMap::new();
        let (mut sources, mut materials) = (Vec::new(), Vec::new());
        for (t, corners) in mesh.triangles.iter_mut().enumerate() {
            let group = mesh.groups.get(t).copied().unwrap_or(0) as usize;
            let material = self.groups.get(group).and_then(|group| group.material).map_or(0, |m| m + 1);
            for v in corners {
                *v = *number.entry((*v, material)).or_insert_with(|| {
                    sources.push(*v);
                    materials.push(material);
                    sources.len() as u32 - 1
                });
            }
        }
        mesh.positions = sources.iter().map(|&v| mesh.positions[v as usize]).collect();
        mesh.layers = mesh.layers.iter().map(|layer| layer.gather(&sources)).collect();
        mesh.layers.push(AttributeLayer {
            semantic: semantic_of(MATERIAL),
            component_count: 1,
            normalized: false,
            data: LayerData::U32(materials),
        });
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn snapping_is_idempotent() {
        for (min, max, step) in
            [(-1.0f32, 3.0, 1e-4), (1e6, 1e6 + 10.0, 1e-6), (0.0, 0.0, 0.0), (-3e4, 5e4, 0.125)]
        {
            let grid = PagedGrid::of([min; 3], [max; 3], [step, 2.0 * step, step]).unwrap();
            for i in 0..1000 {
                let p = [min + (max - min) * i as f32 / 999.0; 3];
                let snapped = grid.snap(p);
                assert_eq!(grid.snap(snapped), snapped, "{grid:?} {p:?}");
            }
        }
    }

    #[test]
    fn steps_are_one_number_or_three() {
        let json = |step| serde_json::to_value(PagedGrid { origin: [0.0; 3], step }).unwrap();
        for step in [[0.25; 3], [0.25, 0.5, 0.25]] {
            let again: PagedGrid = serde_json::from_value(json(step)).unwrap();
            assert_eq!(again.step, step);
        }
        assert_eq!(json([0.25; 3])["step"], 0.25);
        assert_eq!(PagedGrid::of([0.0; 3], [1.0, 1.0, 1e15], [1e-3; 3]), None, "too fine for one axis");
    }

    #[test]
    fn layers_are_described_and_made_again() {
        for semantic in
            ["normal", "tangent", "texcoord_1", "color_0", "joints_0", "morph_3_normal", "generic_x"]
        {
            assert_eq!(semantic_of(semantic).to_string(), semantic);
        }
    }
}
