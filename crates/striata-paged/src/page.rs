//! One page: the steps of one cell, with the vertices that they restore.

use striata::mesh::AttributeLayer;

/// Name of a page: the level and the cell whose steps it contains.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct PageId {
    /// Level of the cell, 0 for the finest. The base page has the number of levels.
    pub level: u8,
    /// Index of the cell in its level.
    pub cell: u32,
}

/// A vertex of another page.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Import {
    /// Index of the page in the directory; smaller than that of the importing page.
    pub page: u32,
    /// Vertex among those that the page owns.
    pub vertex: u32,
}

/// A decoded page.
///
/// Vertices are numbered locally: first the `n` that the page owns, then its imports. Loading the page replaces
/// the triangles that its own become when every owned vertex collapses to its target.
#[derive(Clone, Debug, PartialEq)]
pub struct Page {
    /// Level and cell.
    pub id: PageId,
    /// Position of each owned vertex, in mesh units, in refinement order.
    pub positions: Vec<[f32; 3]>,
    /// Attribute layers of the owned vertices.
    pub layers: Vec<AttributeLayer>,
    /// First vertex of each owned position, followed by the number of owned vertices.
    pub first: Vec<u32>,
    /// Target of each owned vertex: an owned vertex of an earlier position or an import. Empty in the base page.
    pub targets: Vec<u32>,
    /// Key of the step that restores each owned position; empty in the base page.
    pub keys: Vec<f32>,
    /// Error of the surface without each owned position, mesh units; empty in the base page.
    pub errors: Vec<f32>,
    /// Vertices of other pages, sorted and without repetitions.
    pub imports: Vec<Import>,
    /// Triangles with at least one owned corner.
    pub triangles: Vec<[u32; 3]>,
    /// Group of each triangle; empty if all belong to group 0.
    pub groups: Vec<u32>,
}
