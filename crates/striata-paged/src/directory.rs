//! The directory: place, counts, bounds and errors of every page.

use serde::{Deserialize, Serialize};

use crate::{Page, PageId};

/// Maximum number of bounds of a page.
pub(crate) const MAX_BOUNDS: usize = 8;

/// Part of a page: where some of its owned positions are, and the largest error among their steps.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct PageBound {
    /// Smallest coordinates of the owned positions, in mesh units.
    pub min: [f32; 3],
    /// Largest coordinates, in mesh units.
    pub max: [f32; 3],
    /// Largest error of a step that restores one of them, in mesh units.
    pub error: f32,
}

/// One page in the directory.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
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
    /// Approximate number of triangles that the page adds to the surface.
    pub added_triangle_count: u32,
    /// Largest error of its steps, in mesh units.
    pub error: f32,
    /// Largest key of its steps.
    pub key: f32,
    /// Pages that its imports name. Sorted; all smaller than its own index.
    pub parents: Vec<u32>,
    /// Parts of the page, at most 8.
    pub bounds: Vec<PageBound>,
}

impl PageEntry {
    /// Describes a page with these bytes.
    pub fn new(page: &Page, bytes: &[u8], offset: u64) -> Self {
        let mut parents: Vec<u32> = page.imports.iter().map(|import| import.page).collect();
        parents.sort_unstable();
        parents.dedup();
        let mut order: Vec<u32> = (0..page.first.len().saturating_sub(1) as u32).collect();
        let mut bounds = Vec::new();
        divide(page, &mut order, MAX_BOUNDS, &mut bounds);
        let owned = page.positions.len() as u32;
        let coarse = |mut v: u32| {
            while v < owned {
                match page.targets.get(v as usize) {
                    Some(&target) => v = target,
                    // The base page has no targets.
                    None => break,
                }
            }
            v
        };
        let is_left = |t: &&[u32; 3]| {
            let [a, b, c] = t.map(coarse);
            a != b && b != c && c != a
        };
        let is_base = page.targets.is_empty();
        let left = if is_base { 0 } else { page.triangles.iter().filter(is_left).count() };
        Self {
            id: page.id,
            offset,
            byte_count: bytes.len() as u32,
            crc: crc32fast::hash(bytes),
            position_count: page.first.len().saturating_sub(1) as u32,
            vertex_count: page.positions.len() as u32,
            triangle_count: page.triangles.len() as u32,
            added_triangle_count: (page.triangles.len() - left) as u32,
            error: page.errors.iter().copied().fold(0.0, f32::max),
            key: page.keys.iter().copied().fold(0.0, f32::max),
            parents,
            bounds,
        }
    }
}

/// Divides positions at the medians of their widest axes into at most `count` bounds.
fn divide(page: &Page, order: &mut [u32], count: usize, bounds: &mut Vec<PageBound>) {
    if order.is_empty() {
        return;
    }
    let at = |p: u32| page.positions[page.first[p as usize] as usize];
    let mut bound = PageBound { min: at(order[0]), max: at(order[0]), error: 0.0 };
    for &p in order.iter() {
        for axis in 0..3 {
            bound.min[axis] = bound.min[axis].min(at(p)[axis]);
            bound.max[axis] = bound.max[axis].max(at(p)[axis]);
        }
        bound.error = bound.error.max(page.errors.get(p as usize).copied().unwrap_or(0.0));
    }
    if count <= 1 || order.len() < 2 {
        bounds.push(bound);
        return;
    }
    let extent = |axis: usize| bound.max[axis] - bound.min[axis];
    let axis = (1..3).fold(0, |best, axis| if extent(axis) > extent(best) { axis } else { best });
    let middle = order.len() / 2;
    order.select_nth_unstable_by(middle, |&p, &q| at(p)[axis].total_cmp(&at(q)[axis]).then(p.cmp(&q)));
    let (below, above) = order.split_at_mut(middle);
    divide(page, below, count / 2, bounds);
    divide(page, above, count - count / 2, bounds);
}

/// Path of an image in a folder or bucket: `images/N`.
pub fn image_path(index: u32) -> String {
    format!("images/{index}")
}

/// Path of a page in a folder or bucket: `L/C.page`.
pub fn page_path(id: PageId) -> String {
    format!("{}/{}.page", id.level, id.cell)
}
