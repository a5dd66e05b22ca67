//! The directory: what is known about every page without reading it.

use crate::PageId;

/// Part of a page: where some of its owned positions are, and the largest error among their steps.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PageBound {
    /// Smallest coordinates of the owned positions, in mesh units.
    pub min: [f32; 3],
    /// Largest coordinates, in mesh units.
    pub max: [f32; 3],
    /// Largest error of a step that restores one of them, in mesh units.
    pub error: f32,
}

/// One page in the directory.
#[derive(Clone, Debug, PartialEq)]
pub struct PageEntry {
    /// Level and cell.
    pub id: PageId,
    /// First byte, counted from the first byte of the first page.
    pub offset: u64,
    /// Number of bytes.
    pub byte_count: u32,
    /// CRC-32 of the bytes.
    pub crc: u32,
    /// Number of owned positions.
    pub position_count: u32,
    /// Number of owned vertices.
    pub vertex_count: u32,
    /// Number of triangles with an owned corner.
    pub triangle_count: u32,
    /// Largest error of its steps, in mesh units.
    pub error: f32,
    /// Largest key of its steps.
    pub key: f32,
    /// Pages that its imports name. Sorted; all smaller than its own index.
    pub parents: Vec<u32>,
    /// Parts of the page, at most 16.
    pub bounds: Vec<PageBound>,
}
