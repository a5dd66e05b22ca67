//! What replaces a removed vertex: checks and distances of the new fan of triangles.
//!
//! Everything is relative to the removed vertex, which is therefore the origin.

use glam::Vec3;

/// Squared distance of the origin from the triangle `(a, b, c)`, degenerate ones included.
///
/// The regions of the triangle are told apart as in Ericson, Real-Time Collision Detection, 5.1.5.
#[inline]
pub(super) fn distance_squared(a: Vec3, b: Vec3, c: Vec3) -> f32 {
    let [_, v, w] = nearest(a, b, c);
    (a + (b - a) * v + (c - a) * w).length_squared()
}

/// Barycentric coordinates of the point of the triangle `(a, b, c)` nearest to the origin.
#[inline]
pub(super) fn nearest(a: Vec3, b: Vec3, c: Vec3) -> [f32; 3] {
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

/// A quotient that is 0 where nothing is divided by nothing, as degenerate triangles do.
#[inline]
fn ratio(x: f32, y: f32) -> f32 {
    if y > 0.0 { x / y } else { 0.0 }
}

/// Cosine that the normals of an old and a new triangle must at least have between them.
const FLIP_COSINE: f32 = 0.2;
/// A new triangle may not be thinner than this (1 is equilateral), unless the one it replaces was thinner still.
const SLIVER_QUALITY: f32 = 0.01;
/// Below this the normal of a triangle is noise.
const NEEDLE_QUALITY: f32 = 0.02;

/// True where the triangle `(u, a, b)` may stand for `(v, a, b)`, v being the origin and `normal` the unscaled
/// normal of the old triangle: it keeps facing the same way and is no sliver.
///
/// A needle faces nowhere in particular, so what follows it must agree with `mean`, the sum of all normals of
/// the star, or stay as small. Scans are full of needles, and locking them would lock their neighbours.
#[inline]
pub(super) fn may_replace(u: Vec3, a: Vec3, b: Vec3, normal: Vec3, mean: Vec3) -> bool {
    let new = (a - u).cross(b - u);
    let (new_length, old_length) = (new.length(), normal.length());
    let rim = (b - a).length_squared();
    let old_edges = a.length_squared() + b.length_squared() + rim;
    if TWICE_ROOT_3 * old_length <= NEEDLE_QUALITY * old_edges {
        return new.dot(mean) > 0.0 || new_length <= 2.0 * old_length;
    }
    if new.dot(normal) <= FLIP_COSINE * new_length * old_length {
        // A triangle that was folded over may unfold.
        return normal.dot(mean) <= 0.0 && new.dot(mean) > FLIP_COSINE * new_length * mean.length();
    }
    let new_edges = (a - u).length_squared() + (b - u).length_squared() + rim;
    TWICE_ROOT_3 * new_length >= SLIVER_QUALITY * new_edges
        || new_length * old_edges >= old_length * new_edges
}

/// Makes `TWICE_ROOT_3 * |normal| / (sum of squared edges)` 1 for equilateral triangles.
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
        assert!(may_replace(Vec3::new(-1.0, -1.0, 0.0), a, b, normal, normal));
        assert!(!may_replace(Vec3::new(2.0, 2.0, 0.0), a, b, normal, normal));
        assert!(!may_replace(Vec3::new(0.5, 0.4999, 0.0), a, b, normal, normal));
    }
}
