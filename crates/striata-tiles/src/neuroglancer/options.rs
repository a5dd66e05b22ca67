//! Options of meshes for Neuroglancer.

use super::shards::Sharding;

/// Bits of the coordinates of a vertex within its fragment.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum VertexBits {
    /// 10 bits: less than half the bytes.
    Ten,
    /// 16 bits.
    #[default]
    Sixteen,
}

impl VertexBits {
    /// Number of bits.
    pub fn count(self) -> u32 {
        match self {
            Self::Ten => 10,
            Self::Sixteen => 16,
        }
    }
}

/// Options of meshes for Neuroglancer.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct NeuroglancerOptions {
    /// Triangles of a fragment, about; default 16,384.
    pub fragment_triangles: u64,
    /// Bits of coordinates; default 16.
    pub bits: VertexBits,
    /// How segments are distributed to shards; default two files for each segment.
    pub sharding: Option<Sharding>,
}

impl Default for NeuroglancerOptions {
    fn default() -> Self {
        Self { fragment_triangles: 16_384, bits: VertexBits::default(), sharding: None }
    }
}
