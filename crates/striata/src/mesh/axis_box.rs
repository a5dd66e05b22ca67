//! Boxes along the axes.

use glam::Vec3A;

/// An axis-aligned box.
#[derive(Clone, Copy, Debug)]
pub(crate) struct AxisBox {
    pub min: Vec3A,
    pub max: Vec3A,
}

impl AxisBox {
    pub(super) const EMPTY: Self = Self { min: Vec3A::INFINITY, max: Vec3A::NEG_INFINITY };

    pub(super) fn union(self, other: Self) -> Self {
        Self { min: self.min.min(other.min), max: self.max.max(other.max) }
    }

    /// Twice the center, which gives the same order.
    pub(super) fn doubled_center(&self) -> [f32; 3] {
        (self.min + self.max).to_array()
    }
}
