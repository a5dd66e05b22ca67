//! Compressed buffer views.

use meshoptimizer_rs::codec::{
    IndexEncoding, VertexEncoding, encode_filter_oct, encode_filter_quat, encode_index_buffer,
    encode_index_sequence, encode_vertex_buffer,
};
use serde_json::{Value, json};

use super::order::{MeshoptOrder, workspace};
use super::roles::{AccessorRole, AccessorUse};
use crate::QuantizeOptions;
use crate::gltf::accessor::accessor;
use crate::gltf::component_type::GltfComponentType;
use crate::gltf::document::GltfDocument;
use crate::gltf::passes::additions::{Additions, Shelf, ViewKind, describe, plain_view, remove};
use crate::gltf::passes::elements::Elements;
use crate::gltf::passes::parts::{GltfParts, array_length, entries_mut, push_entries};

pub(super) const EXTENSION: &str = "EXT_meshopt_compression";

const TRIANGLES: &str = "triangles";
const STRIPS: &str = "strips";

/// An accessor, and what it is used for.
pub(super) struct RoledAccessor<'a> {
    /// Index in the document.
    pub index: u64,
    /// Its use.
    pub role: &'a AccessorRole,
}

/// Moves an accessor to a view of its kind, in its new order.
pub(super) fn move_accessor(
    document: &GltfDocument<'_>,
    RoledAccessor { index, role }: RoledAccessor<'_>,
    order: &MeshoptOrder,
    root: &mut Value,
    additions: &mut Additions,
) {
    let Ok(source) = accessor(document, index, &document.root) else { return };
    let slot = usize::try_from(index).ok().and_then(|index| entries_mut(root, "accessors").get_mut(index));
    let Some(slot) = slot else { return };
    let is_empty = slot.get("bufferView").is_none() && slot.get("sparse").is_none();
    if is_empty || source.count == 0 {
        return;
    }
    let (kind, elements) = match role.usage {
        AccessorUse::Vertices => {
            let elements = Elements::read(&source);
            let vertices = order.vertices(index).map(|vertices| elements.reordered(vertices));
            let elements = vertices.unwrap_or(elements);
            (ViewKind::of_vertices(&role.name, &elements), elements)
        }
        AccessorUse::Triangles | AccessorUse::Strips => {
            let integers = order.indices(index).map(<[u32]>::to_vec).or_else(|| source.integers());
            let Some(integers) = integers else { return };
            let is_small = integers.iter().all(|&vertex| vertex < 0xffff);
            let component = if is_small { GltfComponentType::U16 } else { GltfComponentType::U32 };
            let is_list = role.usage == AccessorUse::Triangles && integers.len().is_multiple_of(3);
            let elements = Elements::integers(integers.into_iter().map(i64::from), 1, component);
            (ViewKind::of_indices(if is_list { TRIANGLES } else { STRIPS }, &elements), elements)
        }
        AccessorUse::Other => {
            let elements = Elements::read(&source);
            if !elements.element_bytes().is_multiple_of(4) {
                return;
            }
            (ViewKind::of_others(&role.name, &elements), elements)
        }
    };
    slot["componentType"] = json!(elements.component.number());
    remove(slot, "sparse");
    additions.store(kind, &elements, slot);
}

/// Buffer that stands for the uncompressed data, and has no bytes.
pub(super) struct Fallback<'q> {
    index: usize,
    quantization: Option<&'q QuantizeOptions>,
    /// Size of the uncompressed data.
    pub bytes: usize,
}

impl<'q> Fallback<'q> {
    /// Starts an empty buffer after those of the document.
    pub(super) fn new(root: &Value, quantization: Option<&'q QuantizeOptions>) -> Self {
        let index = array_length(root, "buffers").max(1);
        Self { index, quantization, bytes: 0 }
    }

    /// Adds the buffer to the document.
    pub(super) fn declare(&self, root: &mut Value) {
        let buffer = json!({ "byteLength": self.bytes, "extensions": { EXTENSION: { "fallback": true } } });
        push_entries(root, "buffers", vec![buffer]);
    }

    /// Adds the bytes of a shelf, compressed if that makes them smaller, and returns their view.
    pub(super) fn view(&mut self, parts: &mut GltfParts, shelf: &Shelf) -> Value {
        let packed = packed(shelf, self.quantization).filter(|packed| packed.bytes.len() < shelf.bytes.len());
        let Some(packed) = packed else { return plain_view(parts, shelf) };
        let mut extension = parts.push_bytes(&packed.bytes);
        let stride = shelf.kind.stride;
        extension["byteStride"] = json!(stride);
        extension["mode"] = json!(packed.mode);
        extension["count"] = json!(shelf.bytes.len() / stride);
        if packed.filter != "NONE" {
            extension["filter"] = json!(packed.filter);
        }
        self.bytes = self.bytes.next_multiple_of(4);
        let mut view = json!({
            "buffer": self.index,
            "byteOffset": self.bytes,
            "byteLength": shelf.bytes.len(),
            "extensions": { EXTENSION: extension },
        });
        describe(&mut view, &shelf.kind);
        self.bytes += shelf.bytes.len();
        view
    }
}

/// Compressed data.
struct Packed {
    mode: &'static str,
    filter: &'static str,
    bytes: Vec<u8>,
}

fn packed(shelf: &Shelf, quantization: Option<&QuantizeOptions>) -> Option<Packed> {
    match shelf.kind.role.as_str() {
        TRIANGLES | STRIPS if shelf.kind.target.is_some() => packed_indices(shelf),
        _ => packed_attributes(shelf, quantization),
    }
}

fn packed_indices(shelf: &Shelf) -> Option<Packed> {
    let list: Vec<u32> = match shelf.kind.stride {
        2 => shelf.bytes.as_chunks::<2>().0.iter().map(|&word| u16::from_le_bytes(word).into()).collect(),
        _ => shelf.bytes.as_chunks::<4>().0.iter().map(|&word| u32::from_le_bytes(word)).collect(),
    };
    let (encoding, work) = (IndexEncoding::new(1).ok()?, &mut workspace());
    let (mode, bytes) = if shelf.kind.role == TRIANGLES {
        ("TRIANGLES", encode_index_buffer(&list, encoding, work).ok()?)
    } else {
        ("INDICES", encode_index_sequence(&list, encoding, work).ok()?)
    };
    Some(Packed { mode, filter: "NONE", bytes })
}

fn packed_attributes(shelf: &Shelf, quantization: Option<&QuantizeOptions>) -> Option<Packed> {
    let encoded = |bytes: &[u8], filter: &'static str| {
        let (stride, encoding) = (shelf.kind.stride, VertexEncoding::new(0, 0).ok()?);
        let bytes = encode_vertex_buffer(bytes, bytes.len() / stride, stride, encoding, &mut workspace());
        Some(Packed { mode: "ATTRIBUTES", filter, bytes: bytes.ok()? })
    };
    let plain = encoded(&shelf.bytes, "NONE")?;
    let rotation_bits = quantization.map(|options| options.rotation_bits.clamp(9, 16));
    let quaternions = quaternions(shelf, rotation_bits).and_then(|bytes| encoded(&bytes, "QUATERNION"));
    let normal_bits = quantization.map(|options| options.normal_bits);
    let octahedral = octahedral(shelf, normal_bits).and_then(|bytes| encoded(&bytes, "OCTAHEDRAL"));
    let exponential = exponential(shelf).and_then(|bytes| encoded(&bytes, "EXPONENTIAL"));
    let candidates = [quaternions, octahedral, exponential].into_iter().flatten();
    Some(
        candidates.fold(plain, |best, other| if other.bytes.len() < best.bytes.len() { other } else { best }),
    )
}

/// Encodes quantized unit vectors in two numbers; [`None`] for other data.
fn octahedral(shelf: &Shelf, normal_bits: Option<u32>) -> Option<Vec<u8>> {
    let ViewKind { role, component, stride, .. } = &shelf.kind;
    let normal_bits = normal_bits.filter(|_| matches!(role.as_str(), "NORMAL" | "TANGENT"))?;
    let (numbers, bits): (Vec<f32>, u32) = match (*component, *stride) {
        (5120, 4) => {
            (shelf.bytes.iter().map(|&b| f32::from(b as i8) / 127.0).collect(), normal_bits.clamp(2, 8))
        }
        (5122, 8) => {
            let words = shelf.bytes.as_chunks::<2>().0.iter();
            let numbers = words.map(|&word| f32::from(i16::from_le_bytes(word)) / 32767.0);
            (numbers.collect(), normal_bits.clamp(2, 16))
        }
        _ => return None,
    };
    encode_filter_oct(shelf.bytes.len() / stride, *stride, bits, &numbers, &mut workspace()).ok()
}

/// Encodes quantized rotations in three numbers; [`None`] for other data.
fn quaternions(shelf: &Shelf, rotation_bits: Option<u32>) -> Option<Vec<u8>> {
    let ViewKind { role, component, stride, .. } = &shelf.kind;
    let bits = rotation_bits.filter(|_| role == "animated rotation" && (*component, *stride) == (5122, 8))?;
    let words = shelf.bytes.as_chunks::<2>().0.iter();
    let numbers: Vec<f32> = words.map(|&word| f32::from(i16::from_le_bytes(word)) / 32767.0).collect();
    encode_filter_quat(shelf.bytes.len() / stride, *stride, bits, &numbers, &mut workspace()).ok()
}

/// Encodes floats as integers with a common exponent for each component; [`None`] if that is not exact.
fn exponential(shelf: &Shelf) -> Option<Vec<u8>> {
    /// Exponents whose powers of two every decoder can represent.
    const EXPONENTS: std::ops::RangeInclusive<i32> = -100..=100;
    if shelf.kind.component != GltfComponentType::F32.number() {
        return None;
    }
    let numbers: Vec<f32> =
        shelf.bytes.as_chunks::<4>().0.iter().map(|&word| f32::from_le_bytes(word)).collect();
    let width = shelf.kind.stride / 4;
    let mut exponents = vec![i32::MAX; width];
    for (place, &number) in numbers.iter().enumerate() {
        let exponent = &mut exponents[place % width];
        *exponent = (*exponent).min(last_bit(number)?);
    }
    let exponents: Vec<i32> = exponents.into_iter().map(|e| if e == i32::MAX { 0 } else { e }).collect();
    if !exponents.iter().all(|exponent| EXPONENTS.contains(exponent)) {
        return None;
    }
    let mut bytes = Vec::with_capacity(shelf.bytes.len());
    for (place, &number) in numbers.iter().enumerate() {
        let exponent = exponents[place % width];
        let mantissa = f64::from(number) / f64::from(power_of_two(exponent)?);
        if mantissa.abs() >= f64::from(1 << 23) {
            return None;
        }
        let word = ((exponent as u32) << 24) | (mantissa as i32 as u32 & 0x00ff_ffff);
        bytes.extend_from_slice(&word.to_le_bytes());
    }
    Some(bytes)
}

/// Returns the exponent of the lowest bit that is set; the largest for 0, [`None`] for other numbers that
/// are not normal.
fn last_bit(number: f32) -> Option<i32> {
    if number == 0.0 {
        return Some(i32::MAX);
    }
    let bits = number.to_bits();
    let mantissa = bits & 0x007f_ffff | 0x0080_0000;
    let exponent = (bits >> 23 & 0xff) as i32 - 127 - 23;
    number.is_normal().then(|| exponent + mantissa.trailing_zeros() as i32)
}

fn power_of_two(exponent: i32) -> Option<f32> {
    let biased = u32::try_from(exponent + 127).ok().filter(|biased| (1..255).contains(biased))?;
    Some(f32::from_bits(biased << 23))
}
