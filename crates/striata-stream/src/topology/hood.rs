//! What both sides know around a vertex when its position is coded.

use crate::topology::surface::Surface;

/// The surroundings of a new vertex.
pub(crate) struct Hood<'a> {
    /// The surface, all splits of this stretch done.
    pub(crate) surface: &'a Surface,
    /// Grid coordinates of the vertices below `vertex`; what stands beyond means nothing. Virtual vertices have none.
    pub(crate) places: &'a [[i32; 3]],
    /// The new vertex.
    pub(crate) vertex: u32,
    /// The corners at the vertex, counter-clockwise: first that of A, whose next vertex is the one that split; then
    /// those of the patch; last that of B.
    pub(crate) corners: &'a [u32],
}

impl Hood<'_> {
    /// The grid coordinates of a vertex, where both sides know them.
    #[inline]
    pub(crate) fn place(&self, vertex: u32) -> Option<[i32; 3]> {
        (vertex < self.vertex && !self.surface.is_virtual(vertex)).then(|| self.places[vertex as usize])
    }
}
