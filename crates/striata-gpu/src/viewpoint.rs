//! Camera position and its projection matrix.

use glam::{DMat4, DVec3, DVec4, Mat4};
use striata::mesh::Bounds;
use striata::view::{Camera, CameraError};

/// A perspective camera that looks at a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Viewpoint {
    /// Position of the eye, mesh units.
    pub eye: [f32; 3],
    /// Point in the middle of the screen, mesh units.
    pub look_at: [f32; 3],
    /// Direction that points up on the screen.
    pub up: [f32; 3],
    /// Vertical field of view, radians.
    pub fov: f32,
}

impl Viewpoint {
    /// Shows all of a mesh from the front, rotated sideways by `turn` and seen from above by `rise`, both
    /// in radians.
    pub fn portrait(bounds: &Bounds, turn: f32, rise: f32, fov: f32) -> Self {
        let look_at: [f32; 3] = std::array::from_fn(|axis| (bounds.min[axis] + bounds.max[axis]) / 2.0);
        let radius = (bounds.diagonal() as f32 / 2.0).max(f32::MIN_POSITIVE);
        let distance = radius / (fov / 2.0).sin();
        let direction = [rise.cos() * turn.sin(), rise.sin(), rise.cos() * turn.cos()];
        let eye = std::array::from_fn(|axis| look_at[axis] + distance * direction[axis]);
        Self { eye, look_at, up: [0.0, 1.0, 0.0], fov }
    }

    /// Camera for the criteria of selective refinement, for a screen of `[width, height]` pixels.
    ///
    /// # Errors
    /// Fails like [`Camera::new`].
    pub fn camera(&self, screen: [u32; 2]) -> Result<Camera, CameraError> {
        Camera::new(self.eye, self.look_at, self.up, f64::from(self.fov / 2.0).tan(), screen)
    }

    /// Matrix from coordinates relative to `origin` to wgpu's clip space, with reversed depth: near is 1,
    /// infinitely far is 0.
    ///
    /// `radius` is the size of the mesh. The near plane is a thousandth of it in front of the eye, or just
    /// in front of the mesh if the eye is outside.
    pub fn clip_from_model(&self, origin: [f32; 3], radius: f32, aspect: f32) -> Mat4 {
        let [right, up, back] = self.axes_64();
        let eye = to_f64(self.eye) - to_f64(origin);
        let radius = f64::from(radius).max(1e-30);
        let near = (eye.length() - 1.001 * radius).max(radius * 1e-3);
        let high = 1.0 / (f64::from(self.fov) / 2.0).tan();
        let across = high / f64::from(aspect);
        // One row each: x, y, the constant near distance as z, and the depth as w.
        let row = |axis: DVec3, scale: f64| (scale * axis).extend(-scale * axis.dot(eye));
        let depth = DVec4::new(0.0, 0.0, 0.0, near);
        DMat4::from_cols(row(right, across), row(up, high), depth, row(back, -1.0)).transpose().as_mat4()
    }

    /// Eye position relative to `origin`.
    pub(crate) fn eye_in_model(&self, origin: [f32; 3]) -> [f32; 3] {
        std::array::from_fn(|axis| self.eye[axis] - origin[axis])
    }

    /// Axes of the screen: right, up, and toward the eye.
    pub(crate) fn axes(&self) -> [[f32; 3]; 3] {
        self.axes_64().map(|axis| axis.as_vec3().into())
    }

    fn axes_64(&self) -> [DVec3; 3] {
        let back = (to_f64(self.eye) - to_f64(self.look_at)).normalize_or(DVec3::Z);
        let right = to_f64(self.up).cross(back).normalize_or(back.any_orthonormal_vector());
        [right, back.cross(right), back]
    }
}

fn to_f64(point: [f32; 3]) -> DVec3 {
    DVec3::from(point.map(f64::from))
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::Vec3;

    #[test]
    fn a_portrait_shows_the_whole_box_at_any_size() {
        for scale in [1e-7f32, 1.0, 1e7] {
            let bounds = Bounds { min: [-scale, 2.0 * scale, 0.0], max: [scale, 5.0 * scale, scale] };
            let view = Viewpoint::portrait(&bounds, -0.6, 0.1, 0.5);
            let origin = view.look_at;
            let matrix = view.clip_from_model(origin, bounds.diagonal() as f32 / 2.0, 1.0);
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
        let view = Viewpoint { eye: [0.0, 0.0, 5.0], look_at: [0.0; 3], up: [0.0, 1.0, 0.0], fov: 0.8 };
        let clip = view.clip_from_model([0.0; 3], 1.0, 1.5) * Vec3::new(0.5, 0.25, 0.0).extend(1.0);
        assert!(clip.x > 0.0 && clip.y > 0.0 && clip.w > 0.0);
        assert_eq!(view.axes()[0], [1.0, 0.0, 0.0]);
    }
}
