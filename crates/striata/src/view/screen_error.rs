//! The criterion of a camera: errors in pixels, of what is on the screen and does not turn its back.
//!
//! A part is refined if it can be seen and its error takes more pixels than allowed. All that is asked of it, how deep it lies
//! in the picture, how far it is turned away and how near it is, changes no faster than the eye moves; so each answer comes with how
//! far it is from the next one, and most parts need not be asked again for many frames \[Hop97\].
//!
//! Differs: \[Hop97\] looks at directions of errors, here an error is a distance in any direction; how the flat screen
//! stretches what is off its middle is counted.

use glam::{DMat3, Vec3};

use super::{Camera, Criterion, Part, Sphere, Verdict};

/// The most that a place in the view, once it has moved by one, changes the distance that errors are divided by.
const STRETCH: f32 = 1.16;

/// Motion of the eye in the model counts so many times less than motion of the model in the view: the eye is mostly
/// farther from the model than that is large.
const EYE_SHARE: f32 = 0.4;

/// More than rounding can do to a length here, in parts of it.
const SLACK: f32 = 4e-6;

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
    eye: Vec3,
    right: Vec3,
    up: Vec3,
    forward: Vec3,
    /// Lean of the sides of the picture, and what makes distances of them.
    half: [f32; 2],
    across: [f32; 2],
    corner: f32,
    /// Pixels of a unit one unit away, and pixels allowed.
    scale: f32,
    pixels: f32,
    silhouette: Option<f32>,
    region: Option<(Sphere, f32)>,
    fovea: Option<(Fovea, Vec3)>,
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

    /// Pixels allowed for a part that faces the eye, or may not, and how long that lasts.
    fn allowed(&self, part: &Part, faces: f32) -> (f32, f32) {
        let mut allowed = self.pixels;
        let mut lasts = f32::INFINITY;
        if let Some(pixels) = self.silhouette {
            if faces <= 0.0 {
                allowed = allowed.min(pixels);
            }
            lasts = faces.abs() * EYE_SHARE;
        }
        if let Some((region, pixels)) = &self.region {
            let apart = Vec3::from(part.sphere.center).distance(region.center.into());
            if apart <= (part.sphere.radius + region.radius) * (1.0 + SLACK) {
                allowed = allowed.min(*pixels);
            }
        }
        (allowed, lasts)
    }

    /// How many times more is allowed aside of where the eye looks, and the most by which motion changes that, times
    /// the distance.
    fn aside(&self, view: Vec3, distance: f32, radius: f32) -> (f32, f32) {
        let Some((fovea, gaze)) = &self.fovea else { return (1.0, 0.0) };
        // The chord is no longer than the angle; and the sphere spans no more than this.
        let chord = (view / distance).distance(*gaze) - 2.0 * radius / distance - fovea.radius;
        if distance > radius {
            (1.0 + fovea.falloff * chord.max(0.0), 8.0 * fovea.falloff)
        } else {
            (1.0, 0.0)
        }
    }
}

impl Criterion for ScreenError {
    #[inline]
    fn weigh(&self, part: &Part) -> Verdict {
        let sight = Vec3::from(part.sphere.center) - self.eye;
        let view = Vec3::new(sight.dot(self.right), sight.dot(self.up), sight.dot(self.forward));
        let square = sight.length_squared();
        let distance = square.sqrt();
        let radius = part.sphere.radius + (part.sphere.radius + distance) * SLACK;

        // How deep the sphere reaches into the picture, and how far its surface is turned away: both are no larger for
        // what lies within, and change no faster than the eye moves.
        let side = |i: usize| (self.half[i] * view.z - view[i].abs()) * self.across[i];
        let seen = side(0).min(side(1)).min(view.z) + radius;
        let along = sight.dot(part.cone.axis.into());
        let (cos, beside) = (part.cone.cos, (square - along * along).max(0.0).sqrt());
        let lean = beside * (1.0 - cos * cos).max(0.0).sqrt() + radius;
        let is_narrow = cos > 0.0;
        let away = if is_narrow { along * cos - lean } else { -distance - radius };
        let faces = if is_narrow { -along * cos - lean } else { -distance - radius };

        let (allowed, allowed_lasts) = self.allowed(part, faces);
        let (times, times_change) = self.aside(view, distance, radius);
        let cos_view = (view.z / distance).max(self.corner);
        let near = (distance * cos_view * cos_view - STRETCH * radius) * times;
        let needed = if part.error > 0.0 { part.error * self.scale / allowed } else { 0.0 };
        let far = (near - needed) / (STRETCH * times.max(1.0 + times_change) + times_change);
        let change_holds = if times_change > 0.0 { 0.5 * distance } else { f32::INFINITY };
        let error_lasts = far.abs().min(allowed_lasts).min(change_holds);

        let is_hidden = seen < 0.0 || away > 0.0;
        if !is_hidden {
            let weight = if near > 0.0 { needed / near } else { f32::INFINITY };
            let is_wanted = weight > 1.0;
            let lasts = if is_wanted { error_lasts.min(seen).min(-away * EYE_SHARE) } else { error_lasts };
            return Verdict { weight: if part.error > 0.0 { weight } else { 0.0 }, lasts };
        }
        let unneeded = if far > 0.0 { error_lasts } else { 0.0 };
        Verdict { weight: 0.0, lasts: unneeded.max(-seen).max(away * EYE_SHARE) }
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
        let turned = (turn - turn_before).to_cols_array().iter().map(|x| x * x).sum::<f64>().sqrt();
        let moved = center.distance(center_before) + turned * f64::from(model.radius);
        let eye = self.camera.eye.distance(earlier.camera.eye) * f64::from(EYE_SHARE);
        (moved.max(eye) * (1.0 + 1e-5)) as f32
    }
}
