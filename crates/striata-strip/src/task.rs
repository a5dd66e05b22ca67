//! Input of every stripifier, and its budget.

use std::ops::Range;

use striata::mesh::is_proper;

use crate::options::StripOptions;

/// Callback that receives the number of moves made so far and returns the spent share of the budget. The
/// search ends at 1.
///
/// Searches plan by this share (annealing cools as it grows). It should grow steadily, and it must reach 1:
/// `cheapest` has no other end.
pub type SpentFn<'a> = dyn FnMut(u64) -> f64 + 'a;

/// Mesh and options of one call.
pub(crate) struct Task<'a> {
    pub(crate) triangles: &'a [[u32; 3]],
    pub(crate) groups: &'a [Range<usize>],
    pub(crate) options: &'a StripOptions,
}

impl Task<'_> {
    /// Whether a triangle has three distinct corners; other triangles are in no strip.
    pub(crate) fn is_proper(&self, triangle: u32) -> bool {
        is_proper(&self.triangles[triangle as usize])
    }
}
