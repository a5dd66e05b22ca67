//! Triangles cut off at the near plane, as a GPU cuts them.

use super::camera::Camera;

type Vec3 = [f32; 3];

/// A corner of a triangle with all that is interpolated over it, as the camera sees it: x right, y up, z towards the eye.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Corner {
    pub(super) place: Vec3,
    pub(super) color: Vec3,
    pub(super) normal: Vec3,
}

/// What is left of a triangle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Piece {
    pub(super) corners: [Corner; 3],
    /// Whether the side opposite to a corner is one of the triangle's own, not made by cutting.
    pub(super) is_edge: [bool; 3],
}

/// How far before the eye the near plane is: as `striata_gpu::Viewpoint` has it.
pub(super) fn near_plane(camera: &Camera, center: [f64; 3], radius: f64) -> f64 {
    let radius = radius.max(1e-30);
    let away: f64 = (0..3).map(|k| (f64::from(camera.eye[k]) - center[k]).powi(2)).sum();
    (away.sqrt() - 1.001 * radius).max(1e-3 * radius)
}

/// What lies at least `near` before the eye: none, one or two pieces.
pub(super) fn clipped(corners: [Corner; 3], near: f32) -> impl Iterator<Item = Piece> {
    let is_inside = corners.map(|corner| -corner.place[2] >= near);
    let pieces = match is_inside.iter().filter(|&&inside| inside).count() {
        0 => [None, None],
        3 => [Some(Piece { corners, is_edge: [true; 3] }), None],
        _ => cut_up(&corners, is_inside, near),
    };
    pieces.into_iter().flatten()
}

/// Cuts a triangle with corners on both sides.
fn cut_up(corners: &[Corner; 3], is_inside: [bool; 3], near: f32) -> [Option<Piece>; 2] {
    // A polygon, and whether the side that begins at each of its corners is the triangle's own.
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
    let piece = |corners: [Corner; 3], is_edge| Some(Piece { corners, is_edge });
    if count == 3 {
        [piece([a.0, b.0, c.0], [b.1, c.1, a.1]), None]
    } else {
        [piece([a.0, b.0, c.0], [b.1, false, a.1]), piece([a.0, c.0, d.0], [c.1, d.1, false])]
    }
}

/// Where the side from a corner inside to one outside goes through the plane.
fn between(inside: &Corner, outside: &Corner, near: f32) -> Corner {
    let [from, to] = [inside, outside].map(|corner| -f64::from(corner.place[2]));
    let share = (from - f64::from(near)) / (from - to);
    let mixed = |a: Vec3, b: Vec3| -> Vec3 {
        [0, 1, 2].map(|k| (f64::from(a[k]) + share * (f64::from(b[k]) - f64::from(a[k]))) as f32)
    };
    Corner {
        place: mixed(inside.place, outside.place),
        color: mixed(inside.color, outside.color),
        normal: mixed(inside.normal, outside.normal),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn corner(x: f32, y: f32, z: f32) -> Corner {
        Corner { place: [x, y, z], color: [x, y, z], normal: [0.0, 0.0, 1.0] }
    }

    fn area(piece: &Piece) -> f32 {
        let [a, b, c] = piece.corners.map(|corner| corner.place);
        // These triangles lie in a plane of constant y.
        ((b[0] - a[0]) * (c[2] - a[2]) - (b[2] - a[2]) * (c[0] - a[0])).abs() / 2.0
    }

    #[test]
    fn what_is_left_has_the_area_and_the_sides_that_it_should() {
        let [far, left, right] = [corner(0.0, -1.0, -4.0), corner(-2.0, -1.0, 0.0), corner(2.0, -1.0, 0.0)];
        // One corner is before the plane: a small triangle of half the size.
        let pieces: Vec<Piece> = clipped([far, left, right], 2.0).collect();
        assert_eq!(pieces.len(), 1);
        assert!((area(&pieces[0]) - 2.0).abs() < 1e-6);
        assert_eq!(pieces[0].is_edge, [false, true, true]);
        assert_eq!(pieces[0].corners[1].color, [-1.0, -1.0, -2.0], "colors are cut along with places");
        // Two corners are: the rest, in two pieces that share a side which is nobody's edge.
        let near = corner(0.0, -1.0, 0.0);
        let [left, right] = [corner(-2.0, -1.0, -4.0), corner(2.0, -1.0, -4.0)];
        for corners in [[near, left, right], [right, near, left], [left, right, near]] {
            let pieces: Vec<Piece> = clipped(corners, 2.0).collect();
            assert_eq!(pieces.len(), 2);
            assert!((pieces.iter().map(area).sum::<f32>() - 6.0).abs() < 1e-5);
            assert_eq!(pieces.iter().flat_map(|piece| piece.is_edge).filter(|&edge| edge).count(), 3);
        }
    }

    #[test]
    fn whole_triangles_stay_or_go() {
        let whole = [corner(0.0, 0.0, -3.0), corner(1.0, 0.0, -3.0), corner(0.0, 1.0, -3.0)];
        assert_eq!(clipped(whole, 3.0).next(), Some(Piece { corners: whole, is_edge: [true; 3] }));
        assert_eq!(clipped(whole, 3.1).count(), 0);
    }
}
