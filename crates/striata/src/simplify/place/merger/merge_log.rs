//! Records merges, so that a sequence of fragments can be built from them.

use crate::mesh::AttributeLayer;

/// One merge, in the numbering of the welded mesh.
#[derive(Clone, Debug)]
pub(in crate::simplify::place) struct LoggedMerge {
    /// Position that is removed, and the one that it is merged with.
    pub removed: u32,
    pub kept: u32,
    /// New place of the kept position, mesh units, and the first row with the attributes of its wedges;
    /// `None` if it stays.
    pub moved: Option<([f32; 3], u32)>,
    /// Other positions that lose their last triangle.
    pub lost: Vec<u32>,
    /// Whether the merge belongs to the same step as the one before it.
    pub continues: bool,
}

/// All merges, and the attributes of moved vertices.
#[derive(Clone, Debug)]
pub(in crate::simplify::place) struct MergeLog {
    pub merges: Vec<LoggedMerge>,
    /// Attributes: a row for each vertex of the welded mesh, then one for each wedge that moved, in order.
    pub rows: Vec<AttributeLayer>,
    pub row_count: u32,
}

impl MergeLog {
    pub(super) fn new(layers: &[AttributeLayer], vertex_count: usize) -> Self {
        Self { merges: Vec::new(), rows: layers.to_vec(), row_count: vertex_count as u32 }
    }

    /// Adds the current attributes of some wedges as rows; returns the index of the first.
    pub(super) fn add_rows(&mut self, layers: &[AttributeLayer], wedges: std::ops::Range<u32>) -> u32 {
        let first = self.row_count;
        self.row_count += wedges.len() as u32;
        for (rows, layer) in self.rows.iter_mut().zip(layers) {
            let n = layer.component_count as usize;
            let values = wedges.start as usize * n..wedges.end as usize * n;
            let is_one_type = rows.data.extend_from_range(&layer.data, values);
            debug_assert!(is_one_type, "rows were copied from the layers");
        }
        first
    }
}
