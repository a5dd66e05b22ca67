//! Octahedral encoding of unit vectors as two integers.
//!
//! A direction is scaled until its absolute coordinates sum to 1, which puts it on an octahedron. Seen from
//! above, the upper half of the octahedron fills a square turned by 45 degrees; the triangles of the lower
//! half are folded out into the corners of the enclosing square. The square is a grid of `2^bits - 1` by
//! `2^bits - 1` points, so that 0, both signs and the axes are represented exactly.

use glam::{DVec2, DVec3};

/// Encodes a direction as the nearest grid point, by angle, among the four around its exact location.
///
/// A zero or non-finite vector is encoded as the z axis.
///
/// # Panics
/// If `bits` is not from 2 to 16.
pub(super) fn encode(direction: [f32; 3], bits: u32) -> [i16; 2] {
    let scale = scale_of(bits);
    let direction = DVec3::from(direction.map(f64::from)).try_normalize().unwrap_or(DVec3::Z);
    let sum = direction.abs().element_sum();
    let flat = direction.truncate() / sum;
    let point = (if direction.z < 0.0 { fold(flat) } else { flat }) * scale;
    let floor = point.floor();
    let corners = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [1.0, 1.0]];
    let points =
        corners.map(|corner| (floor + DVec2::from(corner)).clamp(DVec2::splat(-scale), DVec2::splat(scale)));
    let nearness = |point: &DVec2| direction_at(*point / scale).dot(direction);
    let nearest = points.iter().max_by(|a, b| nearness(a).total_cmp(&nearness(b))).unwrap_or(&floor);
    [nearest.x as i16, nearest.y as i16]
}

/// Decodes a grid point to a unit vector. Coordinates outside the grid are clamped.
///
/// # Panics
/// If `bits` is not from 2 to 16.
pub(super) fn decode(point: [i16; 2], bits: u32) -> [f32; 3] {
    let scale = scale_of(bits);
    let point = DVec2::from(point.map(f64::from)) / scale;
    direction_at(point.clamp(DVec2::NEG_ONE, DVec2::ONE)).as_vec3().into()
}

fn scale_of(bits: u32) -> f64 {
    assert!((2..=16).contains(&bits), "{bits} bits");
    f64::from((1u32 << (bits - 1)) - 1)
}

/// Maps a point of the lower half of the octahedron to its corner of the square, or back.
fn fold(flat: DVec2) -> DVec2 {
    let sign = |x: f64| if x < 0.0 { -1.0 } else { 1.0 };
    DVec2::new((1.0 - flat.y.abs()) * sign(flat.x), (1.0 - flat.x.abs()) * sign(flat.y))
}

fn direction_at(point: DVec2) -> DVec3 {
    let z = 1.0 - point.x.abs() - point.y.abs();
    let flat = if z < 0.0 { fold(point) } else { point };
    flat.extend(z).normalize()
}

#[cfg(test)]
mod tests {
    use super::*;
    use striata::mesh::Random;

    #[test]
    fn directions_round_trip_within_half_a_cell() {
        let mut random = Random::new(3);
        for bits in [4, 8, 10, 12, 16] {
            let mut largest = 0.0f64;
            for _ in 0..5000 {
                let direction = DVec3::from([(); 3].map(|()| random.unit() - 0.5)).normalize();
                let kept = decode(encode(direction.as_vec3().into(), bits), bits);
                largest = largest.max(DVec3::from(kept.map(f64::from)).distance(direction));
            }
            // An offset on the square changes the direction by at most twice its length.
            let cell = 1.0 / scale_of(bits);
            assert!(
                largest < 1.42 * cell + 1e-7 && largest > 0.3 * cell,
                "{bits} bits: off by {largest}, cell {cell}"
            );
        }
    }

    #[test]
    fn axes_are_exact_and_invalid_input_is_accepted() {
        for axis in [[1.0, 0.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.0, 1.0], [0.0, 0.0, -1.0]] {
            assert_eq!(decode(encode(axis, 8), 8), axis);
        }
        for invalid in [[0.0; 3], [f32::NAN; 3], [f32::INFINITY, 0.0, 0.0]] {
            assert_eq!(decode(encode(invalid, 16), 16), [0.0, 0.0, 1.0]);
        }
        assert_eq!(decode([i16::MIN, 0], 16), [-1.0, 0.0, 0.0]);
    }
}
