//! Draws the frustum of one camera as lines in the picture of another.

use glam::Vec3;

use super::camera::{Camera, to_f64};
use super::{Line, Shot};

/// Frustum of a camera, extended to the far end of the mesh.
#[derive(Clone, Debug, PartialEq)]
pub struct Frustum {
    eye: [f32; 3],
    /// Corners of the far side, in order.
    corners: [[f32; 3]; 4],
}

/// Linear light as bytes: a color that contrasts with stone, dark and light.
const COLOR: [u8; 4] = [255, 62, 8, 255];

/// Line width, in pixels of a picture with 1000 rows.
const WIDTH: f32 = 3.0;

impl Frustum {
    /// Frustum up to the farthest of some points, or up to the camera's target if all are behind it.
    pub fn new(camera: &Camera, aspect: f32, points: &[[f32; 3]]) -> Self {
        let [right, up, back] = camera.axes();
        let eye = camera.eye_64();
        let depth_of = |p: &[f32; 3]| -(to_f64(*p) - eye).dot(back);
        let farthest = points.iter().map(depth_of).filter(|d| d.is_finite()).fold(0.0, f64::max);
        let depth = if farthest > 0.0 { farthest } else { eye.distance(to_f64(camera.look_at)) };
        let high = depth * (f64::from(camera.fov) / 2.0).tan();
        let wide = high * f64::from(aspect);
        let corner =
            |x: f64, y: f64| (eye - depth * back + x * wide * right + y * high * up).as_vec3().to_array();
        let corners = [corner(-1.0, -1.0), corner(1.0, -1.0), corner(1.0, 1.0), corner(-1.0, 1.0)];
        Self { eye: camera.eye, corners }
    }

    /// The eye and the far corners.
    pub fn points(&self) -> Vec<[f32; 3]> {
        [&[self.eye][..], &self.corners].concat()
    }

    /// Adds its edges, and a small screen in front of its eye, to a shot.
    pub fn draw_into(&self, shot: &mut Shot<'_>) {
        let line = |from, to, width| Line { ends: [from, to], color: COLOR, width };
        let eye = Vec3::from(self.eye);
        let screen = self.corners.map(|corner| eye.lerp(corner.into(), 0.14).to_array());
        for i in 0..4 {
            let next = (i + 1) % 4;
            shot.lines.push(line(self.eye, self.corners[i], WIDTH));
            shot.lines.push(line(self.corners[i], self.corners[next], WIDTH));
            shot.lines.push(line(screen[i], screen[next], WIDTH));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_frustum_reaches_the_far_end_of_the_mesh() {
        let camera = Camera { eye: [0.0, 0.0, 4.0], look_at: [0.0; 3], up: [0.0, 1.0, 0.0], fov: 1.0 };
        let frustum = Frustum::new(&camera, 2.0, &[[0.0, 0.0, -1.0], [0.5, 0.0, 1.0]]);
        let high = 5.0 * 0.5f32.tan();
        for corner in frustum.corners {
            let [x, y, z] = corner;
            assert!((x.abs() - 2.0 * high).abs() < 1e-4 && (y.abs() - high).abs() < 1e-4 && z == -1.0);
        }
        let behind = Frustum::new(&camera, 1.0, &[[0.0, 0.0, 9.0]]);
        assert!(behind.corners.iter().all(|c| c[2].abs() < 1e-5), "{behind:?}");
    }
}
