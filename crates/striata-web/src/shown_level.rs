//! Levels that are shown: triangles over the vertex buffer, group by group.

/// A level that is shown, uniform or view-dependent.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct ShownLevel {
    /// Corners of the triangles, group by group.
    pub triangles: Vec<[u32; 3]>,
    /// Triangle count of each group; there is at least one group.
    pub group_counts: Vec<u32>,
    /// Number of vertex splits of the level.
    pub split_count: usize,
    /// Largest distance from the full mesh, mesh units.
    pub error: f32,
}
