//! What was measured of assets.

use serde::Serialize;

use super::levels::LevelRow;

/// What was measured of one asset.
#[derive(Clone, Debug, Serialize)]
pub(in crate::compare) struct AssetsReport {
    /// Triangles of the welded mesh, without degenerate ones: what shares are shares of.
    pub(super) triangle_count: usize,
    pub(super) vertex_count: usize,
    pub(super) has_normals: bool,
    pub(super) has_uvs: bool,
    /// Why rows are missing.
    pub(super) notes: Vec<String>,
    pub(super) levels: Vec<LevelRow>,
}
