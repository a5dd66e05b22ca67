//! The collapse chosen for a position: its target, kind, cost and distances.

/// Effect of a collapse on the surface.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(in crate::simplify) enum CollapseKind {
    /// Preserves the topology and flips no triangle.
    #[default]
    Strict,
    /// Breaks the link condition or moves a vertex off its border.
    Link,
    /// Flips triangles.
    Fold,
    /// Removes all triangles of the position, but not all of the target.
    Fin,
    /// Removes all triangles of both ends; the connected part keeps others.
    Remnant,
    /// Removes the last triangles of a connected part.
    Vanish,
}

/// A collapse whose cost has been evaluated in full.
#[derive(Clone, Copy, Debug)]
pub(in crate::simplify) struct CollapseChoice {
    pub kind: CollapseKind,
    pub cost: f32,
    /// Share of the cost that attributes have, if it has been evaluated alone.
    pub attributes: f32,
    pub target: u32,
    /// Squared distance of the vertex from its new fan, scaled units.
    pub distance_squared: f32,
    /// Squared distance of the fan's new edges from the old star, scaled units.
    pub protrusion_squared: f32,
    /// Distance of the fan from the original mesh, scaled units, if it has been measured.
    pub outward: Option<f32>,
}

impl CollapseChoice {
    /// Returns an upper bound of the squared distance by which the new fan sticks out of the old star.
    pub(in crate::simplify) fn protrusion_bound_squared(&self) -> f32 {
        // A fold moves its triangles by the length of the edge.
        let moved = if self.kind == CollapseKind::Fold { self.distance_squared } else { 0.0 };
        self.protrusion_squared.max(moved)
    }
}
