//! Distances of points from the triangles of a step's floor, four triangles at a time.
//!
//! Each distance is computed to a point that was found on the triangle. Whatever the search rounds, the
//! result is therefore less than the true distance by no more than the rounding of the last subtraction.

use glam::DVec3;
use wide::f64x4;

/// Four triangles in SIMD lanes, relative to their first corners.
#[derive(Clone, Copy)]
struct FourTriangles {
    first: [f64x4; 3],
    to_second: [f64x4; 3],
    to_third: [f64x4; 3],
    /// Squared lengths of the two sides and their dot product.
    second_squared: f64x4,
    third_squared: f64x4,
    product: f64x4,
    /// Inverse squared lengths of the sides (first to second, first to third, second to third), 0 for a
    /// side without length.
    inverse_sides: [f64x4; 3],
    /// Inverse square of twice the area; 0 without area.
    inverse_area: f64x4,
}

/// The triangles of one floor.
#[derive(Default)]
pub(super) struct Floor {
    batches: Vec<FourTriangles>,
    corners: Vec<[DVec3; 3]>,
}

impl Floor {
    /// Replaces the triangles.
    pub(super) fn set(&mut self, triangles: impl Iterator<Item = [DVec3; 3]>) {
        self.corners.clear();
        self.corners.extend(triangles);
        self.batches.clear();
        for four in self.corners.chunks(4) {
            // Unused lanes repeat the last triangle.
            self.batches
                .push(FourTriangles::new([0, 1, 2, 3].map(|lane: usize| &four[lane.min(four.len() - 1)])));
        }
    }

    /// Number of triangles.
    pub(super) fn count(&self) -> usize {
        self.corners.len()
    }

    /// Returns the triangles that share a side with a triangle.
    pub(super) fn adjacent(&self, triangle: usize) -> impl Iterator<Item = usize> {
        let own = &self.corners[triangle];
        let is_adjacent =
            move |other: &[DVec3; 3]| own.iter().filter(|corner| other.contains(corner)).count() >= 2;
        (0..self.corners.len()).filter(move |&other| other != triangle && is_adjacent(&self.corners[other]))
    }

    /// Returns a point and the normal of the plane whose points are equally far from two triangles that
    /// share a side.
    pub(super) fn bisector_plane(&self, one: usize, other: usize) -> Option<(DVec3, DVec3)> {
        let (one, other) = (&self.corners[one], &self.corners[other]);
        let [a, b] = [(one, other), (other, one)].map(|(t, u)| t.iter().find(|corner| !u.contains(corner)));
        let mut shared = one.iter().filter(|corner| other.contains(corner));
        let (start, end) = (*shared.next()?, *shared.next()?);
        let along = (end - start).normalize_or_zero();
        let [to_a, to_b] = [*a?, *b?].map(|p| (p - start).reject_from_normalized(along).normalize_or_zero());
        let normal = to_a - to_b;
        (normal.length_squared() > 1e-6).then_some((start, normal))
    }

    /// Appends the squared distances of a point from all triangles, four per entry; returns the smallest.
    #[inline]
    pub(super) fn push_squared_distances(&self, point: DVec3, out: &mut Vec<f64x4>) -> f64 {
        let mut least = f64x4::splat(f64::INFINITY);
        for four in &self.batches {
            let squared = four.squared_distances(point);
            least = least.fast_min(squared);
            out.push(squared);
        }
        least.to_array().into_iter().fold(f64::INFINITY, f64::min)
    }

    /// Returns the triangle whose largest squared distance from any of the given points is smallest, and that
    /// distance; keeps no distances.
    pub(super) fn best(&self, points: &[DVec3]) -> (usize, f64) {
        let (mut best, mut least) = (0, f64::INFINITY);
        for (batch, four) in self.batches.iter().enumerate() {
            let worst = points
                .iter()
                .fold(f64x4::ZERO, |worst, &point| worst.fast_max(four.squared_distances(point)));
            for (lane, &squared) in worst.to_array().iter().enumerate() {
                if squared < least && 4 * batch + lane < self.count() {
                    (best, least) = (4 * batch + lane, squared);
                }
            }
        }
        (best, least)
    }
}

impl FourTriangles {
    fn new(triangles: [&[DVec3; 3]; 4]) -> Self {
        let lanes = |f: &dyn Fn(&[DVec3; 3]) -> DVec3| {
            let at = triangles.map(f);
            [0, 1, 2].map(|axis| f64x4::from(at.map(|p| p[axis])))
        };
        let first = lanes(&|t| t[0]);
        let (to_second, to_third) = (lanes(&|t| t[1] - t[0]), lanes(&|t| t[2] - t[0]));
        let across = [0, 1, 2].map(|axis| to_third[axis] - to_second[axis]);
        let (second_squared, third_squared) = (dot(to_second, to_second), dot(to_third, to_third));
        let product = dot(to_second, to_third);
        let inverse_sides = [second_squared, third_squared, dot(across, across)].map(inverse);
        let inverse_area = inverse(second_squared * third_squared - product * product);
        Self {
            first,
            to_second,
            to_third,
            second_squared,
            third_squared,
            product,
            inverse_sides,
            inverse_area,
        }
    }

    #[inline]
    fn squared_distances(&self, point: DVec3) -> f64x4 {
        let (zero, one) = (f64x4::ZERO, f64x4::ONE);
        let from_first = [
            f64x4::splat(point.x) - self.first[0],
            f64x4::splat(point.y) - self.first[1],
            f64x4::splat(point.z) - self.first[2],
        ];
        let (along_second, along_third) = (dot(from_first, self.to_second), dot(from_first, self.to_third));
        let squared_to = |u: f64x4, v: f64x4| {
            let rest =
                [0, 1, 2].map(|axis| from_first[axis] - u * self.to_second[axis] - v * self.to_third[axis]);
            dot(rest, rest)
        };
        let u = (self.third_squared * along_second - self.product * along_third) * self.inverse_area;
        let v = (self.second_squared * along_third - self.product * along_second) * self.inverse_area;
        let is_inside = u.simd_gt(zero) & v.simd_gt(zero) & (u + v).simd_lt(one);
        let inside = squared_to(u, v);
        if is_inside.all() {
            return inside;
        }
        let clamp = |t: f64x4| t.fast_max(zero).fast_min(one);
        let on_second = clamp(along_second * self.inverse_sides[0]);
        let on_third = clamp(along_third * self.inverse_sides[1]);
        let across = along_third - along_second - self.product + self.second_squared;
        let on_across = clamp(across * self.inverse_sides[2]);
        let sides = squared_to(on_second, zero)
            .fast_min(squared_to(zero, on_third))
            .fast_min(squared_to(one - on_across, on_across));
        is_inside.bitselect(inside, sides)
    }
}

#[inline]
fn dot(a: [f64x4; 3], b: [f64x4; 3]) -> f64x4 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// Inverse of `x`; 0 if `x` is 0 or less.
fn inverse(x: f64x4) -> f64x4 {
    f64x4::from(x.to_array().map(|x| if x > 0.0 && x.recip().is_finite() { x.recip() } else { 0.0 }))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::Random;

    fn distances(triangles: &[[DVec3; 3]], point: DVec3) -> Vec<f64> {
        let mut floor = Floor::default();
        floor.set(triangles.iter().copied());
        let mut out = Vec::new();
        let least = floor.push_squared_distances(point, &mut out);
        let all: Vec<f64> = out.iter().flat_map(|four| four.to_array()).take(floor.count()).collect();
        assert_eq!(least, all.iter().copied().fold(f64::INFINITY, f64::min));
        all.into_iter().map(f64::sqrt).collect()
    }

    #[test]
    fn distances_in_all_regions_of_a_triangle() {
        let at = DVec3::new;
        let t = [at(0.0, 0.0, 0.0), at(4.0, 0.0, 0.0), at(0.0, 3.0, 0.0)];
        let cases = [
            (at(1.0, 1.0, 2.0), 2.0),
            (at(2.0, -1.0, 0.0), 1.0),
            (at(-2.0, 1.0, 0.0), 2.0),
            (at(5.0, 5.0, 0.0), 23.0 / 5.0),
            (at(-3.0, -4.0, 0.0), 5.0),
            (at(7.0, -4.0, 0.0), 5.0),
            (at(-3.0, 7.0, 12.0), 13.0),
        ];
        for (point, expected) in cases {
            for found in distances(&[t, [t[1], t[2], t[0]], [t[2], t[1], t[0]], t, t], point) {
                assert!((found - expected).abs() < 1e-12, "{point}: {found}, expected {expected}");
            }
        }
    }

    #[test]
    fn triangles_without_area_have_distances() {
        let at = DVec3::new;
        let line = [at(0.0, 0.0, 0.0), at(1.0, 0.0, 0.0), at(4.0, 0.0, 0.0)];
        let point = [at(1.0, 0.0, 0.0); 3];
        assert_eq!(distances(&[line, point], at(3.0, 2.0, 0.0)), [2.0, 8f64.sqrt()]);
        assert_eq!(distances(&[], at(3.0, 2.0, 0.0)), [0.0; 0]);
    }

    /// The distance is to a point of the triangle, so it is never below the true one; samples on a fine
    /// grid are hardly farther.
    #[test]
    fn distances_match_dense_sampling() {
        let mut random = Random::new(1);
        for _ in 0..300 {
            let mut any = || DVec3::from_array([(); 3].map(|()| random.unit() * 2.0 - 1.0));
            let (t, point) = ([any(), any(), any()], any());
            let found = distances(&[t], point)[0];
            let mut least = f64::INFINITY;
            for (i, j) in (0..=60).flat_map(|i| (0..=60 - i).map(move |j| (i, j))) {
                let (u, v) = (f64::from(i) / 60.0, f64::from(j) / 60.0);
                least = least.min((t[0] + (t[1] - t[0]) * u + (t[2] - t[0]) * v - point).length());
            }
            assert!(found <= least + 1e-12 && least < found + 0.03, "{found}, {least}");
        }
    }
}
