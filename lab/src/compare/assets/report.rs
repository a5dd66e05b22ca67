//! Report of the comparison of assets.

use serde::Serialize;

use super::levels::LevelRow;

/// The report of one asset.
#[derive(Clone, Debug, Serialize)]
pub(in crate::compare) struct AssetsReport {
    /// Number of triangles of the welded mesh, without degenerate ones; shares refer to it.
    pub(super) triangle_count: usize,
    pub(super) vertex_count: usize,
    pub(super) has_normals: bool,
    pub(super) has_uvs: bool,
    /// Reasons for missing rows.
    pub(super) notes: Vec<String>,
    pub(super) levels: Vec<LevelRow>,
}
