//! Detail by place: all of it inside a box, little outside.

use super::{Criterion, Part, Verdict};

/// A criterion of places: full detail inside a box, an error at most outside.
///
/// Whatever reaches into the box is inside. It weighs parts, so it can be asked of every model that follows views.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DetailBox {
    /// The least coordinates of the box.
    pub min: [f32; 3],
    /// The greatest coordinates of the box.
    pub max: [f32; 3],
    /// The error that is allowed outside, mesh units; infinite for the base.
    pub error_outside: f32,
}

impl Criterion for DetailBox {
    fn weigh(&self, part: &Part) -> Verdict {
        let outside = |a: usize| {
            let [min, at, max] = [self.min[a], part.sphere.center[a], self.max[a]].map(f64::from);
            (min - at).max(at - max).max(0.0)
        };
        let [x, y, z] = [outside(0), outside(1), outside(2)];
        // Numbers that are no numbers are inside: nothing is left out for them.
        let is_outside = (x * x + y * y + z * z).sqrt() > f64::from(part.sphere.radius);
        let is_wanted = !(is_outside && part.error <= self.error_outside);
        Verdict { weight: if is_wanted { f32::INFINITY } else { 0.0 }, lasts: f32::INFINITY }
    }

    fn motion_since(&self, earlier: &Self) -> f32 {
        if self == earlier { 0.0 } else { f32::INFINITY }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::view::{NormalCone, Sphere};

    #[test]
    fn what_reaches_into_the_box_is_wanted_and_what_is_far_off() {
        let detail = DetailBox { min: [0.0; 3], max: [1.0, 2.0, 3.0], error_outside: 0.1 };
        let is_wanted = |center, radius, error| {
            let part = Part { sphere: Sphere { center, radius }, cone: NormalCone::ALL, error };
            detail.weigh(&part).is_wanted()
        };
        assert!(is_wanted([0.5, 1.9, 0.1], 0.0, 0.0), "within");
        assert!(is_wanted([2.0, 1.0, 1.0], 1.0, 0.0), "reaches it");
        assert!(!is_wanted([2.0, 1.0, 1.0], 0.99, 0.1), "does not");
        assert!(!is_wanted([2.0, 3.0, 4.0], 1.7, 0.1), "nor at a corner");
        assert!(is_wanted([2.0, 3.0, 4.0], 1.7, 0.11), "too far off");
        assert!(is_wanted([f32::NAN; 3], 1.0, 0.0), "nobody knows where");
        assert!(is_wanted([2.0, 3.0, 4.0], 1.7, f32::NAN), "nobody knows how far off");
        assert!(is_wanted([2e30, 0.0, 0.0], 3e30, 0.0), "reaches it from afar");
        assert!(!is_wanted([2e30, 0.0, 0.0], 1e30, 0.0), "afar");
    }

    #[test]
    fn a_box_of_no_numbers_leaves_nothing_out() {
        let part = Part {
            sphere: Sphere { center: [5.0; 3], radius: 1.0 },
            cone: NormalCone::ALL,
            error: f32::INFINITY,
        };
        let detail = DetailBox { min: [0.0; 3], max: [1.0; 3], error_outside: f32::INFINITY };
        assert!(!detail.weigh(&part).is_wanted());
        assert!(DetailBox { error_outside: f32::NAN, ..detail }.weigh(&part).is_wanted());
        assert!(DetailBox { min: [f32::NAN; 3], max: [f32::NAN; 3], ..detail }.weigh(&part).is_wanted());
    }
}
