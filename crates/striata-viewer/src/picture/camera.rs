//! Cameras, and how to place one so that all points are in the picture.

use striata::mesh::Bounds;

/// A perspective camera.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    /// Position of the eye, mesh units.
    pub eye: [f32; 3],
    /// Point in the middle of the picture, mesh units.
    pub look_at: [f32; 3],
    /// Direction that points up in the picture.
    pub up: [f32; 3],
    /// Vertical field of view, radians.
    pub fov: f32,
}

/// Unit vectors of the screen in world space: right, up, and toward the eye.
pub(super) type Axes = [[f64; 3]; 3];

/// Viewing direction as angles in radians.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ViewAngles {
    /// Rotation around the up axis, from the front to the right.
    pub turn: f32,
    /// Elevation above the horizon.
    pub rise: f32,
    /// Up direction.
    pub up: [f32; 3],
    /// Vertical field of view.
    pub fov: f32,
}

impl ViewAngles {
    /// Default angles: from the front, slightly from the left and above. Terrains, and meshes that are as flat
    /// along z, have z up and are seen from higher.
    pub fn usual(bounds: Option<&Bounds>, is_terrain: bool) -> Self {
        const FLAT: f32 = 0.3;
        let size = bounds.map_or([1.0; 3], |bounds| [0, 1, 2].map(|k| bounds.max[k] - bounds.min[k]));
        let lies_flat = size[2] < FLAT * size[0].min(size[1]);
        let (up, rise): (_, f32) =
            if lies_flat || is_terrain { ([0.0, 0.0, 1.0], 40.0) } else { ([0.0, 1.0, 0.0], 8.0) };
        Self { turn: (-35.0f32).to_radians(), rise: rise.to_radians(), up, fov: 27.0f32.to_radians() }
    }
}

impl Camera {
    /// Places the camera as close as possible in a direction such that all points are in a picture of
    /// this aspect ratio, with a margin.
    pub fn around(points: &[[f32; 3]], angles: &ViewAngles, aspect: f32) -> Self {
        let up = unit(to_f64(angles.up));
        let front = front_of(up);
        let side = cross(up, front);
        let (turn, rise) = (f64::from(angles.turn), f64::from(angles.rise));
        let level = [0, 1, 2].map(|k| turn.cos() * front[k] + turn.sin() * side[k]);
        let back = [0, 1, 2].map(|k| rise.cos() * level[k] + rise.sin() * up[k]);
        // Seen straight from above, up is where the back was.
        let upright = if rise.cos().abs() < 1e-3 { level.map(|x| -x * rise.signum()) } else { up };
        let right = unit(cross(upright, back));
        let axes = [right, cross(back, right), back];
        let eye = fit_eye(points, &axes, f64::from(angles.fov), f64::from(aspect));
        let at = |away: f64| [0, 1, 2].map(|k| (eye.position[k] - away * back[k]) as f32);
        Self { eye: at(0.0), look_at: at(eye.distance), up: axes[1].map(|x| x as f32), fov: angles.fov }
    }

    /// Zooms by narrowing the field of view, without moving.
    pub fn zoomed(self, zoom: f32) -> Self {
        Self { fov: 2.0 * ((self.fov / 2.0).tan() / zoom).atan(), ..self }
    }

    /// Aspect ratio (width by height) of some points as seen by this camera.
    pub fn aspect_of(&self, points: &[[f32; 3]]) -> f32 {
        let [right, up, back] = self.axes();
        let eye = to_f64(self.eye);
        let (mut min, mut max) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
        for point in points {
            let p = sub(to_f64(*point), eye);
            let depth = -dot(p, back);
            for (k, axis) in [right, up].into_iter().enumerate().filter(|_| depth > 0.0) {
                let ratio = dot(p, axis) / depth;
                (min[k], max[k]) = (min[k].min(ratio), max[k].max(ratio));
            }
        }
        let ratio = (max[0] - min[0]) / (max[1] - min[1]);
        if ratio.is_finite() { (ratio as f32).clamp(0.05, 20.0) } else { 1.0 }
    }

    /// Axes of the screen.
    pub(super) fn axes(&self) -> Axes {
        let back = unit(sub(to_f64(self.eye), to_f64(self.look_at)));
        let mut right = cross(to_f64(self.up), back);
        if dot(right, right) < 1e-20 {
            right = cross(front_of(back), back);
        }
        let right = unit(right);
        [right, cross(back, right), back]
    }
}

/// Position of an eye, and its distance to the middle of the points.
struct EyePosition {
    position: [f64; 3],
    distance: f64,
}

/// Margin around a picture, as a fraction of its half size.
const MARGIN: f64 = 0.06;

/// Finds the closest eye position that sees all points.
///
/// A point at (x, y, z) is visible from (a, b, c) if |x - a| <= t (c - z), so each side of the picture
/// gives a plane that the eye must be behind. Between each pair of opposite planes, the eye is centered.
fn fit_eye(points: &[[f32; 3]], axes: &Axes, fov: f64, aspect: f64) -> EyePosition {
    let slopes = [(fov / 2.0).tan() * aspect, (fov / 2.0).tan()].map(|t| t * (1.0 - MARGIN));
    let mut reach = [[f64::NEG_INFINITY; 2]; 2];
    let (mut near, mut far) = (f64::NEG_INFINITY, f64::INFINITY);
    for point in points.iter().filter(|p| p.iter().all(|x| x.is_finite())) {
        let [x, y, z] = axes.map(|axis| dot(axis, to_f64(*point)));
        (near, far) = (near.max(z), far.min(z));
        for (k, at) in [x, y].into_iter().enumerate() {
            reach[k][0] = reach[k][0].max(at + slopes[k] * z);
            reach[k][1] = reach[k][1].max(slopes[k] * z - at);
        }
    }
    if near < far {
        return EyePosition { position: axes[2], distance: 1.0 };
    }
    let depths = [0, 1].map(|k| (reach[k][0] + reach[k][1]) / (2.0 * slopes[k]));
    // A single point is viewed from far enough away that the coordinates of eye and point differ.
    let magnitude = reach.iter().flatten().chain([&near]).fold(0.0, |most: f64, x| most.max(x.abs()));
    let size = if near > far { near - far } else { magnitude.max(1e-30) };
    let depth = depths[0].max(depths[1]).max(near + 0.02 * size);
    let offset = [0, 1].map(|k| (reach[k][0] - reach[k][1]) / 2.0);
    let position = [0, 1, 2].map(|k| offset[0] * axes[0][k] + offset[1] * axes[1][k] + depth * axes[2][k]);
    EyePosition { position, distance: depth - (near + far) / 2.0 }
}

/// Front direction of an upright mesh: toward the viewer, perpendicular to up.
fn front_of(up: [f64; 3]) -> [f64; 3] {
    // With z up, as in surveying and printing, the front faces -y.
    let preferred = if up[2].abs() > 0.8 { [0.0, -1.0, 0.0] } else { [0.0, 0.0, 1.0] };
    let along = dot(preferred, up);
    unit([0, 1, 2].map(|k| preferred[k] - along * up[k]))
}

pub(super) fn to_f64(v: [f32; 3]) -> [f64; 3] {
    v.map(f64::from)
}

pub(super) fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub(super) fn sub(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

pub(super) fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// Normalizes a vector; a zero vector stays zero.
pub(super) fn unit(v: [f64; 3]) -> [f64; 3] {
    let length = dot(v, v).sqrt();
    if length > 0.0 { v.map(|x| x / length) } else { v }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn on_screen(camera: &Camera, aspect: f64, point: [f32; 3]) -> [f64; 2] {
        let [right, up, back] = camera.axes();
        let p = sub(to_f64(point), to_f64(camera.eye));
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
                let angles = ViewAngles { turn, rise, up, fov: 0.5 };
                let camera = Camera::around(&points, &angles, aspect);
                let points_on_screen = points.map(|p| on_screen(&camera, f64::from(aspect), p));
                let reach = |k: usize| points_on_screen.iter().map(|p| p[k].abs()).fold(0.0, f64::max);
                let most = reach(0).max(reach(1));
                assert!((0.93..0.95).contains(&most), "{turn} {rise} {aspect} {up:?}: {most}");
            }
        }
    }

    #[test]
    fn turning_goes_around_and_rising_goes_up() {
        let points = [[-1.0, -1.0, -1.0], [1.0, 1.0, 1.0]];
        let eye = |turn, rise| {
            Camera::around(&points, &ViewAngles { turn, rise, up: [0.0, 1.0, 0.0], fov: 0.5 }, 1.0).eye
        };
        assert!(eye(0.0, 0.0)[2] > 2.0 && eye(1.5, 0.0)[0] > 2.0 && eye(0.0, 1.0)[1] > 2.0);
    }

    #[test]
    fn empty_and_single_points_give_a_valid_camera() {
        let angles = ViewAngles { turn: 0.0, rise: 0.0, up: [0.0, 1.0, 0.0], fov: 0.5 };
        for points in [&[][..], &[[5.0, 5.0, 5.0]], &[[0.0; 3]]] {
            let camera = Camera::around(points, &angles, 1.0);
            assert!(camera.eye.iter().chain(&camera.look_at).all(|x| x.is_finite()), "{camera:?}");
            assert!(camera.eye != camera.look_at, "{camera:?}");
        }
    }

    #[test]
    fn flat_meshes_have_z_up_and_are_seen_from_higher() {
        let usual = |max: [f32; 3]| ViewAngles::usual(Some(&Bounds { min: [0.0; 3], max }), false);
        let flat = usual([10.0, 8.0, 1.0]);
        assert!(flat.up == [0.0, 0.0, 1.0] && flat.rise > 0.5);
        for upright in [[1.0; 3], [10.0, 1.0, 10.0], [1.0, 10.0, 1.0], [10.0, 1.0, 1.0]] {
            assert_eq!(usual(upright), ViewAngles::usual(None, false), "{upright:?}");
        }
    }

    #[test]
    fn zooming_narrows_the_view() {
        let camera = Camera { eye: [0.0, 0.0, 2.0], look_at: [0.0; 3], up: [0.0, 1.0, 0.0], fov: 1.0 };
        let ratio = (camera.fov / 2.0).tan() / (camera.zoomed(2.0).fov / 2.0).tan();
        assert!((ratio - 2.0).abs() < 1e-5);
    }
}
