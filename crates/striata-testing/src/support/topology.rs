//! Topological invariants that simplification must preserve.

use striata::mesh::{IndexedMesh, Statistics};

/// Invariants that a step on a manifold must not change.
#[derive(Debug, PartialEq)]
pub struct Topology {
    pub component_count: usize,
    pub boundary_loop_count: usize,
    pub euler_characteristic: i64,
    pub genus: Option<usize>,
    pub duplicate_triangle_count: usize,
    pub is_closed: bool,
}

impl Topology {
    pub fn of(mesh: &IndexedMesh) -> Self {
        let statistics = Statistics::of(mesh).expect("levels are valid");
        Self {
            component_count: statistics.component_count,
            boundary_loop_count: statistics.boundary_loop_count,
            euler_characteristic: statistics.euler_characteristic,
            genus: statistics.genus,
            duplicate_triangle_count: statistics.duplicate_triangle_count,
            is_closed: statistics.is_closed,
        }
    }
}
