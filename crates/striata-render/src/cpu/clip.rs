//! Clips triangles at the near plane, as a GPU does.

type Vec3 = [f32; 3];

/// A triangle corner with its interpolated attributes, in camera space: x right, y up, z toward the eye.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Corner {
    pub position: Vec3,
    pub color: Vec3,
    pub normal: Vec3,
}

/// Part of a triangle that remains after clipping.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct ClippedTriangle {
    pub corners: [Corner; 3],
    /// Whether the side opposite each corner is part of an original edge, rather than created by clipping.
    pub is_edge: [bool; 3],
}

/// Clips a triangle to depths of at least `near`; yields up to two triangles.
pub(crate) fn clip(corners: [Corner; 3], near: f32) -> impl Iterator<Item = ClippedTriangle> {
    let is_inside = corners.map(|corner| -corner.position[2] >= near);
    let clipped_triangles = match is_inside.iter().filter(|&&inside| inside).count() {
        0 => [None, None],
        3 => [Some(ClippedTriangle { corners, is_edge: [true; 3] }), None],
        _ => clip_crossing(&corners, is_inside, near),
    };
    clipped_triangles.into_iter().flatten()
}

/// Clips a triangle with corners on both sides of the plane.
fn clip_crossing(corners: &[Corner; 3], is_inside: [bool; 3], near: f32) -> [Option<ClippedTriangle>; 2] {
    // A polygon, and whether the side that starts at each of its corners is an original edge.
    let mut polygon = [(corners[0], false); 4];
    let mut count = 0;
    let mut push = |corner: Corner, is_edge: bool| {
        polygon[count] = (corner, is_edge);
        count += 1;
    };
    for k in 0..3 {
        let next = (k + 1) % 3;
        let (from, to) = (&corners[k], &corners[next]);
        match (is_inside[k], is_inside[next]) {
            (true, true) => push(*from, true),
            (true, false) => {
                push(*from, true);
                push(between(from, to, near), false);
            }
            (false, true) => push(between(to, from, near), true),
            (false, false) => {}
        }
    }
    let [a, b, c, d] = polygon;
    let clipped_triangle = |corners: [Corner; 3], is_edge| Some(ClippedTriangle { corners, is_edge });
    if count == 3 {
        [clipped_triangle([a.0, b.0, c.0], [b.1, c.1, a.1]), None]
    } else {
        [
            clipped_triangle([a.0, b.0, c.0], [b.1, false, a.1]),
            clipped_triangle([a.0, c.0, d.0], [c.1, d.1, false]),
        ]
    }
}

/// Intersects the side from a corner inside to one outside with the plane.
fn between(inside: &Corner, outside: &Corner, near: f32) -> Corner {
    let [from, to] = [inside, outside].map(|corner| -f64::from(corner.position[2]));
    let share = (from - f64::from(near)) / (from - to);
    let mixed = |a: Vec3, b: Vec3| -> Vec3 {
        [0, 1, 2].map(|k| (f64::from(a[k]) + share * (f64::from(b[k]) - f64::from(a[k]))) as f32)
    };
    Corner {
        position: mixed(inside.position, outside.position),
        color: mixed(inside.color, outside.color),
        normal: mixed(inside.normal, outside.normal),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn corner(x: f32, y: f32, z: f32) -> Corner {
        Corner { position: [x, y, z], color: [x, y, z], normal: [0.0, 0.0, 1.0] }
    }

    fn area(clipped_triangle: &ClippedTriangle) -> f32 {
        let [a, b, c] = clipped_triangle.corners.map(|corner| corner.position);
        // These triangles lie in a plane of constant y.
        ((b[0] - a[0]) * (c[2] - a[2]) - (b[2] - a[2]) * (c[0] - a[0])).abs() / 2.0
    }

    #[test]
    fn clipping_gives_the_expected_areas_and_edges() {
        let [far, left, right] = [corner(0.0, -1.0, -4.0), corner(-2.0, -1.0, 0.0), corner(2.0, -1.0, 0.0)];
        // One corner is in front of the plane: a small triangle of half the size.
        let clipped_triangles: Vec<ClippedTriangle> = clip([far, left, right], 2.0).collect();
        assert_eq!(clipped_triangles.len(), 1);
        assert!((area(&clipped_triangles[0]) - 2.0).abs() < 1e-6);
        assert_eq!(clipped_triangles[0].is_edge, [false, true, true]);
        assert_eq!(
            clipped_triangles[0].corners[1].color,
            [-1.0, -1.0, -2.0],
            "colors are interpolated like positions"
        );
        // Two corners are in front: two triangles that share a side which is not an edge.
        let near = corner(0.0, -1.0, 0.0);
        let [left, right] = [corner(-2.0, -1.0, -4.0), corner(2.0, -1.0, -4.0)];
        for corners in [[near, left, right], [right, near, left], [left, right, near]] {
            let clipped_triangles: Vec<ClippedTriangle> = clip(corners, 2.0).collect();
            assert_eq!(clipped_triangles.len(), 2);
            assert!((clipped_triangles.iter().map(area).sum::<f32>() - 6.0).abs() < 1e-5);
            assert_eq!(
                clipped_triangles
                    .iter()
                    .flat_map(|clipped_triangle| clipped_triangle.is_edge)
                    .filter(|&edge| edge)
                    .count(),
                3
            );
        }
    }

    #[test]
    fn triangles_on_one_side_are_kept_or_dropped() {
        let whole = [corner(0.0, 0.0, -3.0), corner(1.0, 0.0, -3.0), corner(0.0, 1.0, -3.0)];
        assert_eq!(clip(whole, 3.0).next(), Some(ClippedTriangle { corners: whole, is_edge: [true; 3] }));
        assert_eq!(clip(whole, 3.1).count(), 0);
    }
}
