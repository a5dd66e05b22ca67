//! Which way a part of a surface faces, as cheap to ask as a distance.

use glam::Vec3;

use super::NormalCone;

/// Directions around an axis, told by a sine.
///
/// A part with normals within an angle `a` of an axis that lies in a sphere of radius `r` around a point at distance `d`
/// turns its back on the eye if the sight falls along the axis by more than `d sin a + r`: for then no normal that is `a`
/// aside, at no point that is `r` aside, looks back. That takes no angle and no division, and how far the eye may move before
/// the answer changes is the difference of the two.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Facing {
    /// The axis; not longer than 1. A shorter one says less.
    pub axis: [f32; 3],
    /// Sine of the angle to the farthest direction, times the axis' length; 1 where nothing is known.
    pub sin: f32,
}

impl Facing {
    /// Every direction.
    pub const ALL: Self = Self { axis: [0.0; 3], sin: 1.0 };

    /// The directions of a cone.
    pub fn of_cone(cone: &NormalCone) -> Self {
        if cone.cos <= 0.0 {
            return Self::ALL;
        }
        // What rounding adds to the axis and takes from the sine is given back.
        let sin = (1.0 - f64::from(cone.cos) * f64::from(cone.cos)).max(0.0).sqrt() + 1e-6;
        Self { axis: (Vec3::from(cone.axis) * (1.0 - 1e-6)).into(), sin: sin.min(1.0) as f32 }
    }
}
