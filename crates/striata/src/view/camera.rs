//! Cameras, perspective or orthographic: visibility of bounding spheres and projection of errors to pixels.

use glam::{DMat4, DVec3};

use super::Sphere;

/// Largest cosine of the angle between the axes of a screen that count as perpendicular.
const MAX_SKEW: f64 = 1e-5;

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
    /// The matrices are singular, or a number in them is not finite.
    #[error("the view and projection matrices are singular, or contain a number that is not finite")]
    Singular,
    /// The matrices are neither a perspective nor an orthographic projection, for example because they shear.
    #[error("the view and projection matrices are neither a perspective nor an orthographic projection")]
    Projection,
}

/// A camera without near and far planes: perspective, also off-center as for stereo and VR, or orthographic.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    /// Position; a point on the line through the center of the screen if the camera is orthographic.
    pub(super) eye: DVec3,
    pub(super) forward: DVec3,
    pub(super) right: DVec3,
    pub(super) up: DVec3,
    /// Half the width and height of the screen, at unit distance if the camera is perspective.
    pub(super) half: [f64; 2],
    /// Center of the screen at unit distance, to the right and upward.
    pub(super) shift: [f64; 2],
    /// Pixels per unit of length, at unit distance if the camera is perspective.
    pub(super) pixels: f64,
    pub(super) is_orthographic: bool,
}

impl Camera {
    /// Creates a perspective camera at `eye` that looks at `target`, with `up` pointing upward on its screen
    /// of `[width, height]` pixels.
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
            shift: [0.0; 2],
            pixels: f64::from(height) / (2.0 * tan_half_fov),
            is_orthographic: false,
        })
    }

    /// Creates the camera of a view matrix (from the space of the mesh to the space of the view) and a projection
    /// matrix (to clip space), as an engine hands them to its shaders, for a screen of `[width, height]` pixels.
    /// Both are lists of columns.
    ///
    /// The conventions of OpenGL, Vulkan, WebGPU and Direct3D all work, as do off-center, reversed and infinite
    /// projections, because near and far planes do not matter. An orthographic camera looks along the negative z
    /// axis of its view, or along the positive one if its near plane lies there, at a distance of 0 or more. It
    /// also sees what is in front of its near plane, as the camera of a shadow should.
    ///
    /// # Errors
    /// [`CameraError::Singular`], [`CameraError::Projection`] or [`CameraError::Screen`].
    pub fn from_matrices<T: Into<f64>>(
        view: [[T; 4]; 4],
        projection: [[T; 4]; 4],
        [width, height]: [u32; 2],
    ) -> Result<Self, CameraError> {
        let [view, projection] =
            [view, projection].map(|columns| DMat4::from_cols_array_2d(&columns.map(|c| c.map(Into::into))));
        if width == 0 || height == 0 {
            return Err(CameraError::Screen { width, height });
        }
        let clip = projection * view;
        let [x, y, w] = [0, 1, 3].map(|row| clip.row(row));
        let [x_axis, y_axis, w_axis] = [x, y, w].map(glam::DVec4::truncate);
        let is_orthographic = w_axis == DVec3::ZERO;
        // An orthographic camera looks along the direction that its screen does not show.
        let direction = if is_orthographic {
            let along_z = view.row(2).truncate() * if looks_along_z(&projection) { 1.0 } else { -1.0 };
            let across = x_axis.cross(y_axis);
            across * along_z.dot(across).signum()
        } else {
            w_axis
        };
        let forward = direction.try_normalize().ok_or(CameraError::Singular)?;
        let [right, up] = [x_axis, y_axis].map(|axis| axis.reject_from_normalized(forward));
        let depth_scale = if is_orthographic { w.w } else { w_axis.length() };
        let half = [right, up].map(|axis| depth_scale / axis.length());
        let shift =
            [(x_axis, right), (y_axis, up)].map(|(axis, across)| -axis.dot(forward) / across.length());
        let (right, up) = right.try_normalize().zip(up.try_normalize()).ok_or(CameraError::Singular)?;
        if right.dot(up).abs() > MAX_SKEW || depth_scale < 0.0 {
            return Err(CameraError::Projection);
        }
        // The eye is where all three rows are 0; the line through the center of the screen where two are.
        let eye = if is_orthographic {
            let position = view.inverse().transform_point3(DVec3::ZERO);
            let off =
                [(x, half[0]), (y, half[1])].map(|(row, half)| row.dot(position.extend(1.0)) * half / w.w);
            position - right * off[0] - up * off[1]
        } else {
            glam::DMat3::from_cols(x_axis, y_axis, w_axis).transpose().inverse() * -DVec3::new(x.w, y.w, w.w)
        };
        let up = forward.cross(right) * forward.cross(right).dot(up).signum();
        let pixels = (f64::from(width) / half[0]).max(f64::from(height) / half[1]) / 2.0;
        let camera = Self { eye, forward, right, up, half, shift, pixels, is_orthographic }.upright();
        let is_valid = camera.half.iter().all(|half| *half > 0.0)
            && [eye.length(), pixels, half[0], half[1], shift[0], shift[1]]
                .iter()
                .all(|number| number.is_finite());
        is_valid.then_some(camera).ok_or(CameraError::Singular)
    }

    /// Returns the camera with the handedness of [`new`](Self::new), which images that are upside down lack.
    fn upright(self) -> Self {
        if self.right.cross(self.up).dot(self.forward) < 0.0 {
            return self;
        }
        Self { up: -self.up, shift: [self.shift[0], -self.shift[1]], ..self }
    }

    /// Position of the camera. If it is orthographic, a point on the line through the center of its screen.
    pub fn eye(&self) -> [f32; 3] {
        self.eye.as_vec3().into()
    }

    /// Whether all lines of sight are parallel.
    pub fn is_orthographic(&self) -> bool {
        self.is_orthographic
    }

    /// Whether any part of a sphere can be on the screen.
    pub fn may_see(&self, sphere: &Sphere) -> bool {
        let to = self.offset_to(sphere);
        let radius = f64::from(sphere.radius);
        let [depth, x, y] = [self.forward, self.right, self.up].map(|axis| to.dot(axis));
        let reach = radius + 1e-9 * (to.length() + radius);
        // The signed offset from a side of the screen is the distance to the side plane, times the length of the
        // plane's normal.
        let is_within = |across: f64, side: f64| {
            if self.is_orthographic {
                across - side <= reach
            } else {
                across - side * depth <= reach * (1.0 + side * side).sqrt()
            }
        };
        let is_between = |across: f64, i: usize| {
            is_within(across, self.half[i] + self.shift[i])
                && is_within(-across, self.half[i] - self.shift[i])
        };
        (self.is_orthographic || depth >= -reach) && is_between(x, 0) && is_between(y, 1)
    }

    /// Upper bound, in pixels, for the error on the screen of a sphere whose points are off by `error` mesh
    /// units.
    ///
    /// `error` must be small compared with the distance. If the camera is perspective, the bound is infinite if
    /// the eye is inside the sphere. On a flat screen, an offset appears larger away from the view axis: by one
    /// over the squared cosine of the angle, once because the screen is inclined and once because the depth is
    /// smaller than the distance.
    pub fn error_px(&self, error: f32, sphere: &Sphere) -> f32 {
        if self.is_orthographic {
            return (f64::from(error) * self.pixels) as f32;
        }
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
        // Lengths on the screen of a perspective camera are ratios.
        let scale = if self.is_orthographic { matrix.transform_vector3(self.forward).length() } else { 1.0 };
        let (half, pixels) = (self.half.map(|half| half * scale), self.pixels / scale);
        Self { eye: matrix.transform_point3(self.eye), forward, right, up, half, pixels, ..*self }
    }

    /// Cosine of the angle between the view axis and the farthest corner of the screen.
    pub(super) fn corner_cos(&self) -> f64 {
        let [x, y] = self.sides();
        1.0 / (1.0 + x.powi(2) + y.powi(2)).sqrt()
    }

    /// Largest distances of the sides of the screen from the view axis at unit distance.
    pub(super) fn sides(&self) -> [f64; 2] {
        [0, 1].map(|i| self.half[i] + self.shift[i].abs())
    }

    fn offset_to(&self, sphere: &Sphere) -> DVec3 {
        DVec3::from(sphere.center.map(f64::from)) - self.eye
    }

    /// Position of a point on the screen, from -1 to 1 in both directions; `None` if it is behind the eye.
    #[cfg(test)]
    fn project(&self, point: [f32; 3]) -> Option<[f64; 2]> {
        let to = self.offset_to(&Sphere::point(point));
        let depth = if self.is_orthographic { 1.0 } else { to.dot(self.forward) };
        let on_screen = |i: usize, axis: DVec3| (to.dot(axis) / depth - self.shift[i]) / self.half[i];
        (depth > 0.0).then(|| [on_screen(0, self.right), on_screen(1, self.up)])
    }
}

/// Whether an orthographic projection looks along the positive z axis of its view, as is usual in Direct3D: if its
/// near plane lies there. Depth grows from 0 or -1 at the near plane, or falls from 1.
fn looks_along_z(projection: &DMat4) -> bool {
    let (slope, at_eye) = (projection.z_axis.z, projection.w_axis.z);
    (slope > 0.0 && at_eye <= 0.0) || (slope < 0.0 && at_eye >= 1.0)
}

#[cfg(test)]
mod tests {
    use glam::dcamera::{lh, rh};

    use super::*;
    use crate::mesh::Random;

    const EYE: DVec3 = DVec3::new(3.0, -5.0, 2.0);

    fn camera() -> Camera {
        Camera::new(EYE.as_vec3().into(), [0.5, 0.0, 0.0], [0.0, 0.0, 1.0], 0.4, [1600, 900]).unwrap()
    }

    fn view_matrix() -> DMat4 {
        rh::view::look_at_mat4(EYE, DVec3::new(0.5, 0.0, 0.0), DVec3::Z)
    }

    /// A projection with 0.4 for the tangent of half the field of view, then an off-center one and an orthographic one.
    fn projections() -> [DMat4; 3] {
        let fov = 2.0 * 0.4f64.atan();
        [
            rh::proj::directx::perspective(fov, 1600.0 / 900.0, 0.1, 100.0),
            rh::proj::directx::frustum(-0.05, 0.09, -0.06, 0.02, 0.1, 100.0),
            rh::proj::directx::orthographic(-1.0, 4.0, -2.0, 1.0, -3.0, 60.0),
        ]
    }

    fn from_matrices(view: DMat4, projection: DMat4) -> Result<Camera, CameraError> {
        Camera::from_matrices(view.to_cols_array_2d(), projection.to_cols_array_2d(), [1600, 900])
    }

    fn cameras() -> Vec<Camera> {
        let others = projections().map(|projection| from_matrices(view_matrix(), projection).unwrap());
        std::iter::once(camera()).chain(others).collect()
    }

    fn is_close(a: &Camera, b: &Camera) -> bool {
        let numbers = |camera: &Camera| {
            let directions = [camera.forward, camera.right, camera.up, camera.eye].map(|v| v.to_array());
            let Camera { half: [width, height], shift: [x, y], pixels, .. } = *camera;
            [directions.as_flattened(), &[width, height, x, y, pixels]].concat()
        };
        a.is_orthographic == b.is_orthographic
            && numbers(a).iter().zip(numbers(b)).all(|(a, b)| (a - b).abs() < 1e-4 * (1.0 + b.abs()))
    }

    #[test]
    fn all_conventions_of_matrices_give_the_same_camera() {
        let (view, fov, aspect) = (view_matrix(), 2.0 * 0.4f64.atan(), 1600.0 / 900.0);
        let flip_y = DMat4::from_scale(DVec3::new(1.0, -1.0, 1.0));
        let flip_z = DMat4::from_scale(DVec3::new(1.0, 1.0, -1.0));
        let reversed = DMat4::from_translation(DVec3::Z) * flip_z;
        let perspective = rh::proj::directx::perspective(fov, aspect, 0.1, 100.0);
        let perspectives = [
            (view, perspective),
            (view, rh::proj::opengl::perspective(fov, aspect, 0.1, 100.0)),
            (view, rh::proj::directx::perspective_infinite(fov, aspect, 0.1)),
            (view, rh::proj::directx::perspective_infinite_reverse(fov, aspect, 0.1)),
            (view, flip_y * perspective),
            (flip_z * view, lh::proj::directx::perspective(fov, aspect, 0.1, 100.0)),
            (DMat4::from_scale(DVec3::splat(7.0)) * view, perspective),
        ];
        for (i, (view, projection)) in perspectives.into_iter().enumerate() {
            let made = from_matrices(view, projection).unwrap();
            assert!(is_close(&made, &camera()), "{i}: {made:?}, not {:?}", camera());
            let [view, projection] = [view, projection].map(|matrix| matrix.as_mat4().to_cols_array_2d());
            assert!(
                is_close(&Camera::from_matrices(view, projection, [1600, 900]).unwrap(), &camera()),
                "{i}"
            );
        }
        for (near, far) in [(0.0, 20.0), (1.0, 20.0), (-20.0, 20.0), (-5.0, 20.0)] {
            let flat = rh::proj::directx::orthographic(-1.0, 4.0, -2.0, 1.0, near, far);
            let expected = from_matrices(view, flat).unwrap();
            assert!(expected.is_orthographic() && (expected.forward - camera().forward).length() < 1e-9);
            let gl = rh::proj::opengl::orthographic(-1.0, 4.0, -2.0, 1.0, near, far);
            let mut all = vec![(view, gl), (view, reversed * flat), (view, flip_y * flat)];
            if near >= 0.0 {
                let left_handed = lh::proj::directx::orthographic(-1.0, 4.0, -2.0, 1.0, near, far);
                all.extend([(flip_z * view, left_handed), (flip_z * view, reversed * left_handed)]);
            }
            for (i, (view, projection)) in all.into_iter().enumerate() {
                let made = from_matrices(view, projection).unwrap();
                assert!(is_close(&made, &expected), "{near}, {i}: {made:?}, not {expected:?}");
            }
        }
    }

    #[test]
    fn cameras_project_points_as_their_matrices_do() {
        let mut random = Random::new(6);
        for (projection, camera) in projections().into_iter().zip(&cameras()[1..]) {
            for _ in 0..1000 {
                let point = point(&mut random, 20.0);
                let clip = projection * view_matrix() * DVec3::from(point.map(f64::from)).extend(1.0);
                let Some(at) = camera.project(point) else {
                    assert!(clip.w <= 1e-6);
                    continue;
                };
                let expected = [clip.x / clip.w, clip.y / clip.w];
                let is_close = |i: usize| (at[i] - expected[i]).abs() < 1e-6 * (1.0 + at[i].abs());
                assert!(is_close(0) && is_close(1), "{at:?}, not {expected:?}: {camera:?}");
            }
        }
    }

    #[test]
    fn invalid_matrices_are_rejected() {
        let (view, [perspective, _, flat]) = (view_matrix(), projections());
        let shear = DMat4::from_cols_array_2d(&[
            [1.0, 0.0, 0.0, 0.0],
            [0.3, 1.0, 0.0, 0.0],
            [0.0, 0.0, 1.0, 0.0],
            [0.0, 0.0, 0.0, 1.0],
        ]);
        for projection in [perspective, flat] {
            assert_eq!(from_matrices(view, projection * shear), Err(CameraError::Projection));
            assert_eq!(from_matrices(view, DMat4::ZERO), Err(CameraError::Singular));
            assert_eq!(from_matrices(DMat4::ZERO, projection), Err(CameraError::Singular));
            assert_eq!(from_matrices(view * f64::NAN, projection), Err(CameraError::Singular));
            assert_eq!(from_matrices(view * f64::INFINITY, projection), Err(CameraError::Singular));
            let one_axis = DMat4::from_scale(DVec3::new(1.0, 0.0, 1.0)) * projection;
            assert_eq!(from_matrices(view, one_axis), Err(CameraError::Singular));
            let made = Camera::from_matrices(view.to_cols_array_2d(), projection.to_cols_array_2d(), [0, 9]);
            assert_eq!(made, Err(CameraError::Screen { width: 0, height: 9 }));
        }
        assert_eq!(from_matrices(view, -flat), Err(CameraError::Projection));
    }

    fn point(random: &mut Random, spread: f64) -> [f32; 3] {
        [(); 3].map(|()| ((random.unit() - 0.5) * spread) as f32)
    }

    #[test]
    fn visible_points_are_never_culled() {
        let mut random = Random::new(4);
        let cameras = cameras();
        let mut unseen = [0; 4];
        for round in 0..80_000 {
            let camera = &cameras[round % 4];
            let (center, other) = (point(&mut random, 30.0), point(&mut random, 3.0));
            let inside = [0, 1, 2].map(|i| center[i] + other[i]);
            let sphere = Sphere::point(center).with_point(inside);
            let on_screen = camera.project(inside).is_some_and(|p| p.iter().all(|x| x.abs() <= 1.0));
            assert!(!on_screen || camera.may_see(&sphere), "{inside:?} in {sphere:?}");
            unseen[round % 4] += usize::from(!camera.may_see(&sphere));
        }
        assert!(unseen.iter().all(|count| *count > 10_000), "only {unseen:?} of 20,000 are culled");
    }

    #[test]
    fn errors_in_pixels_are_upper_bounds() {
        let mut random = Random::new(5);
        let cameras = cameras();
        let (mut seen, mut tight) = ([0; 4], [0.0f64; 4]);
        for round in 0..160_000 {
            let camera = &cameras[round % 4];
            let (center, other) = (point(&mut random, 20.0), point(&mut random, 1.0));
            let inside = [0, 1, 2].map(|i| center[i] + other[i]);
            let sphere = Sphere::point(center).with_point(inside);
            let off = DVec3::from(point(&mut random, 1.0).map(f64::from)).normalize() * 1e-3;
            let moved = (DVec3::from(inside.map(f64::from)) + off).as_vec3().into();
            let (Some(a), Some(b)) = (camera.project(inside), camera.project(moved)) else { continue };
            if a.iter().chain(&b).any(|x| x.abs() > 1.0) {
                continue;
            }
            seen[round % 4] += 1;
            let pixels = ((a[0] - b[0]) * 800.0).hypot((a[1] - b[1]) * 450.0);
            let bound = f64::from(camera.error_px(1e-3, &sphere));
            // The error is not infinitely small compared with the distance, and positions are rounded.
            assert!(pixels <= bound * 1.01 + 1e-3, "{pixels} px, above the bound of {bound}");
            tight[round % 4] = tight[round % 4].max(pixels / bound);
        }
        let is_tight = tight.iter().all(|tight| *tight > 0.8);
        assert!(
            seen.iter().all(|seen| *seen > 500) && is_tight,
            "{seen:?} seen, the tightest at {tight:?} of the bound"
        );
        let around = Sphere { center: [3.0, -5.0, 2.1], radius: 0.2 };
        assert_eq!(camera().error_px(1e-9, &around), f32::INFINITY);
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
