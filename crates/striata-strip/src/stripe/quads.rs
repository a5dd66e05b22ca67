//! Quadrilaterals: pairs of consecutive triangles that share an edge.
//!
//! ```text
//!        north          sides are numbered counterclockwise; the side opposite k is k + 2.
//!      o-------o
//!      |     / |        Readers split a polygon into consecutive triangles, so that a pair of them is
//! west |   /   | east   most likely a quadrilateral of the model.
//!      | /     |
//!      o-------o
//!        south
//! ```

use striata::mesh::{NO_TWIN, is_proper};
use striata::strip::{StripLinks, next_side, prev_side};

/// A side of a quadrilateral.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct QuadSide {
    pub quad: u32,
    /// Number of the side, counterclockwise, 0 to 3.
    pub number: u8,
}

impl QuadSide {
    /// The opposite side of the same quadrilateral.
    pub(super) fn opposite(self) -> Self {
        self.turned(2)
    }

    /// The side that follows counterclockwise after a number of others.
    pub(super) fn turned(self, by: u8) -> Self {
        Self { number: (self.number + by) % 4, ..self }
    }
}

/// Quadrilaterals of a mesh.
pub(super) struct Quads<'a> {
    twins: &'a [u32],
    /// Side of the first triangle that is the diagonal of each quadrilateral.
    diagonals: Vec<u32>,
    /// Quadrilateral of each triangle, or [`NO_TWIN`].
    quad_of: Vec<u32>,
}

impl<'a> Quads<'a> {
    /// Pairs consecutive triangles that share one edge and belong to no strip yet.
    pub(super) fn new(triangles: &[[u32; 3]], links: &StripLinks<'a>) -> Self {
        let twins = links.twins();
        let is_free = |t: u32| links.solid_bits(t) == 0 && is_proper(&triangles[t as usize]);
        let mut quads = Self { twins, diagonals: Vec::new(), quad_of: vec![NO_TWIN; triangles.len()] };
        let mut t = 0;
        while t + 1 < triangles.len() as u32 {
            let shared = |&side: &u32| twins[side as usize] != NO_TWIN && twins[side as usize] / 3 == t + 1;
            let mut diagonals = (3 * t..3 * t + 3).filter(shared);
            if let (Some(diagonal), None) = (diagonals.next(), diagonals.next())
                && is_free(t)
                && is_free(t + 1)
            {
                quads.quad_of[t as usize] = quads.diagonals.len() as u32;
                quads.quad_of[t as usize + 1] = quads.diagonals.len() as u32;
                quads.diagonals.push(diagonal);
                t += 1;
            }
            t += 1;
        }
        quads
    }

    /// Number of quadrilaterals.
    pub(super) fn count(&self) -> usize {
        self.diagonals.len()
    }

    /// The diagonal of a quadrilateral, as a side of its first triangle.
    pub(super) fn diagonal(&self, quad: u32) -> u32 {
        self.diagonals[quad as usize]
    }

    /// The side of a triangle that is a side of a quadrilateral.
    pub(super) fn triangle_side(&self, side: QuadSide) -> u32 {
        let diagonal = self.diagonal(side.quad);
        let of = if side.number < 2 { diagonal } else { self.twins[diagonal as usize] };
        if side.number.is_multiple_of(2) { next_side(of) } else { prev_side(of) }
    }

    /// The side on the other side of an edge, if another quadrilateral is there.
    pub(super) fn across(&self, side: QuadSide) -> Option<QuadSide> {
        let twin = self.twins[self.triangle_side(side) as usize];
        if twin == NO_TWIN {
            return None;
        }
        let quad = self.quad_of[twin as usize / 3];
        if quad == NO_TWIN || quad == side.quad {
            return None;
        }
        let diagonal = self.diagonal(quad);
        let (first, of) = match twin / 3 == diagonal / 3 {
            true => (0, diagonal),
            false => (2, self.twins[diagonal as usize]),
        };
        Some(QuadSide { quad, number: first + u8::from(twin == prev_side(of)) })
    }
}
