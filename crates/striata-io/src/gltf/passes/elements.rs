//! Arrays of accessors in memory, tightly packed.

use serde_json::{Value, json};

use super::super::accessor::Accessor;
use super::super::component_type::GltfComponentType;

/// All elements of an accessor.
#[derive(Clone, Debug)]
pub(super) struct Elements {
    pub component: GltfComponentType,
    /// Number of components of an element.
    pub width: usize,
    pub normalized: bool,
    pub count: usize,
    /// Components without gaps, little-endian.
    pub bytes: Vec<u8>,
}

impl Elements {
    /// Copies the elements of an accessor.
    pub(super) fn read(accessor: &Accessor<'_>) -> Self {
        Self {
            component: accessor.component,
            width: accessor.component_count,
            normalized: accessor.normalized,
            count: accessor.count,
            bytes: accessor.packed_bytes(),
        }
    }

    /// Creates elements of floats.
    pub(super) fn floats(numbers: &[f32], width: usize) -> Self {
        let bytes = numbers.iter().flat_map(|x| x.to_le_bytes()).collect();
        Self {
            component: GltfComponentType::F32,
            width,
            normalized: false,
            count: numbers.len() / width,
            bytes,
        }
    }

    /// Creates elements of integers, which must fit into the component type.
    pub(super) fn integers(
        numbers: impl IntoIterator<Item = i64>,
        width: usize,
        component: GltfComponentType,
    ) -> Self {
        let size = component.bytes();
        let mut bytes = Vec::new();
        for number in numbers {
            bytes.extend_from_slice(&number.to_le_bytes()[..size]);
        }
        let count = bytes.len() / (size * width).max(1);
        Self { component, width, normalized: false, count, bytes }
    }

    /// Declares that the integers are fractions of their largest value.
    pub(super) fn into_normalized(self) -> Self {
        Self { normalized: true, ..self }
    }

    /// Returns the size of an element in bytes.
    pub(super) fn element_bytes(&self) -> usize {
        self.width * self.component.bytes()
    }

    /// Returns the size of an element of vertex data in bytes, which must be a multiple of 4.
    pub(super) fn stride(&self) -> usize {
        self.element_bytes().next_multiple_of(4)
    }

    /// Returns the bytes with gaps of zeros, so that elements start every `stride` bytes.
    pub(super) fn padded(&self, stride: usize) -> Vec<u8> {
        let size = self.element_bytes();
        if size == stride {
            return self.bytes.clone();
        }
        let mut out = Vec::with_capacity(self.count * stride);
        for element in self.bytes.chunks_exact(size.max(1)) {
            out.extend_from_slice(element);
            out.resize(out.len() + stride - size, 0);
        }
        out
    }

    /// Returns the elements in another order.
    pub(super) fn reordered(&self, order: &[u32]) -> Self {
        let size = self.element_bytes();
        let mut bytes = Vec::with_capacity(order.len() * size);
        for &element in order {
            let start = element as usize * size;
            bytes.extend_from_slice(&self.bytes[start..start + size]);
        }
        Self { bytes, count: order.len(), ..*self }
    }

    /// Returns component `place` of the whole array, in the units in which it is stored.
    pub(super) fn number(&self, place: usize) -> f64 {
        let size = self.component.bytes();
        let mut word = [0; 4];
        word[..size].copy_from_slice(&self.bytes[place * size..(place + 1) * size]);
        let [a, b, ..] = word;
        match self.component {
            GltfComponentType::I8 => f64::from(a as i8),
            GltfComponentType::U8 => f64::from(a),
            GltfComponentType::I16 => f64::from(i16::from_le_bytes([a, b])),
            GltfComponentType::U16 => f64::from(u16::from_le_bytes([a, b])),
            GltfComponentType::U32 => f64::from(u32::from_le_bytes(word)),
            GltfComponentType::F32 => f64::from(f32::from_le_bytes(word)),
        }
    }

    /// Sets `min` and `max` of an accessor of these elements.
    pub(super) fn declare_bounds(&self, accessor: &mut Value) {
        let mut bounds = vec![[f64::INFINITY, f64::NEG_INFINITY]; self.width];
        for place in 0..self.count * self.width {
            let (number, bound) = (self.number(place), &mut bounds[place % self.width]);
            *bound = [bound[0].min(number), bound[1].max(number)];
        }
        let list = |side: usize| {
            let number = |bound: &[f64; 2]| match self.component {
                GltfComponentType::F32 => json!(bound[side]),
                _ => json!(bound[side] as i64),
            };
            bounds.iter().map(number).collect::<Vec<Value>>()
        };
        if self.count > 0 {
            accessor["min"] = json!(list(0));
            accessor["max"] = json!(list(1));
        }
    }

    /// Returns an accessor of these elements, without a place in a buffer view.
    pub(super) fn accessor(&self) -> Value {
        let mut accessor = json!({
            "componentType": self.component.number(),
            "count": self.count,
            "type": match self.width {
                1 => "SCALAR",
                2 => "VEC2",
                3 => "VEC3",
                16 => "MAT4",
                _ => "VEC4",
            },
        });
        if self.normalized {
            accessor["normalized"] = json!(true);
        }
        accessor
    }
}
