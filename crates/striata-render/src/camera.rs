//! Cameras, and how to place one so that all points are in the picture.

use glam::DVec3;
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
pub(crate) type Axes = [DVec3; 3];

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
        let lies_flat = bounds.is_some_and(Bounds::lies_flat);
        let (up, rise): (_, f32) =
            if lies_flat || is_terrain { ([0.0, 0.0, 1.0], 40.0) } else { ([0.0, 1.0, 0.0], 8.0) };
        Self { turn: (-35.0f32).to_radians(), rise: rise.to_radians(), up, fov: 27.0f32.to_radians() }
    }
}

impl Camera {
    /// Places the camera as close as possible in a direction such that all points are in a picture of
    /// this aspect ratio, with a margin.
    pub fn around(points: &[[f32; 3]], angles: &ViewAngles, aspect: f32) -> Self {
        let up = to_f64(angles.up).normalize_or_zero();
        let front = front_of(up);
        let side = up.cross(front);
        let (turn, rise) = (f64::from(angles.turn), f64::from(angles.rise));
        let level = turn.cos() * front + turn.sin() * side;
        let back = rise.cos() * level + rise.sin() * up;
        // Seen straight from above, up is where the back was.
        let upright = if rise.cos().abs() < 1e-3 { -rise.signum() * level } else { up };
        let right = upright.cross(back).normalize_or_zero();
        let axes = [right, back.cross(right), back];
        let eye = fit_eye(points, &axes, f64::from(angles.fov), f64::from(aspect));
        let at = |away: f64| (eye.position - away * back).as_vec3().to_array();
        Self { eye: at(0.0), look_at: at(eye.distance), up: axes[1].as_vec3().into(), fov: angles.fov }
    }

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

    /// Zooms by narrowing the field of view, without moving.
    pub fn zoomed(self, zoom: f32) -> Self {
        Self { fov: 2.0 * ((self.fov / 2.0).tan() / zoom).atan(), ..self }
    }

    /// Aspect ratio (width by height) of some points as seen by this camera.
    pub fn aspect_of(&self, points: &[[f32; 3]]) -> f32 {
        let [right, up, back] = self.axes();
        let (mut min, mut max) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
        for point in points {
            let p = to_f64(*point) - self.eye_64();
            let depth = -p.dot(back);
            for (k, axis) in [right, up].into_iter().enumerate().filter(|_| depth > 0.0) {
                let ratio = p.dot(axis) / depth;
                (min[k], max[k]) = (min[k].min(ratio), max[k].max(ratio));
            }
        }
        let ratio = (max[0] - min[0]) / (max[1] - min[1]);
        if ratio.is_finite() { (ratio as f32).clamp(0.05, 20.0) } else { 1.0 }
    }

    /// Axes of the screen.
    pub(crate) fn axes(&self) -> Axes {
        let back = (self.eye_64() - to_f64(self.look_at)).normalize_or(DVec3::Z);
        let mut right = to_f64(self.up).cross(back);
        if right.length_squared() < 1e-20 {
            right = front_of(back).cross(back);
        }
        let right = right.normalize_or(back.any_orthonormal_vector());
        [right, back.cross(right), back]
    }

    /// Distance of the near plane: a thousandth of the mesh in front of the eye, or just in front of the mesh if
    /// the eye is outside.
    pub(crate) fn near_plane(&self, center: DVec3, radius: f64) -> f64 {
        let radius = radius.max(1e-30);
        (self.eye_64().distance(center) - 1.001 * radius).max(1e-3 * radius)
    }

    /// Position of the eye in 64 bits.
    pub(crate) fn eye_64(&self) -> DVec3 {
        to_f64(self.eye)
    }
}

/// Position of an eye, and its distance to the middle of the points.
struct EyePosition {
    position: DVec3,
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
        let [x, y, z] = axes.map(|axis| axis.dot(to_f64(*point)));
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
    let position = offset[0] * axes[0] + offset[1] * axes[1] + depth * axes[2];
    EyePosition { position, distance: depth - (near + far) / 2.0 }
}

/// Front direction of an upright mesh: toward the viewer, perpendicular to up.
fn front_of(up: DVec3) -> DVec3 {
    // With z up, as in surveying and printing, the front faces -y.
    let preferred = if up.z.abs() > 0.8 { DVec3::NEG_Y } else { DVec3::Z };
    (preferred - preferred.dot(up) * up).normalize_or_zero()
}

pub(crate) fn to_f64(v: [f32; 3]) -> DVec3 {
    DVec3::from(v.map(f64::from))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn on_screen(camera: &Camera, aspect: f64, point: [f32; 3]) -> [f64; 2] {
        let [right, up, back] = camera.axes();
        let p = to_f64(point) - camera.eye_64();
        let high = -p.dot(back) * (f64::from(camera.fov) / 2.0).tan();
        assert!(high > 0.0, "{point:?} is behind the eye");
        [p.dot(right) / (high * aspect), p.dot(up) / high]
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
