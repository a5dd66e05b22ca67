//! Convex polygons inside one triangle, in the triangle's own coordinates.
//!
//! `u` runs toward the triangle's second corner, `v` toward its third. Cuts and hulls lose no more
//! than f64 rounding.

/// Maximum number of corners of a polygon.
pub(super) const MAX_CORNERS: usize = 8;

/// The three corners of the whole triangle.
pub(super) const WHOLE: [[f64; 2]; 3] = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]];

/// A corner closer than this to the line between its neighbors is dropped, in units of the triangle's sides.
const FLATNESS_TOLERANCE: f64 = 1e-14;

/// A convex polygon, counterclockwise.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Polygon {
    count: u8,
    corners: [[f64; 2]; MAX_CORNERS],
}

impl Polygon {
    /// Creates a polygon from its corners, at most [`MAX_CORNERS`].
    pub(super) fn new(corners: &[[f64; 2]]) -> Self {
        let mut all = [[0.0; 2]; MAX_CORNERS];
        all[..corners.len()].copy_from_slice(corners);
        Self { count: corners.len() as u8, corners: all }
    }

    #[inline]
    pub(super) fn corners(&self) -> &[[f64; 2]] {
        &self.corners[..usize::from(self.count)]
    }

    /// Whether the polygon is the whole triangle.
    pub(super) fn is_whole(&self) -> bool {
        self.count == 3 && WHOLE.iter().all(|corner| self.corners().contains(corner))
    }

    /// Area in units in which the whole triangle has the area 1/2.
    pub(super) fn area(&self) -> f64 {
        let corners = self.corners();
        let first = corners[0];
        let twice = |pair: &[[f64; 2]]| {
            let [p, q] = [0, 1].map(|i| [pair[i][0] - first[0], pair[i][1] - first[1]]);
            p[0] * q[1] - p[1] * q[0]
        };
        0.5 * corners.windows(2).map(twice).sum::<f64>()
    }

    /// Returns the convex hull of both; `None` if it has too many corners.
    pub(super) fn hull(&self, other: &Self) -> Option<Self> {
        let mut points = [[0.0; 2]; 2 * MAX_CORNERS];
        let (first, second) = (self.corners(), other.corners());
        let count = first.len() + second.len();
        points[..first.len()].copy_from_slice(first);
        points[first.len()..count].copy_from_slice(second);
        let points = &mut points[..count];
        points.sort_unstable_by(|p, q| p[0].total_cmp(&q[0]).then(p[1].total_cmp(&q[1])));
        // The lower hull from left to right, then the upper one back, as in Andrew's monotone chain.
        let mut chain = [[0.0; 2]; 2 * MAX_CORNERS + 1];
        let mut length = 0;
        for &p in &*points {
            length = push_convex(&mut chain, length, 1, p);
        }
        let below = length;
        for &p in points[..count - 1].iter().rev() {
            length = push_convex(&mut chain, length, below, p);
        }
        let corners = &chain[..length.saturating_sub(1).max(1)];
        (corners.len() <= MAX_CORNERS).then(|| Self::new(corners))
    }
}

/// Appends a point to a chain that turns left, removing earlier points except the first `fixed`;
/// returns the new length.
#[inline]
fn push_convex(chain: &mut [[f64; 2]], mut length: usize, fixed: usize, p: [f64; 2]) -> usize {
    while length > fixed && !turns_left(chain[length - 2], chain[length - 1], p) {
        length -= 1;
    }
    if length > 0 && chain[length - 1] == p {
        return length;
    }
    chain[length] = p;
    length + 1
}

/// Whether the path from `a` over `b` to `c` clearly turns left.
#[inline]
fn turns_left(a: [f64; 2], b: [f64; 2], c: [f64; 2]) -> bool {
    let (ab, ac) = ([b[0] - a[0], b[1] - a[1]], [c[0] - a[0], c[1] - a[1]]);
    let twice_area = ab[0] * ac[1] - ab[1] * ac[0];
    twice_area > 0.0
        && twice_area * twice_area > FLATNESS_TOLERANCE * FLATNESS_TOLERANCE * (ac[0] * ac[0] + ac[1] * ac[1])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::Random;

    #[test]
    fn hull_of_two_halves_is_the_whole_triangle() {
        let (m, n) = ([0.3, 0.0], [0.25, 0.75]);
        let left = Polygon::new(&[[0.0, 0.0], m, n, [0.0, 1.0]]);
        let right = Polygon::new(&[m, [1.0, 0.0], n]);
        let whole = left.hull(&right).unwrap();
        assert!(whole.is_whole(), "{whole:?}");
        assert!(!left.is_whole());
        assert!((left.area() + right.area() - 0.5).abs() < 1e-15);
        assert_eq!(left.hull(&left), Some(left));
    }

    #[test]
    fn points_on_a_line_have_a_hull() {
        let point = Polygon::new(&[[0.5, 0.25]; 3]);
        assert_eq!(point.hull(&point).unwrap().corners(), [[0.5, 0.25]]);
        let line = Polygon::new(&[[0.0, 0.0], [0.25, 0.25], [0.5, 0.5]]);
        assert_eq!(line.hull(&point).unwrap().corners(), [[0.0, 0.0], [0.5, 0.25], [0.5, 0.5]]);
        assert_eq!(line.hull(&line).unwrap().corners(), [[0.0, 0.0], [0.5, 0.5]]);
    }

    #[test]
    fn hulls_contain_all_corners_and_turn_left() {
        let mut random = Random::new(5);
        let mut kept = 0;
        for _ in 0..2_000 {
            let mut any = || {
                let corners = [(); 4].map(|()| [random.unit(), random.unit()]);
                let point = Polygon::new(&corners[..1]);
                corners.iter().fold(point, |all, &p| all.hull(&Polygon::new(&[p])).unwrap())
            };
            let (a, b) = (any(), any());
            let Some(hull) = a.hull(&b) else { continue };
            kept += 1;
            let corners = hull.corners();
            for (i, &p) in corners.iter().enumerate() {
                let q = corners[(i + 1) % corners.len()];
                for &[x, y] in a.corners().iter().chain(b.corners()) {
                    let side = (q[0] - p[0]) * (y - p[1]) - (q[1] - p[1]) * (x - p[0]);
                    assert!(side >= -1e-13, "{hull:?} misses a corner of {a:?} or {b:?}");
                }
            }
        }
        assert!(kept > 1_900);
    }
}
