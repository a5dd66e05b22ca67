//! What is decided for a position: where it collapses to, and what that does.

/// What a collapse does to the surface.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(in crate::simplify) enum Tier {
    /// It keeps what the surface is.
    #[default]
    Strict,
    /// It breaks the link condition or leaves a border.
    Link,
    /// It flips triangles.
    Fold,
    /// It takes all triangles of the position, but not of the target.
    Fin,
    /// It takes all triangles of both; others of the part stay.
    Remnant,
    /// It takes the last triangles of a part.
    Vanish,
}

/// A collapse that was judged in full.
#[derive(Clone, Copy, Debug)]
pub(in crate::simplify) struct Choice {
    pub(in crate::simplify) tier: Tier,
    pub(in crate::simplify) cost: f32,
    pub(in crate::simplify) target: u32,
    /// Squared distance of the vertex from its new fan.
    pub(in crate::simplify) distance_squared: f32,
    /// Squared distance of the fan's new edges from the old star.
    pub(in crate::simplify) protrusion_squared: f32,
    /// Distance of the fan from the original mesh, if it has been measured.
    pub(in crate::simplify) outward: Option<f32>,
}

impl Choice {
    /// How far, squared, what it leaves sticks out of what it replaces, at most.
    pub(in crate::simplify) fn sticks_out_squared(&self) -> f32 {
        // A fold moves its triangles by the whole edge.
        let moved = if self.tier == Tier::Fold { self.distance_squared } else { 0.0 };
        self.protrusion_squared.max(moved)
    }
}
