//! What is shown: triangles over the vertex buffer, group after group.

/// One level, uniform or not.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Shown {
    /// Corners, group after group.
    pub(crate) triangles: Vec<[u32; 3]>,
    /// Triangles of each group, one of them at least.
    pub(crate) group_counts: Vec<u32>,
    /// Vertex splits that are shown.
    pub(crate) split_count: usize,
    /// How far this is from the full mesh at most, mesh units.
    pub(crate) error: f32,
}

/// A level that is the same everywhere.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Wish {
    /// 0 the base mesh, 1 the full mesh.
    Detail(f64),
    /// The most detailed level with no more triangles.
    Triangles(usize),
    /// The coarsest level that is no farther off, mesh units.
    Error(f64),
}
