//! A camera: what of a sphere can be on the screen, and how large an error is there.

use glam::DVec3;

use super::Sphere;

/// A camera cannot look.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum CameraError {
    /// The eye is where it looks, or `up` is along its sight, or one of them is no number.
    #[error("the eye, what it looks at and what is up give no direction")]
    NoDirection,
    /// The field of view is empty, or half the world or more.
    #[error("a field of view with a half of {tan} a unit away cannot be projected")]
    FieldOfView {
        /// Tangent of half the angle from the lower to the upper side.
        tan: f64,
    },
    /// The screen has no pixels.
    #[error("the screen has {width} x {height} pixels")]
    Screen {
        /// Its width.
        width: u32,
        /// Its height.
        height: u32,
    },
}

/// An eye with a screen: a perspective projection without a near or a far side.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    pub(super) eye: DVec3,
    pub(super) forward: DVec3,
    pub(super) right: DVec3,
    pub(super) up: DVec3,
    /// Half the screen's width and height, one unit away.
    pub(super) half: [f64; 2],
    /// Pixels that a unit takes, one unit away.
    pub(super) pixels: f64,
}

impl Camera {
    /// A camera at `eye` that looks at `target`, `up` upwards on its screen of `[width, height]` pixels.
    ///
    /// `tan_half_fov` is the tangent of half the angle of view from the lower to the upper side: 0.577 for 60 degrees.
    ///
    /// # Errors
    /// [`CameraError`] where the directions, the field of view or the screen make no picture.
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

    /// Where it is.
    pub fn eye(&self) -> [f32; 3] {
        self.eye.as_vec3().into()
    }

    /// Whether anything in a sphere can be on the screen.
    pub fn may_see(&self, sphere: &Sphere) -> bool {
        let to = self.to(sphere);
        let radius = f64::from(sphere.radius);
        let [depth, x, y] = [self.forward, self.right, self.up].map(|axis| to.dot(axis));
        let slack = 1e-9 * (to.length() + radius);
        // A side of the picture leans by its half: a point is beyond it by so much, times the side's length.
        let is_within = |across: f64, half: f64| {
            across.abs() - half * depth <= (radius + slack) * (1.0 + half * half).sqrt()
        };
        depth >= -(radius + slack) && is_within(x, self.half[0]) && is_within(y, self.half[1])
    }

    /// The most pixels by which a point of a sphere can move on the screen where it is off by an error, mesh units, which is
    /// small against its distance; infinite where the eye is in the sphere.
    ///
    /// On a flat screen a point off the sight moves more than one as far away on it: by the square of the cosine of the
    /// angle between, once for the screen that leans and once for the depth that is less.
    pub fn error_px(&self, error: f32, sphere: &Sphere) -> f32 {
        let (to, radius) = (self.to(sphere), f64::from(sphere.radius));
        let distance = to.length();
        if distance <= radius {
            return f32::INFINITY;
        }
        // No point of the sphere lies farther off the sight than this, and none on the screen beyond its corner.
        let cos = ((to.dot(self.forward) - radius) / (distance + radius)).max(self.corner_cos());
        (f64::from(error) * self.pixels / ((distance - radius) * cos * cos)) as f32
    }

    /// Cosine of the angle between the sight and a corner of the screen.
    pub(super) fn corner_cos(&self) -> f64 {
        1.0 / (1.0 + self.half[0].powi(2) + self.half[1].powi(2)).sqrt()
    }

    fn to(&self, sphere: &Sphere) -> DVec3 {
        DVec3::from(sphere.center.map(f64::from)) - self.eye
    }

    /// Where a point is on the screen, from -1 to 1 each way; `None` behind the eye.
    #[cfg(test)]
    fn project(&self, point: [f32; 3]) -> Option<[f64; 2]> {
        let to = self.to(&Sphere::point(point));
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
    fn what_is_on_the_screen_is_never_called_invisible() {
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
        assert!(unseen > 10_000, "only {unseen} of 20,000 are told to be unseen");
    }

    #[test]
    fn an_error_is_never_told_too_small() {
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
            let told = f64::from(camera.error_px(1e-3, &sphere));
            // The error is small against the distance, but not nothing, and its ends are rounded.
            assert!(pixels <= told * 1.01 + 1e-3, "{pixels} px, but told {told}");
            tight = tight.max(pixels / told);
        }
        assert!(seen > 1000 && tight > 0.8, "{seen} seen, the nearest at {tight} of what is told");
        let around = Sphere { center: [3.0, -5.0, 2.1], radius: 0.2 };
        assert_eq!(camera.error_px(1e-9, &around), f32::INFINITY);
    }

    #[test]
    fn a_camera_that_cannot_look_is_refused() {
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
