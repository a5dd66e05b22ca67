//! What both sides know around a vertex when its position is coded.

use super::surface::Surface;

/// The surroundings of a new vertex.
pub(super) struct Hood<'a> {
    /// The surface, all splits of this stretch done.
    pub(super) surface: &'a Surface,
    /// Grid coordinates of the vertices below `vertex`; what stands beyond means nothing. Virtual vertices have none.
    pub(super) places: &'a [[i32; 3]],
    /// The new vertex.
    pub(super) vertex: u32,
    /// The corners at the vertex, counter-clockwise: first that of A, whose next vertex is the one that split; then
    /// those of the patch; last that of B.
    pub(super) corners: &'a [u32],
}

impl Hood<'_> {
    /// The grid coordinates of a vertex, where both sides know them.
    #[inline]
    pub(super) fn place(&self, vertex: u32) -> Option<[i32; 3]> {
        (vertex < self.vertex && !self.surface.is_virtual(vertex)).then(|| self.places[vertex as usize])
    }
}
