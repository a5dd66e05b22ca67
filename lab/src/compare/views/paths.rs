//! Camera paths around, toward and through a mesh, with identical cameras on every machine.
//!
//! All lengths are in diagonals of the mesh's bounds, so a path shows meshes of all sizes in the same way.
//! Sines and cosines are derived from a tangent computed as a continued fraction, which rounds the same on
//! every platform.

use striata::mesh::{Bounds, IndexedMesh};
use striata::view::{Camera, CameraError};

use striata_command::args::tan;

/// Width and height of the screen in pixels.
pub(super) const SCREEN_PX: u32 = 1000;

/// Tangent of half the field of view of 60 degrees.
const TAN_HALF_FOV: f64 = 0.577_350_269_189_625_8;

/// Pixels per unit of length at unit distance.
pub(super) const PIXELS_PER_UNIT: f32 = (SCREEN_PX as f64 / (2.0 * TAN_HALF_FOV)) as f32;

/// Minimum and maximum distance of an orbit from the center, in diagonals.
const ORBIT: [f64; 2] = [0.4, 1.8];

/// First and last distance of a dive from the surface, in diagonals.
const DIVE: [f64; 2] = [2.0, 0.02];

/// Direction from the ground to the camera during a dive.
const DIVE_DIRECTION: [f64; 3] = [0.36, 0.48, 0.8];

/// Part of the bounds, in each direction from the center, that a walk inside covers.
const INSIDE: [f64; 3] = [0.7, 0.2, 0.7];

/// How far ahead a walk looks, in degrees of its loop.
const AHEAD: f64 = 10.0;

/// A camera path.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Path {
    /// Around the center at one degree per frame, while the distance grows and shrinks.
    Orbit,
    /// Like the orbit, but with a quarter turn per frame, so that consecutive views share nothing.
    Jumps,
    /// Straight down to the surface.
    Dive,
    /// Through the inside of the bounds in a figure eight, looking ahead.
    Inside,
}

impl Path {
    /// Name of the path.
    pub(super) const fn as_str(self) -> &'static str {
        match self {
            Self::Orbit => "orbit",
            Self::Jumps => "jumps",
            Self::Dive => "dive",
            Self::Inside => "inside",
        }
    }

    /// Description printed in the report.
    pub(super) const fn about(self) -> &'static str {
        match self {
            Self::Orbit => {
                "around the center, 1 degree per frame, 0.4 to 1.8 diagonals of the bounds away and back"
            }
            Self::Jumps => "as orbit, but 90 degrees per frame",
            Self::Dive => "straight down to the surface, from 2 diagonals to 0.02",
            Self::Inside => "through the inside of the bounds in a figure eight, looking ahead",
        }
    }

    const fn frame_count(self) -> usize {
        match self {
            Self::Orbit => 720,
            Self::Jumps => 120,
            Self::Dive | Self::Inside => 240,
        }
    }

    /// The frames of the path around a mesh.
    pub(super) fn frames(self, mesh: &IndexedMesh) -> Vec<PathFrame> {
        let extent = MeshExtent::of(mesh);
        let count = self.frame_count();
        (0..count).map(|frame| self.frame(&extent, frame as f64, count as f64)).collect()
    }

    fn frame(self, extent: &MeshExtent, frame: f64, count: f64) -> PathFrame {
        match self {
            Self::Orbit => extent.around(frame, frame / count),
            Self::Jumps => extent.around(90.0 * frame, frame / count),
            Self::Dive => extent.above(frame / (count - 1.0)),
            Self::Inside => extent.inside(360.0 * frame / count),
        }
    }
}

/// Center, extent and ground of a mesh, relative to which paths are defined.
#[derive(Clone, Copy, Debug)]
struct MeshExtent {
    center: [f64; 3],
    /// Half the extent of the bounds; at least a small one even for flat meshes.
    half: [f64; 3],
    diagonal: f64,
    /// The vertex that a dive ends at.
    ground: [f64; 3],
}

impl MeshExtent {
    fn of(mesh: &IndexedMesh) -> Self {
        let Bounds { min, max } = mesh.bounds().unwrap_or(Bounds { min: [0.0; 3], max: [0.0; 3] });
        // A mesh without extent still gets valid views.
        let diagonal = Some(mesh.diagonal()).filter(|&diagonal| diagonal > 0.0).unwrap_or(1.0);
        let (min, max) = (min.map(f64::from), max.map(f64::from));
        let center = [0, 1, 2].map(|i| (min[i] + max[i]) / 2.0);
        let half = [0, 1, 2].map(|i| ((max[i] - min[i]) / 2.0).max(0.05 * diagonal));
        // No part of the mesh is farther in that direction, so the way down is free.
        let height = |point: &[f32; 3]| dot(point.map(f64::from), DIVE_DIRECTION);
        let highest = mesh.positions.iter().max_by(|a, b| height(a).total_cmp(&height(b)));
        let ground = highest.map_or(center, |point| point.map(f64::from));
        Self { center, half, diagonal, ground }
    }

    /// A view of the center from an angle in degrees, at `share` of the cycle from near to far and back.
    fn around(&self, degrees: f64, share: f64) -> PathFrame {
        let (sin, cos) = sin_cos(degrees);
        let [near, far] = ORBIT;
        let distance = self.diagonal * (near + (far - near) * 0.5 * (1.0 - sin_cos(360.0 * share).1));
        let eye = plus(self.center, [sin, 0.0, cos], distance);
        PathFrame::new(eye, self.center)
    }

    /// A view of the ground at `share` of the way down; the distance is the reciprocal of a linear function.
    fn above(&self, share: f64) -> PathFrame {
        let [far, near] = DIVE;
        let distance = self.diagonal * far / (1.0 + (far / near - 1.0) * share);
        PathFrame::new(plus(self.ground, DIVE_DIRECTION, distance), self.ground)
    }

    fn inside(&self, degrees: f64) -> PathFrame {
        PathFrame::new(self.on_eight(degrees), self.on_eight(degrees + AHEAD))
    }

    /// A point on the walk through the inside.
    fn on_eight(&self, degrees: f64) -> [f64; 3] {
        let across = [sin_cos(degrees).0, sin_cos(3.0 * degrees).0, sin_cos(2.0 * degrees).0];
        [0, 1, 2].map(|i| self.center[i] + INSIDE[i] * self.half[i] * across[i])
    }
}

/// A camera position and the point it looks at.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct PathFrame {
    eye: [f32; 3],
    target: [f32; 3],
    /// Directions to the right, upward and into the picture.
    axes: [[f64; 3]; 3],
}

impl PathFrame {
    const UP: [f64; 3] = [0.0, 1.0, 0.0];

    fn new(eye: [f64; 3], target: [f64; 3]) -> Self {
        let (eye, target) = (eye.map(|x| x as f32), target.map(|x| x as f32));
        let forward = unit(minus(target.map(f64::from), eye.map(f64::from)));
        let right = unit(cross(forward, Self::UP));
        Self { eye, target, axes: [right, cross(right, forward), forward] }
    }

    /// Converts the frame to the library's camera.
    ///
    /// # Errors
    /// If the camera is degenerate.
    pub(super) fn camera(&self) -> Result<Camera, CameraError> {
        Camera::new(self.eye, self.target, [0.0, 1.0, 0.0], TAN_HALF_FOV, [SCREEN_PX, SCREEN_PX])
    }

    /// Position of the camera.
    pub(super) fn eye(&self) -> [f64; 3] {
        self.eye.map(f64::from)
    }

    /// Pixels per unit length at a point, in the direction of greatest magnification; a flat screen
    /// stretches what is off-center. `None` if the point is outside the picture.
    pub(super) fn pixels_at(&self, point: [f64; 3]) -> Option<f64> {
        let to = minus(point, self.eye());
        let [x, y, depth] = self.axes.map(|axis| dot(axis, to));
        let side = TAN_HALF_FOV * depth;
        let is_seen = depth > 0.0 && x.abs() <= side && y.abs() <= side;
        is_seen.then(|| f64::from(SCREEN_PX) / (2.0 * TAN_HALF_FOV) * dot(to, to).sqrt() / (depth * depth))
    }
}

/// Sine and cosine of a nonnegative angle.
fn sin_cos(degrees: f64) -> (f64, f64) {
    let quarters = (degrees / 90.0).floor();
    // The tangent of half the remainder is below 0.42, where no precision is lost.
    let t = tan((degrees - 90.0 * quarters).to_radians() / 2.0);
    let (sin, cos) = (2.0 * t / (1.0 + t * t), (1.0 - t * t) / (1.0 + t * t));
    match quarters as u64 % 4 {
        0 => (sin, cos),
        1 => (cos, -sin),
        2 => (-sin, -cos),
        _ => (-cos, sin),
    }
}

/// `point + length * direction`.
fn plus(point: [f64; 3], direction: [f64; 3], length: f64) -> [f64; 3] {
    [0, 1, 2].map(|i| point[i] + length * direction[i])
}

/// `a - b`.
pub(super) fn minus(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [0, 1, 2].map(|i| a[i] - b[i])
}

/// The dot product.
pub(super) fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// The cross product.
pub(super) fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn unit(a: [f64; 3]) -> [f64; 3] {
    let length = dot(a, a).sqrt();
    a.map(|x| x / length)
}

#[cfg(test)]
mod tests {
    use striata::mesh::shapes;
    use striata::view::Sphere;

    use super::*;

    const ALL: [Path; 4] = [Path::Orbit, Path::Jumps, Path::Dive, Path::Inside];

    fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
        let d = minus(a, b);
        dot(d, d).sqrt()
    }

    #[test]
    fn sin_cos_agrees_with_the_platform() {
        for degrees in 0..1080 {
            let angle = f64::from(degrees) * 0.7;
            let (sin, cos) = sin_cos(angle);
            let (s, c) = angle.to_radians().sin_cos();
            assert!((sin - s).abs() < 1e-13 && (cos - c).abs() < 1e-13, "{angle}: {sin}, {cos}");
        }
    }

    #[test]
    fn paths_are_bit_identical_everywhere() {
        let mesh = shapes::icosphere(2, 3.0);
        let sums = ALL.map(|path| {
            let bits = path.frames(&mesh).into_iter().flat_map(|frame| [frame.eye, frame.target]).flatten();
            bits.fold(0u64, |sum, x| sum.rotate_left(5).wrapping_mul(0x9e37_79b9) ^ u64::from(x.to_bits()))
        });
        assert_eq!(
            sums,
            [0x5d33_bc8f_cf5b_ca2e, 0x0061_4c45_dc69_3a45, 0xbf86_ed0e_b03d_b079, 0x6962_1023_f76f_b8b4]
        );
    }

    #[test]
    fn orbits_have_the_documented_angles_and_distances() {
        let mesh = shapes::torus(24, 12, 1.0, 0.4);
        let diagonal = mesh.diagonal();
        for (path, degrees) in [(Path::Orbit, 1.0f64), (Path::Jumps, 90.0)] {
            let frames = path.frames(&mesh);
            let away: Vec<f64> = frames.iter().map(|f| distance(f.eye(), [0.0; 3]) / diagonal).collect();
            let far = away.iter().copied().fold(0.0, f64::max);
            assert!((away[0] - 0.4).abs() < 1e-6 && (far - 1.8).abs() < 1e-3, "{far}");
            assert!(away.iter().all(|&d| d >= 0.4 - 1e-6));
            for pair in frames.windows(2) {
                let [a, b] = [&pair[0], &pair[1]].map(|frame| unit(frame.eye()));
                assert!((dot(a, b) - degrees.to_radians().cos()).abs() < 1e-6, "{pair:?}");
            }
        }
        assert_eq!(Path::Orbit.frames(&mesh).len(), 720);
    }

    #[test]
    fn dive_ends_just_above_the_surface_and_sees_little_of_it() {
        let mesh = shapes::icosphere(4, 1.0);
        let frames = Path::Dive.frames(&mesh);
        let above: Vec<f64> =
            frames.iter().map(|f| (distance(f.eye(), [0.0; 3]) - 1.0) / mesh.diagonal()).collect();
        assert!((above[0] - 2.0).abs() < 0.01 && above[0] <= 2.0, "{}", above[0]);
        assert!(above.is_sorted_by(|a, b| a > b));
        let last = above[above.len() - 1];
        assert!((0.015..=0.0201).contains(&last), "{last}");
        let seen = |frame: &PathFrame| {
            let facing = |p: &&[f32; 3]| dot(p.map(f64::from), minus(frame.eye(), p.map(f64::from))) > 0.0;
            let is_in = |p: &[f32; 3]| frame.pixels_at(p.map(f64::from)).is_some();
            mesh.positions.iter().filter(facing).filter(|p| is_in(p)).count()
        };
        let (first, last) = (seen(&frames[0]), seen(&frames[frames.len() - 1]));
        assert!(first > mesh.vertex_count() / 3 && last < mesh.vertex_count() / 100, "{first}, {last}");
    }

    #[test]
    fn walk_inside_stays_inside_and_looks_in_all_directions() {
        let mesh = shapes::icosphere(1, 1.0);
        let bounds = mesh.bounds().unwrap();
        let frames = Path::Inside.frames(&mesh);
        for frame in &frames {
            let is_in = |i: usize| bounds.min[i] < frame.eye[i] && frame.eye[i] < bounds.max[i];
            assert!((0..3).all(is_in), "{frame:?}");
        }
        for axis in [0, 2] {
            let looks = |sign: f64| frames.iter().any(|frame| sign * frame.axes[2][axis] > 0.7);
            assert!(looks(1.0) && looks(-1.0));
        }
        let steps = frames.windows(2).map(|pair| dot(pair[0].axes[2], pair[1].axes[2]));
        assert!(steps.fold(1.0, f64::min) > 0.97, "the eye turns too fast to be a walk");
    }

    #[test]
    fn pixels_per_unit_agree_with_the_camera() {
        let mesh = shapes::icosphere(3, 1.0);
        for path in ALL {
            let frames = path.frames(&mesh);
            let frame = frames[frames.len() / 3];
            let camera = frame.camera().unwrap();
            let mut seen = 0;
            for &point in &mesh.positions {
                let Some(pixels) = frame.pixels_at(point.map(f64::from)) else { continue };
                let expected = f64::from(camera.error_px(1.0, &Sphere::point(point)));
                assert!((pixels / expected - 1.0).abs() < 1e-4, "{point:?}: {pixels} and {expected}");
                seen += 1;
            }
            assert!(seen > 10, "{path:?}: {seen} points seen");
        }
    }

    #[test]
    fn meshes_without_extent_have_valid_cameras() {
        let point = IndexedMesh::new(vec![[5.0, 6.0, 7.0]], Vec::new());
        for mesh in [IndexedMesh::default(), point, shapes::grid(3, 3)] {
            for path in ALL {
                assert!(path.frames(&mesh).iter().all(|frame| frame.camera().is_ok()), "{path:?}");
            }
        }
    }
}
