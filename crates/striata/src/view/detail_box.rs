//! A criterion that refines the inside of a box.

use super::{Criterion, Part, Verdict};

/// Full detail inside a box, and a limit on the error outside.
///
/// Parts that only reach into the box count as inside. This works with every model that supports views.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DetailBox {
    /// Smallest coordinates of the box.
    pub min: [f32; 3],
    /// Largest coordinates of the box.
    pub max: [f32; 3],
    /// Largest error allowed outside the box, in mesh units; infinite for the base mesh.
    pub error_outside: f32,
}

impl Criterion for DetailBox {
    fn weigh(&self, part: &Part) -> Verdict {
        let outside = |a: usize| {
            let [min, at, max] = [self.min[a], part.sphere.center[a], self.max[a]].map(f64::from);
            (min - at).max(at - max).max(0.0)
        };
        let [x, y, z] = [outside(0), outside(1), outside(2)];
        // The comparisons are written so that parts with NaN coordinates count as inside: no detail is lost.
        let is_outside = (x * x + y * y + z * z).sqrt() > f64::from(part.sphere.radius);
        let is_wanted = !(is_outside && part.error <= self.error_outside);
        Verdict { weight: if is_wanted { f32::INFINITY } else { 0.0 }, motion_margin: f32::INFINITY }
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
    fn parts_in_the_box_or_with_large_errors_are_refined() {
        let detail = DetailBox { min: [0.0; 3], max: [1.0, 2.0, 3.0], error_outside: 0.1 };
        let is_wanted = |center, radius, error| {
            let part = Part { sphere: Sphere { center, radius }, cone: NormalCone::ALL, error };
            detail.weigh(&part).should_refine()
        };
        assert!(is_wanted([0.5, 1.9, 0.1], 0.0, 0.0), "inside");
        assert!(is_wanted([2.0, 1.0, 1.0], 1.0, 0.0), "reaches it");
        assert!(!is_wanted([2.0, 1.0, 1.0], 0.99, 0.1), "just outside");
        assert!(!is_wanted([2.0, 3.0, 4.0], 1.7, 0.1), "outside, near a corner");
        assert!(is_wanted([2.0, 3.0, 4.0], 1.7, 0.11), "error too large");
        assert!(is_wanted([f32::NAN; 3], 1.0, 0.0), "unknown position");
        assert!(is_wanted([2.0, 3.0, 4.0], 1.7, f32::NAN), "unknown error");
        assert!(is_wanted([2e30, 0.0, 0.0], 3e30, 0.0), "huge but reaches the box");
        assert!(!is_wanted([2e30, 0.0, 0.0], 1e30, 0.0), "huge and outside");
    }

    #[test]
    fn a_box_with_nan_refines_everything() {
        let part = Part {
            sphere: Sphere { center: [5.0; 3], radius: 1.0 },
            cone: NormalCone::ALL,
            error: f32::INFINITY,
        };
        let detail = DetailBox { min: [0.0; 3], max: [1.0; 3], error_outside: f32::INFINITY };
        assert!(!detail.weigh(&part).should_refine());
        assert!(DetailBox { error_outside: f32::NAN, ..detail }.weigh(&part).should_refine());
        assert!(DetailBox { min: [f32::NAN; 3], max: [f32::NAN; 3], ..detail }.weigh(&part).should_refine());
    }
}
