//! Validates and sorts the strips of the full mesh before a strip model is built from them.

use super::ModelError;
use crate::mesh::IndexedMesh;
use crate::strip::{StripSet, strip_triangles};

/// Checks that strips belong to a mesh by comparing their group, vertex and triangle counts.
///
/// # Errors
/// [`ModelError`] if the number of groups or the triangle count of a group differs, or a strip uses a
/// vertex that does not exist.
pub fn check_strips(mesh: &IndexedMesh, strips: &StripSet) -> Result<(), ModelError> {
    let groups = mesh.groups_or_whole();
    if strips.group_count() != groups.len() {
        return Err(ModelError::GroupCount { found: strips.group_count(), expected: groups.len() });
    }
    let vertex_count = mesh.vertex_count();
    for (strip, indices) in strips.strips().enumerate() {
        if let Some(&vertex) = indices.iter().find(|&&v| v as usize >= vertex_count) {
            return Err(ModelError::Vertex { strip, vertex, vertex_count });
        }
    }
    for (group, expected) in groups.iter().map(|g| g.count as usize).enumerate() {
        let found = strips.group_strips(group).map(|s| strip_triangles(strips.strip(s)).count()).sum();
        if found != expected {
            return Err(ModelError::TriangleCount { group, found, expected });
        }
    }
    Ok(())
}

/// Sorts the strips of each group along a space-filling curve, so that strips that meet at a vertex get
/// nearby indices.
pub(super) fn sorted_spatially(strips: &StripSet, positions: &[[f32; 3]]) -> StripSet {
    let mut min = [f64::INFINITY; 3];
    let mut extent = 0f64;
    for p in positions {
        (0..3).for_each(|a| min[a] = min[a].min(f64::from(p[a])));
    }
    for p in positions {
        (0..3).for_each(|a| extent = extent.max(f64::from(p[a]) - min[a]));
    }
    let scale = if extent > 0.0 { 1023.0 / extent } else { 0.0 };
    let code = |strip: usize| {
        let indices = strips.strip(strip);
        let mut code = 0;
        for axis in 0..3 {
            let sum: f64 = indices.iter().map(|&v| f64::from(positions[v as usize][axis]) - min[axis]).sum();
            code |= spread_bits((sum * scale / indices.len().max(1) as f64) as u32) << axis;
        }
        code
    };
    let mut out = StripSet::new();
    for group in 0..strips.group_count() {
        let mut order: Vec<(u32, usize)> = strips.group_strips(group).map(|s| (code(s), s)).collect();
        order.sort_unstable();
        for (_, strip) in order {
            out.push(strips.strip(strip));
        }
        out.end_group();
    }
    out
}

/// Spreads the low 10 bits of a value apart, with two zeros between neighboring bits.
fn spread_bits(value: u32) -> u32 {
    let mut x = value & 0x3ff;
    x = (x | x << 16) & 0x0300_00ff;
    x = (x | x << 8) & 0x0300_f00f;
    x = (x | x << 4) & 0x030c_30c3;
    (x | x << 2) & 0x0924_9249
}
