//! The neighborhood of a new vertex, as both writer and reader know it when the vertex's position is coded.

use crate::topology::surface::Surface;

/// The neighborhood of a new vertex.
pub(crate) struct Neighborhood<'a> {
    /// The surface after all splits of this stretch.
    pub surface: &'a Surface,
    /// Grid coordinates of the vertices below `vertex`; later entries are meaningless. Virtual vertices
    /// have none.
    pub coords: &'a [[i32; 3]],
    /// Index of the new vertex.
    pub vertex: u32,
    /// Corners at the vertex, counterclockwise: first the one in triangle A, whose next vertex is the
    /// one that split, then those of the patch, and last the one in triangle B.
    pub corners: &'a [u32],
}

impl Neighborhood<'_> {
    /// Returns the grid coordinates of a vertex if both sides know them.
    #[inline]
    pub(crate) fn coords_of(&self, vertex: u32) -> Option<[i32; 3]> {
        (vertex < self.vertex && !self.surface.is_virtual(vertex)).then(|| self.coords[vertex as usize])
    }
}
