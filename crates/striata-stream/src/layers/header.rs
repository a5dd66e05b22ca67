//! Binary layout of a layer's form: six bytes, two numbers, a name, and the axes of a grid.

use striata::file::{SemanticCode, semantic_code, semantic_of};

use super::form::{LayerForm, NumberType, ValueTransform};
use crate::format::byte_reader::{ByteReader, write_varint};
use crate::format::error::DecodeError;
use crate::format::grid::{Axis, MAX_BITS};

impl LayerForm {
    /// Appends the bytes of the form.
    pub(crate) fn write(&self, out: &mut Vec<u8>) {
        let SemanticCode { kind, set, name } = semantic_code(&self.semantic);
        let number_type = NumberType::ALL.iter().position(|&t| t == self.number_type).unwrap_or(0) as u8;
        let (transform, bits) = match self.transform {
            ValueTransform::Exact => (0, 0),
            ValueTransform::Octahedral { bits } => (1, bits),
            ValueTransform::Uniform { bits, .. } => (2, bits),
        };
        out.extend([
            kind,
            number_type,
            self.component_count,
            u8::from(self.normalized),
            transform,
            bits as u8,
        ]);
        write_varint(set, out);
        write_varint(name.len() as u32, out);
        out.extend(name.as_bytes());
        if let ValueTransform::Uniform { axes, .. } = &self.transform {
            for axis in axes {
                out.extend(axis.origin.to_le_bytes());
                out.extend(axis.step.to_le_bytes());
            }
        }
    }

    /// Reads a form.
    ///
    /// # Errors
    /// [`DecodeError`] if the bytes end too early or are invalid.
    pub(crate) fn read(reader: &mut ByteReader<'_>) -> Result<Self, DecodeError> {
        let [code, number_type, component_count, normalized] =
            [reader.u8()?, reader.u8()?, reader.u8()?, reader.u8()?];
        let [transform, bits] = [reader.u8()?, reader.u8()?];
        let set = reader.varint()?;
        let name = reader.text()?;
        let Some(semantic) = semantic_of(code, set, &name) else {
            return Err(reader.malformed("unknown semantic of a layer"));
        };
        if component_count == 0 || normalized > 1 {
            return Err(
                reader.malformed("a layer must have 1 to 255 components and a normalized flag of 0 or 1")
            );
        }
        let Some(&number_type) = NumberType::ALL.get(number_type as usize) else {
            return Err(reader.malformed("unknown number type of a layer"));
        };
        let is_float = number_type == NumberType::F32;
        let bits = u32::from(bits);
        let transform = match transform {
            0 => ValueTransform::Exact,
            1 if is_float && matches!(component_count, 3 | 4) && (2..=16).contains(&bits) => {
                ValueTransform::Octahedral { bits }
            }
            2 if is_float && (1..=MAX_BITS).contains(&bits) => {
                let axes = (0..component_count).map(|_| read_axis(reader)).collect::<Result<_, _>>()?;
                ValueTransform::Uniform { axes, bits }
            }
            _ => return Err(reader.malformed("unknown or invalid transform of a layer")),
        };
        Ok(Self { semantic, component_count, normalized: normalized == 1, number_type, transform })
    }
}

/// Reads the origin and step of an axis.
fn read_axis(reader: &mut ByteReader<'_>) -> Result<Axis, DecodeError> {
    let origin = reader.f32()?;
    let step = [u64::from(reader.u32()?), u64::from(reader.u32()?)];
    let axis = Axis { origin, step: f64::from_bits(step[0] | step[1] << 32) };
    axis.check().map_err(|_| reader.malformed("the grid of a layer has an invalid origin or step"))
}
