//! Whether a triangle turns over within a flat surface.
//!
//! Planes of equal height make such a fold free for every quadratic cost, and the normal of a needle is too
//! unreliable to forbid it: a needle of a flat face could turn over by staying small, and then grow. The
//! triangles around the same vertex tell which way a flat surface faces.
//!
//! ```text
//!   a -------- b        a -------- b
//!    \  .v.   /    ->    '..     .'      the needle (v, a, b) turns over if v moves across a-b,
//!     u -----              '. u.'        although u, v, a and b lie in one plane
//! ```
//!
//! A triangle below the noise of single precision has no orientation. Its replacement must face the same way as
//! most of the area around the vertex that lies in its plane. Any other triangle must keep its own orientation
//! within its plane, unless all its neighbors in that plane face the other way: it was folded over, and may
//! unfold. Triangles in other planes do not count, so that creases, however sharp, do not matter.
//!
//! Signs are exact where coordinates are: the differences and products of a flat axis-parallel face have no
//! rounding in double precision that could change them.

use glam::DVec3;

/// Height of a triangle, in scaled units, below which single precision determines no orientation.
pub(in crate::simplify) const NOISE: f64 = 1e-6;
/// Triangles lie in one plane if the cosine between their normals is at least this, or at most its negative.
const FLAT_COSINE: f64 = 0.998;

/// Normal of a triangle, with the size of its edges.
#[derive(Clone, Copy)]
pub(in crate::simplify) struct TriangleNormal {
    /// Unscaled: its length is twice the area.
    normal: DVec3,
    edges_squared: f64,
}

impl TriangleNormal {
    pub(in crate::simplify) fn new([a, b, c]: [DVec3; 3]) -> Self {
        let edges_squared = (b - a).length_squared() + (c - b).length_squared() + (a - c).length_squared();
        Self { normal: (b - a).cross(c - a), edges_squared }
    }

    /// Whether rounding may have determined the orientation.
    fn is_noise(self) -> bool {
        self.normal.length_squared() <= NOISE * NOISE * self.edges_squared
    }

    /// Area on the side of `plane`, doubled, or 0 if the triangle is not in that plane.
    fn area_in(self, plane: DVec3) -> f64 {
        let along = self.normal.dot(plane);
        let is_flat = along * along
            >= FLAT_COSINE * FLAT_COSINE * self.normal.length_squared() * plane.length_squared();
        if is_flat && !self.is_noise() { along / plane.length() } else { 0.0 }
    }
}

/// Whether replacing the triangle `old` by `new` turns it over within the plane of `new`; `others` are the
/// other triangles around the moving vertex, before it moves.
pub(in crate::simplify) fn turns_over(
    old: TriangleNormal,
    new: TriangleNormal,
    others: impl Iterator<Item = TriangleNormal>,
) -> bool {
    if new.is_noise() {
        return false;
    }
    let (mut agreeing, mut opposing) = (0.0, 0.0);
    for other in others {
        let area = other.area_in(new.normal);
        agreeing += area.max(0.0);
        opposing += (-area).max(0.0);
    }
    let own = old.area_in(new.normal);
    if own < 0.0 { opposing > 0.0 || agreeing == 0.0 } else { own == 0.0 && opposing > agreeing }
}

/// Whether triangles that lie in one plane and face the same way become others of which one faces the other way.
pub(in crate::simplify) fn folds_over(before: &[TriangleNormal], after: &[TriangleNormal]) -> bool {
    let largest = |a: &&TriangleNormal, b: &&TriangleNormal| {
        a.normal.length_squared().total_cmp(&b.normal.length_squared())
    };
    let Some(&TriangleNormal { normal: plane, .. }) = before.iter().max_by(largest) else { return false };
    before.iter().all(|triangle| triangle.is_noise() || triangle.area_in(plane) > 0.0)
        && after.iter().any(|triangle| triangle.area_in(plane) < 0.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn flat([a, b, c]: [[f64; 2]; 3]) -> TriangleNormal {
        TriangleNormal::new([a, b, c].map(|[x, y]| DVec3::new(x, y, 0.0)))
    }

    const A: [f64; 2] = [0.0, 0.0];
    const B: [f64; 2] = [1.0, 0.0];
    const ABOVE: [f64; 2] = [0.5, 0.001];
    const ON_LINE: [f64; 2] = [0.5, 0.0];
    const BELOW: [f64; 2] = [0.5, -0.002];

    #[test]
    fn needles_keep_their_side_of_the_plane() {
        let others = [flat([ABOVE, [1.0, 1.0], A]), flat([ABOVE, B, [1.0, 1.0]])];
        let turns = |old, new| turns_over(flat([A, B, old]), flat([A, B, new]), others.into_iter());
        assert!(turns(ABOVE, BELOW));
        assert!(turns(ON_LINE, BELOW), "the others face up");
        assert!(!turns(ON_LINE, ABOVE));
        assert!(!turns(ABOVE, ON_LINE), "without area, there is no side");
        assert!(!turns(BELOW, ABOVE), "it was folded over");
    }

    #[test]
    fn other_planes_do_not_matter() {
        // A wall below the edge, and the sloping other side of a knife's edge, which faces down.
        let wall = TriangleNormal::new([DVec3::ZERO, DVec3::new(0.0, 0.0, -9.0), DVec3::X]);
        let slope = TriangleNormal::new([DVec3::ZERO, DVec3::new(0.0, 9.0, -3.0), DVec3::X]);
        let others = || [wall, slope].into_iter();
        assert!(turns_over(flat([A, B, ABOVE]), flat([A, B, BELOW]), others()));
        assert!(!turns_over(flat([A, B, ON_LINE]), flat([A, B, ABOVE]), others()));
    }
}
