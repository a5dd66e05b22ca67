//! Lower bounds of the strip count, component by component.
//!
//! Combines two proofs and uses the stronger one: bridges (`bridges`) and counts of links (`cover`). Both
//! look at the dual graph alone, so they are valid for all strips that run along its links. Linear in time.

mod bridges;
mod cover;

use striata::mesh::{DualGraph, NO_TWIN};

/// Components of a dual graph and a lower bound of each one's strip count.
#[derive(Debug)]
pub(super) struct StripCountBounds {
    /// Component of each triangle, or [`NO_TWIN`] for triangles that are left out.
    pub component: Vec<u32>,
    /// Least number of strips of each component.
    pub least: Vec<u32>,
}

impl StripCountBounds {
    /// Computes bounds for every component; triangles that are `left_out` belong to none and have no link.
    pub(super) fn new(graph: &DualGraph, left_out: impl Fn(u32) -> bool) -> Self {
        let mut component = vec![NO_TWIN; graph.triangle_count()];
        let mut least =
            bridges::least_strips(graph, left_out, |triangle, part| component[triangle as usize] = part);
        cover::raise(&mut least, &component, graph);
        Self { component, least }
    }
}
