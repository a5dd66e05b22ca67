//! Converts positions and attribute layers to vertex buffers: normals, colors, texture coordinates.

use striata::mesh::{AttributeLayer, Semantic};
use wasm_bindgen::prelude::wasm_bindgen;

/// Vertex attributes of a range of vertices. Each `take_` method returns its buffer once.
#[wasm_bindgen]
#[derive(Debug, Default, PartialEq)]
pub struct Vertices {
    positions: Vec<f32>,
    normals: Option<Vec<f32>>,
    colors: Option<Vec<u8>>,
    uvs: Option<Vec<f32>>,
}

#[wasm_bindgen]
impl Vertices {
    /// Positions, three numbers per vertex, mesh units.
    pub fn take_positions(&mut self) -> Vec<f32> {
        std::mem::take(&mut self.positions)
    }

    /// Normals, three numbers per vertex, if the mesh has any.
    pub fn take_normals(&mut self) -> Option<Vec<f32>> {
        self.normals.take()
    }

    /// Red, green, blue and alpha of each vertex, if the mesh has colors.
    pub fn take_colors(&mut self) -> Option<Vec<u8>> {
        self.colors.take()
    }

    /// Texture coordinates, two numbers per vertex with `v` pointing down, if the mesh has any.
    pub fn take_uvs(&mut self) -> Option<Vec<f32>> {
        self.uvs.take()
    }
}

impl Vertices {
    /// Converts positions and drawable layers, skipping the first `skipped` vertices of the layers.
    pub(crate) fn new(positions: &[[f32; 3]], layers: &[AttributeLayer], skipped: usize) -> Self {
        Self {
            positions: positions.as_flattened().to_vec(),
            normals: find(layers, DrawnLayer::Normal).map(|layer| floats(layer, skipped)),
            colors: find(layers, DrawnLayer::Color).map(|layer| colors(layer, skipped)),
            uvs: find(layers, DrawnLayer::Uv).map(|layer| floats(layer, skipped)),
        }
    }
}

/// Layers that a page draws.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum DrawnLayer {
    /// Three floats.
    Normal,
    /// Four bytes; 255 is full intensity.
    Color,
    /// Two floats.
    Uv,
}

/// Finds the layer if it has a suitable number of components.
fn find(layers: &[AttributeLayer], drawn: DrawnLayer) -> Option<&AttributeLayer> {
    let (semantic, widths) = match drawn {
        DrawnLayer::Normal => (Semantic::Normal, 3..=3),
        DrawnLayer::Color => (Semantic::Color(0), 3..=4),
        DrawnLayer::Uv => (Semantic::TexCoord(0), 2..=2),
    };
    layers.iter().find(|layer| layer.semantic == semantic && widths.contains(&layer.component_count))
}

/// Converts a layer to floats, starting at vertex `first`.
fn floats(layer: &AttributeLayer, first: usize) -> Vec<f32> {
    let width = usize::from(layer.component_count);
    let vertex_count = layer.data.len() / width;
    (first..vertex_count).flat_map(|v| (0..width).map(move |i| layer.get(v, i))).collect()
}

/// Converts colors to four bytes per vertex, starting at vertex `first`.
fn colors(layer: &AttributeLayer, first: usize) -> Vec<u8> {
    let width = usize::from(layer.component_count);
    let vertex_count = layer.data.len() / width;
    let byte = |v: usize, i: usize| {
        let share = if i < width { layer.get(v, i) } else { 1.0 };
        (share.clamp(0.0, 1.0) * 255.0 + 0.5) as u8
    };
    (first..vertex_count).flat_map(|v| (0..4).map(move |i| byte(v, i))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use striata::mesh::LayerData;

    #[test]
    fn colors_of_any_type_become_bytes() {
        let layer = AttributeLayer::from_f32(Semantic::Color(0), 3, vec![0.0, 0.5, 2.0, 1.0, f32::NAN, -1.0]);
        assert_eq!(colors(&layer, 0), [0, 128, 255, 255, 255, 0, 0, 255]);
        assert_eq!(colors(&layer, 1), [255, 0, 0, 255]);
        let data = LayerData::U8(vec![1, 2, 3, 4]);
        let bytes =
            AttributeLayer { semantic: Semantic::Color(0), component_count: 4, normalized: true, data };
        assert_eq!(colors(&bytes, 0), [1, 2, 3, 4]);
        assert!(find(std::slice::from_ref(&bytes), DrawnLayer::Color).is_some());
        assert!(find(&[bytes], DrawnLayer::Uv).is_none());
    }
}
