//! What both sides know when a vertex is asked.

use crate::refine::walk::Walk;
use crate::topology::surface::Surface;

/// What both sides know when a vertex is asked whether it splits.
pub(crate) struct Scene<'a> {
    /// The surface, with the splits of earlier stretches done. Triangles that no other split of the batch may have are
    /// marked with the batch.
    pub(crate) surface: &'a Surface,
    /// Grid coordinates of all vertices but virtual ones.
    pub(crate) places: &'a [[i32; 3]],
    /// What has become of other vertices in this batch.
    pub(crate) walk: &'a Walk,
    /// Most triangles that a new vertex takes over.
    pub(crate) max_patch: u32,
}

impl Scene<'_> {
    /// True where a triangle cannot go to a new vertex any more in this batch.
    #[inline]
    pub(crate) fn is_taken(&self, triangle: u32) -> bool {
        self.surface.mark(triangle) == self.walk.batch()
    }
}
