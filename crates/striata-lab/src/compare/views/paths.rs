//! The ways that an eye goes around, towards and through a mesh: the same cameras on every machine.
//!
//! All lengths are in diagonals of the mesh's bounds, so that a path shows the same of a mesh of any size. Sines and cosines
//! come from one tangent, which is a continued fraction.

use striata::mesh::{Bounds, IndexedMesh};
use striata::view::{Camera, CameraError};

use striata_command::args::tan;

/// Pixels of the screen each way.
pub(super) const SCREEN_PX: u32 = 1000;

/// Tangent of half the angle of view, 60 degrees.
const TAN_HALF_FOV: f64 = 0.577_350_269_189_625_8;

/// How near to the middle an orbit comes, and how far from it, diagonals.
const ORBIT: [f64; 2] = [0.4, 1.8];

/// How far from the surface a dive begins and ends, diagonals.
const DIVE: [f64; 2] = [2.0, 0.02];

/// Where a dive goes down.
const DIVE_DIRECTION: [f64; 3] = [0.36, 0.48, 0.8];

/// How much of the bounds, each way from the middle, a walk through the inside goes over.
const INSIDE: [f64; 3] = [0.7, 0.2, 0.7];

/// How far ahead a walk looks, degrees of its round.
const AHEAD: f64 = 10.0;

/// A way to go.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Path {
    /// Around the middle, a degree a frame, while the distance grows and falls.
    Orbit,
    /// The same, a quarter of a turn a frame: nothing of a view is left in the next one.
    Jumps,
    /// Straight down to the surface.
    Dive,
    /// Through the inside of the bounds in the shape of an eight, looking ahead.
    Inside,
}

impl Path {
    /// Its name.
    pub(super) const fn as_str(self) -> &'static str {
        match self {
            Self::Orbit => "orbit",
            Self::Jumps => "jumps",
            Self::Dive => "dive",
            Self::Inside => "inside",
        }
    }

    /// What it is, for people.
    pub(super) const fn about(self) -> &'static str {
        match self {
            Self::Orbit => {
                "around the middle, 1 degree a frame, 0.4 to 1.8 diagonals of the bounds away and back"
            }
            Self::Jumps => "the same around, 90 degrees a frame",
            Self::Dive => "straight down to the surface, from 2 diagonals to 0.02",
            Self::Inside => "through the inside of the bounds in the shape of an eight, looking ahead",
        }
    }

    const fn frame_count(self) -> usize {
        match self {
            Self::Orbit => 720,
            Self::Jumps => 120,
            Self::Dive | Self::Inside => 240,
        }
    }

    /// The frames of this way around a mesh.
    pub(super) fn frames(self, mesh: &IndexedMesh) -> Vec<Frame> {
        let place = Place::of(mesh);
        let count = self.frame_count();
        (0..count).map(|frame| self.frame(&place, frame as f64, count as f64)).collect()
    }

    fn frame(self, place: &Place, frame: f64, count: f64) -> Frame {
        match self {
            Self::Orbit => place.around(frame, frame / count),
            Self::Jumps => place.around(90.0 * frame, frame / count),
            Self::Dive => place.above(frame / (count - 1.0)),
            Self::Inside => place.inside(360.0 * frame / count),
        }
    }
}

/// Where a mesh is.
#[derive(Clone, Copy, Debug)]
struct Place {
    middle: [f64; 3],
    /// Of the bounds; those of a flat mesh have some width all the same.
    half: [f64; 3],
    diagonal: f64,
    /// The vertex that a dive goes to.
    ground: [f64; 3],
}

impl Place {
    fn of(mesh: &IndexedMesh) -> Self {
        let Bounds { min, max } = mesh.bounds().unwrap_or(Bounds { min: [0.0; 3], max: [0.0; 3] });
        // Without an extent there is nothing to go around, but a view all the same.
        let diagonal = Some(mesh.diagonal()).filter(|&diagonal| diagonal > 0.0).unwrap_or(1.0);
        let (min, max) = (min.map(f64::from), max.map(f64::from));
        let middle = [0, 1, 2].map(|i| (min[i] + max[i]) / 2.0);
        let half = [0, 1, 2].map(|i| ((max[i] - min[i]) / 2.0).max(0.05 * diagonal));
        // Nothing of the mesh lies farther in that direction, so the way down is free.
        let height = |point: &[f32; 3]| dot(point.map(f64::from), DIVE_DIRECTION);
        let highest = mesh.positions.iter().max_by(|a, b| height(a).total_cmp(&height(b)));
        let ground = highest.map_or(middle, |point| point.map(f64::from));
        Self { middle, half, diagonal, ground }
    }

    /// An eye at some degrees around the middle, `share` of the way from near to far and back.
    fn around(&self, degrees: f64, share: f64) -> Frame {
        let (sin, cos) = sin_cos(degrees);
        let [near, far] = ORBIT;
        let distance = self.diagonal * (near + (far - near) * 0.5 * (1.0 - sin_cos(360.0 * share).1));
        let eye = plus(self.middle, [sin, 0.0, cos], distance);
        Frame::new(eye, self.middle)
    }

    /// An eye over the ground, `share` of the way down: each frame is nearer than the one before by a like factor.
    fn above(&self, share: f64) -> Frame {
        let [far, near] = DIVE;
        let distance = self.diagonal * far / (1.0 + (far / near - 1.0) * share);
        Frame::new(plus(self.ground, DIVE_DIRECTION, distance), self.ground)
    }

    fn inside(&self, degrees: f64) -> Frame {
        Frame::new(self.on_eight(degrees), self.on_eight(degrees + AHEAD))
    }

    /// A place of the walk through the inside.
    fn on_eight(&self, degrees: f64) -> [f64; 3] {
        let across = [sin_cos(degrees).0, sin_cos(3.0 * degrees).0, sin_cos(2.0 * degrees).0];
        [0, 1, 2].map(|i| self.middle[i] + INSIDE[i] * self.half[i] * across[i])
    }
}

/// An eye and what it looks at.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Frame {
    eye: [f32; 3],
    target: [f32; 3],
    /// To the right, upwards and into the picture.
    axes: [[f64; 3]; 3],
}

impl Frame {
    const UP: [f64; 3] = [0.0, 1.0, 0.0];

    fn new(eye: [f64; 3], target: [f64; 3]) -> Self {
        let (eye, target) = (eye.map(|x| x as f32), target.map(|x| x as f32));
        let forward = unit(minus(target.map(f64::from), eye.map(f64::from)));
        let right = unit(cross(forward, Self::UP));
        Self { eye, target, axes: [right, cross(right, forward), forward] }
    }

    /// The library's camera there.
    ///
    /// # Errors
    /// Where it makes no picture.
    pub(super) fn camera(&self) -> Result<Camera, CameraError> {
        Camera::new(self.eye, self.target, [0.0, 1.0, 0.0], TAN_HALF_FOV, [SCREEN_PX, SCREEN_PX])
    }

    /// Where the eye is.
    pub(super) fn eye(&self) -> [f64; 3] {
        self.eye.map(f64::from)
    }

    /// Pixels that a small length takes at a point, whichever way it lies: a flat screen stretches what is aside. `None`
    /// where the point is not in the picture.
    pub(super) fn pixels_at(&self, point: [f64; 3]) -> Option<f64> {
        let to = minus(point, self.eye());
        let [x, y, depth] = self.axes.map(|axis| dot(axis, to));
        let side = TAN_HALF_FOV * depth;
        let is_seen = depth > 0.0 && x.abs() <= side && y.abs() <= side;
        is_seen.then(|| f64::from(SCREEN_PX) / (2.0 * TAN_HALF_FOV) * dot(to, to).sqrt() / (depth * depth))
    }
}

/// Sine and cosine of an angle of 0 degrees or more.
fn sin_cos(degrees: f64) -> (f64, f64) {
    let quarters = (degrees / 90.0).floor();
    // The tangent of half the rest is below 0.42, where nothing is lost.
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

/// The scalar product.
pub(super) fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// The vector product.
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
    fn angles_are_those_of_the_platform() {
        for degrees in 0..1080 {
            let angle = f64::from(degrees) * 0.7;
            let (sin, cos) = sin_cos(angle);
            let (s, c) = angle.to_radians().sin_cos();
            assert!((sin - s).abs() < 1e-13 && (cos - c).abs() < 1e-13, "{angle}: {sin}, {cos}");
        }
    }

    #[test]
    fn paths_are_the_same_bits_everywhere() {
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
    fn orbits_turn_by_what_they_say_at_the_distances_that_they_say() {
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
    fn a_dive_ends_just_above_the_surface_and_loses_the_rest_of_it() {
        let mesh = shapes::icosphere(4, 1.0);
        let frames = Path::Dive.frames(&mesh);
        let above: Vec<f64> =
            frames.iter().map(|f| (distance(f.eye(), [0.0; 3]) - 1.0) / mesh.diagonal()).collect();
        assert!((above[0] - 2.0).abs() < 0.01 && above[0] <= 2.0, "{}", above[0]);
        assert!(above.is_sorted_by(|a, b| a > b));
        let last = above[above.len() - 1];
        assert!((0.015..=0.0201).contains(&last), "{last}");
        let seen = |frame: &Frame| {
            let facing = |p: &&[f32; 3]| dot(p.map(f64::from), minus(frame.eye(), p.map(f64::from))) > 0.0;
            let is_in = |p: &[f32; 3]| frame.pixels_at(p.map(f64::from)).is_some();
            mesh.positions.iter().filter(facing).filter(|p| is_in(p)).count()
        };
        let (first, last) = (seen(&frames[0]), seen(&frames[frames.len() - 1]));
        assert!(first > mesh.vertex_count() / 3 && last < mesh.vertex_count() / 100, "{first}, {last}");
    }

    #[test]
    fn a_walk_inside_stays_inside_and_turns_all_around() {
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
    fn pixels_are_those_of_the_camera() {
        let mesh = shapes::icosphere(3, 1.0);
        for path in ALL {
            let frames = path.frames(&mesh);
            let frame = frames[frames.len() / 3];
            let camera = frame.camera().unwrap();
            let mut seen = 0;
            for &point in &mesh.positions {
                let Some(pixels) = frame.pixels_at(point.map(f64::from)) else { continue };
                let told = f64::from(camera.error_px(1.0, &Sphere::point(point)));
                assert!((pixels / told - 1.0).abs() < 1e-4, "{point:?}: {pixels} and {told}");
                seen += 1;
            }
            assert!(seen > 10, "{path:?}: {seen} points seen");
        }
    }

    #[test]
    fn meshes_without_extent_are_looked_at_too() {
        let point = IndexedMesh::new(vec![[5.0, 6.0, 7.0]], Vec::new());
        for mesh in [IndexedMesh::default(), point, shapes::grid(3, 3)] {
            for path in ALL {
                assert!(path.frames(&mesh).iter().all(|frame| frame.camera().is_ok()), "{path:?}");
            }
        }
    }
}
