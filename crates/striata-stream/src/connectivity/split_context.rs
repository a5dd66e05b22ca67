//! [`SplitContext`]: what both sides know when the flag or cut of a vertex is coded.

use crate::refine::walk::BatchWalk;
use crate::topology::surface::Surface;

/// Data that both writer and reader have when the flag or cut of a vertex is coded.
pub(crate) struct SplitContext<'a> {
    /// The surface after the splits of earlier stretches. Triangles that no other split of the batch may
    /// move are marked with the batch.
    pub surface: &'a Surface,
    /// Grid coordinates of all vertices; meaningless for virtual ones.
    pub grid_points: &'a [[i32; 3]],
    /// Records which vertices of the batch have been visited, and which of these split.
    pub walk: &'a BatchWalk,
    /// Maximum number of triangles that move to a new vertex.
    pub max_patch: u32,
}

impl SplitContext<'_> {
    /// Whether another split of this batch has claimed a triangle, so that it cannot move any more.
    #[inline]
    pub(crate) fn is_claimed(&self, triangle: u32) -> bool {
        self.surface.mark(triangle) == self.walk.batch()
    }
}
