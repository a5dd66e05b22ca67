//! How a stream stores an attribute layer: conversion between the layer's numbers and integers.
//!
//! A unit normal becomes a point on the unfolded octahedron, a tangent such a point and a sign, and other
//! floats points of a uniform grid. Integers stay as they are, and so do identifiers that are stored as
//! floats: their grid has a step of 1. Floats that a grid cannot represent (infinities, or all floats if
//! the caller requests lossless storage) are mapped to integers in the same order. Decoded numbers convert
//! to the same integers again, so a stream can be encoded again without further loss.

use std::borrow::Cow;

use striata::mesh::{AttributeLayer, LayerData, Semantic};

use super::octahedral;
use super::options::LayerOptions;
use crate::format::grid::{Axis, MAX_BITS, float_to_ordered, ordered_to_float};

/// Data type of a layer's numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum NumberType {
    F32,
    U8,
    U16,
    U32,
    I8,
    I16,
    I32,
    F64,
}

impl NumberType {
    /// All types, in the order of their codes.
    pub(super) const ALL: [Self; 8] =
        [Self::F32, Self::U8, Self::U16, Self::U32, Self::I8, Self::I16, Self::I32, Self::F64];

    fn of(data: &LayerData) -> Self {
        match data {
            LayerData::F32(_) => Self::F32,
            LayerData::U8(_) => Self::U8,
            LayerData::U16(_) => Self::U16,
            LayerData::U32(_) => Self::U32,
            LayerData::I8(_) => Self::I8,
            LayerData::I16(_) => Self::I16,
            LayerData::I32(_) => Self::I32,
            LayerData::F64(_) => Self::F64,
        }
    }

    fn empty(self) -> LayerData {
        match self {
            Self::F32 => LayerData::F32(Vec::new()),
            Self::U8 => LayerData::U8(Vec::new()),
            Self::U16 => LayerData::U16(Vec::new()),
            Self::U32 => LayerData::U32(Vec::new()),
            Self::I8 => LayerData::I8(Vec::new()),
            Self::I16 => LayerData::I16(Vec::new()),
            Self::I32 => LayerData::I32(Vec::new()),
            Self::F64 => LayerData::F64(Vec::new()),
        }
    }

    /// Whether the numbers are floats.
    pub(super) fn is_float(self) -> bool {
        matches!(self, Self::F32 | Self::F64)
    }
}

/// How the numbers of a vertex are converted to integers.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum ValueTransform {
    /// A unit vector: 3 floats become 2 integers; 4 floats, the last of which is 1 or -1, become 3.
    Octahedral {
        /// Bits of each of the first two integers.
        bits: u32,
    },
    /// Each component is quantized to a uniform grid.
    Uniform {
        /// Grid of each component.
        axes: Vec<Axis>,
        /// Bits of each integer.
        bits: u32,
    },
    /// Integers are kept; floats are mapped to integers in the same order, doubles to two integers each.
    Exact,
}

/// Description of a layer without its numbers, as stored in the header of a stream.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct LayerForm {
    /// Meaning of the layer.
    pub semantic: Semantic,
    /// Number of components per vertex.
    pub component_count: u8,
    pub normalized: bool,
    /// Data type of the numbers.
    pub number_type: NumberType,
    /// Conversion between numbers and integers.
    pub transform: ValueTransform,
}

impl LayerForm {
    /// Chooses how to store a layer.
    pub(crate) fn of(layer: &AttributeLayer, options: &LayerOptions) -> Self {
        let is_exact = options.lossless || is_kept_double(layer) || layer.has_identifiers();
        let transform = match singles(&layer.data).filter(|_| !is_exact) {
            Some(numbers) => transform_of(&layer.semantic, layer.component_count as usize, &numbers, options),
            None => identifier_grid(layer, options.lossless).unwrap_or(ValueTransform::Exact),
        };
        let number_type = match NumberType::of(&layer.data) {
            NumberType::F64 if !is_exact => NumberType::F32,
            own => own,
        };
        Self {
            semantic: layer.semantic.clone(),
            component_count: layer.component_count,
            normalized: layer.normalized,
            number_type,
            transform,
        }
    }

    /// Number of integers per vertex.
    pub(crate) fn integer_count(&self) -> usize {
        match self.transform {
            ValueTransform::Octahedral { .. } => self.component_count as usize - 1,
            ValueTransform::Exact if self.number_type == NumberType::F64 => 2 * self.component_count as usize,
            _ => self.component_count as usize,
        }
    }

    /// Converts all numbers of a layer of this form to integers.
    pub(crate) fn integers(&self, layer: &AttributeLayer) -> Vec<i32> {
        let n = self.component_count as usize;
        if let (LayerData::F64(_), NumberType::F32) = (&layer.data, self.number_type)
            && let Some(numbers) = singles(&layer.data)
        {
            let data = LayerData::F32(numbers.into_owned());
            return self.integers(&AttributeLayer { data, semantic: layer.semantic.clone(), ..*layer });
        }
        match (&self.transform, &layer.data) {
            (ValueTransform::Octahedral { bits }, LayerData::F32(numbers)) => {
                numbers.chunks_exact(n).flat_map(|v| octahedral_integers(v, *bits)).collect()
            }
            (ValueTransform::Uniform { axes, bits }, LayerData::F32(numbers)) => {
                let limit = ((1u32 << bits) - 1) as i32;
                numbers
                    .chunks_exact(n)
                    .flat_map(|v| v.iter().zip(axes).map(|(&x, a)| a.quantize(x, limit)))
                    .collect()
            }
            (_, LayerData::F32(numbers)) => numbers.iter().map(|&x| float_to_ordered(x)).collect(),
            (_, LayerData::U8(numbers)) => numbers.iter().map(|&x| i32::from(x)).collect(),
            (_, LayerData::U16(numbers)) => numbers.iter().map(|&x| i32::from(x)).collect(),
            (_, LayerData::U32(numbers)) => numbers.iter().map(|&x| x as i32).collect(),
            (_, LayerData::I8(numbers)) => numbers.iter().map(|&x| i32::from(x)).collect(),
            (_, LayerData::I16(numbers)) => numbers.iter().map(|&x| i32::from(x)).collect(),
            (_, LayerData::I32(numbers)) => numbers.clone(),
            (_, LayerData::F64(numbers)) => numbers.iter().flat_map(|&x| double_to_ordered(x)).collect(),
        }
    }

    /// Returns a layer of this form without vertices.
    pub(crate) fn empty_layer(&self) -> AttributeLayer {
        AttributeLayer {
            semantic: self.semantic.clone(),
            component_count: self.component_count,
            normalized: self.normalized,
            data: self.number_type.empty(),
        }
    }

    /// Converts integers to numbers and appends them to a layer of this form. Integers that no number
    /// maps to are replaced by the nearest valid number.
    pub(crate) fn append(&self, integers: &[i32], out: &mut LayerData) {
        match (&self.transform, out) {
            (ValueTransform::Octahedral { bits }, LayerData::F32(out)) => {
                for vertex in integers.chunks_exact(self.integer_count()) {
                    out.extend(octahedral::decode([vertex[0], vertex[1]].map(clamped_i16), *bits));
                    out.extend(vertex.get(2).map(|&sign| if sign < 0 { -1.0 } else { 1.0 }));
                }
            }
            (ValueTransform::Uniform { axes, .. }, LayerData::F32(out)) => {
                let vertices = integers.chunks_exact(axes.len());
                out.extend(vertices.flat_map(|v| v.iter().zip(axes).map(|(&q, axis)| axis.position(q))));
            }
            (_, LayerData::F32(out)) => out.extend(integers.iter().map(|&x| ordered_to_float(x))),
            (_, LayerData::U8(out)) => out.extend(integers.iter().map(|&x| x.clamp(0, 0xFF) as u8)),
            (_, LayerData::U16(out)) => out.extend(integers.iter().map(|&x| x.clamp(0, 0xFFFF) as u16)),
            (_, LayerData::U32(out)) => out.extend(integers.iter().map(|&x| x as u32)),
            (_, LayerData::I8(out)) => out.extend(integers.iter().map(|&x| x.clamp(-0x80, 0x7F) as i8)),
            (_, LayerData::I16(out)) => out.extend(integers.iter().map(|&x| clamped_i16(x))),
            (_, LayerData::I32(out)) => out.extend_from_slice(integers),
            (_, LayerData::F64(out)) => out.extend(integers.as_chunks().0.iter().map(ordered_to_double)),
        }
    }
}

/// Whether a layer of doubles is stored as such even if the stream may round: nothing is known about its unit, and
/// the digits may matter, as in times.
fn is_kept_double(layer: &AttributeLayer) -> bool {
    matches!((&layer.semantic, &layer.data), (Semantic::Generic(_), LayerData::F64(_)))
}

/// Returns a grid with a step of 1 that keeps the identifiers of a layer of floats; `None` if the layer has
/// other values, or if they span too much.
fn identifier_grid(layer: &AttributeLayer, is_lossless: bool) -> Option<ValueTransform> {
    let LayerData::F32(numbers) = &layer.data else { return None };
    // The grid has no negative zero.
    let is_negative_zero = |x: &f32| x.to_bits() == (-0.0f32).to_bits();
    if !layer.has_identifiers() || (is_lossless && numbers.iter().any(is_negative_zero)) {
        return None;
    }
    let ranges = ranges_of(layer.component_count as usize, numbers);
    let most = ranges.iter().fold(0.0f64, |most, r| most.max(f64::from(r.1) - f64::from(r.0)));
    let bits = (most as u32 + 1).next_power_of_two().ilog2().max(1);
    let axes = ranges.iter().map(|r| Axis { origin: r.0 + 0.0, step: 1.0 }).collect();
    (bits <= MAX_BITS).then_some(ValueTransform::Uniform { axes, bits })
}

/// The numbers of a layer of floats in single precision; `None` for integers.
fn singles(data: &LayerData) -> Option<Cow<'_, [f32]>> {
    match data {
        LayerData::F32(numbers) => Some(Cow::Borrowed(numbers)),
        LayerData::F64(numbers) => Some(numbers.iter().map(|&x| x as f32).collect()),
        _ => None,
    }
}

/// Maps a double to its upper and lower half, in the order of the numbers.
fn double_to_ordered(x: f64) -> [i32; 2] {
    let bits = x.to_bits() as i64;
    let ordered = bits ^ (((bits >> 63) as u64) >> 1) as i64;
    [(ordered >> 32) as i32, (ordered as u32 ^ 1 << 31) as i32]
}

/// The inverse of [`double_to_ordered`].
fn ordered_to_double(&[high, low]: &[i32; 2]) -> f64 {
    let ordered = i64::from(high) << 32 | i64::from(low as u32 ^ 1 << 31);
    f64::from_bits((ordered ^ (((ordered >> 63) as u64) >> 1) as i64) as u64)
}

fn clamped_i16(x: i32) -> i16 {
    x.clamp(i32::from(i16::MIN), i32::from(i16::MAX)) as i16
}

/// Returns the octahedral coordinates of a unit vector, and the sign of its fourth component. Of the two
/// equivalent points on the square's border, the first one is chosen.
fn octahedral_integers(vector: &[f32], bits: u32) -> impl Iterator<Item = i32> + use<> {
    let [x, y] = octahedral::encode([vector[0], vector[1], vector[2]], bits).map(i32::from);
    let side = (1i32 << (bits - 1)) - 1;
    let point = [if y.abs() == side { x.abs() } else { x }, if x.abs() == side { y.abs() } else { y }];
    point.into_iter().chain(vector.get(3).map(|&w| if w < 0.0 { -1 } else { 1 }))
}

/// Chooses the transform of a layer of floats.
fn transform_of(semantic: &Semantic, n: usize, numbers: &[f32], options: &LayerOptions) -> ValueTransform {
    if numbers.iter().any(|x| !x.is_finite()) {
        return ValueTransform::Exact;
    }
    let is_direction = match semantic {
        Semantic::Normal => n == 3,
        Semantic::Tangent => n == 4 && numbers.chunks_exact(4).all(|v| v[3].abs() == 1.0),
        _ => false,
    };
    let bits = options.bits_of(semantic);
    if is_direction && numbers.chunks_exact(n).all(|v| is_unit([v[0], v[1], v[2]]) || has_no_direction(v)) {
        return ValueTransform::Octahedral { bits };
    }
    let ranges = ranges_of(n, numbers);
    // Components with a common unit get a common step; other components are independent.
    if !has_common_unit(semantic) {
        let one_by_one = ranges.iter().map(|&range| Axis::over(&[range], 0.0, bits));
        let (axes, bits): (Vec<_>, Vec<_>) = one_by_one.map(|(axes, bits)| (axes[0], bits)).unzip();
        return ValueTransform::Uniform { axes, bits: bits.into_iter().max().unwrap_or(1) };
    }
    // Vertices that a morph target does not move must stay in place.
    let through_zero = is_displacement(semantic).then(|| Axis::through_zero(&ranges, bits)).flatten();
    let (axes, bits) = through_zero.unwrap_or_else(|| Axis::over(&ranges, 0.0, bits));
    ValueTransform::Uniform { axes, bits }
}

/// Returns the smallest and the largest number of each component.
fn ranges_of(n: usize, numbers: &[f32]) -> Vec<(f32, f32)> {
    if numbers.is_empty() {
        return vec![(0.0, 0.0); n];
    }
    let mut ranges = vec![(f32::INFINITY, f32::NEG_INFINITY); n];
    for vertex in numbers.chunks_exact(n) {
        for (range, &x) in ranges.iter_mut().zip(vertex) {
            *range = (range.0.min(x), range.1.max(x));
        }
    }
    ranges
}

/// Whether a vector has unit length within the usual rounding.
fn is_unit(v: [f32; 3]) -> bool {
    let squared: f64 = v.iter().map(|&x| f64::from(x) * f64::from(x)).sum();
    (squared - 1.0).abs() < 0.01
}

/// Whether a vector is too short to have a direction, such as the normal of a degenerate triangle.
fn has_no_direction(v: &[f32]) -> bool {
    v[..3].iter().all(|x| x.abs() < 1e-6)
}

/// Whether the values are displacements by a morph target.
fn is_displacement(semantic: &Semantic) -> bool {
    matches!(semantic, Semantic::MorphPosition(_) | Semantic::MorphNormal(_) | Semantic::MorphTangent(_))
}

/// Whether all components are measured in the same unit.
fn has_common_unit(semantic: &Semantic) -> bool {
    !matches!(semantic, Semantic::Tangent | Semantic::Generic(_))
}

#[cfg(test)]
mod tests {
    use striata::mesh::Random;

    use super::*;
    use crate::format::byte_reader::ByteReader;

    fn unit(random: &mut Random) -> [f32; 3] {
        let v = [(); 3].map(|()| random.between(-1.0, 1.0));
        let length = v.iter().map(|x| x * x).sum::<f32>().sqrt();
        v.map(|x| x / length)
    }

    fn layers() -> Vec<AttributeLayer> {
        let mut random = Random::new(9);
        let n = 400;
        let mut normals: Vec<f32> = (0..n).flat_map(|_| unit(&mut random)).collect();
        for (slot, axis) in normals.chunks_exact_mut(3).zip([
            [0.0, 0.0, -1.0],
            [0.0, 0.0, 1.0],
            [1.0, 0.0, 0.0],
            [0.0, -1.0, 0.0],
            [0.6, -0.8, 0.0],
            [-0.6, 0.8, -1e-9],
        ]) {
            slot.copy_from_slice(&axis);
        }
        let tangents: Vec<f32> = (0..n)
            .flat_map(|i| unit(&mut random).into_iter().chain([if i % 3 == 0 { -1.0 } else { 1.0 }]))
            .collect();
        let mut floats = |count: usize, low: f32, high: f32| -> Vec<f32> {
            (0..count).map(|_| random.between(low, high)).collect()
        };
        let uv = floats(2 * n, -0.2, 3.0);
        let odd_normals = floats(3 * n, -2.0, 2.0);
        let mut wild = floats(3 * n, -1.0, 1.0);
        wild[5] = f32::NAN;
        wild[6] = f32::NEG_INFINITY;
        wild[7] = -0.0;
        let mixed: Vec<f32> =
            (0..n).flat_map(|i| [i as f32 * 1e-20, 7.0, (i as f32) * 1e20, 1e6 + i as f32 / 16.0]).collect();
        let bytes: Vec<u8> = (0..4 * n).map(|i| (i * 37) as u8).collect();
        vec![
            AttributeLayer::from_f32(Semantic::Normal, 3, normals),
            AttributeLayer::from_f32(Semantic::Normal, 3, odd_normals),
            AttributeLayer::from_f32(Semantic::Tangent, 4, tangents),
            AttributeLayer::from_f32(Semantic::Tangent, 4, floats(4 * n, -1.0, 1.0)),
            AttributeLayer::from_f32(Semantic::TexCoord(3), 2, uv),
            AttributeLayer::from_f32(Semantic::Weights(1), 4, floats(4 * n, 0.0, 1.0)),
            AttributeLayer::from_f32(Semantic::MorphPosition(400), 3, floats(3 * n, -1e-6, 1e-6)),
            AttributeLayer::from_f32(Semantic::Generic("wild".into()), 3, wild),
            AttributeLayer::from_f32(Semantic::Generic("mixed".into()), 4, mixed),
            AttributeLayer::from_f32(Semantic::Generic("none".into()), 3, Vec::new()),
            AttributeLayer {
                semantic: Semantic::Color(0),
                component_count: 4,
                normalized: true,
                data: LayerData::U8(bytes.clone()),
            },
            AttributeLayer {
                semantic: Semantic::Joints(0),
                component_count: 4,
                normalized: false,
                data: LayerData::U16(bytes.iter().map(|&x| u16::from(x) * 257).collect()),
            },
            AttributeLayer {
                semantic: Semantic::Generic("id".into()),
                component_count: 1,
                normalized: false,
                data: LayerData::U32((0..n as u32).map(|x| x.wrapping_mul(0x9E37_79B9)).collect()),
            },
            generic(LayerData::I8((0..n).map(|x| (x * 37) as i8).collect())),
            generic(LayerData::I16((0..n).map(|x| (x * 7919) as i16).collect())),
            generic(LayerData::I32((0..n as i32).map(|x| x.wrapping_mul(-0x1E37_79B9)).collect())),
            generic(LayerData::F64(
                (0..n)
                    .map(|x| [1.6e9 + x as f64 * 1e-3, -1e-300, f64::NAN, f64::NEG_INFINITY, -0.0][x % 5])
                    .collect(),
            )),
        ]
    }

    fn generic(data: LayerData) -> AttributeLayer {
        let semantic = Semantic::Generic(data.type_name().to_owned());
        AttributeLayer { semantic, component_count: 1, normalized: false, data }
    }

    fn decoded(form: &LayerForm, integers: &[i32]) -> AttributeLayer {
        let mut layer = form.empty_layer();
        form.append(integers, &mut layer.data);
        layer
    }

    #[test]
    fn integers_survive_conversion_to_numbers() {
        for layer in layers() {
            for options in [
                LayerOptions::default(),
                LayerOptions::default().with_normal_bits(16).with_generic_bits(24).with_texcoord_bits(24),
                LayerOptions::default().with_normal_bits(2).with_generic_bits(1).with_weight_bits(1),
                LayerOptions::default().with_lossless(true),
            ] {
                let form = LayerForm::of(&layer, &options);
                let integers = form.integers(&layer);
                let again = decoded(&form, &integers);
                assert_eq!(again.data.len(), layer.data.len(), "{form:?}");
                assert_eq!(form.integers(&again), integers, "{form:?}");
                if form.transform == ValueTransform::Exact {
                    assert_eq!(again.data.as_bytes(), layer.data.as_bytes(), "{form:?}");
                }
            }
        }
    }

    #[test]
    fn layers_get_a_suitable_form() {
        use ValueTransform::*;
        let options = LayerOptions::default();
        let forms: Vec<_> = layers().iter().map(|layer| LayerForm::of(layer, &options)).collect();
        let kinds: Vec<_> = forms.iter().map(|f| (&f.transform, f.integer_count())).collect();
        assert_eq!(kinds[0], (&Octahedral { bits: 10 }, 2));
        assert!(matches!(kinds[1], (Uniform { bits: 10, .. }, 3)), "not of length 1");
        assert_eq!(kinds[2], (&Octahedral { bits: 10 }, 3));
        assert!(matches!(kinds[3], (Uniform { .. }, 4)), "no sign");
        assert!(matches!(kinds[4], (Uniform { bits: 12, .. }, 2)));
        assert_eq!((kinds[7], kinds[10].0), ((&Exact, 3), &Exact), "not finite; integers");
        let exact = LayerForm::of(&layers()[0], &options.with_lossless(true));
        assert_eq!((exact.transform, exact.component_count), (Exact, 3));
    }

    #[test]
    fn quantization_errors_are_at_most_half_a_step() {
        for layer in layers() {
            let form = LayerForm::of(&layer, &LayerOptions::default());
            let again = decoded(&form, &form.integers(&layer));
            let (LayerData::F32(old), LayerData::F32(new)) = (&layer.data, &again.data) else { continue };
            let n = layer.component_count as usize;
            for (index, (&x, &y)) in old.iter().zip(new).enumerate() {
                let allowed = match &form.transform {
                    ValueTransform::Uniform { axes, .. } => 0.5000001 * axes[index % n].step,
                    ValueTransform::Octahedral { .. } if index % n == 3 => 0.0,
                    ValueTransform::Octahedral { .. } => 1.42 / 511.0,
                    ValueTransform::Exact => continue,
                };
                let off = (f64::from(x) - f64::from(y)).abs();
                assert!(off <= allowed, "{form:?}: {x} became {y}");
            }
        }
    }

    #[test]
    fn reads_written_forms_and_rejects_truncated_ones() {
        for layer in layers() {
            let form = LayerForm::of(&layer, &LayerOptions::default());
            let mut bytes = Vec::new();
            form.write(&mut bytes);
            let mut reader = ByteReader::new(&bytes);
            assert_eq!(LayerForm::read(&mut reader).unwrap(), form);
            reader.end().unwrap();
            for length in 0..bytes.len() {
                assert!(LayerForm::read(&mut ByteReader::new(&bytes[..length])).is_err());
            }
        }
    }

    #[test]
    fn displacements_of_zero_stay_zero() {
        let mut random = Random::new(8);
        for (low, high) in [(-1.0, 1.0), (-0.3, 1e-4), (0.0, 7e9), (-1e-20, 3e-20), (-0.1, 0.0)] {
            let mut numbers: Vec<f32> = (0..900).map(|_| random.between(low, high)).collect();
            numbers[..600].fill(0.0);
            let layer = AttributeLayer::from_f32(Semantic::MorphPosition(2), 3, numbers);
            for bits in [1, 5, 12, 20, 23] {
                let form = LayerForm::of(&layer, &LayerOptions::default().with_generic_bits(bits));
                let ValueTransform::Uniform { axes, .. } = &form.transform else { unreachable!() };
                assert!(axes[0].step <= f64::from(high - low) / f64::from((1u32 << bits) - 1));
                let integers = form.integers(&layer);
                let again = decoded(&form, &integers);
                assert_eq!(again.data.slice(0..600), layer.data.slice(0..600), "{form:?}");
                let steps = |form: &LayerForm| match &form.transform {
                    ValueTransform::Uniform { axes, .. } => axes[0].step,
                    _ => unreachable!(),
                };
                let next = LayerForm::of(&again, &LayerOptions::default().with_generic_bits(bits));
                assert!(bits == 1 || steps(&next) <= steps(&form), "encoding again rounds no more");
            }
        }
    }

    #[test]
    fn identifiers_in_floats_get_a_grid_of_step_1() {
        let mut random = Random::new(3);
        for (most, is_grid) in [(0.0, true), (1.0, true), (8_388_607.0, true), (16_777_215.0, false)] {
            let mut ids: Vec<f32> = (0..300).map(|_| random.between(-most, most).round() + 0.0).collect();
            ids[..4].copy_from_slice(&[most, 0.0 - most, 0.0, most]);
            let layer = AttributeLayer::from_f32(Semantic::Generic("ids".into()), 2, ids);
            for options in [
                LayerOptions::default(),
                LayerOptions::default().with_generic_bits(1),
                LayerOptions::default().with_lossless(true),
            ] {
                let form = LayerForm::of(&layer, &options);
                assert_eq!(matches!(form.transform, ValueTransform::Uniform { .. }), is_grid, "{form:?}");
                let again = decoded(&form, &form.integers(&layer));
                assert_eq!(again.data.as_bytes(), layer.data.as_bytes());
            }
        }
        let with_negative_zero = |options| {
            let layer = AttributeLayer::from_f32(Semantic::Generic("ids".into()), 1, vec![-0.0, 7.0]);
            let form = LayerForm::of(&layer, &options);
            let LayerData::F32(numbers) = decoded(&form, &form.integers(&layer)).data else { unreachable!() };
            numbers.iter().map(|x| x.to_bits()).collect::<Vec<_>>()
        };
        let found = with_negative_zero(LayerOptions::default());
        assert_eq!(found, [0.0f32, 7.0].map(f32::to_bits));
        let found = with_negative_zero(LayerOptions::default().with_lossless(true));
        assert_eq!(found, [-0.0f32, 7.0].map(f32::to_bits));
    }

    #[test]
    fn damaged_forms_are_rejected_or_harmless() {
        let mut random = Random::new(2);
        for layer in layers() {
            let form = LayerForm::of(&layer, &LayerOptions::default());
            let mut bytes = Vec::new();
            form.write(&mut bytes);
            for at in 0..bytes.len() {
                for value in [0, 1, 2, 5, 17, 25, 128, 255] {
                    let mut bad = bytes.clone();
                    bad[at] = value;
                    let Ok(form) = LayerForm::read(&mut ByteReader::new(&bad)) else {
                        continue;
                    };
                    let integers: Vec<i32> =
                        (0..3 * form.integer_count()).map(|_| random.next_u64() as i32).collect();
                    let layer = decoded(&form, &integers);
                    assert_eq!(layer.data.len(), 3 * layer.component_count as usize);
                    let LayerData::F32(numbers) = &layer.data else { continue };
                    assert!(
                        form.transform == ValueTransform::Exact || numbers.iter().all(|x| x.is_finite()),
                        "{form:?}"
                    );
                }
            }
        }
    }

    #[test]
    fn rejects_bits_beyond_the_limits() {
        assert_eq!(LayerOptions::default().check(), Ok(()));
        for bad in [
            LayerOptions::default().with_normal_bits(1),
            LayerOptions::default().with_normal_bits(17),
            LayerOptions::default().with_texcoord_bits(0),
            LayerOptions::default().with_color_bits(25),
            LayerOptions::default().with_weight_bits(0),
            LayerOptions::default().with_generic_bits(25),
        ] {
            assert!(bad.check().is_err(), "{bad:?}");
        }
    }
}
