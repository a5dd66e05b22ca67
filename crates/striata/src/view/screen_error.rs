//! The criterion of a camera: errors in pixels, of what is on the screen and does not turn its back.
//!
//! A part is refined if it can be seen and its error takes more pixels than allowed. All that is asked of it, how deep it lies
//! in the picture, how far it is turned away and how near it is, changes no faster than the eye moves; so each answer comes with how
//! far it is from the next one, and most parts need not be asked again for many frames \[Hop97\].
//!
//! Differs: \[Hop97\] looks at directions of errors, here an error is a distance in any direction; how the flat screen
//! stretches what is off its middle is counted.

use glam::{DMat3, Vec3};

use super::screen_lanes::{EYE_SHARE, LANES};
use super::{Camera, Criterion, Part, Sphere, Verdict};

/// Where the eye looks at, and how fast it stops to care aside of that.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fovea {
    /// Place on the screen, from -1 to 1 each way, upwards and to the right.
    pub at: [f32; 2],
    /// Half the angle that is seen sharp, radians.
    pub radius: f32,
    /// What is allowed grows by so many times what it is in the middle for each radian beyond.
    pub falloff: f32,
}

/// Refines what takes too many pixels; see the [module](self).
#[derive(Clone, Debug, PartialEq)]
pub struct ScreenError {
    camera: Camera,
    model: Option<Sphere>,
    pub(super) eye: Vec3,
    pub(super) right: Vec3,
    pub(super) up: Vec3,
    pub(super) forward: Vec3,
    /// Lean of the sides of the picture, and what makes distances of them.
    pub(super) half: [f32; 2],
    pub(super) across: [f32; 2],
    pub(super) corner: f32,
    /// Pixels of a unit one unit away, and pixels allowed.
    pub(super) scale: f32,
    pub(super) pixels: f32,
    pub(super) silhouette: Option<f32>,
    pub(super) region: Option<(Sphere, f32)>,
    pub(super) fovea: Option<(Fovea, Vec3)>,
}

impl ScreenError {
    /// Allows errors of so many pixels on a camera's screen.
    pub fn new(camera: Camera, pixels: f32) -> Self {
        let half = camera.half.map(|half| half as f32);
        Self {
            model: None,
            eye: camera.eye.as_vec3(),
            right: camera.right.as_vec3(),
            up: camera.up.as_vec3(),
            forward: camera.forward.as_vec3(),
            half,
            across: camera.half.map(|half| (1.0 / (1.0 + half * half).sqrt()) as f32),
            corner: camera.corner_cos() as f32,
            scale: camera.pixels as f32,
            pixels,
            silhouette: None,
            region: None,
            fovea: None,
            camera,
        }
    }

    /// The same, with a sphere that holds all parts that will be asked for: without one nothing is known of how far they
    /// move in the view, and every verdict lasts for one view only.
    #[must_use]
    pub fn of_model(self, model: Sphere) -> Self {
        Self { model: Some(model), ..self }
    }

    /// The same, with another number of pixels allowed where the surface can turn from the eye: outlines show errors as
    /// steps against the background, where a surface that faces the eye hides them in its shading.
    #[must_use]
    pub fn with_silhouettes(self, pixels: f32) -> Self {
        Self { silhouette: Some(pixels), ..self }
    }

    /// The same, with another number of pixels allowed in a region of interest. What is allowed elsewhere may be infinite.
    #[must_use]
    pub fn with_region(self, region: Sphere, pixels: f32) -> Self {
        Self { region: Some((region, pixels)), ..self }
    }

    /// The same for an eye that looks at one place of the screen.
    #[must_use]
    pub fn with_fovea(self, fovea: Fovea) -> Self {
        let [x, y] = [0, 1].map(|i| fovea.at[i] * self.half[i]);
        let gaze = Vec3::new(x, y, 1.0).normalize();
        Self { fovea: Some((fovea, gaze)), ..self }
    }

    /// The camera.
    pub fn camera(&self) -> &Camera {
        &self.camera
    }

    /// Pixels allowed where nothing else is said.
    pub fn pixels(&self) -> f32 {
        self.pixels
    }
}

impl Criterion for ScreenError {
    fn weigh(&self, part: &Part) -> Verdict {
        let mut verdicts = [Verdict::now(0.0); LANES];
        self.weigh_lanes(std::slice::from_ref(part), &mut verdicts);
        verdicts[0]
    }

    fn weigh_all(&self, parts: &[Part], verdicts: &mut Vec<Verdict>) {
        let mut lanes = [Verdict::now(0.0); LANES];
        for parts in parts.chunks(LANES) {
            self.weigh_lanes(parts, &mut lanes);
            verdicts.extend_from_slice(&lanes[..parts.len()]);
        }
    }

    fn motion_since(&self, earlier: &Self) -> f32 {
        let (Some(model), Some(of_earlier)) = (&self.model, &earlier.model) else { return f32::INFINITY };
        let rest = |s: &Self| (s.half, s.scale, s.pixels, s.silhouette, s.region, s.fovea);
        if model != of_earlier || rest(self) != rest(earlier) {
            return f32::INFINITY;
        }
        let place = |s: &Self| {
            let camera = &s.camera;
            let turn = DMat3::from_cols(camera.right, camera.up, camera.forward).transpose();
            (turn, turn * (glam::DVec3::from(model.center.map(f64::from)) - camera.eye))
        };
        let ((turn, center), (turn_before, center_before)) = (place(self), place(earlier));
        // What a turn moves a point of the unit sphere by at most: its difference has two equal singular values.
        let squares = (turn - turn_before).to_cols_array().iter().map(|x| x * x).sum::<f64>();
        let turned = (squares / 2.0).sqrt();
        let moved = center.distance(center_before) + turned * f64::from(model.radius);
        let eye = self.camera.eye.distance(earlier.camera.eye) * f64::from(EYE_SHARE);
        (moved.max(eye) * (1.0 + 1e-5)) as f32
    }
}
