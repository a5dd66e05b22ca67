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

/// Parts that are weighed together.
pub(super) const LANES: usize = 8;

/// Motion of the eye in the model counts so many times less than motion of the model in the view: the eye is mostly
/// farther from the model than that is large.
pub(super) const EYE_SHARE: f32 = 0.55;

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

/// Refines the parts that are inside the frustum, face the camera, and whose stored error exceeds the pixel tolerance; with
/// [`of_model`](Self::of_model) each verdict says for how much motion of the camera it lasts \[Hop97\].
///
/// Stored errors are estimates unless they were certified for any state
/// ([`certify_collapses_in_any_state`](crate::simplify::certify_collapses_in_any_state)), so what is really on the screen can be
/// off by more than the tolerance: by up to 46 % on the measured meshes.
///
/// Errors are distances in any direction, as a flat screen shows them. Coordinates may lie between 1e-18 and 1e18.
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
    /// What is nearer than this weighs no more.
    pub(super) nearest: f32,
    /// Pixels of a unit one unit away, and pixels allowed.
    pub(super) scale: f32,
    pub(super) pixels: f32,
    pub(super) silhouette: Option<f32>,
    pub(super) region: Option<(Sphere, f32)>,
    pub(super) fovea: Option<(Fovea, Vec3)>,
}

impl ScreenError {
    /// Allows errors of so many pixels on a camera's screen; none at all where that is no number above 0.
    ///
    /// Squares of distances have to be numbers: coordinates and the sizes of models may be from 1e-18 to 1e18.
    pub fn new(camera: Camera, pixels: f32) -> Self {
        let half = camera.half.map(|half| half as f32);
        Self {
            model: None,
            nearest: f32::MIN_POSITIVE,
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
        let nearest = (model.radius * 1e-6).max(f32::MIN_POSITIVE);
        Self { model: Some(model), nearest, ..self }
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::Random;
    use crate::view::NormalCone;

    struct Draw(Random);

    impl Draw {
        fn number(&mut self, spread: f32) -> f32 {
            (self.0.unit() as f32 - 0.5) * spread
        }

        fn point(&mut self, spread: f32) -> [f32; 3] {
            [(); 3].map(|()| self.number(spread))
        }

        fn part(&mut self) -> Part {
            let axis = Vec3::from(self.point(2.0)).normalize();
            let sphere = Sphere { center: self.point(4.0), radius: self.number(0.6).abs() };
            let cos = 1.0 - self.number(2.2).abs();
            Part { sphere, cone: NormalCone { axis: axis.into(), cos }, error: self.number(0.03).abs() }
        }

        fn criterion(&mut self, eye: [f32; 3], kind: usize) -> ScreenError {
            let camera = Camera::new(eye, [0.1, 0.0, 0.2], [0.0, 1.0, 0.0], 0.6, [900, 700]).unwrap();
            kinds(ScreenError::new(camera, 1.0).of_model(MODEL), kind)
        }
    }

    const MODEL: Sphere = Sphere { center: [0.0; 3], radius: 4.0 };

    fn kinds(criterion: ScreenError, kind: usize) -> ScreenError {
        match kind {
            0 => criterion,
            1 => criterion.with_silhouettes(0.25),
            2 => criterion.with_region(Sphere { center: [1.0, 0.0, 0.0], radius: 0.8 }, 0.2),
            _ => criterion.with_fovea(Fovea { at: [0.3, 0.1], radius: 0.1, falloff: 20.0 }),
        }
    }

    #[test]
    fn a_verdict_lasts_as_long_as_it_says() {
        let mut draw = Draw(Random::new(11));
        let (mut lasted, mut changed) = (0, 0);
        for round in 0..120_000 {
            let kind = round % 4;
            // From afar the eye moves much where the picture moves little.
            let far = [1.0, 1.0, 8.0][round % 3];
            let eye = draw.point(9.0 * far);
            let before = draw.criterion(eye, kind);
            let size = [0.02, 0.1, 0.5, 1.0, 2.0][round % 5] * far;
            let aside = draw.point(size);
            let after = draw.criterion([0, 1, 2].map(|i| eye[i] + aside[i]), kind);
            let part = draw.part();
            let part = Part { error: part.error * far, ..part };
            let (first, second) = (before.weigh(&part), after.weigh(&part));
            let motion = after.motion_since(&before);
            let is_changed = first.is_wanted() != second.is_wanted();
            assert!(
                !(is_changed && motion < first.lasts),
                "{kind}: {part:?}: {first:?}, {second:?} after {motion}"
            );
            lasted += usize::from(motion < first.lasts);
            changed += usize::from(is_changed);
        }
        assert!(lasted > 20_000 && changed > 2000, "{lasted} verdicts lasted, {changed} changed");
    }

    #[test]
    fn what_lies_within_never_weighs_more() {
        let mut draw = Draw(Random::new(12));
        let mut unlike = 0;
        for round in 0..20_000 {
            let (eye, part) = (draw.point(9.0), draw.part());
            let criterion = draw.criterion(eye, round % 4);
            let aside = Vec3::from(draw.point(0.5));
            let sphere = Sphere { center: (Vec3::from(part.sphere.center) + aside).into(), ..part.sphere };
            let whole = Part { sphere: sphere.with_sphere(&part.sphere), error: part.error * 1.1, ..part };
            let [inner, outer] = [&part, &whole].map(|part| criterion.weigh(part).weight);
            // Spheres that touch the same side of the picture differ by rounding.
            assert!(
                inner <= outer * 1.0001 || outer == 0.0 && criterion.weigh(&whole).lasts < 1e-4,
                "{inner}, {outer}"
            );
            unlike += usize::from(inner < outer);
        }
        assert!(unlike > 3000);
    }

    #[test]
    fn weights_are_errors_in_pixels_over_what_is_allowed() {
        let mut draw = Draw(Random::new(13));
        let mut compared = 0;
        for _ in 0..20_000 {
            let (eye, part) = (draw.point(9.0), draw.part());
            let criterion = draw.criterion(eye, 0);
            let weight = criterion.weigh(&part).weight;
            let camera = criterion.camera();
            let is_hidden =
                !camera.may_see(&part.sphere) || part.cone.is_turned_away(&part.sphere, camera.eye());
            // The camera looks at a sphere as a whole, the criterion at its center and then at its radius.
            let middle = camera.error_px(part.error, &Sphere::point(part.sphere.center));
            if weight > 0.0 {
                assert!(!is_hidden || criterion.weigh(&part).lasts < 1e-3);
                let on_screen = camera.may_see(&Sphere::point(part.sphere.center));
                assert!(!on_screen || weight >= middle * 0.999, "{weight} of {middle}");
                compared += 1;
            }
        }
        assert!(compared > 3000, "{compared}");
    }

    #[test]
    fn silhouettes_regions_and_gaze_change_what_is_allowed() {
        let criterion = |kind| Draw(Random::new(1)).criterion([0.0, 0.0, 5.0], kind);
        let part = |center: [f32; 3], axis: [f32; 3]| Part {
            sphere: Sphere { center, radius: 0.05 },
            cone: NormalCone { axis, cos: 0.98 },
            error: 0.004,
        };
        let weight = |kind, part: &Part| criterion(kind).weigh(part).weight;
        let (front, edge) = (part([0.0; 3], [0.0, 0.0, 1.0]), part([0.0; 3], [1.0, 0.0, 0.0]));
        assert_eq!(weight(1, &front), weight(0, &front));
        assert!((weight(1, &edge) / weight(0, &edge) - 4.0).abs() < 1e-3);
        assert_eq!(weight(0, &part([0.0; 3], [0.0, 0.0, -1.0])), 0.0);
        let inside = part([1.0, 0.0, 0.0], [0.0, 0.0, 1.0]);
        assert!((weight(2, &inside) / weight(0, &inside) - 5.0).abs() < 1e-3);
        assert_eq!(weight(2, &front), weight(0, &front));
        let far_off = part([-1.5, -1.0, 0.0], [0.0, 0.0, 1.0]);
        assert!(weight(3, &far_off) < 0.7 * weight(0, &far_off) && weight(3, &far_off) > 0.0);
    }
}
