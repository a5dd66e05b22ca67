//! Options of [`LodStrips::build_staged`](super::LodStrips::build_staged).

/// Options of [`LodStrips::build_staged`](super::LodStrips::build_staged).
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct StageOptions {
    /// New strips are made for a level that would need more indices per triangle than this, restarts
    /// included. Default 1.45; infinite for a single stage. Strips made for one level need about 1.13 to
    /// 1.3, and the closer the limit is to that, the more stages there are. Very coarse levels need more
    /// than 1.45 in any case, for example 6 indices for the 4 triangles of a tetrahedron.
    pub max_indices_per_triangle: f64,
}

impl Default for StageOptions {
    fn default() -> Self {
        Self { max_indices_per_triangle: 1.45 }
    }
}

impl StageOptions {
    /// Options for a single stage, which keeps the strips of the full mesh at all levels.
    pub fn single() -> Self {
        Self { max_indices_per_triangle: f64::INFINITY }
    }

    /// Sets [`StageOptions::max_indices_per_triangle`].
    pub fn with_max_indices_per_triangle(mut self, limit: f64) -> Self {
        self.max_indices_per_triangle = limit;
        self
    }
}
