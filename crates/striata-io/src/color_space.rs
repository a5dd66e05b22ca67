//! Conversion of vertex colors between sRGB and linear light.
//!
//! PLY, OBJ, OFF and VTK store colors as they are shown (sRGB), by convention. glTF stores them linear, and 3MF is
//! read and written as glTF. Reading and writing must not change them: a file that is
//! read and written in its own format keeps every bit. So readers keep the numbers and note the color space in
//! the [`Appearance`](striata::mesh::Appearance), writers keep them too, and whoever crosses formats calls
//! [`convert_colors`].
//!
//! Linear colors take 16 bits per channel. Adjacent 8-bit sRGB values are at least 19 apart there, so that
//! converting 8-bit colors to linear ones and back changes nothing. Alpha has the same meaning in both
//! spaces. Powers come from `libm`, because those of the platform differ between machines.

use std::borrow::Cow;

use striata::mesh::{AttributeLayer, ColorSpace, IndexedMesh, LayerData, Semantic};

use crate::Format;
use crate::error::Place;
use crate::report::Warnings;

/// Returns the color space of a format; [`None`] if it has no colors, or keeps those of its source.
fn color_space(format: Format) -> Option<ColorSpace> {
    match format {
        Format::Ply | Format::Obj | Format::Off | Format::Vtk | Format::Vtp | Format::Vtu => {
            Some(ColorSpace::Srgb)
        }
        Format::Gltf | Format::Glb | Format::ThreeMf => Some(ColorSpace::Linear),
        Format::Stl | Format::Striata | Format::Stream => None,
    }
}

/// Converts the vertex colors of a mesh to those of the format that it will be written in.
///
/// Colors change only between glTF, whose colors are linear (and 3MF), and PLY, OBJ, OFF or VTK, whose colors
/// are sRGB. `.striata` files and streams say which they have, so nothing changes for them.
pub fn convert_colors(mesh: &mut IndexedMesh, to: Format) {
    match (mesh.appearance.color_space, color_space(to)) {
        (ColorSpace::Srgb, Some(ColorSpace::Linear)) => srgb_to_linear_colors(mesh),
        (ColorSpace::Linear, Some(ColorSpace::Srgb)) => linear_to_srgb_colors(mesh),
        _ => {}
    }
}

/// Whether the format has colors in the other color space.
pub fn needs_other_colors(mesh: &IndexedMesh, to: Format) -> bool {
    let is_color = |layer: &AttributeLayer| matches!(layer.semantic, Semantic::Color(_));
    color_space(to).is_some_and(|to| to != mesh.appearance.color_space) && mesh.layers.iter().any(is_color)
}

/// Notes that the colors of a file are linear, if there are any.
#[cfg(feature = "gltf")]
pub(crate) fn set_linear(
    appearance: &mut striata::mesh::Appearance,
    mut semantics: impl Iterator<Item = Semantic>,
) {
    if semantics.any(|semantic| matches!(semantic, Semantic::Color(_))) {
        appearance.color_space = ColorSpace::Linear;
    }
}

/// Converts the vertex colors of a mesh from sRGB to linear light, as normalized 16-bit integers.
///
/// Colors outside 0 to 1 are clamped; NaN becomes 0. Alpha is kept.
pub fn srgb_to_linear_colors(mesh: &mut IndexedMesh) {
    mesh.appearance.color_space = linear_if_any(mesh);
    for layer in color_layers(mesh) {
        let word = |value: f32, is_alpha: bool| {
            quantized(if is_alpha { value } else { srgb_to_linear(value) }, 65535.0) as u16
        };
        layer.data = LayerData::U16(converted(layer, word));
        layer.normalized = true;
    }
}

/// Converts the vertex colors of a mesh from linear light to sRGB: integers become normalized 8-bit
/// integers, floats stay floats.
///
/// Colors outside 0 to 1 are clamped; NaN becomes 0. Alpha is kept, rounded to 8 bits for integers.
pub fn linear_to_srgb_colors(mesh: &mut IndexedMesh) {
    mesh.appearance.color_space = ColorSpace::Srgb;
    for layer in color_layers(mesh) {
        let encode = |value: f32, is_alpha: bool| if is_alpha { value } else { linear_to_srgb(value) };
        if matches!(layer.data, LayerData::F32(_)) {
            layer.data = LayerData::F32(converted(layer, encode));
        } else {
            let byte = |value: f32, is_alpha: bool| quantized(encode(value, is_alpha), 255.0) as u8;
            layer.data = LayerData::U8(converted(layer, byte));
            layer.normalized = true;
        }
    }
}

/// A mesh without colors has no color space of its own.
fn linear_if_any(mesh: &IndexedMesh) -> ColorSpace {
    let is_color = |layer: &AttributeLayer| matches!(layer.semantic, Semantic::Color(_));
    if mesh.layers.iter().any(is_color) { ColorSpace::Linear } else { ColorSpace::Srgb }
}

fn color_layers(mesh: &mut IndexedMesh) -> impl Iterator<Item = &mut AttributeLayer> {
    mesh.layers.iter_mut().filter(|layer| {
        matches!(layer.semantic, Semantic::Color(_)) && matches!(layer.component_count, 3 | 4)
    })
}

/// Converts all components of a layer; the second argument is whether a component is alpha.
fn converted<T: Copy>(layer: &AttributeLayer, convert: impl Fn(f32, bool) -> T) -> Vec<T> {
    let width = layer.component_count as usize;
    if let (LayerData::U8(bytes), true) = (&layer.data, layer.normalized) {
        // A table saves computing millions of powers.
        let table = [false, true].map(|is_alpha| -> Vec<T> {
            (0..=255u8).map(|byte| convert(f32::from(byte) / 255.0, is_alpha)).collect()
        });
        let component = |(index, &byte): (usize, &u8)| table[usize::from(index % width == 3)][byte as usize];
        return bytes.iter().enumerate().map(component).collect();
    }
    let component = |index: usize| convert(layer.get(index / width, index % width), index % width == 3);
    (0..layer.data.len()).map(component).collect()
}

/// Returns the first color set as normalized bytes, which all readers of PLY and OFF understand; most take
/// floats and 16-bit integers for black or refuse them. Other layers are returned as they are.
///
/// Values outside 0 to 1 are clamped, and 16-bit integers are rounded, with a warning.
#[cfg(any(feature = "ply", feature = "off"))]
pub(crate) fn byte_colors<'l>(layer: &'l AttributeLayer, warnings: &mut Warnings) -> Cow<'l, AttributeLayer> {
    let is_fraction = match &layer.data {
        LayerData::F32(_) | LayerData::F64(_) => true,
        LayerData::U16(_) => layer.normalized,
        _ => false,
    };
    let is_color = layer.semantic == Semantic::Color(0) && matches!(layer.component_count, 3 | 4);
    if !is_fraction || !is_color {
        return Cow::Borrowed(layer);
    }
    let data = match &layer.data {
        LayerData::F32(values) => {
            let outside_count = values.iter().filter(|value| !(0.0..=1.0).contains(*value)).count();
            if outside_count > 0 {
                let reason =
                    format!("colors are stored as bytes: {outside_count} values outside 0 to 1 are clamped");
                warnings.push(Place::File, reason);
            }
            values.iter().map(|&value| quantized(value, 255.0) as u8).collect()
        }
        _ => {
            let bytes = converted(layer, |value, _| quantized(value, 255.0) as u8);
            let is_exact = (0..bytes.len()).all(|i| match &layer.data {
                LayerData::U16(words) => words[i] == u16::from(bytes[i]) * 257,
                _ => true,
            });
            if !is_exact {
                warnings.push(Place::File, "colors are stored as bytes: 16-bit values are rounded");
            }
            bytes
        }
    };
    let (semantic, component_count) = (layer.semantic.clone(), layer.component_count);
    Cow::Owned(AttributeLayer { semantic, component_count, normalized: true, data: LayerData::U8(data) })
}

/// Scales a value in 0..=1 to an integer; conversion from floats maps NaN to 0 and saturates.
fn quantized(value: f32, largest: f32) -> u32 {
    (value.clamp(0.0, 1.0) * largest).round() as u32
}

/// Converts an sRGB value in 0..=1 to linear light.
pub(crate) fn srgb_to_linear(value: f32) -> f32 {
    let x = f64::from(unit(value));
    (if x <= 0.040_45 { x / 12.92 } else { libm::pow((x + 0.055) / 1.055, 2.4) }) as f32
}

/// Converts linear light in 0..=1 to an sRGB value.
pub fn linear_to_srgb(value: f32) -> f32 {
    let x = f64::from(unit(value));
    (if x <= 0.003_130_8 { x * 12.92 } else { 1.055 * libm::pow(x, 1.0 / 2.4) - 0.055 }) as f32
}

/// Clamps to 0..=1; NaN becomes 0.
fn unit(value: f32) -> f32 {
    if value.is_nan() { 0.0 } else { value.clamp(0.0, 1.0) }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn mesh_with(component_count: u8, normalized: bool, data: LayerData) -> IndexedMesh {
        let vertex_count = data.len() / component_count as usize;
        let semantic = Semantic::Color(0);
        let layers = vec![AttributeLayer { semantic, component_count, normalized, data }];
        IndexedMesh { layers, ..IndexedMesh::new(vec![[0.0; 3]; vertex_count], Vec::new()) }
    }

    #[test]
    fn bytes_survive_the_round_trip() {
        let bytes: Vec<u8> = (0..=255).flat_map(|i| [i, 255 - i, i / 2, i]).collect();
        let mesh = mesh_with(4, true, LayerData::U8(bytes));
        let mut linear = mesh.clone();
        convert_colors(&mut linear, Format::Glb);
        let LayerData::U16(words) = &linear.layers[0].data else { panic!("{linear:?}") };
        assert_eq!(words[128 * 4..][..4], [14146, 13909, 3360, 128 * 257]);
        convert_colors(&mut linear, Format::Off);
        assert_eq!(linear, mesh);
    }

    #[test]
    fn floats_are_clamped_and_converted() {
        let mut mesh = mesh_with(3, false, LayerData::F32(vec![0.0, 0.5, 1.0, -1.0, f32::NAN, 9.0]));
        linear_to_srgb_colors(&mut mesh);
        let LayerData::F32(values) = &mesh.layers[0].data else { panic!("{mesh:?}") };
        for (found, expected) in values.iter().zip([0.0, 0.735_357, 1.0, 0.0, 0.0, 1.0]) {
            assert!((found - expected).abs() < 1e-6, "{values:?}");
        }
        srgb_to_linear_colors(&mut mesh);
        assert_eq!(mesh.layers[0].data, LayerData::U16(vec![0, 32768, 65535, 0, 0, 65535]));
        assert!(mesh.layers[0].normalized);
    }

    #[test]
    fn other_formats_and_layers_are_left_alone() {
        let mesh = mesh_with(3, true, LayerData::U8(vec![1, 2, 3]));
        for (own, to) in [
            (ColorSpace::Srgb, Format::Obj),
            (ColorSpace::Linear, Format::Gltf),
            (ColorSpace::Linear, Format::Stream),
            (ColorSpace::Srgb, Format::Striata),
        ] {
            let mut mesh = mesh.clone();
            mesh.appearance.color_space = own;
            let before = mesh.clone();
            convert_colors(&mut mesh, to);
            assert_eq!(mesh, before);
            assert!(!needs_other_colors(&mesh, to));
        }
        let mut generic = mesh.clone();
        generic.layers[0].semantic = Semantic::Normal;
        let before = generic.clone();
        srgb_to_linear_colors(&mut generic);
        linear_to_srgb_colors(&mut generic);
        assert_eq!(generic, before);
    }
}
