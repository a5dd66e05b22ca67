//! Origin of texture coordinates: the bottom of the image in PLY files, its top in a mesh.
//!
//! Reading replaces `v` by `1 - v`. In binary files this rounds: `f32` is finer near 0 than near 1, so that
//! several `v` become the same number. Writing returns the one among them that the file probably contained:
//!
//! * a multiple of 2^-16 (a pixel of an image), if all values of the layer are;
//! * otherwise a decimal fraction of up to 7 digits, if all values of the layer can be;
//! * otherwise the exact difference, which is right for all `v` from 0.5 to 2.
//!
//! So a file whose coordinates are pixels, short decimals or at least 0.5 is written as it was read; others
//! differ by at most 2^-25, a thousandth of a pixel of the largest images. In text, numbers are subtracted in
//! decimal, and nothing is lost.

use std::borrow::Cow;

use striata::mesh::{AttributeLayer, LayerData, Semantic};

use super::column::Column;
use super::names::column_sets;

/// Steps of pixels between two whole coordinates.
const PIXELS: f32 = 65536.0;

/// Whether a layer has coordinates with an origin; plain integers are pixels or something else.
pub(super) fn has_origin(layer: &AttributeLayer) -> bool {
    let is_fraction = match layer.data {
        LayerData::F32(_) | LayerData::F64(_) => true,
        LayerData::U8(_) | LayerData::U16(_) => layer.normalized,
        _ => false,
    };
    matches!(layer.semantic, Semantic::TexCoord(_)) && layer.component_count == 2 && is_fraction
}

/// Moves the origin of coordinates that were read from the bottom to the top of the image.
pub(super) fn flip(layer: &mut AttributeLayer) {
    if !has_origin(layer) {
        return;
    }
    match &mut layer.data {
        LayerData::F32(values) => values.iter_mut().skip(1).step_by(2).for_each(|v| *v = 1.0 - *v),
        LayerData::F64(values) => values.iter_mut().skip(1).step_by(2).for_each(|v| *v = 1.0 - *v),
        other => flip_integers(other),
    }
}

/// Integers are flipped exactly.
fn flip_integers(data: &mut LayerData) {
    match data {
        LayerData::U8(values) => values.iter_mut().skip(1).step_by(2).for_each(|v| *v = u8::MAX - *v),
        LayerData::U16(values) => values.iter_mut().skip(1).step_by(2).for_each(|v| *v = u16::MAX - *v),
        _ => {}
    }
}

/// Returns a layer as binary files store it.
pub(super) fn with_bottom_origin(layer: &AttributeLayer) -> Cow<'_, AttributeLayer> {
    if !has_origin(layer) {
        return Cow::Borrowed(layer);
    }
    let mut layer = layer.clone();
    match &mut layer.data {
        LayerData::F32(values) => {
            let unflipped = inverse_of(values.iter().skip(1).step_by(2).copied());
            values.iter_mut().skip(1).step_by(2).for_each(|v| *v = unflipped(*v));
        }
        LayerData::F64(values) => values.iter_mut().skip(1).step_by(2).for_each(|v| *v = one_minus_f64(*v)),
        other => flip_integers(other),
    }
    Cow::Owned(layer)
}

/// Returns `1 - value`, as a decimal fraction of 15 digits if reading that gives `value` again.
pub(super) fn one_minus_f64(value: f64) -> f64 {
    let decimal = ((1.0 - value) * 1e15).round() / 1e15;
    if 1.0 - decimal == value { decimal } else { 1.0 - value }
}

/// Returns the function that undoes `1 - v` for these values; see the header of the module.
fn inverse_of(values: impl Iterator<Item = f32> + Clone) -> fn(f32) -> f32 {
    let is_pixel = |value: f32| (value * PIXELS).fract() == 0.0;
    if values.clone().all(is_pixel) {
        return |value| 1.0 - value;
    }
    let is_decimal = |value: f32| is_exact(value) || 1.0 - decimal_difference(value) == value;
    if values.clone().all(is_decimal) {
        return |value| if is_exact(value) { 1.0 - value } else { decimal_difference(value) };
    }
    |value| 1.0 - value
}

/// Whether no other number than `1 - value` can have become `value`.
fn is_exact(value: f32) -> bool {
    value <= 0.5 || value > 2.0 || !value.is_finite()
}

/// Returns `1 - value`, rounded to as many decimals as `value` has.
fn decimal_difference(value: f32) -> f32 {
    let scale = if value > 1.0 { 1e6 } else { 1e7 };
    (((1.0 - f64::from(value)) * scale).round() / scale) as f32
}

/// Marks the columns whose numbers count from the top of the image, so that they are not flipped again.
pub(crate) fn mark_flipped(columns: &mut [Column]) {
    let all = columns.to_vec();
    for set in column_sets(&all, false) {
        if matches!(set.semantic, Semantic::TexCoord(_)) && set.columns.len() == 2 {
            let offset = set.columns[1].offset;
            columns.iter_mut().filter(|column| column.offset == offset).for_each(|c| c.is_flipped = true);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Reads coordinates, writes them, and returns how many have changed.
    fn changed_count(values: &[f32]) -> usize {
        let data = values.iter().flat_map(|&v| [0.25, v]).collect();
        let original = AttributeLayer::from_f32(Semantic::TexCoord(0), 2, data);
        let mut read = original.clone();
        flip(&mut read);
        let written = with_bottom_origin(&read).into_owned();
        let mut again = written.clone();
        flip(&mut again);
        assert_eq!(again, read, "what is read never changes again");
        let pairs = (0..values.len()).map(|i| (original.get(i, 1), written.get(i, 1)));
        pairs.clone().for_each(|(a, b)| assert!((a - b).abs() <= 0.5f32.powi(25), "{a} became {b}"));
        pairs.filter(|(a, b)| a.to_bits() != b.to_bits()).count()
    }

    #[test]
    fn usual_coordinates_come_back_bit_for_bit() {
        let decimals = |count: u32, scale: f64| {
            (0..count).map(|i| (f64::from(i) * 7919.0 % scale / scale) as f32).collect::<Vec<_>>()
        };
        for scale in [10.0, 1e3, 1e6, 1e7] {
            assert_eq!(changed_count(&decimals(5000, scale)), 0, "{scale}");
        }
        let pixels: Vec<f32> = (0..4096).map(|i| (i as f32 + 0.5) / 4096.0).collect();
        assert_eq!(changed_count(&pixels), 0);
        assert_eq!(changed_count(&[3.0 / 4096.0, 0.0, 1.0, 0.25]), 0);
        assert_eq!(changed_count(&[-0.3, -0.125, 1.3, 2.75, 0.1, 17.2, 0.0]), 0);
        let upper: Vec<f32> = (0..5000).map(|i| 0.5 + (i as f32) * 1.234_567e-5).collect();
        assert_eq!(changed_count(&upper), 0);
    }

    #[test]
    fn other_coordinates_change_by_less_than_a_pixel() {
        let binary: Vec<f32> = (1..5000).map(|i| 1.0 / i as f32).collect();
        assert!(changed_count(&binary) > 0);
    }

    #[test]
    fn integers_are_exact_and_pixels_are_kept() {
        let layer = |normalized, data| {
            let semantic = Semantic::TexCoord(0);
            AttributeLayer { semantic, component_count: 2, normalized, data }
        };
        let words = layer(true, LayerData::U16(vec![1, 0, 2, 65535]));
        let written = with_bottom_origin(&words).into_owned();
        assert_eq!(written.data, LayerData::U16(vec![1, 65535, 2, 0]));
        let pixels = layer(false, LayerData::U16(vec![1, 0, 2, 65535]));
        assert_eq!(*with_bottom_origin(&pixels), pixels);
    }
}
