//! Edges of a star that lie on a border.

/// Weight of the area between the old and the new course of a border; 1 to 50 differ little in RMS, and small ones lose
/// thin ears of the boundary early.
pub(super) const BORDER_WEIGHT: f32 = 4.0;

/// What makes an edge special, the weakest first: a vertex moves along the strongest that it is on.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Border {
    /// Its triangles show different wedges.
    Seam,
    /// It has three or more triangles, or two that disagree about its direction.
    Branch,
    /// It has one triangle.
    Boundary,
}

/// An edge of the star that lies on a border.
#[derive(Clone, Copy, Debug)]
pub(super) struct Special {
    pub(super) neighbor: u32,
    pub(super) border: Border,
    /// Squared difference of the attributes on both sides of a seam; infinite for other borders, and for seams that must stay.
    pub(super) difference_squared: f32,
}

impl Special {
    /// What it costs that this edge's end moves so that twice the area of `swept_squared`, squared, is swept.
    pub(super) fn leave_cost(&self, swept_squared: f32) -> f32 {
        let course = BORDER_WEIGHT * swept_squared;
        if self.difference_squared == f32::INFINITY {
            return course;
        }
        course.min(0.5 * swept_squared.sqrt() * self.difference_squared)
    }

    /// What it costs that the border, whose only edge this is, recedes by a squared length.
    pub(super) fn recede_cost(&self, length_squared: f32) -> f32 {
        (length_squared * length_squared).min(length_squared * self.difference_squared)
    }
}
