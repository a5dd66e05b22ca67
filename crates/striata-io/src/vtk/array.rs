//! Data arrays, with their values in the type that the file gives them.

use striata::mesh::LayerData;

use crate::text::{parsed, quoted};

/// Type of the values of an array.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum VtkScalar {
    I8,
    U8,
    I16,
    U16,
    I32,
    U32,
    I64,
    U64,
    F32,
    F64,
}

/// Values of an array.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Values {
    I8(Vec<i8>),
    U8(Vec<u8>),
    I16(Vec<i16>),
    U16(Vec<u16>),
    I32(Vec<i32>),
    U32(Vec<u32>),
    I64(Vec<i64>),
    U64(Vec<u64>),
    F32(Vec<f32>),
    F64(Vec<f64>),
}

/// Meaning of an array.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Role {
    Normals,
    TexCoords,
    Other,
}

/// An array of the points or the cells.
#[derive(Clone, Debug)]
pub(super) struct Array {
    pub name: String,
    pub role: Role,
    pub component_count: usize,
    pub values: Values,
}

/// Evaluates an expression with the vector of any type.
macro_rules! with_vector {
    ($values:expr, $vector:ident => $body:expr) => {
        match $values {
            Values::I8($vector) => $body,
            Values::U8($vector) => $body,
            Values::I16($vector) => $body,
            Values::U16($vector) => $body,
            Values::I32($vector) => $body,
            Values::U32($vector) => $body,
            Values::I64($vector) => $body,
            Values::U64($vector) => $body,
            Values::F32($vector) => $body,
            Values::F64($vector) => $body,
        }
    };
}

/// Evaluates an expression that converts to the vector of the scalar's type, whose name is `$type`.
macro_rules! of_scalar {
    ($scalar:expr, $type:ident => $body:expr) => {
        match $scalar {
            VtkScalar::I8 => Values::I8(of_scalar!(@ i8, $type => $body)),
            VtkScalar::U8 => Values::U8(of_scalar!(@ u8, $type => $body)),
            VtkScalar::I16 => Values::I16(of_scalar!(@ i16, $type => $body)),
            VtkScalar::U16 => Values::U16(of_scalar!(@ u16, $type => $body)),
            VtkScalar::I32 => Values::I32(of_scalar!(@ i32, $type => $body)),
            VtkScalar::U32 => Values::U32(of_scalar!(@ u32, $type => $body)),
            VtkScalar::I64 => Values::I64(of_scalar!(@ i64, $type => $body)),
            VtkScalar::U64 => Values::U64(of_scalar!(@ u64, $type => $body)),
            VtkScalar::F32 => Values::F32(of_scalar!(@ f32, $type => $body)),
            VtkScalar::F64 => Values::F64(of_scalar!(@ f64, $type => $body)),
        }
    };
    (@ $actual:ident, $type:ident => $body:expr) => {{
        type $type = $actual;
        $body
    }};
}

impl VtkScalar {
    /// Returns the type with a name of the legacy format.
    pub(super) fn from_legacy(name: &str) -> Option<Self> {
        Some(match name {
            "char" | "signed_char" => Self::I8,
            "unsigned_char" => Self::U8,
            "short" => Self::I16,
            "unsigned_short" => Self::U16,
            // Identifiers take 32 bits in legacy files.
            "int" | "vtkidtype" => Self::I32,
            "unsigned_int" => Self::U32,
            "long" | "vtktypeint64" => Self::I64,
            "unsigned_long" | "vtktypeuint64" => Self::U64,
            "float" => Self::F32,
            "double" => Self::F64,
            _ => return None,
        })
    }

    /// Returns the type with a name of the XML format.
    pub(super) fn from_xml(name: &str) -> Option<Self> {
        Some(match name {
            "Int8" => Self::I8,
            "UInt8" => Self::U8,
            "Int16" => Self::I16,
            "UInt16" => Self::U16,
            "Int32" => Self::I32,
            "UInt32" => Self::U32,
            "Int64" => Self::I64,
            "UInt64" => Self::U64,
            "Float32" => Self::F32,
            "Float64" => Self::F64,
            _ => return None,
        })
    }

    /// Size of a value, in bytes.
    pub(super) fn bytes(self) -> usize {
        match self {
            Self::I8 | Self::U8 => 1,
            Self::I16 | Self::U16 => 2,
            Self::I32 | Self::U32 | Self::F32 => 4,
            Self::I64 | Self::U64 | Self::F64 => 8,
        }
    }
}

impl Values {
    /// Converts bytes; those after the last whole value are ignored.
    pub(super) fn from_bytes(scalar: VtkScalar, bytes: &[u8], is_big_endian: bool) -> Self {
        of_scalar!(scalar, T => {
            let (chunks, _) = bytes.as_chunks::<{ size_of::<T>() }>();
            let convert = if is_big_endian { T::from_be_bytes } else { T::from_le_bytes };
            chunks.iter().map(|&chunk| convert(chunk)).collect()
        })
    }

    /// Parses words; `next` returns each, and [`None`] after the last.
    pub(super) fn from_words<'a>(
        scalar: VtkScalar,
        mut next: impl FnMut() -> Option<&'a [u8]>,
    ) -> Result<Self, String> {
        Ok(of_scalar!(scalar, T => {
            let mut values: Vec<T> = Vec::new();
            while let Some(word) = next() {
                match parsed(word) {
                    Some(value) => values.push(value),
                    None => return Err(format!("expected a number of the type {}, found {}", stringify_type(scalar), quoted(word))),
                }
            }
            values
        }))
    }

    pub(super) fn len(&self) -> usize {
        with_vector!(self, v => v.len())
    }

    #[expect(clippy::unnecessary_cast, reason = "one expression for all types")]
    pub(super) fn floats(&self) -> Vec<f32> {
        with_vector!(self, v => v.iter().map(|&x| x as f32).collect())
    }

    /// Returns whole numbers; floats are truncated.
    #[expect(clippy::unnecessary_cast, reason = "one expression for all types")]
    pub(super) fn integers(&self) -> Vec<i64> {
        with_vector!(self, v => v.iter().map(|&x| x as i64).collect())
    }

    /// Appends values of the same type; false if the types differ.
    pub(super) fn append(&mut self, more: &Self) -> bool {
        match (self, more) {
            (Self::I8(to), Self::I8(from)) => to.extend_from_slice(from),
            (Self::U8(to), Self::U8(from)) => to.extend_from_slice(from),
            (Self::I16(to), Self::I16(from)) => to.extend_from_slice(from),
            (Self::U16(to), Self::U16(from)) => to.extend_from_slice(from),
            (Self::I32(to), Self::I32(from)) => to.extend_from_slice(from),
            (Self::U32(to), Self::U32(from)) => to.extend_from_slice(from),
            (Self::I64(to), Self::I64(from)) => to.extend_from_slice(from),
            (Self::U64(to), Self::U64(from)) => to.extend_from_slice(from),
            (Self::F32(to), Self::F32(from)) => to.extend_from_slice(from),
            (Self::F64(to), Self::F64(from)) => to.extend_from_slice(from),
            _ => return false,
        }
        true
    }
}

fn stringify_type(scalar: VtkScalar) -> &'static str {
    match scalar {
        VtkScalar::I8 => "Int8",
        VtkScalar::U8 => "UInt8",
        VtkScalar::I16 => "Int16",
        VtkScalar::U16 => "UInt16",
        VtkScalar::I32 => "Int32",
        VtkScalar::U32 => "UInt32",
        VtkScalar::I64 => "Int64",
        VtkScalar::U64 => "UInt64",
        VtkScalar::F32 => "Float32",
        VtkScalar::F64 => "Float64",
    }
}

/// Converts the values to those of a layer, or returns why they cannot be kept.
///
/// 64-bit integers are kept as 32-bit integers if all fit, otherwise as doubles if these are exact.
pub(super) fn layer_data(values: Values) -> Result<LayerData, String> {
    match values {
        Values::I8(v) => Ok(LayerData::I8(v)),
        Values::U8(v) => Ok(LayerData::U8(v)),
        Values::I16(v) => Ok(LayerData::I16(v)),
        Values::U16(v) => Ok(LayerData::U16(v)),
        Values::I32(v) => Ok(LayerData::I32(v)),
        Values::U32(v) => Ok(LayerData::U32(v)),
        Values::F32(v) => Ok(LayerData::F32(v)),
        Values::F64(v) => Ok(LayerData::F64(v)),
        Values::I64(v) => narrowed(&v.iter().map(|&x| i128::from(x)).collect::<Vec<_>>()),
        Values::U64(v) => narrowed(&v.iter().map(|&x| i128::from(x)).collect::<Vec<_>>()),
    }
}

fn narrowed(values: &[i128]) -> Result<LayerData, String> {
    let fit = |range: std::ops::RangeInclusive<i128>| values.iter().all(|x| range.contains(x));
    if fit(i128::from(i32::MIN)..=i128::from(i32::MAX)) {
        Ok(LayerData::I32(values.iter().map(|&x| x as i32).collect()))
    } else if fit(0..=i128::from(u32::MAX)) {
        Ok(LayerData::U32(values.iter().map(|&x| x as u32).collect()))
    } else if fit(-(1 << 53)..=1 << 53) {
        Ok(LayerData::F64(values.iter().map(|&x| x as f64).collect()))
    } else {
        Err("64-bit integers beyond 2^53 are left out".to_owned())
    }
}
