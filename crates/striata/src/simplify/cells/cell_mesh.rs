//! Triangles of one cell, with what finer levels say about them.

use crate::mesh::AttributeLayer;

/// The last step that changed a triangle, or that removed a neighbor of a vertex and left no triangle at it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct History {
    /// Key of the step: its cost, rounded, and larger than the key of every step that it depends on. The unit
    /// is the diagonal of the whole mesh to the fourth power.
    pub key: f32,
    /// Error of the step, mesh units: an estimate of the distance between the surface after it and the original,
    /// no less than the error of any step that it depends on.
    pub error: f32,
}

impl History {
    /// Takes the larger key and the larger error.
    pub fn join(self, other: Self) -> Self {
        Self { key: self.key.max(other.key), error: self.error.max(other.error) }
    }
}

/// Part of a mesh, as passed from one level of cells to the next.
///
/// Several parts can be appended to each other, so equal vertices may be repeated. A vertex without triangles is
/// a wedge whose triangles were removed at a finer level; it is removed together with its position.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct CellMesh {
    /// Position of each vertex, in mesh units.
    pub positions: Vec<[f32; 3]>,
    /// Attribute layers, each with data for every vertex.
    pub layers: Vec<AttributeLayer>,
    /// Vertex indices of each triangle.
    pub triangles: Vec<[u32; 3]>,
    /// Group of each triangle; empty if all belong to group 0.
    pub groups: Vec<u32>,
    /// Attribute layers of the triangles, each with a row for every triangle.
    pub triangle_layers: Vec<AttributeLayer>,
    /// History of each triangle; empty if no triangle has been changed.
    pub histories: Vec<History>,
    /// Steps that must precede the removal of a vertex although they left no triangle at it, by vertex.
    pub waits: Vec<(u32, History)>,
}

/// Triangles that a cell task reads.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Cell {
    /// Triangles whose corners all belong to the cell.
    pub inside: CellMesh,
    /// Border triangles with at least one corner in the cell. They do not change, and lock their corners.
    pub border: CellMesh,
    /// For each vertex of `border`, whether its position belongs to the cell.
    pub is_within: Vec<bool>,
}
