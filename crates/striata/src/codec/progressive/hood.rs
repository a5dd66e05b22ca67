//! What both sides know around a vertex when its position is coded.

use super::surface::{Surface, next};

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
    /// Vertices around the new one: the one that split, then `r0` to `rk`. At most one of them is virtual.
    #[cfg_attr(not(test), expect(dead_code, reason = "for the models of positions"))]
    pub(super) fn ring(&self) -> impl ExactSizeIterator<Item = u32> + '_ {
        self.corners.iter().map(|&c| self.surface.vertex(next(c)))
    }

    /// The vertex beyond the edge from ring vertex `i` to the next one.
    #[cfg_attr(not(test), expect(dead_code, reason = "for the models of positions"))]
    pub(super) fn apex(&self, i: usize) -> u32 {
        self.surface.vertex(self.surface.opposite(self.corners[i]))
    }

    /// The grid coordinates of a vertex, where both sides know them.
    #[inline]
    pub(super) fn place(&self, vertex: u32) -> Option<[i32; 3]> {
        (vertex < self.vertex && !self.surface.is_virtual(vertex)).then(|| self.places[vertex as usize])
    }
}
