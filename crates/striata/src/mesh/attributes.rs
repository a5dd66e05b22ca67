//! Attribute layers: per-vertex data other than the position.

use std::fmt;

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

/// Values of a layer, vertex by vertex, with `component_count` values each.
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
}

impl LayerData {
    /// Number of values: vertices times components.
    pub fn len(&self) -> usize {
        match self {
            Self::F32(v) => v.len(),
            Self::U8(v) => v.len(),
            Self::U16(v) => v.len(),
            Self::U32(v) => v.len(),
        }
    }

    /// Whether the layer has no values.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Size of one value, in bytes.
    pub fn component_bytes(&self) -> usize {
        match self {
            Self::F32(_) | Self::U32(_) => 4,
            Self::U16(_) => 2,
            Self::U8(_) => 1,
        }
    }

    /// The values as little-endian bytes, which is their layout in memory on all supported machines.
    pub fn as_bytes(&self) -> &[u8] {
        match self {
            Self::F32(v) => bytemuck::cast_slice(v),
            Self::U8(v) => v,
            Self::U16(v) => bytemuck::cast_slice(v),
            Self::U32(v) => bytemuck::cast_slice(v),
        }
    }
}

/// One attribute of every vertex.
#[derive(Clone, Debug, PartialEq)]
pub struct AttributeLayer {
    /// Meaning of the values.
    pub semantic: Semantic,
    /// Number of values per vertex, 1 to 255.
    pub component_count: u8,
    /// Whether integers stand for fractions (255 means 1.0), as in glTF.
    pub normalized: bool,
    /// `vertex_count * component_count` values.
    pub data: LayerData,
}

impl AttributeLayer {
    /// Creates a layer of floats.
    pub fn from_f32(semantic: Semantic, component_count: u8, data: Vec<f32>) -> Self {
        Self { semantic, component_count, normalized: false, data: LayerData::F32(data) }
    }

    /// Size of one vertex in this layer, in bytes.
    pub fn vertex_bytes(&self) -> usize {
        self.component_count as usize * self.data.component_bytes()
    }

    /// Component `component` of vertex `vertex` as a float; normalized integers are mapped to 0..=1.
    pub fn get(&self, vertex: usize, component: usize) -> f32 {
        let index = vertex * self.component_count as usize + component;
        match &self.data {
            LayerData::F32(v) => v[index],
            LayerData::U8(v) if self.normalized => f32::from(v[index]) / 255.0,
            LayerData::U8(v) => f32::from(v[index]),
            LayerData::U16(v) if self.normalized => f32::from(v[index]) / 65535.0,
            LayerData::U16(v) => f32::from(v[index]),
            LayerData::U32(v) => v[index] as f32,
        }
    }

    /// Selects and reorders vertices: vertex `i` of the result is vertex `order[i]` of this layer.
    pub fn gather(&self, order: &[u32]) -> Self {
        fn pick<T: Copy>(data: &[T], order: &[u32], n: usize) -> Vec<T> {
            let mut out = Vec::with_capacity(order.len() * n);
            for &v in order {
                out.extend_from_slice(&data[v as usize * n..][..n]);
            }
            out
        }
        let n = self.component_count as usize;
        let data = match &self.data {
            LayerData::F32(v) => LayerData::F32(pick(v, order, n)),
            LayerData::U8(v) => LayerData::U8(pick(v, order, n)),
            LayerData::U16(v) => LayerData::U16(pick(v, order, n)),
            LayerData::U32(v) => LayerData::U32(pick(v, order, n)),
        };
        Self { semantic: self.semantic.clone(), data, ..*self }
    }
}
