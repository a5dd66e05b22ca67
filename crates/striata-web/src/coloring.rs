//! Assigns triangles to strips or fans, for coloring.
//!
//! Triangles are reordered by strip or fan, and each gets the number of its strip or fan, so that a
//! renderer only needs a color for each number.

use striata::mesh::{IndexedMesh, TriangleGroup};
#[cfg(feature = "files")]
use striata::model::{FanIndices, fan_triangles_into};
#[cfg(feature = "files")]
use striata::strip::RESTART;
use striata::strip::{strip_triangles, stripify};

use crate::Failure;
use crate::shown_level::ShownLevel;

/// Stripifies the shown triangles, reorders them by strip, and returns the strip number of each.
///
/// # Errors
/// If the triangles do not form a valid mesh.
pub(crate) fn by_strips(shown: &mut ShownLevel, vertex_count: usize) -> Result<Vec<u32>, Failure> {
    // Stripification uses only connectivity, so positions may be anything.
    let mut mesh = IndexedMesh::new(vec![[0.0; 3]; vertex_count], std::mem::take(&mut shown.triangles));
    let mut first = 0;
    for &count in &shown.group_counts {
        mesh.groups.push(TriangleGroup { name: String::new(), material: None, first, count });
        first += count;
    }
    let strips = stripify(&mesh).map_err(Failure::corrupt)?;
    let mut numbers = Vec::with_capacity(mesh.triangles.len());
    for group in 0..strips.group_count() {
        let before = shown.triangles.len();
        for strip in strips.group_strips(group) {
            shown.triangles.extend(strip_triangles(strips.strip(strip)));
            numbers.resize(shown.triangles.len(), strip as u32);
        }
        if let Some(count) = shown.group_counts.get_mut(group) {
            *count = (shown.triangles.len() - before) as u32;
        }
    }
    Ok(numbers)
}

/// Reorders triangles by fan and returns the fan number of each.
#[cfg(feature = "files")]
pub(crate) fn by_fans(shown: &mut ShownLevel, fans: &FanIndices) -> Vec<u32> {
    shown.triangles.clear();
    shown.group_counts.clear();
    let (mut numbers, mut fan_count) = (Vec::new(), 0);
    for range in &fans.group_ranges {
        let before = shown.triangles.len();
        let indices = &fans.indices[range.start as usize..range.end as usize];
        for fan in indices.split(|&index| index == RESTART).filter(|fan| !fan.is_empty()) {
            fan_triangles_into(fan, &mut shown.triangles);
            numbers.resize(shown.triangles.len(), fan_count);
            fan_count += 1;
        }
        shown.group_counts.push((shown.triangles.len() - before) as u32);
    }
    numbers
}

/// Returns the pivot of each triangle: the vertex that is removed first, which has the highest index.
pub(crate) fn by_pivots(shown: &ShownLevel) -> Vec<u32> {
    shown.triangles.iter().map(|corners| corners.iter().copied().max().unwrap_or(0)).collect()
}
