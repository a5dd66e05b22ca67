//! Where one looks from, and the matrix that follows.

use glam::{DMat4, DVec3, DVec4, Mat4};
use striata::mesh::Bounds;
use striata::view::{Camera, CameraError};

/// An eye that looks at a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Viewpoint {
    /// Where the eye is, mesh units.
    pub eye: [f32; 3],
    /// The point it looks at.
    pub look_at: [f32; 3],
    /// What is up on the screen.
    pub up: [f32; 3],
    /// Angle from the lower to the upper side, radians.
    pub fov: f32,
}

impl Viewpoint {
    /// A portrait: all of a mesh, from the front, turned to a side by `turn` and from above by `rise`, radians.
    pub fn portrait(bounds: &Bounds, turn: f32, rise: f32, fov: f32) -> Self {
        let look_at: [f32; 3] = std::array::from_fn(|axis| (bounds.min[axis] + bounds.max[axis]) / 2.0);
        let radius = (bounds.diagonal() as f32 / 2.0).max(f32::MIN_POSITIVE);
        let distance = radius / (fov / 2.0).sin();
        let direction = [rise.cos() * turn.sin(), rise.sin(), rise.cos() * turn.cos()];
        let eye = std::array::from_fn(|axis| look_at[axis] + distance * direction[axis]);
        Self { eye, look_at, up: [0.0, 1.0, 0.0], fov }
    }

    /// The same view as a criterion of selective refinement takes it, for a screen of `[width, height]` pixels.
    ///
    /// # Errors
    /// What [`Camera::new`] says.
    pub fn camera(&self, screen: [u32; 2]) -> Result<Camera, CameraError> {
        Camera::new(self.eye, self.look_at, self.up, f64::from(self.fov / 2.0).tan(), screen)
    }

    /// From coordinates less `origin` to the clip space of wgpu, near at depth 1 and infinitely far at 0.
    ///
    /// `radius` is the size of what is drawn: the near side is a thousandth of it before the eye, or nearer to what is
    /// drawn where the eye is outside.
    pub fn clip_from_model(&self, origin: [f32; 3], radius: f32, aspect: f32) -> Mat4 {
        let [right, up, back] = self.axes_64();
        let eye = wide(self.eye) - wide(origin);
        let radius = f64::from(radius).max(1e-30);
        let near = (eye.length() - 1.001 * radius).max(radius * 1e-3);
        let high = 1.0 / (f64::from(self.fov) / 2.0).tan();
        let across = high / f64::from(aspect);
        // A row each: x, y, the constant near as z, and the depth as w.
        let row = |axis: DVec3, scale: f64| (scale * axis).extend(-scale * axis.dot(eye));
        let depth = DVec4::new(0.0, 0.0, 0.0, near);
        DMat4::from_cols(row(right, across), row(up, high), depth, row(back, -1.0)).transpose().as_mat4()
    }

    /// The eye less `origin`.
    pub(crate) fn eye_in_model(&self, origin: [f32; 3]) -> [f32; 3] {
        std::array::from_fn(|axis| self.eye[axis] - origin[axis])
    }

    /// The axes of the screen: right, up, and towards the eye.
    pub(crate) fn axes(&self) -> [[f32; 3]; 3] {
        self.axes_64().map(|axis| axis.as_vec3().into())
    }

    fn axes_64(&self) -> [DVec3; 3] {
        let back = (wide(self.eye) - wide(self.look_at)).normalize_or(DVec3::Z);
        let right = wide(self.up).cross(back).normalize_or(back.any_orthonormal_vector());
        [right, back.cross(right), back]
    }
}

fn wide(point: [f32; 3]) -> DVec3 {
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
