//! What a contender is asked for, and the level that it makes.

use striata::mesh::IndexedMesh;

/// How many triangles a level is to have.
pub(super) struct Request {
    /// Percent of the triangles.
    pub(super) percent: f64,
    /// The same as a count, rounded down.
    pub(super) target_count: usize,
}

impl Request {
    /// Target, as a percentage of the mesh's triangles.
    pub(super) fn new(percent: f64, triangle_count: usize) -> Self {
        let target_count = (percent / 100.0 * triangle_count as f64 + 1e-6) as usize;
        Self { percent, target_count }
    }
}

/// A level that a contender made.
pub(super) struct Level {
    pub(super) mesh: IndexedMesh,
    pub(super) secs: f64,
    /// The error that the contender reports, mesh units.
    pub(super) error: Option<f64>,
    /// The error limit that the contender was given, a share of the extent.
    pub(super) error_limit: Option<f64>,
}

/// Makes a level with a share of the triangles, or says why it cannot.
pub(super) type Simplify<'a> = Box<dyn Fn(&Request) -> Result<Level, String> + 'a>;
