//! Converts positions and attribute layers to vertex buffers.

use striata::mesh::{AttributeLayer, ColorSpace, LayerData, Semantic};
use wasm_bindgen::prelude::wasm_bindgen;

/// Vertex attributes of a range of vertices. Each `take_` method returns its buffer once.
///
/// Layers have the names that glTF gives them: `NORMAL`, `TEXCOORD_0`; a layer of a morph target is preceded
/// by the number of the target: `0/POSITION`.
#[wasm_bindgen]
#[derive(Debug, Default, PartialEq)]
pub struct Vertices {
    positions: Vec<f32>,
    layers: Vec<AttributeLayer>,
}

#[wasm_bindgen]
impl Vertices {
    /// Positions, three numbers per vertex, mesh units.
    pub fn take_positions(&mut self) -> Vec<f32> {
        std::mem::take(&mut self.positions)
    }

    /// Normals, three numbers per vertex, if the mesh has any.
    pub fn take_normals(&mut self) -> Option<Vec<f32>> {
        self.take(DrawnLayer::Normal).map(|layer| floats(&layer))
    }

    /// Red, green, blue and alpha of each vertex in linear light, if the mesh has colors; 65535 is all of it.
    pub fn take_colors(&mut self) -> Option<Vec<u16>> {
        self.take(DrawnLayer::Color).map(|layer| colors(&layer, ColorSpace::Linear))
    }

    /// Texture coordinates, two numbers per vertex with `v` pointing down, if the mesh has any.
    pub fn take_uvs(&mut self) -> Option<Vec<f32>> {
        self.take(DrawnLayer::Uv).map(|layer| floats(&layer))
    }

    /// Number of layers that were not taken yet.
    #[wasm_bindgen(getter)]
    pub fn layer_count(&self) -> usize {
        self.layers.len()
    }

    /// Takes the first layer that was not taken yet.
    pub fn take_layer(&mut self) -> Option<VertexLayer> {
        (!self.layers.is_empty()).then(|| VertexLayer(self.layers.remove(0)))
    }
}

impl Vertices {
    /// Converts positions and layers, skipping the first `skipped` vertices of the layers. Colors become light.
    pub(crate) fn new(
        positions: &[[f32; 3]],
        layers: &[AttributeLayer],
        skipped: usize,
        color_space: ColorSpace,
    ) -> Self {
        let layers = layers.iter().filter(|layer| layer.component_count > 0);
        let layers = layers.map(|layer| in_light(from_vertex(layer, skipped), color_space));
        Self { positions: positions.as_flattened().to_vec(), layers: layers.collect() }
    }

    fn take(&mut self, drawn: DrawnLayer) -> Option<AttributeLayer> {
        let at = find(&self.layers, drawn)?;
        Some(self.layers.remove(at))
    }
}

/// An attribute of a range of vertices.
#[wasm_bindgen]
#[derive(Debug, PartialEq)]
pub struct VertexLayer(AttributeLayer);

#[wasm_bindgen]
impl VertexLayer {
    /// Name of the attribute.
    #[wasm_bindgen(getter)]
    pub fn name(&self) -> String {
        match &self.0.semantic {
            Semantic::Normal => "NORMAL".to_owned(),
            Semantic::Tangent => "TANGENT".to_owned(),
            Semantic::TexCoord(set) => format!("TEXCOORD_{set}"),
            Semantic::Color(set) => format!("COLOR_{set}"),
            Semantic::Joints(set) => format!("JOINTS_{set}"),
            Semantic::Weights(set) => format!("WEIGHTS_{set}"),
            Semantic::MorphPosition(target) => format!("{target}/POSITION"),
            Semantic::MorphNormal(target) => format!("{target}/NORMAL"),
            Semantic::MorphTangent(target) => format!("{target}/TANGENT"),
            Semantic::Generic(name) => name.clone(),
        }
    }

    /// Number of values per vertex.
    #[wasm_bindgen(getter)]
    pub fn component_count(&self) -> u8 {
        self.0.component_count
    }

    /// Whether integers stand for 0 to 1.
    #[wasm_bindgen(getter)]
    pub fn is_normalized(&self) -> bool {
        self.0.normalized
    }

    /// Type of the values: `f32`, `u8`, `u16`, `u32`, `i8`, `i16`, `i32` or `f64`.
    #[wasm_bindgen(getter)]
    pub fn component_type(&self) -> String {
        self.0.data.type_name().to_owned()
    }

    /// Values of all vertices, little-endian.
    pub fn bytes(&self) -> Vec<u8> {
        self.0.data.as_bytes().to_vec()
    }
}

/// Layers with methods of their own.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum DrawnLayer {
    /// Three floats.
    Normal,
    /// Four 16-bit integers.
    Color,
    /// Two floats.
    Uv,
}

/// Finds the layer if it has a suitable number of components.
fn find(layers: &[AttributeLayer], drawn: DrawnLayer) -> Option<usize> {
    let (semantic, widths) = match drawn {
        DrawnLayer::Normal => (Semantic::Normal, 3..=3),
        DrawnLayer::Color => (Semantic::Color(0), 3..=4),
        DrawnLayer::Uv => (Semantic::TexCoord(0), 2..=2),
    };
    layers.iter().position(|layer| layer.semantic == semantic && widths.contains(&layer.component_count))
}

/// The values of a layer from vertex `first` on.
fn from_vertex(layer: &AttributeLayer, first: usize) -> AttributeLayer {
    let first = (first * usize::from(layer.component_count)).min(layer.data.len());
    let data = layer.data.slice(first..layer.data.len());
    AttributeLayer { semantic: layer.semantic.clone(), data, ..*layer }
}

/// Converts colors that are not light.
fn in_light(layer: AttributeLayer, color_space: ColorSpace) -> AttributeLayer {
    let is_light = color_space == ColorSpace::Linear || !matches!(layer.semantic, Semantic::Color(_));
    if is_light || layer.component_count > 4 {
        return layer;
    }
    let data = LayerData::U16(colors(&layer, color_space));
    AttributeLayer { component_count: 4, normalized: true, data, ..layer }
}

/// Converts a layer to floats.
fn floats(layer: &AttributeLayer) -> Vec<f32> {
    let width = usize::from(layer.component_count);
    let vertex_count = layer.data.len() / width;
    (0..vertex_count).flat_map(|v| (0..width).map(move |i| layer.get(v, i))).collect()
}

/// Converts colors to four numbers per vertex, in linear light.
fn colors(layer: &AttributeLayer, color_space: ColorSpace) -> Vec<u16> {
    let width = usize::from(layer.component_count);
    let vertex_count = layer.data.len() / width;
    let word = |v: usize, i: usize| {
        let share = if i < width { layer.get(v, i) } else { 1.0 };
        let light = if i < 3 { color_space.light_of(share) } else { share };
        (light.clamp(0.0, 1.0) * 65535.0 + 0.5) as u16
    };
    (0..vertex_count).flat_map(|v| (0..4).map(move |i| word(v, i))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn colors_of_any_type_become_light() {
        let layer = AttributeLayer::from_f32(Semantic::Color(0), 3, vec![0.0, 0.5, 2.0, 1.0, f32::NAN, -1.0]);
        let linear = |layer: &AttributeLayer| colors(layer, ColorSpace::Linear);
        assert_eq!(linear(&layer), [0, 32768, 65535, 65535, 65535, 0, 0, 65535]);
        assert_eq!(linear(&from_vertex(&layer, 1)), [65535, 0, 0, 65535]);
        assert_eq!(colors(&layer, ColorSpace::Srgb)[..4], [0, 14027, 65535, 65535]);
        let data = LayerData::U8(vec![1, 2, 3, 4]);
        let bytes =
            AttributeLayer { semantic: Semantic::Color(0), component_count: 4, normalized: true, data };
        assert_eq!(linear(&bytes), [257, 514, 771, 1028]);
        assert!(find(std::slice::from_ref(&bytes), DrawnLayer::Color).is_some());
        assert!(find(&[bytes], DrawnLayer::Uv).is_none());
    }

    #[test]
    fn every_layer_is_taken_once_under_its_name() {
        let data = LayerData::U16(vec![0, 1, 2, 3, 4, 5, 6, 7]);
        let joints =
            AttributeLayer { semantic: Semantic::Joints(1), component_count: 4, normalized: false, data };
        let layers = [joints, AttributeLayer::from_f32(Semantic::MorphPosition(3), 3, vec![0.5; 6])];
        let mut vertices = Vertices::new(&[[0.0; 3]], &layers, 1, ColorSpace::Linear);
        let names: Vec<String> = (0..vertices.layer_count())
            .filter_map(|_| vertices.take_layer())
            .map(|layer| format!("{} {} {}", layer.name(), layer.component_type(), layer.bytes().len()))
            .collect();
        assert_eq!(names, ["JOINTS_1 u16 8", "3/POSITION f32 12"]);
        assert!(vertices.take_layer().is_none());
    }
}
