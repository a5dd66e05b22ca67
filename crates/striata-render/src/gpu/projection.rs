//! Projection matrices of a camera.

use glam::{DMat4, DVec3, DVec4, Mat4};

use crate::camera::Camera;

impl Camera {
    /// Matrix from coordinates relative to `origin` to wgpu's clip space, with reversed depth: the near plane is
    /// at 1, and what is infinitely far is at 0.
    pub(crate) fn clip_from(&self, origin: DVec3, near: f64, [width, height]: [u32; 2]) -> Mat4 {
        let aspect = f64::from(width.max(1)) / f64::from(height.max(1));
        let [right, up, back] = self.axes();
        let eye = self.eye_64() - origin;
        let high = 1.0 / (f64::from(self.fov).clamp(1e-4, 3.1) / 2.0).tan();
        // One row each: x, y, the constant near distance as z, and the depth as w.
        let row = |axis: DVec3, scale: f64| (scale * axis).extend(-scale * axis.dot(eye));
        let depth = DVec4::new(0.0, 0.0, 0.0, near);
        DMat4::from_cols(row(right, high / aspect), row(up, high), depth, row(back, -1.0))
            .transpose()
            .as_mat4()
    }
}

#[cfg(test)]
mod tests {
    use glam::Vec3;
    use striata::mesh::Bounds;

    use super::*;

    #[test]
    fn a_portrait_shows_the_whole_box_at_any_size() {
        for scale in [1e-7f32, 1.0, 1e7] {
            let bounds = Bounds { min: [-scale, 2.0 * scale, 0.0], max: [scale, 5.0 * scale, scale] };
            let camera = Camera::portrait(&bounds, -0.6, 0.1, 0.5);
            let origin = camera.look_at;
            let matrix =
                camera.clip_from(DVec3::from(origin.map(f64::from)), 1e-3 * f64::from(scale), [1, 1]);
            for corner in 0..8 {
                let point: [f32; 3] = std::array::from_fn(|k| {
                    (if corner >> k & 1 == 0 { bounds.min[k] } else { bounds.max[k] }) - origin[k]
                });
                let clip = matrix * Vec3::from(point).extend(1.0);
                let seen = clip / clip.w;
                assert!(clip.w > 0.0 && seen.x.abs() <= 1.0 && seen.y.abs() <= 1.0, "{scale}: {seen}");
                assert!(seen.z > 0.0 && seen.z < 1.0, "{scale}: {seen}");
            }
        }
    }

    #[test]
    fn right_of_the_eye_is_right_on_the_screen() {
        let camera = Camera { eye: [0.0, 0.0, 5.0], look_at: [0.0; 3], up: [0.0, 1.0, 0.0], fov: 0.8 };
        let clip = camera.clip_from(DVec3::ZERO, 1.0, [3, 2]) * Vec3::new(0.5, 0.25, 0.0).extend(1.0);
        assert!(clip.x > 0.0 && clip.y > 0.0 && clip.w > 0.0);
        assert_eq!(camera.axes()[0], DVec3::X);
    }
}
