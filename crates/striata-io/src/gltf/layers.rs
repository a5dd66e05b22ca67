//! Attribute layers from accessors: a common type for all primitives, and default values for missing
//! attributes.

use std::collections::BTreeMap;

use striata::mesh::{AttributeLayer, LayerData, Semantic};

use super::accessor::{Accessor, AccessorShape};
use super::component_type::GltfComponentType;
use super::primitive::Primitive;
use super::transform::{Transform, transform_values};
use crate::error::Fault;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum AccessorKind {
    U8,
    U16,
    U32,
    I8,
    I16,
    F32,
}

/// Storage format of a layer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct LayerFormat {
    component_count: u8,
    kind: AccessorKind,
    normalized: bool,
}

impl LayerFormat {
    /// Returns the format that keeps an accessor's numbers unchanged, or floats if a layer cannot.
    fn of(semantic: &Semantic, accessor: &AccessorShape) -> Result<Self, Fault> {
        let count = accessor.component_count;
        let fits = match semantic {
            Semantic::Normal
            | Semantic::MorphPosition(_)
            | Semantic::MorphNormal(_)
            | Semantic::MorphTangent(_) => count == 3,
            Semantic::Tangent | Semantic::Joints(_) | Semantic::Weights(_) => count == 4,
            Semantic::TexCoord(_) => count == 2,
            Semantic::Color(_) => matches!(count, 3 | 4),
            Semantic::Generic(_) => true,
        };
        if !fits {
            return Err(accessor.fault(format!("{count} components cannot be a {semantic}")));
        }
        let kind = match accessor.component {
            GltfComponentType::U8 => AccessorKind::U8,
            GltfComponentType::U16 => AccessorKind::U16,
            GltfComponentType::U32 => AccessorKind::U32,
            GltfComponentType::I8 => AccessorKind::I8,
            GltfComponentType::I16 => AccessorKind::I16,
            GltfComponentType::F32 => AccessorKind::F32,
        };
        let keeps_integers = match semantic {
            Semantic::TexCoord(_) | Semantic::Color(_) | Semantic::Weights(_) => {
                accessor.normalized && matches!(kind, AccessorKind::U8 | AccessorKind::U16)
            }
            Semantic::Joints(_) => !matches!(kind, AccessorKind::I8 | AccessorKind::I16),
            Semantic::Generic(_) => true,
            _ => false,
        };
        let kind = if keeps_integers { kind } else { AccessorKind::F32 };
        let normalized = accessor.normalized && kind != AccessorKind::F32;
        Ok(Self { component_count: count as u8, kind, normalized })
    }

    /// Returns a format that can represent both.
    fn united(self, other: Self) -> Self {
        let component_count = self.component_count.max(other.component_count);
        if self.kind == other.kind && self.normalized == other.normalized {
            return Self { component_count, ..self };
        }
        let has_no_fractions = |f: Self| f.kind != AccessorKind::F32 && !f.normalized;
        let is_signed = [self, other].iter().any(|f| matches!(f.kind, AccessorKind::I8 | AccessorKind::I16));
        // Of signed types, floats represent all values that occur together.
        let kind = if !is_signed && has_no_fractions(self) && has_no_fractions(other) {
            if self.kind == AccessorKind::U32 || other.kind == AccessorKind::U32 {
                AccessorKind::U32
            } else {
                AccessorKind::U16
            }
        } else {
            AccessorKind::F32
        };
        Self { component_count, kind, normalized: false }
    }

    /// Returns the size of one vertex's values in bytes.
    pub(crate) fn vertex_bytes(self) -> u64 {
        let size = match self.kind {
            AccessorKind::U8 | AccessorKind::I8 => 1,
            AccessorKind::U16 | AccessorKind::I16 => 2,
            AccessorKind::U32 | AccessorKind::F32 => 4,
        };
        u64::from(self.component_count) * size
    }

    /// Creates an empty layer with capacity for all vertices.
    pub(crate) fn layer(self, semantic: &Semantic, vertex_count: usize) -> AttributeLayer {
        let room = vertex_count * self.component_count as usize;
        let data = match self.kind {
            AccessorKind::U8 => LayerData::U8(Vec::with_capacity(room)),
            AccessorKind::U16 => LayerData::U16(Vec::with_capacity(room)),
            AccessorKind::U32 => LayerData::U32(Vec::with_capacity(room)),
            AccessorKind::I8 => LayerData::I8(Vec::with_capacity(room)),
            AccessorKind::I16 => LayerData::I16(Vec::with_capacity(room)),
            AccessorKind::F32 => LayerData::F32(Vec::with_capacity(room)),
        };
        let Self { component_count, normalized, .. } = self;
        AttributeLayer { semantic: semantic.clone(), component_count, normalized, data }
    }
}

/// Formats of the layers of a scene.
pub(crate) type LayerFormats = BTreeMap<Semantic, LayerFormat>;

/// Checks the shapes of a primitive's accessors, and widens the formats of the layers for them; returns the
/// number of vertices.
pub(crate) fn add_vertices(
    primitive: &Primitive<'_>,
    formats: &mut LayerFormats,
    shape_of: impl Fn(Option<&Semantic>, u64) -> Result<AccessorShape, Fault>,
) -> Result<usize, Fault> {
    let positions = shape_of(None, primitive.position)?;
    if positions.component_count != 3 {
        return Err(positions.fault("POSITION must be VEC3"));
    }
    let vertex_count = positions.count;
    for (semantic, index) in &primitive.attributes {
        let shape = shape_of(Some(semantic), *index)?;
        if shape.count != vertex_count {
            return Err(shape.fault(format!("{} elements for {vertex_count} vertices", shape.count)));
        }
        let format = LayerFormat::of(semantic, &shape)?;
        formats.entry(semantic.clone()).and_modify(|f| *f = f.united(format)).or_insert(format);
    }
    Ok(vertex_count)
}

/// Appends an accessor's elements, transformed like the instance.
pub(crate) fn append(layer: &mut AttributeLayer, accessor: &Accessor<'_>, transform: Option<&Transform>) {
    let width = layer.component_count as usize;
    let is_full_width = accessor.component_count == width;
    match (&mut layer.data, accessor.component) {
        (LayerData::U8(data), GltfComponentType::U8) if is_full_width => {
            data.extend(accessor.read::<1, _>(|[b]| b));
        }
        (LayerData::U16(data), GltfComponentType::U16) if is_full_width => {
            data.extend(accessor.read::<2, _>(u16::from_le_bytes));
        }
        (LayerData::I8(data), GltfComponentType::I8) if is_full_width => {
            data.extend(accessor.read::<1, _>(i8::from_le_bytes));
        }
        (LayerData::I16(data), GltfComponentType::I16) if is_full_width => {
            data.extend(accessor.read::<2, _>(i16::from_le_bytes));
        }
        (LayerData::F32(data), _) => {
            let mut numbers = accessor.floats();
            if let Some(transform) = transform {
                transform_values(&layer.semantic, &mut numbers, transform);
            }
            widen(data, &numbers, [accessor.component_count, width], &layer.semantic, 1.0);
        }
        (data, _) => {
            let numbers = accessor.integers().unwrap_or_default();
            let shape = [accessor.component_count, width];
            match data {
                LayerData::U8(data) => {
                    let narrow: Vec<u8> = numbers.iter().map(|&x| x as u8).collect();
                    widen(data, &narrow, shape, &layer.semantic, u8::MAX);
                }
                LayerData::U16(data) => {
                    let narrow: Vec<u16> = numbers.iter().map(|&x| x as u16).collect();
                    widen(data, &narrow, shape, &layer.semantic, u16::MAX);
                }
                LayerData::U32(data) => widen(data, &numbers, shape, &layer.semantic, u32::MAX),
                LayerData::I8(data) => {
                    let narrow: Vec<i8> = accessor.read::<1, _>(i8::from_le_bytes);
                    widen(data, &narrow, shape, &layer.semantic, i8::MAX);
                }
                LayerData::I16(data) => {
                    let narrow: Vec<i16> = accessor.read::<2, _>(i16::from_le_bytes);
                    widen(data, &narrow, shape, &layer.semantic, i16::MAX);
                }
                // No format of glTF has these types.
                LayerData::F32(_) | LayerData::I32(_) | LayerData::F64(_) => {}
            }
        }
    }
}

/// Copies elements into a layer that may be wider: a color's missing alpha is `one`, all else zero.
fn widen<T: Copy + Default>(
    out: &mut Vec<T>,
    numbers: &[T],
    [from, to]: [usize; 2],
    semantic: &Semantic,
    one: T,
) {
    if from == to {
        out.extend_from_slice(numbers);
        return;
    }
    let fill = if matches!(semantic, Semantic::Color(_)) { one } else { T::default() };
    for element in numbers.chunks_exact(from) {
        out.extend_from_slice(element);
        out.extend(std::iter::repeat_n(fill, to - from));
    }
}

/// Appends default values for vertices without the attribute: white, a tangent along x, else zero.
pub(crate) fn fill(layer: &mut AttributeLayer, vertex_count: usize) {
    let count = vertex_count * layer.component_count as usize;
    let is_white = matches!(layer.semantic, Semantic::Color(_));
    match &mut layer.data {
        LayerData::U8(data) => data.resize(data.len() + count, if is_white { u8::MAX } else { 0 }),
        LayerData::U16(data) => data.resize(data.len() + count, if is_white { u16::MAX } else { 0 }),
        LayerData::U32(data) => data.resize(data.len() + count, 0),
        LayerData::F32(data) if layer.semantic == Semantic::Tangent => {
            data.extend(std::iter::repeat_n([1.0, 0.0, 0.0, 1.0], vertex_count).flatten());
        }
        LayerData::F32(data) => data.resize(data.len() + count, if is_white { 1.0 } else { 0.0 }),
        data => data.resize_with_zeros(data.len() + count),
    }
}
