//! Draws the frustum of a frozen view as lines over the picture.

use egui::{Color32, Painter, Pos2, Rect, Stroke};
use striata_gpu::Viewpoint;

use super::state::Frozen;

/// Draws the frustum of `frozen`, up to the distance of its target, over a picture taken from `viewpoint`.
pub(super) fn draw(painter: &Painter, rect: Rect, viewpoint: &Viewpoint, frozen: &Frozen) {
    let aspect = rect.width() / rect.height().max(1.0);
    let [eye, corners @ ..] = frustum_points(frozen);
    let stroke = Stroke::new(1.5, Color32::from_rgb(255, 176, 32));
    let edges = (0..4).flat_map(|k| [[eye, corners[k]], [corners[k], corners[(k + 1) % 4]]]);
    for ends in edges {
        if let Some(ends) = project(viewpoint, aspect, ends) {
            let at = |[x, y]: [f32; 2]| {
                let [right, down] = [(1.0 + x) / 2.0, (1.0 - y) / 2.0];
                Pos2::new(rect.left() + right * rect.width(), rect.top() + down * rect.height())
            };
            painter.line_segment(ends.map(at), stroke);
        }
    }
}

/// Eye of a frozen view, and the corners of its frustum at the distance of its target.
fn frustum_points(frozen: &Frozen) -> [[f64; 3]; 5] {
    let Viewpoint { eye, look_at, up, fov } = frozen.viewpoint;
    let [eye, look_at, up] = [eye, look_at, up].map(|point| point.map(f64::from));
    let ahead = sub(look_at, eye);
    let right = unit(cross(ahead, up));
    let up = unit(cross(right, ahead));
    let high = dot(ahead, ahead).sqrt() * (f64::from(fov) / 2.0).tan();
    let across = high * f64::from(frozen.size[0].max(1)) / f64::from(frozen.size[1].max(1));
    let corner =
        |x: f64, y: f64| std::array::from_fn(|k| look_at[k] + x * across * right[k] + y * high * up[k]);
    [eye, corner(-1.0, -1.0), corner(1.0, -1.0), corner(1.0, 1.0), corner(-1.0, 1.0)]
}

/// Projects a line to the screen, -1 to 1 on each axis, clipped in front of the eye; none if it is behind.
fn project(viewpoint: &Viewpoint, aspect: f32, ends: [[f64; 3]; 2]) -> Option<[[f32; 2]; 2]> {
    let [eye, look_at, up] =
        [viewpoint.eye, viewpoint.look_at, viewpoint.up].map(|point| point.map(f64::from));
    let ahead = unit(sub(look_at, eye));
    let right = unit(cross(ahead, up));
    let up = cross(right, ahead);
    let half = (f64::from(viewpoint.fov) / 2.0).tan();
    let seen = ends.map(|end| {
        let to = sub(end, eye);
        [dot(to, right), dot(to, up), dot(to, ahead)]
    });
    let near = 1e-4 * dot(sub(look_at, eye), sub(look_at, eye)).sqrt();
    let cut = |from: [f64; 3], to: [f64; 3]| {
        if from[2] >= near {
            return Some(from);
        }
        if to[2] < near {
            return None;
        }
        let share = (near - from[2]) / (to[2] - from[2]);
        Some(std::array::from_fn(|k| from[k] + share * (to[k] - from[k])))
    };
    let [a, b] = seen;
    let to_screen = |[x, y, depth]: [f64; 3]| {
        [(x / (depth * half * f64::from(aspect))) as f32, (y / (depth * half)) as f32]
    };
    Some([to_screen(cut(a, b)?), to_screen(cut(b, a)?)])
}

fn sub(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    std::array::from_fn(|k| a[k] - b[k])
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn unit(a: [f64; 3]) -> [f64; 3] {
    let length = dot(a, a).sqrt().max(f64::MIN_POSITIVE);
    a.map(|x| x / length)
}

#[cfg(test)]
mod tests {
    use super::*;

    const FRONT: Viewpoint =
        Viewpoint { eye: [0.0, 0.0, 4.0], look_at: [0.0; 3], up: [0.0, 1.0, 0.0], fov: 0.8 };

    #[test]
    fn from_its_own_eye_the_frustum_fills_the_picture() {
        let frozen = Frozen { viewpoint: FRONT, size: [200, 100] };
        let [_, corners @ ..] = frustum_points(&frozen);
        for (corner, expected) in
            corners.into_iter().zip([[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]])
        {
            let [found, _] = project(&FRONT, 2.0, [corner, [0.0; 3]]).expect("in front of the eye");
            assert!(found.iter().zip(expected).all(|(a, b): (&f32, f32)| (a - b).abs() < 1e-5), "{found:?}");
        }
    }

    #[test]
    fn lines_are_clipped_in_front_of_the_eye() {
        let [a, b] = project(&FRONT, 1.0, [[0.0, 0.0, 0.0], [1.0, 0.0, 9.0]]).expect("half of it is visible");
        assert!(a[0].abs() < 1e-6 && b[0].is_finite() && b[0] > 1.0, "{a:?} {b:?}");
        assert!(project(&FRONT, 1.0, [[0.0, 0.0, 5.0], [1.0, 0.0, 9.0]]).is_none());
    }
}
