//! Tests and distances of the new triangle fan that replaces a removed vertex.
//!
//! All coordinates are relative to the removed vertex, which is therefore the origin.

use glam::Vec3;
use wide::f32x8;

use super::flat_fold::NOISE;

/// Squared distance of the origin from the triangle `(a, b, c)`, which may be degenerate.
///
/// The regions of the triangle are distinguished as in Ericson, Real-Time Collision Detection, 5.1.5.
#[inline]
pub(in crate::simplify) fn distance_squared(a: Vec3, b: Vec3, c: Vec3) -> f32 {
    let [_, v, w] = nearest(a, b, c);
    (a + (b - a) * v + (c - a) * w).length_squared()
}

/// Returns a position as a vector, without its padding.
#[inline]
pub(in crate::simplify) fn point(positions: &[[f32; 4]], p: u32) -> Vec3 {
    let [x, y, z, _] = positions[p as usize];
    Vec3::new(x, y, z)
}

/// Barycentric coordinates of the point of the triangle `(a, b, c)` nearest to the origin.
#[inline]
pub(in crate::simplify) fn nearest(a: Vec3, b: Vec3, c: Vec3) -> [f32; 3] {
    let (ab, ac) = (b - a, c - a);
    let (d1, d2) = (-ab.dot(a), -ac.dot(a));
    if d1 <= 0.0 && d2 <= 0.0 {
        return [1.0, 0.0, 0.0];
    }
    let (d3, d4) = (-ab.dot(b), -ac.dot(b));
    if d3 >= 0.0 && d4 <= d3 {
        return [0.0, 1.0, 0.0];
    }
    let vc = d1 * d4 - d3 * d2;
    if vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0 {
        let v = ratio(d1, d1 - d3);
        return [1.0 - v, v, 0.0];
    }
    let (d5, d6) = (-ab.dot(c), -ac.dot(c));
    if d6 >= 0.0 && d5 <= d6 {
        return [0.0, 0.0, 1.0];
    }
    let vb = d5 * d2 - d1 * d6;
    if vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0 {
        let w = ratio(d2, d2 - d6);
        return [1.0 - w, 0.0, w];
    }
    let va = d3 * d6 - d5 * d4;
    if va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0 {
        let w = ratio(d4 - d3, (d4 - d3) + (d5 - d6));
        return [0.0, 1.0 - w, w];
    }
    let sum = va + vb + vc;
    let (v, w) = (ratio(vb, sum), ratio(vc, sum));
    [1.0 - v - w, v, w]
}

/// Quotient, or 0 if the divisor is not positive, as for degenerate triangles.
#[inline]
fn ratio(x: f32, y: f32) -> f32 {
    if y > 0.0 { x / y } else { 0.0 }
}

/// Least cosine allowed between the normals of an old triangle and its replacement.
const FLIP_COSINE: f32 = 0.2;
/// A new triangle must have at least this quality (1 is equilateral), unless the one it replaces was worse.
const SLIVER_QUALITY: f32 = 0.01;
/// Below this quality, the normal of a triangle is noise.
const NEEDLE_QUALITY: f32 = 0.02;
/// Squared height, in scaled units, below which single precision determines no orientation.
const NOISE_SQUARED: f32 = (NOISE * NOISE) as f32;

/// Length of the sum of a star's normals.
#[derive(Clone, Copy)]
pub(in crate::simplify) struct StarNormal {
    length: f32x8,
}

impl StarNormal {
    #[inline]
    pub(in crate::simplify) fn new(mean: Vec3) -> Self {
        Self { length: f32x8::splat(mean.length()) }
    }
}

/// Lane masks of eight triangles.
#[derive(Clone, Copy)]
pub(in crate::simplify) struct LaneVerdict {
    /// Triangles that keep their orientation and do not become slivers, as far as their own normals show.
    pub is_allowed: f32x8,
    /// Allowed triangles whose own old normal does not rule out that they turn over within a flat surface.
    pub may_turn: f32x8,
}

/// Eight triangles `(v, a, b)` and the fan triangles `(u, a, b)` that would replace them.
#[derive(Clone, Copy)]
pub(in crate::simplify) struct FanChange {
    /// Lengths of the unscaled normals.
    pub old_length: f32x8,
    pub new_length: f32x8,
    /// Dot products of the unscaled normals with each other, and with the sum of all normals of the star.
    pub new_on_old: f32x8,
    pub new_on_mean: f32x8,
    pub old_on_mean: f32x8,
    /// Sums of the squared edge lengths.
    pub old_edges: f32x8,
    pub new_edges: f32x8,
}

impl FanChange {
    /// Tests whether the triangles keep their orientation and do not become slivers.
    ///
    /// The normal of a needle is unreliable, so its replacement must agree with the mean normal of the
    /// star, or stay as small. Scans are full of needles, and locking them would lock their neighbors.
    /// Needles of a flat surface are not allowed to turn over, though: see `flat_fold.rs`.
    #[inline]
    pub(in crate::simplify) fn verdict(self, star: StarNormal) -> LaneVerdict {
        let splat = f32x8::splat;
        let was_needle =
            (splat(TWICE_ROOT_3) * self.old_length).simd_le(splat(NEEDLE_QUALITY) * self.old_edges);
        let was_noise = (self.old_length * self.old_length).simd_le(splat(NOISE_SQUARED) * self.old_edges);
        let follows_mean = self.new_on_mean.simd_gt(f32x8::ZERO);
        let stays_small = self.new_length.simd_le(self.old_length + self.old_length);
        let flips = self.new_on_old.simd_le(splat(FLIP_COSINE) * self.new_length * self.old_length);
        // A triangle that was folded over may unfold.
        let unfolds = self.old_on_mean.simd_le(f32x8::ZERO)
            & self.new_on_mean.simd_gt(splat(FLIP_COSINE) * self.new_length * star.length);
        let is_sound = (splat(TWICE_ROOT_3) * self.new_length)
            .simd_ge(splat(SLIVER_QUALITY) * self.new_edges)
            | (self.new_length * self.old_edges).simd_ge(self.old_length * self.new_edges);
        let is_allowed = was_needle.bitselect(follows_mean | stays_small, flips.bitselect(unfolds, is_sound));
        LaneVerdict { is_allowed, may_turn: is_allowed & (flips | was_noise) }
    }
}

/// Distances of a point from eight triangles `(A, B, C)`, by dot products only: the triangles of a star
/// share most of them.
///
/// With `p` the point, `d` contains AB.Ap, AC.Ap, AB.Bp, AC.Bp, AB.Cp, AC.Cp.
#[derive(Clone, Copy)]
pub(in crate::simplify) struct Products {
    pub d: [f32x8; 6],
    /// Squared distances of the point from A, B and C.
    pub corners: [f32x8; 3],
    /// Distance from the plane times the length of the unscaled normal.
    pub height: f32x8,
    pub normal_squared: f32x8,
}

impl Products {
    /// Squared distance of the point from the triangle. It is exact perpendicular to the plane, and
    /// within the plane accurate to a few units in the last place of the squared edges. For a triangle
    /// without area, it is the distance from its sides.
    #[inline]
    pub(in crate::simplify) fn distance_squared(&self) -> f32x8 {
        let [d1, d2, d3, d4, d5, d6] = self.d;
        let [from_a, from_b, _] = self.corners;
        let (vc, vb, va) = (d1 * d4 - d3 * d2, d5 * d2 - d1 * d6, d3 * d6 - d5 * d4);
        let zero = f32x8::ZERO;
        let is_inside = va.simd_gt(zero) & vb.simd_gt(zero) & vc.simd_gt(zero);
        let floor = f32x8::splat(f32::MIN_POSITIVE);
        let above = self.height * self.height / self.normal_squared.fast_max(floor);
        let sides = segment_distance_squared(from_a, d1, d1 - d3)
            .fast_min(segment_distance_squared(from_a, d2, d2 - d6))
            .fast_min(segment_distance_squared(from_b, d4 - d3, (d4 - d3) + (d5 - d6)));
        is_inside.bitselect(above, sides)
    }
}

/// Squared distance of a point from a segment. `from` is the squared distance from the segment's start,
/// `along` the dot product of the vector from there to the point with the segment, `length_squared` the
/// segment's squared length.
#[inline]
fn segment_distance_squared(from: f32x8, along: f32x8, length_squared: f32x8) -> f32x8 {
    let share = along / length_squared.fast_max(f32x8::splat(f32::MIN_POSITIVE));
    let share = share.fast_max(f32x8::ZERO).fast_min(f32x8::ONE);
    (from - share * (along + along - share * length_squared)).fast_max(f32x8::ZERO)
}

/// Factor that makes `TWICE_ROOT_3 * |normal| / (sum of squared edges)` 1 for equilateral triangles.
const TWICE_ROOT_3: f32 = 3.464_101_6;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn distances_in_every_region() {
        let at = |x: f32, y: f32, z: f32| {
            let p = Vec3::new(x, y, z);
            let [a, b, c] = [[0., 0., 0.], [4., 0., 0.], [0., 4., 0.]].map(|q| Vec3::from(q) - p);
            distance_squared(a, b, c)
        };
        assert_eq!(at(1.0, 1.0, 2.0), 4.0);
        assert_eq!(at(-1.0, -2.0, 2.0), 9.0);
        assert_eq!(at(6.0, -1.0, 0.0), 5.0);
        assert_eq!(at(2.0, -3.0, 0.0), 9.0);
        assert_eq!(at(-3.0, 2.0, 0.0), 9.0);
        assert_eq!(at(4.0, 4.0, 0.0), 8.0);
        assert_eq!(at(-1.0, 7.0, 1.0), 11.0);
    }

    #[test]
    fn products_match_direct_distances() {
        let [a, b, c] = [[0.1, 0.2, 0.3], [4., 0.5, 0.], [-0.3, 4., 1.]].map(Vec3::from);
        for i in 0..1000i32 {
            let at = |k: i32| ((i * k) % 97) as f32 / 10.0 - 4.0;
            let p = Vec3::new(at(7), at(13), at(29));
            let (ab, ac) = (b - a, c - a);
            let normal = ab.cross(ac);
            let products = Products {
                d: [ab.dot(p - a), ac.dot(p - a), ab.dot(p - b), ac.dot(p - b), ab.dot(p - c), ac.dot(p - c)]
                    .map(f32x8::splat),
                corners: [a, b, c].map(|q| f32x8::splat((p - q).length_squared())),
                height: f32x8::splat(normal.dot(p - a)),
                normal_squared: f32x8::splat(normal.length_squared()),
            };
            let expected = distance_squared(a - p, b - p, c - p);
            let found = products.distance_squared().to_array()[0];
            assert!((found - expected).abs() <= 1e-4 * expected.max(1.0), "{p}: {found} {expected}");
        }
    }

    #[test]
    fn degenerate_triangles_are_points_and_segments() {
        let p = Vec3::new(3.0, 4.0, 0.0);
        assert_eq!(distance_squared(p, p, p), 25.0);
        let d =
            distance_squared(Vec3::new(-1.0, 2.0, 0.0), Vec3::new(1.0, 2.0, 0.0), Vec3::new(3.0, 2.0, 0.0));
        assert!((d - 4.0).abs() < 1e-6, "{d}");
    }

    #[test]
    fn flips_and_slivers_are_refused() {
        let (a, b) = (Vec3::new(1.0, 0.0, 0.0), Vec3::new(0.0, 1.0, 0.0));
        let normal = a.cross(b);
        let may = |x: f32, y: f32| {
            let u = Vec3::new(x, y, 0.0);
            let new = (a - u).cross(b - u);
            let splat = f32x8::splat;
            let edges = |p: Vec3| {
                splat((a - p).length_squared() + (b - p).length_squared() + (b - a).length_squared())
            };
            let change = FanChange {
                old_length: splat(normal.length()),
                new_length: splat(new.length()),
                new_on_old: splat(new.dot(normal)),
                new_on_mean: splat(new.dot(normal)),
                old_on_mean: splat(normal.dot(normal)),
                old_edges: edges(Vec3::ZERO),
                new_edges: edges(u),
            };
            change.verdict(StarNormal::new(normal)).is_allowed.all()
        };
        assert!(may(-1.0, -1.0));
        assert!(!may(2.0, 2.0));
        assert!(!may(0.5, 0.4999));
    }
}
