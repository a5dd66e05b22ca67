//! Edges of a star that lie on a border.

/// Weight of the area between the old and the new path of a border; values from 1 to 50 differ little
/// in RMS, and small ones remove thin ears of the boundary early.
pub(super) const BORDER_WEIGHT: f32 = 4.0;

/// Kinds of border, the weakest first: a vertex moves along the strongest one on which it lies.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum BorderKind {
    /// The triangles at the edge use different wedges.
    Seam,
    /// The edge has three or more triangles, or two that disagree about its direction.
    Branch,
    /// The edge has one triangle, or one and its opposite copy.
    Boundary,
}

/// An edge of the star that lies on a border.
#[derive(Clone, Copy, Debug)]
pub(super) struct BorderEdge {
    pub neighbor: u32,
    pub kind: BorderKind,
    /// Squared difference of the attributes on both sides of a seam; infinite for other borders and for
    /// seams that must stay.
    pub difference_squared: f32,
}

impl BorderEdge {
    /// Cost of moving the edge's end; `swept_squared` is the square of twice the swept area.
    pub(super) fn leave_cost(&self, swept_squared: f32) -> f32 {
        let executor = BORDER_WEIGHT * swept_squared;
        if self.difference_squared == f32::INFINITY {
            return executor;
        }
        executor.min(0.5 * swept_squared.sqrt() * self.difference_squared)
    }

    /// Cost of shortening a border that ends here, with this as its only edge, by a squared length.
    pub(super) fn recede_cost(&self, length_squared: f32) -> f32 {
        (length_squared * length_squared).min(length_squared * self.difference_squared)
    }
}
