//! What a paged file says about the whole mesh.

use serde::{Deserialize, Serialize};

/// Regular positions: `origin + step * i` for integers `i`, computed in f64 and rounded to f32.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Grid {
    /// Position of the integers 0, in mesh units.
    pub origin: [f64; 3],
    /// Distance of neighboring positions, in mesh units.
    pub step: f64,
}

/// Kind of an attribute layer, and how its values are rounded.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct PagedLayer {
    /// Meaning, as [`Semantic`](striata::mesh::Semantic) is displayed: `normal`, `texcoord_0`.
    pub semantic: String,
    /// Number of values per vertex.
    pub component_count: u8,
    /// Whether integers stand for fractions.
    pub normalized: bool,
    /// `f32`, `u8`, `u16` or `u32`.
    pub component_type: String,
    /// Floats are multiples of this; `None` if they are stored exactly, and for integers.
    pub step: Option<f64>,
}

/// A group of triangles.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct PagedGroup {
    /// Name of the group; may be empty.
    pub name: String,
    /// Index of its material, or `None`.
    pub material: Option<u32>,
}

/// What a paged file says about the whole mesh, stored as JSON.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Metadata {
    /// Name of the input.
    pub source: String,
    /// Number of triangles at full detail.
    pub triangle_count: u64,
    /// Number of positions at full detail.
    pub position_count: u64,
    /// Number of vertices at full detail.
    pub vertex_count: u64,
    /// Smallest coordinates, in mesh units.
    pub min: [f32; 3],
    /// Largest coordinates, in mesh units.
    pub max: [f32; 3],
    /// Where positions are; `None` if they are stored exactly.
    pub grid: Option<Grid>,
    /// Attribute layers.
    pub layers: Vec<PagedLayer>,
    /// Groups that triangles refer to.
    pub groups: Vec<PagedGroup>,
    /// glTF materials as JSON objects, one per material, with textures by index and images by address.
    pub appearance: serde_json::Value,
    /// Number of cells per level, finest first.
    pub cell_counts: Vec<u32>,
    /// Georeference of a terrain.
    pub georeference: Option<serde_json::Value>,
    /// Options of the build, for reference.
    pub options: serde_json::Value,
}
