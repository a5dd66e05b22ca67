//! Faces with three corners and three opposite half-edges each.
//!
//! Half-edge `3 f + i` of face `f` leads from its corner `i` to the next one.

/// Marks a half-edge without an opposite one, at a border.
pub(super) const NONE: u32 = u32::MAX;

/// The faces of a surface.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct HalfEdgeFaces {
    /// Vertex from which each half-edge leads.
    pub corners: Vec<u32>,
    /// Opposite half-edge of each, or [`NONE`].
    pub twins: Vec<u32>,
}

/// The half-edge after `half_edge` in the same face.
#[inline]
pub(super) fn next(half_edge: u32) -> u32 {
    if half_edge % 3 == 2 { half_edge - 2 } else { half_edge + 1 }
}

/// The half-edge before `half_edge` in the same face.
#[inline]
pub(super) fn prev(half_edge: u32) -> u32 {
    if half_edge.is_multiple_of(3) { half_edge + 2 } else { half_edge - 1 }
}

impl HalfEdgeFaces {
    #[inline]
    pub(super) fn corner(&self, half_edge: u32) -> u32 {
        self.corners[half_edge as usize]
    }

    #[inline]
    pub(super) fn set_corner(&mut self, half_edge: u32, vertex: u32) {
        self.corners[half_edge as usize] = vertex;
    }

    #[inline]
    pub(super) fn twin(&self, half_edge: u32) -> u32 {
        self.twins[half_edge as usize]
    }

    /// Makes two half-edges opposite to each other; either may be [`NONE`].
    #[inline]
    pub(super) fn link(&mut self, a: u32, b: u32) {
        for (side, other) in [(a, b), (b, a)] {
            if side != NONE {
                self.twins[side as usize] = other;
            }
        }
    }

    /// The next half-edge that leaves the same vertex, counterclockwise: away from the left face of a split.
    #[inline]
    pub(super) fn turned(&self, half_edge: u32) -> u32 {
        self.twin(prev(half_edge))
    }

    /// The next half-edge that leaves the same vertex in the other direction.
    #[inline]
    pub(super) fn turned_back(&self, half_edge: u32) -> u32 {
        match self.twin(half_edge) {
            NONE => NONE,
            twin => next(twin),
        }
    }
}
