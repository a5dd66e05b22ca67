//! Weighs eight parts at a time: screen errors are asked for by the ten thousand.

use glam::Vec3;
use wide::f32x8;

use super::screen_error::{EYE_SHARE, LANES};
use super::{Part, ScreenError, Verdict};

/// The most that a place in the view, once it has moved by one, changes the distance that errors are divided by: that
/// distance is `d cos^2 a`, `a` off the sight, and its slope `cos a sqrt(4 - 3 cos^2 a)`.
const STRETCH: f32 = 1.16;

/// More than rounding can do to a length here, in parts of it.
const SLACK: f32 = 4e-6;

/// More than rounding can do to the square of a length here and to that of its part along an axis, in parts of them.
const ALONG_SLACK: f32 = 1e-6;

/// Parts with each of their numbers in lanes.
struct Lanes {
    center: [f32x8; 3],
    axis: [f32x8; 3],
    cos: f32x8,
    radius: f32x8,
    error: f32x8,
}

/// Where parts lie in the view.
struct Places {
    /// To the right, upwards and into the picture.
    view: [f32x8; 3],
    sight: [f32x8; 3],
    square: f32x8,
    distance: f32x8,
    /// A little more than that of the parts.
    radius: f32x8,
}

/// What is allowed aside of where the eye looks.
struct Aside {
    /// How many times more.
    times: f32x8,
    /// The most by which motion changes what errors are divided by through that.
    slope: f32x8,
    /// How long that is true.
    lasts: f32x8,
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
    /// Weighs up to eight parts.
    #[inline]
    pub(super) fn weigh_lanes(&self, parts: &[Part], verdicts: &mut [Verdict; LANES]) {
        let lanes = Lanes::new(parts);
        let places = self.places(&lanes);
        let seen = self.seen(&places);
        let [away, faces] = facing(&lanes, &places);
        let (allowed, allowed_lasts) = self.allowed(&lanes, faces);
        let Aside { times, slope: times_slope, lasts: times_last } = self.aside(&places);

        // All that decides changes no faster than the view moves, and is no larger for what lies within.
        let cos = (places.view[2] / places.distance).fast_max(splat(self.corner));
        let near = (places.distance * cos * cos - splat(STRETCH) * places.radius) * times;
        // Where the eye may touch a part nothing is small enough; but errors still tell what comes first.
        let nearest = splat(self.nearest);
        let touched = near.simd_le(nearest).bitselect(splat(2.0), splat(0.0));
        let needed = (lanes.error * splat(self.scale) / allowed).fast_min(splat(f32::MAX));
        let slope = splat(STRETCH) * times + times_slope;
        let change = (near - needed).abs().fast_min((near - nearest).abs());
        let error_lasts = (change / slope).fast_min(allowed_lasts).fast_min(times_last);

        let weight =
            needed / near.fast_max(nearest) + needed.simd_gt(splat(0.0)).bitselect(touched, splat(0.0));
        let is_large = weight.simd_gt(splat(1.0));
        let is_hidden = seen.simd_lt(splat(0.0)) | away.simd_gt(splat(0.0));
        let weight = is_hidden.bitselect(splat(0.0), weight);
        let eye_share = splat(EYE_SHARE);
        let lasts_wanted = error_lasts.fast_min(seen).fast_min(-away * eye_share);
        let lasts_small = is_large.bitselect(splat(0.0), error_lasts);
        let lasts_hidden = lasts_small.fast_max(-seen).fast_max(away * eye_share);
        let lasts = is_hidden.bitselect(lasts_hidden, is_large.bitselect(lasts_wanted, lasts_small));
        let (weight, lasts) = (weight.to_array(), lasts.fast_max(splat(0.0)).to_array());
        for ((verdict, &weight), &lasts) in verdicts.iter_mut().zip(&weight).zip(&lasts) {
            *verdict = Verdict { weight, lasts };
        }
    }

    #[inline]
    fn places(&self, lanes: &Lanes) -> Places {
        let sight = minus(lanes.center, self.eye);
        let square = dot(sight, sight);
        // An eye at the very center sees it in no direction, which is as good as any.
        let distance = square.sqrt() + splat(f32::MIN_POSITIVE);
        Places {
            view: [self.right, self.up, self.forward].map(|axis| dot(sight, splat3(axis))),
            sight,
            square,
            distance,
            radius: lanes.radius + (lanes.radius + distance) * splat(SLACK),
        }
    }

    /// How deep spheres reach into the picture.
    #[inline]
    fn seen(&self, places: &Places) -> f32x8 {
        let side =
            |i: usize| (splat(self.half[i]) * places.view[2] - places.view[i].abs()) * splat(self.across[i]);
        side(0).fast_min(side(1)).fast_min(places.view[2]) + places.radius
    }

    /// Pixels allowed for parts that face the eye, or may not, and how long that lasts.
    #[inline]
    fn allowed(&self, lanes: &Lanes, faces: f32x8) -> (f32x8, f32x8) {
        // What is no number allows nothing, on every machine.
        let at_least = |pixels: f32| splat(pixels.max(f32::MIN_POSITIVE));
        let (mut allowed, mut lasts) = (at_least(self.pixels), splat(f32::MAX));
        if let Some(pixels) = self.silhouette {
            let is_outline = faces.simd_le(splat(0.0));
            allowed = is_outline.bitselect(allowed.fast_min(at_least(pixels)), allowed);
            lasts = faces.abs() * splat(EYE_SHARE);
        }
        if let Some((region, pixels)) = &self.region {
            let apart = minus(lanes.center, region.center.into());
            let reach = (lanes.radius + splat(region.radius)) * splat(1.0 + SLACK);
            let meets = dot(apart, apart).sqrt().simd_le(reach);
            allowed = meets.bitselect(allowed.fast_min(at_least(*pixels)), allowed);
        }
        (allowed, lasts)
    }

    /// What is allowed aside of where the eye looks.
    #[inline]
    fn aside(&self, places: &Places) -> Aside {
        let Some((fovea, gaze)) = &self.fovea else {
            return Aside { times: splat(1.0), slope: splat(0.0), lasts: splat(f32::MAX) };
        };
        let towards = places.view.map(|x| x / places.distance);
        let chord = minus(towards, *gaze);
        // No point of the sphere is seen farther aside than this, and an angle is no less than its chord.
        let spread = splat(2.0) * places.radius / places.distance;
        let aside = dot(chord, chord).sqrt() - spread - splat(fovea.radius);
        let times = splat(1.0) + splat(fovea.falloff) * aside.fast_max(splat(0.0));
        // Chord and spread change by 3 / d at most; while no more than half the distance is moved, by twice that, where the
        // distance itself is 1.5 times what it was at most, and `times` by no more than 3 times the falloff.
        Aside { times, slope: splat(16.0 * fovea.falloff), lasts: splat(0.5) * places.distance }
    }
}

/// How far parts are turned away from the eye, and how far they face it: over 0 where all of them do.
///
/// The least that a normal within an angle `a` of the axis, at a point within `r` of the center, looks along the sight is
/// `d cos(b + a) - r` where the sight is an angle `b` off the axis: that is exact, so what lies within is turned as far.
#[inline]
fn facing(lanes: &Lanes, places: &Places) -> [f32x8; 2] {
    let along = dot(places.sight, lanes.axis);
    // Where the sight is along the axis, rounding may leave less of it than there is.
    let beside = (places.square * splat(1.0 + ALONG_SLACK) - along * along).fast_max(splat(0.0)).sqrt();
    let sin = (splat(1.0) - lanes.cos * lanes.cos).fast_max(splat(0.0)).sqrt();
    let lean = beside * sin + places.radius;
    let along = along * lanes.cos;
    let is_narrow = lanes.cos.simd_gt(splat(0.0));
    let wide = -(places.distance + places.radius);
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
        for _ in 0..40_000 {
            let eye = direction(&mut random) * 5.0;
            let camera = Camera::new(eye.into(), [0.0; 3], [0.1, 1.0, 0.2], 1.2, [900, 700]).unwrap();
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
        assert!(compared > 10_000 && tight > 0.98, "{compared} compared, {tight} of what is told");
    }

    #[test]
    fn an_eye_along_the_axis_hides_nothing_that_faces_it() {
        let mut random = Random::new(22);
        for _ in 0..20_000 {
            let axis = direction(&mut random);
            let aside = axis.cross(direction(&mut random)).normalize() * (random.unit() as f32 * 6e-4);
            let center = (axis + aside) * (1.0 + 4.0 * random.unit() as f32);
            let cos = 0.02 + 0.3 * random.unit() as f32;
            // In f64, of the numbers as they are: how far the part would be turned away if it were a point.
            let [sight, axis_f64] = [center, axis].map(|v| v.as_dvec3());
            let (along, cos_f64) = (sight.dot(axis_f64), f64::from(cos));
            let beside = (sight - axis_f64 * along / axis_f64.length_squared()).length();
            let away = along * cos_f64 - beside * (1.0 - cos_f64 * cos_f64).sqrt();
            let sphere = Sphere { center: center.into(), radius: (away * (1.0 + 2e-6)) as f32 };
            let part = Part { sphere, cone: NormalCone { axis: axis.into(), cos }, error: 1.0 };
            let camera = Camera::new([0.0; 3], axis.into(), [0.3, 0.5, 0.7], 1.0, [100, 100]).unwrap();
            let weight = ScreenError::new(camera, 1.0).weigh(&part).weight;
            assert!(weight > 0.0, "{part:?} is hidden, {beside} beside");
        }
    }
}
