//! Where a picture is taken from, and how to stand so that all is on it.

use striata::mesh::Bounds;

/// An eye, where it looks, and how much of the world it takes in.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    /// Eye, mesh units.
    pub eye: [f32; 3],
    /// What lies in the middle of the picture.
    pub look_at: [f32; 3],
    /// What points up in the picture.
    pub up: [f32; 3],
    /// Angle from the lower to the upper side, radians.
    pub fov: f32,
}

/// Directions of a screen in the world: right, up, and towards the eye; each of length 1.
pub(super) type Axes = [[f64; 3]; 3];

/// From where a mesh is seen, by angles in radians.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Angles {
    /// Around the mesh, from its front to its right.
    pub turn: f32,
    /// Up.
    pub rise: f32,
    /// What is up.
    pub up: [f32; 3],
    /// Height of the view.
    pub fov: f32,
}

impl Angles {
    /// From where a mesh is seen that nobody said anything of: from its front, a little from its left and above. What lies
    /// flat along z, as terrains do, has z up and is seen from higher.
    pub fn usual(bounds: Option<&Bounds>) -> Self {
        const FLAT: f32 = 0.3;
        let size = bounds.map_or([1.0; 3], |bounds| [0, 1, 2].map(|k| bounds.max[k] - bounds.min[k]));
        let lies_flat = size[2] < FLAT * size[0].min(size[1]);
        let (up, rise): (_, f32) = if lies_flat { ([0.0, 0.0, 1.0], 40.0) } else { ([0.0, 1.0, 0.0], 8.0) };
        Self { turn: (-35.0f32).to_radians(), rise: rise.to_radians(), up, fov: 27.0f32.to_radians() }
    }
}

impl Camera {
    /// The nearest place in a direction from which all points are on a picture of that shape, with some air around them.
    pub fn around(points: &[[f32; 3]], angles: &Angles, aspect: f32) -> Self {
        let up = unit(wide(angles.up));
        let front = front_of(up);
        let side = cross(up, front);
        let (turn, rise) = (f64::from(angles.turn), f64::from(angles.rise));
        let level = [0, 1, 2].map(|k| turn.cos() * front[k] + turn.sin() * side[k]);
        let back = [0, 1, 2].map(|k| rise.cos() * level[k] + rise.sin() * up[k]);
        // Straight from above, up is where the back was.
        let upright = if rise.cos().abs() < 1e-3 { level.map(|x| -x * rise.signum()) } else { up };
        let right = unit(cross(upright, back));
        let axes = [right, cross(back, right), back];
        let eye = fitted(points, &axes, f64::from(angles.fov), f64::from(aspect));
        let at = |away: f64| [0, 1, 2].map(|k| (eye.place[k] - away * back[k]) as f32);
        Self { eye: at(0.0), look_at: at(eye.distance), up: axes[1].map(|x| x as f32), fov: angles.fov }
    }

    /// The same, nearer or farther without moving.
    pub fn zoomed(self, zoom: f32) -> Self {
        Self { fov: 2.0 * ((self.fov / 2.0).tan() / zoom).atan(), ..self }
    }

    /// How many times as wide as high some points are, as it sees them.
    pub fn aspect_of(&self, points: &[[f32; 3]]) -> f32 {
        let [right, up, back] = self.axes();
        let eye = wide(self.eye);
        let (mut min, mut max) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
        for point in points {
            let p = minus(wide(*point), eye);
            let depth = -dot(p, back);
            for (k, axis) in [right, up].into_iter().enumerate().filter(|_| depth > 0.0) {
                let place = dot(p, axis) / depth;
                (min[k], max[k]) = (min[k].min(place), max[k].max(place));
            }
        }
        let ratio = (max[0] - min[0]) / (max[1] - min[1]);
        if ratio.is_finite() { (ratio as f32).clamp(0.05, 20.0) } else { 1.0 }
    }

    /// The directions of its screen.
    pub(super) fn axes(&self) -> Axes {
        let back = unit(minus(wide(self.eye), wide(self.look_at)));
        let mut right = cross(wide(self.up), back);
        if dot(right, right) < 1e-20 {
            right = cross(front_of(back), back);
        }
        let right = unit(right);
        [right, cross(back, right), back]
    }
}

/// An eye, and how far from it the middle of what it sees is.
struct Stand {
    place: [f64; 3],
    distance: f64,
}

/// Air around a picture, of its half size.
const AIR: f64 = 0.06;

/// The nearest eye that sees all points.
///
/// A point at (x, y, z) is seen from (a, b, c) where |x - a| <= t (c - z), so each side of the picture gives a plane that the
/// eye must be behind; of each pair of them it stands in the middle.
fn fitted(points: &[[f32; 3]], axes: &Axes, fov: f64, aspect: f64) -> Stand {
    let slopes = [(fov / 2.0).tan() * aspect, (fov / 2.0).tan()].map(|t| t * (1.0 - AIR));
    let mut reach = [[f64::NEG_INFINITY; 2]; 2];
    let (mut near, mut far) = (f64::NEG_INFINITY, f64::INFINITY);
    for point in points.iter().filter(|p| p.iter().all(|x| x.is_finite())) {
        let [x, y, z] = axes.map(|axis| dot(axis, wide(*point)));
        (near, far) = (near.max(z), far.min(z));
        for (k, at) in [x, y].into_iter().enumerate() {
            reach[k][0] = reach[k][0].max(at + slopes[k] * z);
            reach[k][1] = reach[k][1].max(slopes[k] * z - at);
        }
    }
    if near < far {
        return Stand { place: axes[2], distance: 1.0 };
    }
    let depths = [0, 1].map(|k| (reach[k][0] + reach[k][1]) / (2.0 * slopes[k]));
    // A point alone is looked at from so far that coordinates still tell the eye from it.
    let magnitude = reach.iter().flatten().chain([&near]).fold(0.0, |most: f64, x| most.max(x.abs()));
    let size = if near > far { near - far } else { magnitude.max(1e-30) };
    let depth = depths[0].max(depths[1]).max(near + 0.02 * size);
    let aside = [0, 1].map(|k| (reach[k][0] - reach[k][1]) / 2.0);
    let place = [0, 1, 2].map(|k| aside[0] * axes[0][k] + aside[1] * axes[1][k] + depth * axes[2][k]);
    Stand { place, distance: depth - (near + far) / 2.0 }
}

/// Where a mesh looks that stands upright: at us, as far as up allows.
fn front_of(up: [f64; 3]) -> [f64; 3] {
    // With z up, as in surveying and in print, the front is towards -y.
    let wanted = if up[2].abs() > 0.8 { [0.0, -1.0, 0.0] } else { [0.0, 0.0, 1.0] };
    let along = dot(wanted, up);
    unit([0, 1, 2].map(|k| wanted[k] - along * up[k]))
}

pub(super) fn wide(v: [f32; 3]) -> [f64; 3] {
    v.map(f64::from)
}

pub(super) fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub(super) fn minus(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

pub(super) fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// Of length 1, or zero where there is no direction.
pub(super) fn unit(v: [f64; 3]) -> [f64; 3] {
    let length = dot(v, v).sqrt();
    if length > 0.0 { v.map(|x| x / length) } else { v }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn on_screen(camera: &Camera, aspect: f64, point: [f32; 3]) -> [f64; 2] {
        let [right, up, back] = camera.axes();
        let p = minus(wide(point), wide(camera.eye));
        let high = -dot(p, back) * (f64::from(camera.fov) / 2.0).tan();
        assert!(high > 0.0, "{point:?} is behind the eye");
        [dot(p, right) / (high * aspect), dot(p, up) / high]
    }

    #[test]
    fn all_points_are_on_the_picture_and_fill_it() {
        let points = [[-1.0, 2.0, 0.5], [3.0, 2.5, -1.0], [0.0, -4.0, 0.0], [1.0, 1.0, 2.0]];
        for (turn, rise, aspect) in
            [(0.0, 0.0, 1.0), (-0.6, 0.2, 2.5), (2.0, -0.8, 0.4), (0.3, 1.570_796_4, 1.0)]
        {
            for up in [[0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [1.0, 1.0, 0.0]] {
                let angles = Angles { turn, rise, up, fov: 0.5 };
                let camera = Camera::around(&points, &angles, aspect);
                let places = points.map(|p| on_screen(&camera, f64::from(aspect), p));
                let reach = |k: usize| places.iter().map(|p| p[k].abs()).fold(0.0, f64::max);
                let most = reach(0).max(reach(1));
                assert!((0.93..0.95).contains(&most), "{turn} {rise} {aspect} {up:?}: {most}");
            }
        }
    }

    #[test]
    fn turning_goes_around_and_rising_goes_up() {
        let points = [[-1.0, -1.0, -1.0], [1.0, 1.0, 1.0]];
        let eye = |turn, rise| {
            Camera::around(&points, &Angles { turn, rise, up: [0.0, 1.0, 0.0], fov: 0.5 }, 1.0).eye
        };
        assert!(eye(0.0, 0.0)[2] > 2.0 && eye(1.5, 0.0)[0] > 2.0 && eye(0.0, 1.0)[1] > 2.0);
    }

    #[test]
    fn no_points_and_one_point_are_no_trouble() {
        let angles = Angles { turn: 0.0, rise: 0.0, up: [0.0, 1.0, 0.0], fov: 0.5 };
        for points in [&[][..], &[[5.0, 5.0, 5.0]], &[[0.0; 3]]] {
            let camera = Camera::around(points, &angles, 1.0);
            assert!(camera.eye.iter().chain(&camera.look_at).all(|x| x.is_finite()), "{camera:?}");
            assert!(camera.eye != camera.look_at, "{camera:?}");
        }
    }

    #[test]
    fn what_lies_flat_has_z_up_and_is_seen_from_higher() {
        let usual = |max: [f32; 3]| Angles::usual(Some(&Bounds { min: [0.0; 3], max }));
        let flat = usual([10.0, 8.0, 1.0]);
        assert!(flat.up == [0.0, 0.0, 1.0] && flat.rise > 0.5);
        for upright in [[1.0; 3], [10.0, 1.0, 10.0], [1.0, 10.0, 1.0], [10.0, 1.0, 1.0]] {
            assert_eq!(usual(upright), Angles::usual(None), "{upright:?}");
        }
    }

    #[test]
    fn zooming_narrows_the_view() {
        let camera = Camera { eye: [0.0, 0.0, 2.0], look_at: [0.0; 3], up: [0.0, 1.0, 0.0], fov: 1.0 };
        let ratio = (camera.fov / 2.0).tan() / (camera.zoomed(2.0).fov / 2.0).tan();
        assert!((ratio - 2.0).abs() < 1e-5);
    }
}
