//! Screen-space error: the refinement criterion of a camera.
//!
//! A part is refined if it is visible and its error covers more pixels than allowed. Everything that this
//! depends on (the part's position in the view frustum, its orientation and its distance) changes no faster
//! than the eye moves. Each verdict therefore comes with a margin, the motion after which it may change, so
//! most parts need not be evaluated again for many frames \[Hop97\].
//!
//! Differs: \[Hop97\] considers the directions of errors, while here an error is a distance in any
//! direction. The stretching of a flat screen toward its corners is taken into account.

use glam::{DMat3, DMat4, DVec3, Vec3};

use super::{Camera, Criterion, Part, Sphere, Verdict};

/// Number of parts evaluated together.
pub(super) const LANES: usize = 8;

/// Weight of eye motion in the model compared with motion of the model in the view. It is less than 1
/// because the eye is usually farther from the model than the model is large.
pub(super) const EYE_SHARE: f32 = 0.55;

/// Maximum change of the effective distance, by which errors are divided, when a point moves by 1 in the
/// view. The effective distance is `d cos^2 a` at an angle `a` from the view axis, and its slope is `cos a
/// sqrt(4 - 3 cos^2 a)`.
pub(super) const STRETCH: f32 = 1.16;

/// The point of the screen that the viewer looks at, and how fast the error tolerance grows around it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fovea {
    /// Position on the screen, from -1 to 1 in both directions, to the right and upward.
    pub at: [f32; 2],
    /// Half the angle of sharp vision, in radians.
    pub radius: f32,
    /// Growth of the tolerance beyond that angle, per radian, as a multiple of the tolerance at the center.
    pub falloff: f32,
}

/// Refines the parts that are inside the frustum, face the camera, and exceed the pixel tolerance.
///
/// With [`with_model_bounds`](Self::with_model_bounds), each verdict states for how much camera motion
/// it remains valid \[Hop97\].
///
/// Stored errors are estimates unless they were certified for any state
/// ([`certify_collapses_in_any_state`](crate::simplify::certify_collapses_in_any_state)), so the actual
/// error on the screen can exceed the tolerance: by up to 46 % on the measured meshes.
///
/// Errors are distances in any direction, projected to a flat screen. Coordinates must be between 1e-18 and
/// 1e18.
#[derive(Clone, Debug, PartialEq)]
pub struct ScreenError {
    camera: Camera,
    model: Option<Sphere>,
    pub(super) eye: Vec3,
    /// Directions across the screen, to the right and upward. If the camera is off-center, they are inclined so that
    /// points on the line through the center of the screen are at 0.
    pub(super) across_screen: [Vec3; 2],
    pub(super) forward: Vec3,
    /// Half the width and height of the screen, at unit distance if the camera is perspective.
    pub(super) half: [f32; 2],
    pub(super) is_orthographic: bool,
    /// Inverse lengths of the side planes' normals, which turn offsets from a plane into distances.
    pub(super) across: [f32; 2],
    /// Cosine of the angle between the view axis and a corner of the screen.
    pub(super) corner: f32,
    /// Effective distances are clamped to this minimum.
    pub(super) nearest: f32,
    /// Pixels per unit of length, at unit distance if the camera is perspective.
    pub(super) scale: f32,
    /// Tolerance, in pixels.
    pub(super) pixels: f32,
    /// Tolerance on silhouettes, in pixels.
    pub(super) silhouette: Option<f32>,
    /// A region and the tolerance inside it, in pixels.
    pub(super) region: Option<(Sphere, f32)>,
    /// The fovea and the direction of the gaze, relative to the camera.
    pub(super) fovea: Option<(Fovea, Vec3)>,
    /// Motion for which decisions to leave a part coarse have to hold.
    pub(super) reserve: f32,
    /// Criteria of other views, of which any may refine a part.
    pub(super) others: Vec<ScreenError>,
}

impl ScreenError {
    /// Allows errors of up to `pixels` pixels on the screen of a camera; anything but a positive number
    /// allows none.
    ///
    /// Coordinates and sizes of models must be between 1e-18 and 1e18, so that f32 can represent their
    /// squares.
    pub fn new(camera: Camera, pixels: f32) -> Self {
        let inclined = |axis: DVec3, shift: f64| (axis - camera.forward * shift).as_vec3();
        let side_length = |side: f64| if camera.is_orthographic { 1.0 } else { (1.0 + side * side).sqrt() };
        Self {
            model: None,
            nearest: f32::MIN_POSITIVE,
            eye: camera.eye.as_vec3(),
            across_screen: [inclined(camera.right, camera.shift[0]), inclined(camera.up, camera.shift[1])],
            forward: camera.forward.as_vec3(),
            half: camera.half.map(|half| half as f32),
            is_orthographic: camera.is_orthographic,
            across: camera.sides().map(|side| (1.0 / side_length(side)) as f32),
            corner: camera.corner_cos() as f32,
            scale: camera.pixels as f32,
            pixels,
            silhouette: None,
            region: None,
            fovea: None,
            reserve: 0.0,
            others: Vec::new(),
            camera,
        }
    }

    /// Also refines whatever another criterion refines, such as that of the other eye or of a shadow's camera.
    ///
    /// Silhouettes, a region and a fovea that are set later apply to this camera alone; everything else applies to
    /// all cameras.
    #[must_use]
    pub fn or(mut self, other: Self) -> Self {
        self.others.push(other);
        self
    }

    /// Sets a bounding sphere of all parts that will be evaluated. Without it, the motion between two views
    /// is unknown, and every verdict is valid for one view only.
    #[must_use]
    pub fn with_model_bounds(self, model: Sphere) -> Self {
        // The effective distance of an orthographic camera is always 1.
        let nearest = if self.is_orthographic { 0.0 } else { model.radius * 1e-6 };
        let with_bounds =
            |one: Self| Self { model: Some(model), nearest: nearest.max(f32::MIN_POSITIVE), ..one };
        with_bounds(self).for_others(|other| other.with_model_bounds(model))
    }

    /// Refines a little more, so that nothing that is left coarse is too coarse before the view has moved by more than
    /// `motion`, as measured by [`motion_since`](Criterion::motion_since). An instance need not be updated until then.
    ///
    /// The tolerance must not be relaxed by a fovea.
    #[must_use]
    pub fn with_reserve(self, motion: f32) -> Self {
        Self { reserve: motion.max(0.0), ..self }.for_others(|other| other.with_reserve(motion))
    }

    /// Returns the motion of the view within which no error of the model grows by more than about a share of itself; 0
    /// if that is unknown, if the eye may touch the model, or with a fovea.
    pub fn motion_of_growth(&self, share: f32) -> f32 {
        let own = match &self.model {
            Some(_) if self.fovea.is_some() => 0.0,
            // Errors do not grow, but the picture may show other parts.
            Some(_) if self.is_orthographic => share * self.half[0].min(self.half[1]),
            Some(model) => self.scale / self.camera.error_px(1.0, model) * share / ((1.0 + share) * STRETCH),
            None => 0.0,
        };
        self.others.iter().fold(own, |least, other| least.min(other.motion_of_growth(share)))
    }

    /// The motion set by [`with_reserve`](Self::with_reserve).
    pub fn reserve(&self) -> f32 {
        self.reserve
    }

    /// The sphere set by [`with_model_bounds`](Self::with_model_bounds).
    pub fn model(&self) -> Option<Sphere> {
        self.model
    }

    fn for_others(mut self, change: impl Fn(Self) -> Self) -> Self {
        self.others = self.others.into_iter().map(change).collect();
        self
    }

    /// Sets a stricter tolerance for parts that may be on the silhouette. Errors there are visible as steps
    /// against the background, while surfaces that face the eye hide them in their shading.
    #[must_use]
    pub fn with_silhouettes(self, pixels: f32) -> Self {
        Self { silhouette: Some(pixels), ..self }
    }

    /// Sets a stricter tolerance inside a region of interest. The tolerance elsewhere may be infinite.
    #[must_use]
    pub fn with_region(self, region: Sphere, pixels: f32) -> Self {
        Self { region: Some((region, pixels)), ..self }
    }

    /// Relaxes the tolerance away from the point of the screen that the viewer looks at. An orthographic camera has no
    /// angles, so this does not change it.
    #[must_use]
    pub fn with_fovea(self, fovea: Fovea) -> Self {
        if self.is_orthographic {
            return self;
        }
        let [x, y] = [0, 1].map(|i| fovea.at[i] * self.half[i] + self.camera.shift[i] as f32);
        let gaze = Vec3::new(x, y, 1.0).normalize();
        Self { fovea: Some((fovea, gaze)), ..self }
    }

    /// Multiplies all tolerances by a factor.
    #[must_use]
    pub fn relaxed(self, factor: f32) -> Self {
        let [silhouette, region] = [self.silhouette.map(|px| px * factor), self.region.map(|r| r.1 * factor)];
        let region = self.region.map(|(sphere, _)| sphere).zip(region);
        Self { pixels: self.pixels * factor, silhouette, region, ..self }
            .for_others(|other| other.relaxed(factor))
    }

    /// Raises all tolerances to at least `pixels`.
    #[must_use]
    pub fn at_least(self, pixels: f32) -> Self {
        Self {
            pixels: self.pixels.max(pixels),
            silhouette: self.silhouette.map(|tolerance| tolerance.max(pixels)),
            region: self.region.map(|(sphere, tolerance)| (sphere, tolerance.max(pixels))),
            ..self
        }
        .for_others(|other| other.at_least(pixels))
    }

    /// Returns the same criterion for an object that is shown with a transform, in units of the object.
    ///
    /// `transform` is a matrix in column order, from the object to the space of this criterion. The result
    /// has no model bounds. [`None`] if the transform is anything but a rotation with a translation and a
    /// uniform scale, because errors in all directions would then not appear equally large.
    pub fn in_object(&self, transform: &[f64; 16]) -> Option<Self> {
        let matrix = DMat4::from_cols_array(transform);
        let linear = DMat3::from_mat4(matrix);
        let (squares, scale) = (linear.transpose() * linear, linear.x_axis.length());
        let is_similar =
            squares.abs_diff_eq(DMat3::from_diagonal(DVec3::splat(scale * scale)), 1e-5 * scale * scale);
        if !(is_similar && linear.determinant() > 0.0 && matrix.is_finite()) {
            return None;
        }
        let camera = self.camera.moved(&matrix.inverse());
        let region = self.region.map(|(region, pixels)| {
            let center = matrix.inverse().transform_point3(DVec3::from(region.center.map(f64::from)));
            let radius = (f64::from(region.radius) / scale) as f32;
            (Sphere { center: center.as_vec3().into(), radius }, pixels)
        });
        let Self { silhouette, fovea, .. } = *self;
        let others = self.others.iter().map(|other| other.in_object(transform)).collect::<Option<_>>()?;
        Some(Self { silhouette, region, fovea, others, ..Self::new(camera, self.pixels) })
    }

    /// Radius of the model, or 1 if it is unknown.
    pub(super) fn model_radius(&self) -> f32 {
        self.model.map_or(1.0, |model| model.radius.max(f32::MIN_POSITIVE))
    }

    /// The camera; the first one if there are several.
    pub fn camera(&self) -> &Camera {
        &self.camera
    }

    /// Tolerance in pixels outside silhouettes, region and fovea.
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
        let (Some(model), Some(earlier_model)) = (&self.model, &earlier.model) else { return f32::INFINITY };
        let rest = |s: &Self| (s.half, s.scale, s.pixels, s.silhouette, s.region, s.fovea, s.reserve);
        let lens = |s: &Self| (s.is_orthographic, s.camera.shift, s.others.len());
        if model != earlier_model || rest(self) != rest(earlier) || lens(self) != lens(earlier) {
            return f32::INFINITY;
        }
        // An orthographic picture does not depend on the distance.
        let depth_scale = if self.is_orthographic { 0.0 } else { 1.0 };
        let placement = |s: &Self| {
            let camera = &s.camera;
            let rotation = DMat3::from_cols(camera.right, camera.up, camera.forward).transpose();
            let center = rotation * (DVec3::from(model.center.map(f64::from)) - camera.eye);
            (rotation, center * DVec3::new(1.0, 1.0, depth_scale))
        };
        let ((rotation, center), (rotation_before, center_before)) = (placement(self), placement(earlier));
        // Bounds how far the rotation moves a point of the unit sphere: the difference of two rotations has
        // two equal singular values.
        let squares = (rotation - rotation_before).to_cols_array().iter().map(|x| x * x).sum::<f64>();
        let rotated = (squares / 2.0).sqrt();
        let moved = center.distance(center_before) + rotated * f64::from(model.radius);
        let eye = self.camera.eye.distance(earlier.camera.eye) * f64::from(EYE_SHARE) * depth_scale;
        let motion = (moved.max(eye) * (1.0 + 1e-5)) as f32;
        let motions = self.others.iter().zip(&earlier.others).map(|(now, earlier)| now.motion_since(earlier));
        motions.fold(motion, f32::max)
    }
}

#[cfg(test)]
mod tests {
    use glam::DQuat;

    use super::*;
    use crate::mesh::Random;
    use crate::view::NormalCone;

    struct RandomInput(Random);

    impl RandomInput {
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
            kinds(ScreenError::new(camera(eye), 1.0).with_model_bounds(MODEL), kind)
        }
    }

    fn camera(eye: [f32; 3]) -> Camera {
        Camera::new(eye, [0.1, 0.0, 0.2], [0.0, 1.0, 0.0], 0.6, [900, 700]).unwrap()
    }

    fn orthographic(eye: [f32; 3]) -> Camera {
        Camera { is_orthographic: true, half: [1.3, 1.0], pixels: 350.0, ..camera(eye) }
    }

    const KIND_COUNT: usize = 8;

    const MODEL: Sphere = Sphere { center: [0.0; 3], radius: 4.0 };

    fn kinds(criterion: ScreenError, kind: usize) -> ScreenError {
        match kind {
            0 => criterion,
            1 => criterion.with_silhouettes(0.25),
            2 => criterion.with_region(Sphere { center: [1.0, 0.0, 0.0], radius: 0.8 }, 0.2),
            3 => criterion.with_fovea(Fovea { at: [0.3, 0.1], radius: 0.1, falloff: 20.0 }),
            4 => seen_by(off_center(&criterion)),
            5 => seen_by(orthographic(criterion.camera.eye())),
            6 => criterion.clone().or(seen_by(orthographic(criterion.camera.eye())).with_silhouettes(0.25)),
            _ => {
                let fovea = Fovea { at: [0.3, 0.1], radius: 0.1, falloff: 20.0 };
                seen_by(off_center(&criterion)).with_silhouettes(0.25).with_fovea(fovea)
            }
        }
    }

    fn seen_by(camera: Camera) -> ScreenError {
        ScreenError::new(camera, 1.0).with_model_bounds(MODEL)
    }

    fn off_center(criterion: &ScreenError) -> Camera {
        Camera { shift: [0.5, -0.8], ..criterion.camera }
    }

    #[test]
    fn verdicts_hold_within_their_margins() {
        let mut input = RandomInput(Random::new(11));
        let (mut lasted, mut changed) = ([0; KIND_COUNT], [0; KIND_COUNT]);
        for round in 0..240_000 {
            let kind = round % KIND_COUNT;
            // From a distance, large motions of the eye cause only small motions in the picture.
            let far = [1.0, 1.0, 8.0][round % 3];
            let eye = input.point(9.0 * far);
            let before = input.criterion(eye, kind);
            let size = [0.02, 0.1, 0.5, 1.0, 2.0][round % 5] * far;
            let offset = input.point(size);
            let after = input.criterion([0, 1, 2].map(|i| eye[i] + offset[i]), kind);
            let part = input.part();
            let part = Part { error: part.error * far, ..part };
            let (first, second) = (before.weigh(&part), after.weigh(&part));
            let motion = after.motion_since(&before);
            let is_changed = first.should_refine() != second.should_refine();
            assert!(
                !(is_changed && motion < first.motion_margin),
                "{kind}: {part:?}: {first:?}, {second:?} after {motion}"
            );
            lasted[kind] += usize::from(motion < first.motion_margin);
            changed[kind] += usize::from(is_changed);
        }
        let are_enough = lasted.iter().all(|n| *n > 4000) && changed.iter().all(|n| *n > 250);
        assert!(are_enough, "{lasted:?} verdicts lasted, {changed:?} changed");
    }

    #[test]
    fn a_reserve_lasts_for_its_motion() {
        let mut input = RandomInput(Random::new(14));
        let (mut lasted, mut needed) = ([0; KIND_COUNT], [0; KIND_COUNT]);
        for round in 0..160_000 {
            let kind = [0, 1, 2, 4, 5, 6][round % 6];
            let eye = input.point(9.0);
            let before = input.criterion(eye, kind);
            let size = [0.02, 0.1, 0.5, 1.0][round % 4];
            let offset = input.point(size);
            let after = input.criterion([0, 1, 2].map(|i| eye[i] + offset[i]), kind);
            let part = input.part();
            let motion = after.motion_since(&before);
            let reserved = before.clone().with_reserve(motion * 1.0001).weigh(&part);
            assert!(reserved.should_refine() || !after.weigh(&part).should_refine(), "{kind}: {part:?}");
            lasted[kind] += usize::from(!reserved.should_refine());
            let is_due = after.weigh(&part).should_refine() && !before.weigh(&part).should_refine();
            needed[kind] += usize::from(is_due);
        }
        assert!(lasted.iter().sum::<usize>() > 20_000, "{lasted:?} parts stayed coarse");
        assert!(needed.iter().sum::<usize>() > 1000, "{needed:?} parts needed the reserve");
    }

    #[test]
    fn several_cameras_refine_whatever_any_of_them_needs() {
        let mut input = RandomInput(Random::new(15));
        let mut differing = 0;
        for round in 0..20_000 {
            let (kind, part) = (round % KIND_COUNT, input.part());
            let [first, second] = [input.point(9.0), input.point(9.0)].map(|eye| input.criterion(eye, kind));
            let both = first.clone().or(second.clone());
            let [a, b, verdict] = [&first, &second, &both].map(|criterion| criterion.weigh(&part));
            assert_eq!(verdict.weight, a.weight.max(b.weight));
            differing += usize::from(a.should_refine() != b.should_refine());
            let twice = first.clone().or(first.clone());
            assert_eq!(both.motion_since(&twice), second.motion_since(&first));
        }
        assert!(differing > 1000, "{differing}");
    }

    #[test]
    fn parts_weigh_as_much_together_as_alone() {
        let mut input = RandomInput(Random::new(16));
        for kind in 0..KIND_COUNT {
            let eye = input.point(9.0);
            let criterion = input.criterion(eye, kind).with_reserve(0.01);
            let parts: Vec<Part> = (0..77).map(|_| input.part()).collect();
            let mut verdicts = Vec::new();
            criterion.weigh_all(&parts, &mut verdicts);
            assert_eq!(verdicts.len(), parts.len());
            assert!(parts.iter().zip(&verdicts).all(|(part, verdict)| criterion.weigh(part) == *verdict));
        }
    }

    #[test]
    fn parts_never_weigh_more_than_the_parts_around_them() {
        let mut input = RandomInput(Random::new(12));
        let mut different_count = 0;
        for round in 0..20_000 {
            let (eye, part) = (input.point(9.0), input.part());
            let criterion = input.criterion(eye, round % KIND_COUNT);
            let offset = Vec3::from(input.point(0.5));
            let sphere = Sphere { center: (Vec3::from(part.sphere.center) + offset).into(), ..part.sphere };
            let whole = Part { sphere: sphere.with_sphere(&part.sphere), error: part.error * 1.1, ..part };
            let [inner, outer] = [&part, &whole].map(|part| criterion.weigh(part).weight);
            // Spheres that touch the same side of the frustum differ by rounding.
            assert!(
                inner <= outer * 1.0001 || outer == 0.0 && criterion.weigh(&whole).motion_margin < 1e-4,
                "{inner}, {outer}"
            );
            different_count += usize::from(inner < outer);
        }
        assert!(different_count > 3000);
    }

    #[test]
    fn weights_are_errors_in_pixels_over_the_tolerance() {
        let mut input = RandomInput(Random::new(13));
        let mut compared = 0;
        for round in 0..40_000 {
            let (eye, part) = (input.point(9.0), input.part());
            let kind = [0, 4, 5][round % 3];
            let criterion = input.criterion(eye, kind);
            let weight = criterion.weigh(&part).weight;
            let camera = criterion.camera();
            let is_hidden = !camera.may_see(&part.sphere) || part.cone.is_turned_away(&part.sphere, camera);
            // The camera bounds the error over the whole sphere; the criterion uses the center first and
            // then the radius.
            let middle = camera.error_px(part.error, &Sphere::point(part.sphere.center));
            if weight > 0.0 {
                // The sides of an off-center camera are not exact here.
                assert!(!is_hidden || kind == 4 || criterion.weigh(&part).motion_margin < 1e-3);
                let on_screen = camera.may_see(&Sphere::point(part.sphere.center));
                assert!(!on_screen || weight >= middle * 0.999, "{weight} of {middle}");
                compared += 1;
            }
        }
        assert!(compared > 3000, "{compared}");
    }

    #[test]
    fn silhouettes_regions_and_gaze_change_the_tolerance() {
        let criterion = |kind| RandomInput(Random::new(1)).criterion([0.0, 0.0, 5.0], kind);
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
    #[test]
    fn an_object_looks_the_same_in_its_own_space() {
        let mut input = RandomInput(Random::new(21));
        for round in 0..1600 {
            let scale = f64::from(input.number(3.0).abs() + 0.1);
            let axis = Vec3::from(input.point(1.0)).as_dvec3().normalize();
            let (angle, offset) = (f64::from(input.number(6.0)), Vec3::from(input.point(4.0)).as_dvec3());
            let rotation = DQuat::from_axis_angle(axis, angle);
            let matrix = DMat4::from_scale_rotation_translation(DVec3::splat(scale), rotation, offset);
            let eye = input.point(9.0);
            let criterion = input.criterion(eye, round % KIND_COUNT);
            let inside = criterion.in_object(&matrix.to_cols_array()).expect("a similarity");
            let part = input.part();
            let center = matrix.transform_point3(Vec3::from(part.sphere.center).as_dvec3()).as_vec3();
            let axis = (rotation * Vec3::from(part.cone.axis).as_dvec3()).as_vec3();
            let in_scene = Part {
                sphere: Sphere { center: center.into(), radius: part.sphere.radius * scale as f32 },
                cone: NormalCone { axis: axis.into(), ..part.cone },
                error: part.error * scale as f32,
            };
            let [own, outer] = [inside.weigh(&part).weight, criterion.weigh(&in_scene).weight];
            // At the limits of the frustum and of the cone, rounding decides.
            let is_near_limit = own == 0.0 || outer == 0.0;
            assert!(is_near_limit || (own / outer - 1.0).abs() < 1e-3, "{own}, {outer}");
        }
        for bad in [[1.0, 2.0, 1.0], [-1.0, 1.0, 1.0], [0.0; 3]] {
            let matrix = DMat4::from_scale(DVec3::from(bad)).to_cols_array();
            assert_eq!(input.criterion([0.0, 0.0, 5.0], 0).in_object(&matrix), None);
        }
    }
}
