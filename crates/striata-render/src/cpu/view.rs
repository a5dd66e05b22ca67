//! A camera over the samples of a picture.

use glam::{DVec3, Vec3};

use crate::camera::{Axes, Camera, to_f64};
use crate::shot::Shot;

/// Downsampling factor: each final pixel is the mean of a square of this many samples per side.
pub(crate) const DOWNSAMPLING: usize = 3;

/// A camera as three axes and a scale.
pub(crate) struct View {
    axes: Axes,
    pub eye: DVec3,
    /// Samples per unit at distance 1.
    pub scale: f64,
    center: [f64; 2],
    /// Distance of the near plane.
    near: f64,
}

/// A point on the screen: sample coordinates and inverse depth.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ScreenPoint {
    pub x: f32,
    pub y: f32,
    pub inverse_depth: f32,
}

impl View {
    pub(crate) fn new(shot: &Shot<'_>, camera: &Camera, [width, height]: [usize; 2]) -> Self {
        let (middle, radius) = shot.vertices.bounds().map_or((DVec3::ZERO, 1.0), |bounds| {
            ((to_f64(bounds.min) + to_f64(bounds.max)) / 2.0, bounds.diagonal() / 2.0)
        });
        Self {
            axes: camera.axes(),
            eye: camera.eye_64(),
            scale: height as f64 / 2.0 / (f64::from(camera.fov) / 2.0).tan(),
            center: [width as f64 / 2.0, height as f64 / 2.0],
            near: camera.near_plane(middle, radius),
        }
    }

    /// Transforms a point to camera space: x right, y up, z toward the eye.
    pub(crate) fn to_camera_space(&self, point: [f32; 3]) -> Vec3 {
        self.turned(to_f64(point) - self.eye)
    }

    /// Transforms a direction to camera space.
    pub(crate) fn turned(&self, direction: DVec3) -> Vec3 {
        DVec3::from(self.axes.map(|axis| axis.dot(direction))).as_vec3()
    }

    /// Transforms a direction in camera space to world space.
    pub(crate) fn to_world(&self, v: Vec3) -> Vec3 {
        let [right, up, back] = self.axes.map(|axis| axis.as_vec3());
        v.x * right + v.y * up + v.z * back
    }

    /// Returns the ray through a sample, in camera space.
    pub(crate) fn ray(&self, [x, y]: [f64; 2]) -> DVec3 {
        DVec3::new((x - self.center[0]) / self.scale, (self.center[1] - y) / self.scale, -1.0)
    }

    /// Projects a point in camera space to the screen.
    pub(crate) fn project(&self, point: Vec3) -> ScreenPoint {
        let DVec3 { x, y, z } = point.as_dvec3();
        ScreenPoint {
            x: (self.center[0] - self.scale * x / z) as f32,
            y: (self.center[1] + self.scale * y / z) as f32,
            inverse_depth: (-1.0 / z) as f32,
        }
    }

    /// Whether a point is beyond the near plane.
    pub(crate) fn is_inside(&self, point: Vec3) -> bool {
        f64::from(-point.z) >= self.near
    }

    /// Clips a triangle at the near plane, as a GPU does; returns up to two triangles.
    pub(crate) fn clip(&self, corners: [Vec3; 3]) -> impl Iterator<Item = [Vec3; 3]> + use<> {
        let (mut polygon, mut count) = ([Vec3::ZERO; 4], 0);
        let mut push = |point: Vec3| {
            polygon[count] = point;
            count += 1;
        };
        for (from, to) in [0, 1, 2].map(|k| (corners[k], corners[(k + 1) % 3])) {
            if self.is_inside(from) {
                push(from);
            }
            if self.is_inside(from) != self.is_inside(to) {
                // From the inside, so that both triangles of a side get the same point.
                let [a, b] = if self.is_inside(from) { [from, to] } else { [to, from] }.map(|p| p.as_dvec3());
                push(a.lerp(b, (-a.z - self.near) / (b.z - a.z)).as_vec3());
            }
        }
        (2..count).map(move |k| [polygon[0], polygon[k - 1], polygon[k]])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn clipped(corners: [Vec3; 3], near: f64) -> Vec<[Vec3; 3]> {
        let (axes, eye) = ([DVec3::X, DVec3::Y, DVec3::Z], DVec3::ZERO);
        View { axes, eye, scale: 1.0, center: [0.0; 2], near }.clip(corners).collect()
    }

    #[test]
    fn clipping_gives_the_expected_areas() {
        let point = |x: f32, z: f32| Vec3::new(x, -1.0, z);
        let area = |[a, b, c]: &[Vec3; 3]| (b - a).cross(c - a).length() / 2.0;
        // One corner is in front of the plane: a small triangle of half the size.
        let parts = clipped([point(0.0, -4.0), point(-2.0, 0.0), point(2.0, 0.0)], 2.0);
        assert!(parts.len() == 1 && (area(&parts[0]) - 2.0).abs() < 1e-6, "{parts:?}");
        // Two corners are in front: two triangles.
        let (near, left, right) = (point(0.0, 0.0), point(-2.0, -4.0), point(2.0, -4.0));
        for corners in [[near, left, right], [right, near, left], [left, right, near]] {
            let parts = clipped(corners, 2.0);
            assert!(
                parts.len() == 2 && (parts.iter().map(area).sum::<f32>() - 6.0).abs() < 1e-5,
                "{parts:?}"
            );
        }
    }

    #[test]
    fn triangles_on_one_side_are_kept_or_dropped() {
        let whole = [Vec3::new(0.0, 0.0, -3.0), Vec3::new(1.0, 0.0, -3.0), Vec3::new(0.0, 1.0, -3.0)];
        assert_eq!(clipped(whole, 3.0), [whole]);
        assert!(clipped(whole, 3.1).is_empty());
    }
}
