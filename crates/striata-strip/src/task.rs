//! What every stripifier works on, and how long it may.

use std::ops::Range;

use striata::mesh::is_proper;

use crate::options::StripOptions;

/// Takes how many moves a search has made and answers which share of its budget that is; the search ends at 1.
///
/// A search plans with it (it cools as the share grows), so it should grow steadily, and it must come to 1:
/// `cheapest` has no other end.
pub type SpentFn<'a> = dyn FnMut(u64) -> f64 + 'a;

/// What a stripifier works on.
pub(crate) struct Task<'a> {
    pub(crate) triangles: &'a [[u32; 3]],
    pub(crate) groups: &'a [Range<usize>],
    pub(crate) options: &'a StripOptions,
}

impl Task<'_> {
    /// Whether a triangle has three corners: others are in no strip.
    pub(crate) fn is_proper(&self, triangle: u32) -> bool {
        is_proper(&self.triangles[triangle as usize])
    }
}
