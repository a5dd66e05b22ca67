//! All levels of cells of a mesh in memory.

use super::{CellMesh, CellOptions, CellSteps, Partition, route, simplify_cell};
use crate::simplify::SimplifyError;

/// Steps of one cell of a hierarchy.
#[derive(Clone, Debug, PartialEq)]
pub struct HierarchyCell {
    /// Level, 0 for the finest.
    pub level: u8,
    /// Number of the cell in its level.
    pub cell: u32,
    /// Its steps.
    pub steps: CellSteps,
}

/// A mesh simplified in cells.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct CellHierarchy {
    /// Cells with at least one step, by level and number.
    pub cells: Vec<HierarchyCell>,
    /// Base mesh, which is left after all levels.
    pub base: CellMesh,
}

/// Simplifies a mesh that fits into memory in the same cells, and with the same steps, as a mesh that does not.
///
/// [`CellOptions::keep`] applies to all levels but the last, which simplifies as far as possible or to
/// [`SequenceOptions::base_triangle_count`](crate::simplify::SequenceOptions::base_triangle_count).
///
/// # Errors
/// [`SimplifyError`] if the mesh is inconsistent or an option is out of range.
pub fn build_in_cells(
    mesh: CellMesh,
    partition: &Partition,
    options: &CellOptions,
) -> Result<CellHierarchy, SimplifyError> {
    let mut hierarchy = CellHierarchy { cells: Vec::new(), base: mesh };
    let level_count = partition.levels().len();
    for (k, level) in partition.levels().iter().enumerate() {
        let routed = route(level, &hierarchy.base);
        hierarchy.base = routed.onward;
        let mut options = options.clone();
        if k + 1 == level_count {
            options.keep = 0.0;
        } else {
            options.sequence.base_triangle_count = 0;
        }
        for (number, cell) in routed.cells {
            let simplified = simplify_cell(&cell, &options)?;
            hierarchy.base.append(&simplified.survivors);
            if !simplified.steps.keys.is_empty() {
                hierarchy.cells.push(HierarchyCell { level: k as u8, cell: number, steps: simplified.steps });
            }
        }
    }
    Ok(hierarchy)
}
