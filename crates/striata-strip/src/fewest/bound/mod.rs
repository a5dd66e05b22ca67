//! A number of strips that no stripification can go below, component by component.
//!
//! Two proofs, of which the stronger counts: bridges (`bridges`) and links (`cover`). Both look at the dual graph
//! alone, so they hold for all strips that run along its links. Linear in time.

mod bridges;
mod cover;

use striata::mesh::{DualGraph, NO_TWIN};

/// The components of a dual graph and the fewest strips that each could have.
#[derive(Debug)]
pub(super) struct Bounds {
    /// For each triangle its component; none for those left out.
    pub(super) component: Vec<u32>,
    /// For each component a number of strips that it needs at least.
    pub(super) least: Vec<u32>,
}

impl Bounds {
    /// Bounds for every component; triangles that are `left_out` belong to none and have no link.
    pub(super) fn new(graph: &DualGraph, left_out: impl Fn(u32) -> bool) -> Self {
        let mut component = vec![NO_TWIN; graph.triangle_count()];
        let mut least =
            bridges::least_strips(graph, left_out, |triangle, part| component[triangle as usize] = part);
        cover::raise(&mut least, &component, graph);
        Self { component, least }
    }
}
