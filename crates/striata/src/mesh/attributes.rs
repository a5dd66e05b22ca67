//! Attribute layers: per-vertex data other than the position.

use std::fmt;
use std::ops::Range;

/// Meaning of a layer; files store layers in the order of these variants.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Semantic {
    /// Unit normal, 3 components.
    Normal,
    /// Unit tangent with handedness, 4 components.
    Tangent,
    /// Texture coordinates, 2 components; the number is the UV set.
    TexCoord(u8),
    /// Color, 3 or 4 components in 0..=1 (or normalized integers); the number is the color set. The values
    /// are linear if the mesh comes from glTF, and sRGB if it comes from PLY, OBJ or OFF.
    Color(u8),
    /// Indices of up to 4 joints; the number is the set.
    Joints(u8),
    /// Weights of the joints of the same set, 4 components.
    Weights(u8),
    /// Displacement of the position by one morph target, 3 components; the number is the target.
    MorphPosition(u16),
    /// Displacement of the normal by one morph target, 3 components.
    MorphNormal(u16),
    /// Displacement of the tangent by one morph target, 3 components.
    MorphTangent(u16),
    /// Any other attribute, under the name that its file gives it.
    Generic(String),
}

impl Semantic {
    /// Whether the layer describes how vertices move: that of a skin or of a morph target.
    pub fn is_of_poses(&self) -> bool {
        matches!(
            self,
            Self::Joints(_)
                | Self::Weights(_)
                | Self::MorphPosition(_)
                | Self::MorphNormal(_)
                | Self::MorphTangent(_)
        )
    }
}

impl fmt::Display for Semantic {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Normal => f.write_str("normal"),
            Self::Tangent => f.write_str("tangent"),
            Self::TexCoord(set) => write!(f, "texcoord_{set}"),
            Self::Color(set) => write!(f, "color_{set}"),
            Self::Joints(set) => write!(f, "joints_{set}"),
            Self::Weights(set) => write!(f, "weights_{set}"),
            Self::MorphPosition(target) => write!(f, "morph_{target}_position"),
            Self::MorphNormal(target) => write!(f, "morph_{target}_normal"),
            Self::MorphTangent(target) => write!(f, "morph_{target}_tangent"),
            Self::Generic(name) => write!(f, "generic_{name}"),
        }
    }
}

/// Values of a layer, vertex by vertex (or triangle by triangle), with `component_count` values each.
#[derive(Clone, Debug, PartialEq)]
pub enum LayerData {
    /// 32-bit floats.
    F32(Vec<f32>),
    /// Bytes.
    U8(Vec<u8>),
    /// 16-bit integers.
    U16(Vec<u16>),
    /// 32-bit integers.
    U32(Vec<u32>),
    /// Signed bytes.
    I8(Vec<i8>),
    /// Signed 16-bit integers.
    I16(Vec<i16>),
    /// Signed 32-bit integers.
    I32(Vec<i32>),
    /// 64-bit floats.
    F64(Vec<f64>),
}

/// Evaluates an expression for the vector of values, whatever their type.
macro_rules! with_values {
    ($data:expr, $values:ident => $result:expr) => {
        match $data {
            LayerData::F32($values) => $result,
            LayerData::U8($values) => $result,
            LayerData::U16($values) => $result,
            LayerData::U32($values) => $result,
            LayerData::I8($values) => $result,
            LayerData::I16($values) => $result,
            LayerData::I32($values) => $result,
            LayerData::F64($values) => $result,
        }
    };
}

/// Evaluates an expression for the vector of values, and makes data of the same type from its result.
macro_rules! map_values {
    ($data:expr, $values:ident => $result:expr) => {
        match $data {
            LayerData::F32($values) => LayerData::F32($result),
            LayerData::U8($values) => LayerData::U8($result),
            LayerData::U16($values) => LayerData::U16($result),
            LayerData::U32($values) => LayerData::U32($result),
            LayerData::I8($values) => LayerData::I8($result),
            LayerData::I16($values) => LayerData::I16($result),
            LayerData::I32($values) => LayerData::I32($result),
            LayerData::F64($values) => LayerData::F64($result),
        }
    };
}

/// Evaluates an expression for two vectors of the same type; otherwise evaluates the last one.
macro_rules! with_both {
    ($a:expr, $b:expr, ($x:ident, $y:ident) => $result:expr, else $other:expr) => {
        match ($a, $b) {
            (LayerData::F32($x), LayerData::F32($y)) => $result,
            (LayerData::U8($x), LayerData::U8($y)) => $result,
            (LayerData::U16($x), LayerData::U16($y)) => $result,
            (LayerData::U32($x), LayerData::U32($y)) => $result,
            (LayerData::I8($x), LayerData::I8($y)) => $result,
            (LayerData::I16($x), LayerData::I16($y)) => $result,
            (LayerData::I32($x), LayerData::I32($y)) => $result,
            (LayerData::F64($x), LayerData::F64($y)) => $result,
            _ => $other,
        }
    };
}

fn number_of(value: impl Into<f64>) -> f64 {
    value.into()
}

impl LayerData {
    /// Names of the types, in the order of the variants, which is also that of their codes in files.
    pub const TYPE_NAMES: [&'static str; 8] = ["f32", "u8", "u16", "u32", "i8", "i16", "i32", "f64"];

    /// Index of the type in [`TYPE_NAMES`](Self::TYPE_NAMES).
    pub fn type_code(&self) -> usize {
        match self {
            Self::F32(_) => 0,
            Self::U8(_) => 1,
            Self::U16(_) => 2,
            Self::U32(_) => 3,
            Self::I8(_) => 4,
            Self::I16(_) => 5,
            Self::I32(_) => 6,
            Self::F64(_) => 7,
        }
    }

    /// Name of the type of the values, such as `u8`.
    pub fn type_name(&self) -> &'static str {
        Self::TYPE_NAMES[self.type_code()]
    }

    /// No values of the type with this code; `None` if there is no such type.
    pub fn empty_of(type_code: usize) -> Option<Self> {
        Some(match type_code {
            0 => Self::F32(Vec::new()),
            1 => Self::U8(Vec::new()),
            2 => Self::U16(Vec::new()),
            3 => Self::U32(Vec::new()),
            4 => Self::I8(Vec::new()),
            5 => Self::I16(Vec::new()),
            6 => Self::I32(Vec::new()),
            7 => Self::F64(Vec::new()),
            _ => return None,
        })
    }

    /// No values of the type with this name; `None` if there is no such type.
    pub fn empty_named(type_name: &str) -> Option<Self> {
        Self::TYPE_NAMES.iter().position(|&name| name == type_name).and_then(Self::empty_of)
    }

    /// No values, of the same type.
    pub fn empty_like(&self) -> Self {
        map_values!(self, _values => Vec::new())
    }

    /// Values of the same type from little-endian bytes, the inverse of [`as_bytes`](Self::as_bytes); bytes
    /// that are not a whole value are dropped.
    pub fn from_bytes_like(&self, bytes: &[u8]) -> Self {
        let bytes = &bytes[..bytes.len() / self.component_bytes() * self.component_bytes()];
        map_values!(self, _values => bytemuck::pod_collect_to_vec(bytes))
    }

    /// Number of values: vertices times components.
    pub fn len(&self) -> usize {
        with_values!(self, v => v.len())
    }

    /// Whether the layer has no values.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Whether the values are floats.
    pub fn is_float(&self) -> bool {
        matches!(self, Self::F32(_) | Self::F64(_))
    }

    /// Size of one value, in bytes.
    pub fn component_bytes(&self) -> usize {
        match self {
            Self::F64(_) => 8,
            Self::F32(_) | Self::U32(_) | Self::I32(_) => 4,
            Self::U16(_) | Self::I16(_) => 2,
            Self::U8(_) | Self::I8(_) => 1,
        }
    }

    /// The values as little-endian bytes, which is their layout in memory on all supported machines.
    pub fn as_bytes(&self) -> &[u8] {
        with_values!(self, v => bytemuck::cast_slice(v))
    }

    /// A value as a double, which represents all types exactly.
    pub fn number(&self, index: usize) -> f64 {
        with_values!(self, v => number_of(v[index]))
    }

    /// Appends the values in a range of `other`; returns whether both are of the same type.
    pub fn extend_from_range(&mut self, other: &Self, range: Range<usize>) -> bool {
        with_both!(self, other, (to, from) => {
            to.extend_from_slice(&from[range]);
            true
        }, else false)
    }

    /// Appends all values of `other`; returns whether both are of the same type.
    pub fn extend_from(&mut self, other: &Self) -> bool {
        self.extend_from_range(other, 0..other.len())
    }

    /// Changes the number of values; new ones are 0.
    pub fn resize_with_zeros(&mut self, len: usize) {
        with_values!(self, v => v.resize(len, Default::default()));
    }

    /// Copies the values in a range to another place.
    pub fn copy_within(&mut self, from: Range<usize>, to: usize) {
        with_values!(self, v => v.copy_within(from, to));
    }

    /// The values in a range.
    pub fn slice(&self, range: Range<usize>) -> Self {
        map_values!(self, v => v[range].to_vec())
    }

    /// Selects and reorders rows of `n` values.
    pub fn gather(&self, order: &[u32], n: usize) -> Self {
        fn pick<T: Copy>(data: &[T], order: &[u32], n: usize) -> Vec<T> {
            let mut out = Vec::with_capacity(order.len() * n);
            for &v in order {
                out.extend_from_slice(&data[v as usize * n..][..n]);
            }
            out
        }
        map_values!(self, v => pick(v, order, n))
    }
}

/// One attribute of every vertex, or of every triangle.
#[derive(Clone, Debug, PartialEq)]
pub struct AttributeLayer {
    /// Meaning of the values.
    pub semantic: Semantic,
    /// Number of values per vertex or triangle, 1 to 255.
    pub component_count: u8,
    /// Whether integers stand for fractions (255 means 1.0), as in glTF.
    pub normalized: bool,
    /// `vertex_count * component_count` values; for a layer of triangles, `triangle_count * component_count`.
    pub data: LayerData,
}

impl AttributeLayer {
    /// Creates a layer of floats.
    pub fn from_f32(semantic: Semantic, component_count: u8, data: Vec<f32>) -> Self {
        Self { semantic, component_count, normalized: false, data: LayerData::F32(data) }
    }

    /// Whether the values may be identifiers, between which interpolation makes no sense: a generic layer
    /// that contains only whole numbers. Floats count if all are below 2^24 in magnitude, because glTF has
    /// no 32-bit integers for identifiers.
    pub fn has_identifiers(&self) -> bool {
        let is_whole = |x: f64| x.fract() == 0.0 && x.abs() < f64::from(1 << 24);
        matches!(self.semantic, Semantic::Generic(_))
            && match &self.data {
                LayerData::F32(values) => values.iter().all(|&x| is_whole(x.into())),
                LayerData::F64(values) => values.iter().all(|&x| is_whole(x)),
                _ => !self.normalized,
            }
    }

    /// Size of one vertex in this layer, in bytes.
    pub fn vertex_bytes(&self) -> usize {
        self.component_count as usize * self.data.component_bytes()
    }

    /// Component `component` of vertex `vertex` as a float; normalized integers are mapped to 0..=1, or
    /// -1..=1 if they are signed.
    pub fn get(&self, vertex: usize, component: usize) -> f32 {
        let index = vertex * self.component_count as usize + component;
        match &self.data {
            LayerData::F32(v) => v[index],
            LayerData::U8(v) if self.normalized => f32::from(v[index]) / 255.0,
            LayerData::U8(v) => f32::from(v[index]),
            LayerData::U16(v) if self.normalized => f32::from(v[index]) / 65535.0,
            LayerData::U16(v) => f32::from(v[index]),
            LayerData::U32(v) => v[index] as f32,
            LayerData::I8(v) if self.normalized => (f32::from(v[index]) / 127.0).max(-1.0),
            LayerData::I8(v) => f32::from(v[index]),
            LayerData::I16(v) if self.normalized => (f32::from(v[index]) / 32767.0).max(-1.0),
            LayerData::I16(v) => f32::from(v[index]),
            LayerData::I32(v) => v[index] as f32,
            LayerData::F64(v) => v[index] as f32,
        }
    }

    /// Selects and reorders vertices: vertex `i` of the result is vertex `order[i]` of this layer.
    pub fn gather(&self, order: &[u32]) -> Self {
        let data = self.data.gather(order, self.component_count as usize);
        Self { semantic: self.semantic.clone(), data, ..*self }
    }
}

/// Selects and reorders rows of layers: row `i` of the result is row `order[i]`.
pub(crate) fn gather_layers(layers: &[AttributeLayer], order: &[u32]) -> Vec<AttributeLayer> {
    layers.iter().map(|layer| layer.gather(order)).collect()
}
