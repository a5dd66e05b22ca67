//! The request to a contender, and the level that it returns.

use striata::mesh::IndexedMesh;

/// The target of a simplification.
pub(super) struct Request {
    /// Percent of the triangles.
    pub percent: f64,
    /// The target as a triangle count, rounded down.
    pub target_count: usize,
}

impl Request {
    /// Creates a target as a percentage of the mesh's triangles.
    pub(super) fn new(percent: f64, triangle_count: usize) -> Self {
        let target_count = (percent / 100.0 * triangle_count as f64 + 1e-6) as usize;
        Self { percent, target_count }
    }
}

/// A simplified mesh returned by a contender.
pub(super) struct Level {
    pub mesh: IndexedMesh,
    pub secs: f64,
    /// The error that the contender reports, in mesh units.
    pub error: Option<f64>,
    /// The error limit passed to the contender, as a share of the extent.
    pub error_limit: Option<f64>,
}

/// Simplifies to a share of the triangles, or returns why it cannot.
pub(super) type Simplify<'a> = Box<dyn Fn(&Request) -> Result<Level, String> + 'a>;
