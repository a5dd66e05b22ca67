//! SIMD evaluation of screen-space errors, eight parts at a time: a frame may evaluate tens of thousands.

use glam::Vec3;
use wide::f32x8;

use super::screen_error::{EYE_SHARE, LANES, STRETCH};
use super::{Part, ScreenError, Verdict};

/// Upper bound on the relative rounding error of a length here.
const SLACK: f32 = 4e-6;

/// Upper bound on the relative rounding error of a squared length and its squared component along an axis.
const ALONG_SLACK: f32 = 1e-6;

/// Up to eight parts, transposed to one vector per number.
struct Lanes {
    center: [f32x8; 3],
    axis: [f32x8; 3],
    cos: f32x8,
    radius: f32x8,
    error: f32x8,
}

/// Positions of parts relative to the view.
struct ViewPositions {
    /// Coordinates to the right, upward and into the picture.
    view: [f32x8; 3],
    eye_to_center: [f32x8; 3],
    square: f32x8,
    distance: f32x8,
    /// Radius of the parts, enlarged to cover rounding.
    radius: f32x8,
}

/// Lines of sight from the camera to the centers of parts, and the radius of the parts.
struct LinesOfSight {
    to_center: [f32x8; 3],
    square: f32x8,
    distance: f32x8,
    radius: f32x8,
}

/// Relaxed tolerance away from the fovea.
struct FoveaRelaxation {
    /// Factor on the tolerance.
    factor: f32x8,
    /// Maximum change of the effective distance per unit of motion caused by this factor.
    slope: f32x8,
    /// Motion up to which `slope` holds.
    motion_margin: f32x8,
}

impl Lanes {
    #[inline]
    fn new(parts: &[Part]) -> Self {
        let mut lanes = [[0.0; LANES]; 9];
        for (i, Part { sphere, cone, error }) in parts.iter().enumerate().take(LANES) {
            let ([x, y, z], [u, v, w]) = (sphere.center, cone.axis);
            let numbers = [x, y, z, u, v, w, cone.cos, sphere.radius, *error];
            for (lane, number) in lanes.iter_mut().zip(numbers) {
                lane[i] = number;
            }
        }
        let [x, y, z, u, v, w, cos, radius, error] = lanes.map(f32x8::from);
        Self { center: [x, y, z], axis: [u, v, w], cos, radius, error }
    }
}

#[inline]
fn splat(number: f32) -> f32x8 {
    f32x8::from([number; LANES])
}

#[inline]
fn dot(a: [f32x8; 3], b: [f32x8; 3]) -> f32x8 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

#[inline]
fn minus(a: [f32x8; 3], b: Vec3) -> [f32x8; 3] {
    [a[0] - splat(b.x), a[1] - splat(b.y), a[2] - splat(b.z)]
}

#[inline]
fn splat3(v: Vec3) -> [f32x8; 3] {
    [splat(v.x), splat(v.y), splat(v.z)]
}

impl ScreenError {
    /// Evaluates up to eight parts.
    #[inline]
    pub(super) fn weigh_lanes(&self, parts: &[Part], verdicts: &mut [Verdict; LANES]) {
        let lanes = Lanes::new(parts);
        self.weigh_for_camera(&lanes, verdicts);
        for other in &self.others {
            let mut verdicts_of_other = [Verdict::now(0.0); LANES];
            other.weigh_lanes(parts, &mut verdicts_of_other);
            for (verdict, of_other) in verdicts.iter_mut().zip(verdicts_of_other) {
                *verdict = verdict.or(of_other);
            }
        }
    }

    #[inline]
    fn weigh_for_camera(&self, lanes: &Lanes, verdicts: &mut [Verdict; LANES]) {
        let positions = self.positions(lanes);
        let seen = self.seen(&positions);
        let [away, faces] = facing(lanes, &self.sight(&positions));
        let (allowed, allowed_margin) = self.allowed(lanes, faces);
        let FoveaRelaxation { factor, slope: factor_slope, motion_margin: factor_margin } =
            self.fovea_relaxation(&positions);

        // All quantities change no faster than the view moves, and are no larger for parts inside a part.
        let (near, near_slope) = if self.is_orthographic {
            (splat(1.0), splat(f32::MIN_POSITIVE))
        } else {
            let cos = (positions.view[2] / positions.distance).fast_max(splat(self.corner));
            let near = positions.distance * cos * cos - splat(STRETCH) * positions.radius;
            (near * factor, splat(STRETCH) * factor + factor_slope)
        };
        // If the eye may touch a part, no error is small enough; errors still determine the order.
        let nearest = splat(self.nearest);
        let touched = near.simd_le(nearest).bitselect(splat(2.0), splat(0.0));
        let needed = (lanes.error * splat(self.scale) / allowed).fast_min(splat(f32::MAX));
        let change = (near - needed).abs().fast_min((near - nearest).abs());
        let error_margin = (change / near_slope).fast_min(allowed_margin).fast_min(factor_margin);

        let weight =
            needed / near.fast_max(nearest) + needed.simd_gt(splat(0.0)).bitselect(touched, splat(0.0));
        let is_large = weight.simd_gt(splat(1.0));
        let is_hidden = seen.simd_lt(splat(0.0)) | away.simd_gt(splat(0.0));
        let weight = is_hidden.bitselect(splat(0.0), weight);
        let eye_share = splat(EYE_SHARE);
        let margin_if_large = error_margin.fast_min(seen).fast_min(-away * eye_share);
        let margin_if_small = is_large.bitselect(splat(0.0), error_margin);
        let margin_if_hidden = margin_if_small.fast_max(-seen).fast_max(away * eye_share);
        let motion_margin =
            is_hidden.bitselect(margin_if_hidden, is_large.bitselect(margin_if_large, margin_if_small));
        let (weight, motion_margin) = (weight.to_array(), motion_margin.fast_max(splat(0.0)).to_array());
        for ((verdict, &weight), &motion_margin) in verdicts.iter_mut().zip(&weight).zip(&motion_margin) {
            *verdict = Verdict { weight, motion_margin };
        }
    }

    #[inline]
    fn positions(&self, lanes: &Lanes) -> ViewPositions {
        let eye_to_center = minus(lanes.center, self.eye);
        let square = dot(eye_to_center, eye_to_center);
        // A part whose center is at the eye lies in no direction; any direction will do.
        let distance = square.sqrt() + splat(f32::MIN_POSITIVE);
        ViewPositions {
            view: [self.across_screen[0], self.across_screen[1], self.forward]
                .map(|axis| dot(eye_to_center, splat3(axis))),
            eye_to_center,
            square,
            distance,
            radius: lanes.radius + (lanes.radius + distance) * splat(SLACK) + splat(self.reserve),
        }
    }

    /// Lines of sight from the camera to the parts.
    #[inline]
    fn sight(&self, positions: &ViewPositions) -> LinesOfSight {
        // The eye may move farther than the model does in the view.
        let reserve = splat(self.reserve * (1.0 / EYE_SHARE - 1.0));
        if !self.is_orthographic {
            let ViewPositions { eye_to_center, square, distance, radius, .. } = *positions;
            return LinesOfSight { to_center: eye_to_center, square, distance, radius: radius + reserve };
        }
        // The lines are parallel. Their common length is the radius of the model, because a rotation by some angle
        // counts as a motion by that angle times this radius.
        let length = self.model_radius();
        LinesOfSight {
            to_center: splat3(self.forward * length),
            square: splat(length * length),
            distance: splat(length),
            radius: splat(length * SLACK + self.reserve / EYE_SHARE),
        }
    }

    /// How far spheres reach into the view frustum; negative if they are outside.
    #[inline]
    fn seen(&self, positions: &ViewPositions) -> f32x8 {
        if self.is_orthographic {
            let side = |i: usize| splat(self.half[i]) - positions.view[i].abs();
            return side(0).fast_min(side(1)) + positions.radius;
        }
        let side = |i: usize| {
            (splat(self.half[i]) * positions.view[2] - positions.view[i].abs()) * splat(self.across[i])
        };
        side(0).fast_min(side(1)).fast_min(positions.view[2]) + positions.radius
    }

    /// Tolerance in pixels, depending on whether parts face the eye, and the motion up to which it holds.
    #[inline]
    fn allowed(&self, lanes: &Lanes, faces: f32x8) -> (f32x8, f32x8) {
        // NaN allows nothing, on every machine.
        let at_least = |pixels: f32| splat(pixels.max(f32::MIN_POSITIVE));
        let (mut allowed, mut motion_margin) = (at_least(self.pixels), splat(f32::MAX));
        if let Some(pixels) = self.silhouette {
            let is_outline = faces.simd_le(splat(0.0));
            allowed = is_outline.bitselect(allowed.fast_min(at_least(pixels)), allowed);
            motion_margin = faces.abs() * splat(EYE_SHARE);
        }
        if let Some((region, pixels)) = &self.region {
            let apart = minus(lanes.center, region.center.into());
            let reach = (lanes.radius + splat(region.radius)) * splat(1.0 + SLACK);
            let meets = dot(apart, apart).sqrt().simd_le(reach);
            allowed = meets.bitselect(allowed.fast_min(at_least(*pixels)), allowed);
        }
        (allowed, motion_margin)
    }

    /// Relaxation of the tolerance for parts away from the fovea.
    #[inline]
    fn fovea_relaxation(&self, positions: &ViewPositions) -> FoveaRelaxation {
        let Some((fovea, gaze)) = &self.fovea else {
            return FoveaRelaxation { factor: splat(1.0), slope: splat(0.0), motion_margin: splat(f32::MAX) };
        };
        // The view is inclined if the camera is off-center.
        let shift = [0, 1].map(|i| splat(-self.across_screen[i].dot(self.forward)));
        let [x, y, depth] = positions.view;
        let view = [x + shift[0] * depth, y + shift[1] * depth, depth];
        let towards = view.map(|x| x / positions.distance);
        let chord = minus(towards, *gaze);
        // No point of the sphere is seen farther from the gaze than this; an angle is at least as large as
        // its chord.
        let spread = splat(2.0) * positions.radius / positions.distance;
        let off_gaze = dot(chord, chord).sqrt() - spread - splat(fovea.radius);
        let factor = splat(1.0) + splat(fovea.falloff) * off_gaze.fast_max(splat(0.0));
        // Chord and spread change by at most 3 / d. While the motion is at most half the distance, by at
        // most twice that; the distance is then at most 1.5 times its old value, and `factor` changes by at
        // most 3 times the falloff.
        FoveaRelaxation {
            factor,
            slope: splat(16.0 * fovea.falloff),
            motion_margin: splat(0.5) * positions.distance,
        }
    }
}

/// How far parts are turned away from the eye, and how far they face it; positive if that holds for the
/// whole part.
///
/// For a normal within an angle `a` of the axis, at a point within `r` of the center, the smallest
/// component along the line of sight is `d cos(b + a) - r`, where `b` is the angle between the line of
/// sight and the axis. That is exact, so parts inside a part are turned at least as far.
#[inline]
fn facing(lanes: &Lanes, sight: &LinesOfSight) -> [f32x8; 2] {
    let along = dot(sight.to_center, lanes.axis);
    // If the line of sight is almost parallel to the axis, rounding may make this component too small.
    let off_axis = (sight.square * splat(1.0 + ALONG_SLACK) - along * along).fast_max(splat(0.0)).sqrt();
    let sin = (splat(1.0) - lanes.cos * lanes.cos).fast_max(splat(0.0)).sqrt();
    let lean = off_axis * sin + sight.radius;
    let along = along * lanes.cos;
    let is_narrow = lanes.cos.simd_gt(splat(0.0));
    let wide = -(sight.distance + sight.radius);
    [along, -along].map(|along| is_narrow.bitselect(along - lean, wide))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::Random;
    use crate::view::{Camera, Criterion, NormalCone, Sphere};

    fn direction(random: &mut Random) -> Vec3 {
        Vec3::from([(); 3].map(|()| random.unit() as f32 - 0.5)).normalize()
    }

    #[test]
    fn no_point_of_a_sphere_has_a_larger_error() {
        let mut random = Random::new(21);
        let (mut compared, mut tight) = (0, 0.0f32);
        for round in 0..120_000 {
            let eye = direction(&mut random) * 5.0;
            let camera = Camera::new(eye.into(), [0.0; 3], [0.1, 1.0, 0.2], 1.2, [900, 700]).unwrap();
            let camera = match round % 3 {
                0 => camera,
                1 => Camera { shift: [1.3, -0.4], ..camera },
                _ => Camera { is_orthographic: true, half: [3.0, 2.5], ..camera },
            };
            let center = direction(&mut random) * 4.0 * random.unit() as f32;
            let sphere = Sphere { center: center.into(), radius: random.unit() as f32 };
            let part = Part { sphere, cone: NormalCone::ALL, error: 0.01 };
            let weight = ScreenError::new(camera, 1.0).weigh(&part).weight;
            let point = Sphere::point((center + direction(&mut random) * sphere.radius * 0.999).into());
            if weight < 1e6 && camera.may_see(&point) {
                let pixels = camera.error_px(part.error, &point);
                assert!(weight >= pixels * 0.9999, "{weight}, but {pixels} at {point:?} of {part:?}");
                tight = tight.max(pixels / weight);
                compared += 1;
            }
        }
        assert!(compared > 10_000 && tight > 0.98, "{compared} compared, {tight} of the bound");
    }

    #[test]
    fn parts_that_face_an_eye_on_their_axis_are_not_hidden() {
        let mut random = Random::new(22);
        for _ in 0..20_000 {
            let axis = direction(&mut random);
            let offset = axis.cross(direction(&mut random)).normalize() * (random.unit() as f32 * 6e-4);
            let center = (axis + offset) * (1.0 + 4.0 * random.unit() as f32);
            let cos = 0.02 + 0.3 * random.unit() as f32;
            // Reference in f64, from the exact f32 inputs: how far the part would be turned away if it were
            // a point.
            let [eye_to_center, axis_f64] = [center, axis].map(|v| v.as_dvec3());
            let (along, cos_f64) = (eye_to_center.dot(axis_f64), f64::from(cos));
            let off_axis = (eye_to_center - axis_f64 * along / axis_f64.length_squared()).length();
            let away = along * cos_f64 - off_axis * (1.0 - cos_f64 * cos_f64).sqrt();
            let sphere = Sphere { center: center.into(), radius: (away * (1.0 + 2e-6)) as f32 };
            let part = Part { sphere, cone: NormalCone { axis: axis.into(), cos }, error: 1.0 };
            let camera = Camera::new([0.0; 3], axis.into(), [0.3, 0.5, 0.7], 1.0, [100, 100]).unwrap();
            let weight = ScreenError::new(camera, 1.0).weigh(&part).weight;
            assert!(weight > 0.0, "{part:?} is hidden, {off_axis} off the axis");
        }
    }
}
