//! Interpolation of keys, with rotations along the shorter arc.

use glam::DQuat;

/// Number of halvings of an arc; the rest of the way is a chord of less than a millionth of it.
const HALVINGS: u32 = 20;

/// Returns the rotation at `share` of the arc from one unit quaternion to another.
///
/// Exact up to rounding, and the same on every machine, because it uses no trigonometric functions.
pub(super) fn along_arc(from: DQuat, to: DQuat, share: f64) -> DQuat {
    let (mut low, mut high) = (from, if from.dot(to) < 0.0 { -to } else { to });
    let (mut start, mut width) = (0.0, 1.0);
    for _ in 0..HALVINGS {
        let middle = (low + high).normalize();
        width *= 0.5;
        if share < start + width {
            high = middle;
        } else {
            (low, start) = (middle, start + width);
        }
    }
    low.lerp(high, ((share - start) / width).clamp(0.0, 1.0))
}

/// Returns the value at `t` from 0 to 1 of the cubic spline of glTF, one component at a time.
///
/// `tangents` are those at the end of the first key and at the beginning of the second, times the duration.
pub(super) fn cubic(t: f64, [from, to]: [f64; 2], [out, into]: [f64; 2]) -> f64 {
    let (square, cube) = (t * t, t * t * t);
    (2.0 * cube - 3.0 * square + 1.0) * from
        + (cube - 2.0 * square + t) * out
        + (3.0 * square - 2.0 * cube) * to
        + (cube - square) * into
}

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use super::*;

    #[test]
    fn arcs_are_followed_at_constant_speed() {
        let to = DQuat::from_axis_angle(DVec3::new(0.6, 0.0, 0.8), 2.0);
        for share in [0.0, 0.1, 1.0 / 3.0, 0.5, 0.99, 1.0] {
            let expected = DQuat::from_axis_angle(DVec3::new(0.6, 0.0, 0.8), 2.0 * share);
            let found = along_arc(DQuat::IDENTITY, to, share);
            assert!(found.dot(expected).abs() > 1.0 - 1e-12, "{share}: {found} instead of {expected}");
            assert!(along_arc(DQuat::IDENTITY, -to, share).dot(expected).abs() > 1.0 - 1e-12, "{share}");
        }
    }

    #[test]
    fn splines_pass_through_their_keys() {
        assert_eq!(cubic(0.0, [1.0, 5.0], [2.0, 3.0]), 1.0);
        assert_eq!(cubic(1.0, [1.0, 5.0], [2.0, 3.0]), 5.0);
        assert_eq!(cubic(0.5, [0.0, 1.0], [1.0, 1.0]), 0.5);
    }
}
