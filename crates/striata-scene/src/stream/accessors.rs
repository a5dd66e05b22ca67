//! Accessors of the scene's buffer: where they lie, and their numbers.

use std::ops::Range;

use serde_json::Value;

use super::json::referred;
use crate::document::index;

/// Location of an accessor's elements in the buffer.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct AccessorPlace {
    pub bytes: Range<usize>,
    /// Distance between elements, bytes.
    pub stride: usize,
    /// Whether the components are 32 bits wide.
    pub is_wide: bool,
}

/// Returns the place of an accessor without sparse data in the buffer, if all of it is inside.
pub(super) fn place_of(document: &Value, accessor: &Value, buffer_bytes: usize) -> Option<AccessorPlace> {
    let view = referred(document, "bufferViews", accessor, "bufferView")?;
    let component_bytes = match accessor.get("componentType")?.as_u64()? {
        5120 | 5121 => 1,
        5122 | 5123 => 2,
        5125 | 5126 => 4,
        _ => return None,
    };
    let components = match accessor.get("type")?.as_str()? {
        "SCALAR" => 1,
        "VEC2" => 2,
        "VEC3" => 3,
        "VEC4" => 4,
        "MAT4" => 16,
        _ => return None,
    };
    let element = components * component_bytes;
    let stride = index(view, "byteStride").unwrap_or(element).max(element);
    let count = index(accessor, "count")?.checked_sub(1)?;
    let offset = |of: &Value| index(of, "byteOffset").unwrap_or(0);
    let start = offset(view).checked_add(offset(accessor))?;
    let end = count.checked_mul(stride)?.checked_add(element)?.checked_add(start)?;
    (end <= buffer_bytes).then_some(AccessorPlace {
        bytes: start..end,
        stride,
        is_wide: component_bytes == 4,
    })
}

/// Returns the numbers of an accessor of floats or normalized integers; [`None`] if it cannot be read.
pub(super) fn numbers(document: &Value, buffer: &[u8], accessor: usize) -> Option<Vec<f64>> {
    let accessor = crate::document::entries(document, "accessors").get(accessor)?;
    if accessor.get("sparse").is_some() {
        return None;
    }
    let place = place_of(document, accessor, buffer.len())?;
    let bytes = buffer.get(place.bytes)?;
    let float = |b: &[u8; 4]| f64::from(f32::from_le_bytes(*b));
    let short = |b: &[u8; 2]| u16::from_le_bytes(*b);
    Some(match accessor.get("componentType")?.as_u64()? {
        5126 => bytes.as_chunks().0.iter().map(float).collect(),
        5121 => bytes.iter().map(|&b| f64::from(b) / 255.0).collect(),
        5120 => bytes.iter().map(|&b| f64::from(b as i8) / 127.0).collect(),
        5123 => bytes.as_chunks().0.iter().map(|b| f64::from(short(b)) / 65535.0).collect(),
        5122 => bytes.as_chunks().0.iter().map(|b| f64::from(short(b) as i16) / 32767.0).collect(),
        _ => return None,
    })
}
