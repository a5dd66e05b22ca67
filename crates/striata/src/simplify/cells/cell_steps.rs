//! Options and result of a cell task.

use super::CellMesh;
use crate::mesh::AttributeLayer;
use crate::setters::setters;
use crate::simplify::{SequenceOptions, StopReason};

/// Options of [`simplify_cell`](super::simplify_cell).
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct CellOptions {
    /// Cost, weights and rules of the simplification. [`SequenceOptions::base_triangle_count`] counts triangles
    /// inside the cell, of which no less than [`Self::keep`] are kept. [`SequenceOptions::locked_vertices`] is
    /// ignored. [`SequenceOptions::max_error`] limits [`History::error`](super::History): steps beyond it are left
    /// out, with all that depend on them.
    pub sequence: SequenceOptions,
    /// Diagonal of the whole mesh's bounding box, in mesh units: the unit of costs and attribute weights.
    pub diagonal: f64,
    /// Material of each group that triangles refer to; groups beyond its end have none.
    pub materials: Vec<Option<u32>>,
    /// Share of the triangles inside the cell to keep; default 0.25. A hierarchy's last level keeps 0: it
    /// simplifies as far as possible.
    pub keep: f64,
}

impl CellOptions {
    /// Creates the options for cells of a mesh with this diagonal, in mesh units.
    pub fn new(diagonal: f64) -> Self {
        Self { sequence: SequenceOptions::default(), diagonal, materials: Vec::new(), keep: 0.25 }
    }

    setters! {
        with_sequence, sequence: SequenceOptions;
        with_materials, materials: Vec<Option<u32>>;
        with_keep, keep: f64;
    }
}

/// Steps of one cell. Vertices are numbered locally: first the owned ones, which the steps remove, then the
/// others that are mentioned.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct CellSteps {
    /// Position of each vertex, in mesh units. The wedges of an owned position are adjacent.
    pub positions: Vec<[f32; 3]>,
    /// Attribute layers of all vertices.
    pub layers: Vec<AttributeLayer>,
    /// First vertex of each owned position, followed by the number of owned vertices.
    pub first: Vec<u32>,
    /// Target of each owned vertex: a vertex at a position with a larger key, or one that is not owned.
    pub targets: Vec<u32>,
    /// [`History::key`](super::History) of each owned position.
    pub keys: Vec<f32>,
    /// [`History::error`](super::History) of each owned position, in mesh units.
    pub errors: Vec<f32>,
    /// Triangles of the cell's input with at least one owned corner.
    ///
    /// The coarser surface contains what these become when each owned vertex collapses to its target, except
    /// triangles that become degenerate.
    pub triangles: Vec<[u32; 3]>,
    /// Group of each triangle; empty if all belong to group 0.
    pub groups: Vec<u32>,
    /// Attribute layers of the triangles, each with a row for every triangle.
    pub triangle_layers: Vec<AttributeLayer>,
}

/// Result of a cell task.
#[derive(Clone, Debug, PartialEq)]
pub struct SimplifiedCell {
    /// The steps.
    pub steps: CellSteps,
    /// Inside triangles that are left, for the cells of the next level; and wedges without triangles, and
    /// waits, at positions that are left.
    pub survivors: CellMesh,
    /// Why the simplification ended.
    pub stop_reason: StopReason,
}
