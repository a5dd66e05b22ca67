//! Orbit camera: rotates around a target, pans, and zooms.

use striata::mesh::Bounds;
use striata_gpu::Viewpoint;

/// Vertical field of view, radians.
const FOV: f32 = 0.7;

/// Maximum rise, a degree less than a quarter turn: beyond it, the up direction would flip.
const MAX_RISE: f32 = 1.553_343;

/// Turn and rise of the initial view.
const INITIAL_ANGLES: [f32; 2] = [0.55, 0.3];

/// Up axis of the model.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) enum Up {
    /// Used by glTF.
    #[default]
    Y,
    /// Used by most CAD and terrain data.
    Z,
}

/// A camera that orbits around a target.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Orbit {
    /// Point in the middle of the screen, mesh units.
    target: [f64; 3],
    distance: f64,
    /// Angle around the up axis, radians.
    turn: f32,
    /// Angle above the horizon, radians.
    rise: f32,
    up: Up,
    /// Center and half the diagonal of the model's bounds.
    home: [f64; 3],
    radius: f64,
}

impl Default for Orbit {
    fn default() -> Self {
        Self::around(&Bounds { min: [-1.0; 3], max: [1.0; 3] }, Up::Y)
    }
}

impl Orbit {
    /// Shows all of a model from the front, slightly from above.
    pub(super) fn around(bounds: &Bounds, up: Up) -> Self {
        let home = std::array::from_fn(|k| (f64::from(bounds.min[k]) + f64::from(bounds.max[k])) / 2.0);
        let radius = (bounds.diagonal() / 2.0).max(f64::from(f32::MIN_POSITIVE));
        let mut orbit = Self { target: home, distance: 0.0, turn: 0.0, rise: 0.0, up, home, radius };
        orbit.reset();
        orbit
    }

    /// Resets to the initial view.
    pub(super) fn reset(&mut self) {
        self.target = self.home;
        self.distance = self.radius / f64::from(FOV / 2.0).sin();
        [self.turn, self.rise] = INITIAL_ANGLES;
    }

    /// Shows all of a box from the direction in which the camera looks.
    pub(super) fn frame(&mut self, bounds: &Bounds) {
        self.target = std::array::from_fn(|k| f64::midpoint(bounds.min[k].into(), bounds.max[k].into()));
        self.distance = (bounds.diagonal() / 2.0).max(1e-3 * self.radius) / f64::from(FOV / 2.0).sin();
    }

    /// Rotates by a drag of the pointer, in points; dragging across the picture's `height` is half a turn.
    pub(super) fn drag(&mut self, [x, y]: [f32; 2], height: f32) {
        let scale = std::f32::consts::PI / height.max(1.0);
        self.rotate(-x * scale, y * scale);
    }

    /// Rotates to the right and up, radians.
    pub(super) fn rotate(&mut self, turn: f32, rise: f32) {
        self.turn = (self.turn + turn) % std::f32::consts::TAU;
        self.rise = (self.rise + rise).clamp(-MAX_RISE, MAX_RISE);
    }

    /// Pans by points, so that the target stays under the pointer.
    pub(super) fn pan(&mut self, [x, y]: [f32; 2], height: f32) {
        let unit = 2.0 * self.distance * f64::from(FOV / 2.0).tan() / f64::from(height.max(1.0));
        let [right, up] = self.screen_axes();
        for k in 0..3 {
            self.target[k] += unit * (f64::from(y) * up[k] - f64::from(x) * right[k]);
        }
    }

    /// Multiplies the distance to the target, within limits.
    pub(super) fn zoom(&mut self, factor: f32) {
        let range = [1e-3 * self.radius, 100.0 * self.radius];
        self.distance = (self.distance * f64::from(factor)).clamp(range[0], range[1]);
    }

    /// The axis that points up.
    pub(super) fn up(&self) -> Up {
        self.up
    }

    /// Sets the axis that points up.
    pub(super) fn set_up(&mut self, up: Up) {
        self.up = up;
    }

    /// The camera as a viewpoint.
    pub(super) fn viewpoint(&self) -> Viewpoint {
        let out = self.outwards();
        Viewpoint {
            eye: std::array::from_fn(|k| (self.target[k] + self.distance * out[k]) as f32),
            look_at: self.target.map(|x| x as f32),
            up: self.in_model([0.0, 1.0, 0.0]).map(|x| x as f32),
            fov: FOV,
        }
    }

    /// Direction from the target to the eye.
    fn outwards(&self) -> [f64; 3] {
        let (turn, rise) = (f64::from(self.turn), f64::from(self.rise));
        self.in_model([rise.cos() * turn.sin(), rise.sin(), rise.cos() * turn.cos()])
    }

    /// Right and up directions of the screen.
    fn screen_axes(&self) -> [[f64; 3]; 2] {
        let (turn, rise) = (f64::from(self.turn), f64::from(self.rise));
        let right = [turn.cos(), 0.0, -turn.sin()];
        let up = [-rise.sin() * turn.sin(), rise.cos(), -rise.sin() * turn.cos()];
        [self.in_model(right), self.in_model(up)]
    }

    /// Converts a y-up direction to the model's axes.
    fn in_model(&self, [x, y, z]: [f64; 3]) -> [f64; 3] {
        match self.up {
            Up::Y => [x, y, z],
            Up::Z => [x, -z, y],
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const BOX: Bounds = Bounds { min: [-1.0, 2.0, 0.0], max: [3.0, 4.0, 1.0] };

    fn length(a: [f32; 3]) -> f32 {
        a.iter().map(|x| x * x).sum::<f32>().sqrt()
    }

    fn between(a: [f32; 3], b: [f32; 3]) -> f32 {
        length([0, 1, 2].map(|k| a[k] - b[k]))
    }

    #[test]
    fn the_initial_view_shows_the_whole_model() {
        for up in [Up::Y, Up::Z] {
            let view = Orbit::around(&BOX, up).viewpoint();
            assert_eq!(view.look_at, [1.0, 3.0, 0.5]);
            let radius = BOX.diagonal() as f32 / 2.0;
            let seen = between(view.eye, view.look_at) * (view.fov / 2.0).sin();
            assert!((seen - radius).abs() < 1e-4 * radius, "{up:?}: {seen} of {radius}");
        }
        let [y_up, z_up] = [Up::Y, Up::Z].map(|up| Orbit::around(&BOX, up).viewpoint());
        assert!(y_up.eye[1] > y_up.look_at[1] && z_up.eye[2] > z_up.look_at[2], "from above");
        assert!(y_up.eye[2] > y_up.look_at[2] && z_up.eye[1] < z_up.look_at[1], "from the front");
    }

    #[test]
    fn dragging_rotates_around_the_target_and_never_flips() {
        let mut orbit = Orbit::around(&BOX, Up::Y);
        let before = orbit.viewpoint();
        orbit.drag([100.0, 0.0], 400.0);
        let turned = orbit.viewpoint();
        assert_eq!(turned.look_at, before.look_at);
        let [old, new] = [before, turned].map(|view| between(view.eye, view.look_at));
        assert!((old - new).abs() < 1e-4 && between(before.eye, turned.eye) > 0.1);
        assert!((before.eye[1] - turned.eye[1]).abs() < 1e-4, "a drag across does not rise");
        for _ in 0..50 {
            orbit.drag([0.0, 300.0], 400.0);
        }
        let above = orbit.viewpoint();
        assert!(above.eye[1] > above.look_at[1]);
        assert!(above.camera([100, 100]).is_ok(), "straight down is still a direction");
    }

    #[test]
    fn panning_keeps_the_target_under_the_pointer() {
        for up in [Up::Y, Up::Z] {
            let mut orbit = Orbit::around(&BOX, up);
            orbit.rotate(0.4, 0.3);
            let before = orbit.viewpoint();
            orbit.pan([50.0, 0.0], 200.0);
            // 50 of 200 points to the right is half of half the screen: the old target is now there.
            let matrix = orbit.viewpoint().clip_from_model([0.0; 3], 10.0, 1.0);
            let [x, y, z] = before.look_at;
            let clip = [0, 1, 3].map(|row| {
                let row = matrix.row(row);
                row.x * x + row.y * y + row.z * z + row.w
            });
            let [right, high] = [clip[0] / clip[2], clip[1] / clip[2]];
            assert!((right - 0.5).abs() < 1e-3 && high.abs() < 1e-3, "{up:?}: {right} {high}");
        }
    }

    #[test]
    fn zooming_stays_within_limits() {
        let mut orbit = Orbit::around(&BOX, Up::Y);
        let distance = |orbit: &Orbit| between(orbit.viewpoint().eye, orbit.viewpoint().look_at);
        let first = distance(&orbit);
        orbit.zoom(0.5);
        assert!((distance(&orbit) - first / 2.0).abs() < 1e-4);
        (0..100).for_each(|_| orbit.zoom(0.5));
        assert!(distance(&orbit) > 0.0);
        (0..100).for_each(|_| orbit.zoom(4.0));
        assert!(distance(&orbit) < 1000.0);
        orbit.pan([10.0, 20.0], 100.0);
        orbit.reset();
        assert_eq!(orbit, Orbit::around(&BOX, Up::Y));
    }
}
