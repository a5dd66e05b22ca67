//! A perspective camera: visibility of bounding spheres and projection of errors to pixels.

use glam::{DMat4, DVec3};

use super::Sphere;

/// Why a camera cannot be created.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum CameraError {
    /// The eye equals the target, `up` is parallel to the view direction, or a coordinate is not finite.
    #[error("the eye, target and up vectors do not define a view direction")]
    NoDirection,
    /// The field of view is empty, or 180 degrees or more.
    #[error("cannot project a field of view whose half angle has the tangent {tan}")]
    FieldOfView {
        /// Tangent of half the vertical field of view.
        tan: f64,
    },
    /// The screen has no pixels.
    #[error("the screen has {width} x {height} pixels, but needs at least 1 x 1")]
    Screen {
        /// Width in pixels.
        width: u32,
        /// Height in pixels.
        height: u32,
    },
}

/// A perspective camera without near and far planes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    pub(super) eye: DVec3,
    pub(super) forward: DVec3,
    pub(super) right: DVec3,
    pub(super) up: DVec3,
    /// Half the width and height of the screen at unit distance.
    pub(super) half: [f64; 2],
    /// Pixels per unit of length at unit distance.
    pub(super) pixels: f64,
}

impl Camera {
    /// Creates a camera at `eye` that looks at `target`, with `up` pointing upward on its screen of
    /// `[width, height]` pixels.
    ///
    /// `tan_half_fov` is the tangent of half the vertical field of view: 0.577 for 60 degrees.
    ///
    /// # Errors
    /// [`CameraError`] if the directions, the field of view or the screen are invalid.
    pub fn new(
        eye: [f32; 3],
        target: [f32; 3],
        up: [f32; 3],
        tan_half_fov: f64,
        [width, height]: [u32; 2],
    ) -> Result<Self, CameraError> {
        let [eye, target, up] = [eye, target, up].map(|p| DVec3::from(p.map(f64::from)));
        let forward = (target - eye).try_normalize().ok_or(CameraError::NoDirection)?;
        let right = forward.cross(up).try_normalize().ok_or(CameraError::NoDirection)?;
        if !(tan_half_fov > 0.0 && tan_half_fov.is_finite()) {
            return Err(CameraError::FieldOfView { tan: tan_half_fov });
        }
        if width == 0 || height == 0 {
            return Err(CameraError::Screen { width, height });
        }
        let aspect = f64::from(width) / f64::from(height);
        Ok(Self {
            eye,
            forward,
            right,
            up: right.cross(forward),
            half: [tan_half_fov * aspect, tan_half_fov],
            pixels: f64::from(height) / (2.0 * tan_half_fov),
        })
    }

    /// Position of the camera.
    pub fn eye(&self) -> [f32; 3] {
        self.eye.as_vec3().into()
    }

    /// Whether any part of a sphere can be on the screen.
    pub fn may_see(&self, sphere: &Sphere) -> bool {
        let to = self.offset_to(sphere);
        let radius = f64::from(sphere.radius);
        let [depth, x, y] = [self.forward, self.right, self.up].map(|axis| to.dot(axis));
        let slack = 1e-9 * (to.length() + radius);
        // `across - half * depth` is the distance to the side plane, times the length of the plane's normal.
        let is_within = |across: f64, half: f64| {
            across.abs() - half * depth <= (radius + slack) * (1.0 + half * half).sqrt()
        };
        depth >= -(radius + slack) && is_within(x, self.half[0]) && is_within(y, self.half[1])
    }

    /// Upper bound, in pixels, for the error on the screen of a sphere whose points are off by `error` mesh
    /// units.
    ///
    /// `error` must be small compared with the distance. The bound is infinite if the eye is inside the
    /// sphere. On a flat screen, an offset appears larger away from the view axis: by one over the squared
    /// cosine of the angle, once because the screen is inclined and once because the depth is smaller than
    /// the distance.
    pub fn error_px(&self, error: f32, sphere: &Sphere) -> f32 {
        let (to, radius) = (self.offset_to(sphere), f64::from(sphere.radius));
        let distance = to.length();
        if distance <= radius {
            return f32::INFINITY;
        }
        // No point of the sphere is farther from the view axis than this, and no visible point is beyond
        // the screen's corner.
        let cos = ((to.dot(self.forward) - radius) / (distance + radius)).max(self.corner_cos());
        (f64::from(error) * self.pixels / ((distance - radius) * cos * cos)) as f32
    }

    /// Returns the camera in another space; `matrix` is a rotation with a translation and a uniform scale.
    pub(super) fn moved(&self, matrix: &DMat4) -> Self {
        let turned = |direction: DVec3| matrix.transform_vector3(direction).normalize();
        let [forward, right, up] = [self.forward, self.right, self.up].map(turned);
        Self { eye: matrix.transform_point3(self.eye), forward, right, up, ..*self }
    }

    /// Cosine of the angle between the view axis and a corner of the screen.
    pub(super) fn corner_cos(&self) -> f64 {
        1.0 / (1.0 + self.half[0].powi(2) + self.half[1].powi(2)).sqrt()
    }

    fn offset_to(&self, sphere: &Sphere) -> DVec3 {
        DVec3::from(sphere.center.map(f64::from)) - self.eye
    }

    /// Position of a point on the screen, from -1 to 1 in both directions; `None` if it is behind the eye.
    #[cfg(test)]
    fn project(&self, point: [f32; 3]) -> Option<[f64; 2]> {
        let to = self.offset_to(&Sphere::point(point));
        let depth = to.dot(self.forward);
        (depth > 0.0)
            .then(|| [to.dot(self.right) / (depth * self.half[0]), to.dot(self.up) / (depth * self.half[1])])
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::Random;

    fn camera() -> Camera {
        Camera::new([3.0, -5.0, 2.0], [0.5, 0.0, 0.0], [0.0, 0.0, 1.0], 0.4, [1600, 900]).unwrap()
    }

    fn point(random: &mut Random, spread: f64) -> [f32; 3] {
        [(); 3].map(|()| ((random.unit() - 0.5) * spread) as f32)
    }

    #[test]
    fn visible_points_are_never_culled() {
        let (camera, mut random) = (camera(), Random::new(4));
        let mut unseen = 0;
        for _ in 0..20_000 {
            let (center, other) = (point(&mut random, 30.0), point(&mut random, 3.0));
            let inside = [0, 1, 2].map(|i| center[i] + other[i]);
            let sphere = Sphere::point(center).with_point(inside);
            let on_screen = camera.project(inside).is_some_and(|p| p.iter().all(|x| x.abs() <= 1.0));
            assert!(!on_screen || camera.may_see(&sphere), "{inside:?} in {sphere:?}");
            unseen += usize::from(!camera.may_see(&sphere));
        }
        assert!(unseen > 10_000, "only {unseen} of 20,000 are culled");
    }

    #[test]
    fn errors_in_pixels_are_upper_bounds() {
        let (camera, mut random) = (camera(), Random::new(5));
        let (mut seen, mut tight) = (0, 0.0f64);
        for _ in 0..40_000 {
            let (center, other) = (point(&mut random, 20.0), point(&mut random, 1.0));
            let inside = [0, 1, 2].map(|i| center[i] + other[i]);
            let sphere = Sphere::point(center).with_point(inside);
            let off = DVec3::from(point(&mut random, 1.0).map(f64::from)).normalize() * 1e-3;
            let moved = (DVec3::from(inside.map(f64::from)) + off).as_vec3().into();
            let (Some(a), Some(b)) = (camera.project(inside), camera.project(moved)) else { continue };
            if a.iter().chain(&b).any(|x| x.abs() > 1.0) {
                continue;
            }
            seen += 1;
            let pixels = ((a[0] - b[0]) * 800.0).hypot((a[1] - b[1]) * 450.0);
            let bound = f64::from(camera.error_px(1e-3, &sphere));
            // The error is not infinitely small compared with the distance, and positions are rounded.
            assert!(pixels <= bound * 1.01 + 1e-3, "{pixels} px, above the bound of {bound}");
            tight = tight.max(pixels / bound);
        }
        assert!(seen > 1000 && tight > 0.8, "{seen} seen, the tightest at {tight} of the bound");
        let around = Sphere { center: [3.0, -5.0, 2.1], radius: 0.2 };
        assert_eq!(camera.error_px(1e-9, &around), f32::INFINITY);
    }

    #[test]
    fn invalid_cameras_are_rejected() {
        let make = |target: [f32; 3], tan: f64, screen: [u32; 2]| {
            Camera::new([0.0; 3], target, [0.0, 0.0, 1.0], tan, screen)
        };
        assert_eq!(make([0.0; 3], 0.5, [1, 1]), Err(CameraError::NoDirection));
        assert_eq!(make([0.0, 0.0, 2.0], 0.5, [1, 1]), Err(CameraError::NoDirection));
        assert_eq!(make([f32::NAN, 0.0, 2.0], 0.5, [1, 1]), Err(CameraError::NoDirection));
        assert_eq!(make([1.0, 0.0, 0.0], 0.0, [1, 1]), Err(CameraError::FieldOfView { tan: 0.0 }));
        assert_eq!(make([1.0, 0.0, 0.0], 1.0, [0, 9]), Err(CameraError::Screen { width: 0, height: 9 }));
        assert!(make([1.0, 0.0, 0.0], 1.0, [16, 9]).is_ok());
    }
}
