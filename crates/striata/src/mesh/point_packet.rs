//! Eight points whose distances from a triangle or a box are computed at once.

use glam::{Vec3, Vec3A};
use wide::f32x8;

use super::box_tree::AxisBox;

/// Number of points in a packet.
pub(crate) const PACKET: usize = 8;

/// Eight points, by axis, and the box around them.
#[derive(Clone, Copy)]
pub(crate) struct PointPacket {
    points: Vec3x8,
    pub(super) bounds: AxisBox,
}

/// Eight vectors, by axis.
#[derive(Clone, Copy)]
struct Vec3x8([f32x8; 3]);

impl Vec3x8 {
    #[inline]
    fn minus(self, point: Vec3) -> Self {
        let [x, y, z] = self.0;
        Self([x - f32x8::splat(point.x), y - f32x8::splat(point.y), z - f32x8::splat(point.z)])
    }

    #[inline]
    fn dot(self, v: Vec3) -> f32x8 {
        let [x, y, z] = self.0;
        x * f32x8::splat(v.x) + y * f32x8::splat(v.y) + z * f32x8::splat(v.z)
    }

    #[inline]
    fn length_squared(self) -> f32x8 {
        let [x, y, z] = self.0;
        x * x + y * y + z * z
    }
}

impl PointPacket {
    pub(crate) fn new(points: [Vec3; PACKET]) -> Self {
        let bounds = points.map(Vec3A::from).into_iter().fold(AxisBox::EMPTY, |bounds, point| AxisBox {
            min: bounds.min.min(point),
            max: bounds.max.max(point),
        });
        let points = Vec3x8([0, 1, 2].map(|axis| f32x8::new(points.map(|point| point[axis]))));
        Self { points, bounds }
    }

    /// Squared distances from a point.
    #[inline]
    pub(crate) fn squared_distances_from(self, point: Vec3) -> f32x8 {
        self.points.minus(point).length_squared()
    }

    /// Squared distances from a triangle; if it has no area, those from its sides.
    #[inline]
    pub(crate) fn squared_distances(self, [a, b, c]: [Vec3; 3]) -> f32x8 {
        let floor = f32::MIN_POSITIVE;
        let normal = (b - a).cross(c - a);
        let mut sides = f32x8::splat(f32::INFINITY);
        let mut is_above = f32x8::ZERO.simd_eq(f32x8::ZERO);
        for (start, end) in [(a, b), (b, c), (c, a)] {
            let (side, from) = (end - start, self.points.minus(start));
            let along = from.dot(side) * f32x8::splat(side.length_squared().max(floor).recip());
            let Vec3x8([x, y, z]) = from;
            let share = along.fast_max(f32x8::ZERO).fast_min(f32x8::ONE);
            let off = Vec3x8([
                x - share * f32x8::splat(side.x),
                y - share * f32x8::splat(side.y),
                z - share * f32x8::splat(side.z),
            ]);
            sides = sides.fast_min(off.length_squared());
            is_above &= from.dot(normal.cross(side)).simd_gt(f32x8::ZERO);
        }
        let height = self.points.minus(a).dot(normal);
        let above = height * height * f32x8::splat(normal.length_squared().max(floor).recip());
        is_above.bitselect(above, sides)
    }

    /// Squared distances from a box.
    #[inline]
    pub(super) fn squared_distances_from_box(self, AxisBox { min, max }: AxisBox) -> f32x8 {
        let [x, y, z] = [0, 1, 2].map(|axis| {
            let at = self.points.0[axis];
            let away = (f32x8::splat(min[axis]) - at).fast_max(at - f32x8::splat(max[axis]));
            let away = away.fast_max(f32x8::ZERO);
            away * away
        });
        x + y + z
    }
}

/// Maximum over all lanes.
#[inline]
pub(crate) fn lane_max(lanes: f32x8) -> f32 {
    lanes.to_array().into_iter().fold(f32::NEG_INFINITY, f32::max)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn distances_in_every_region() {
        let triangle = [[0., 0., 0.], [4., 0., 0.], [0., 4., 0.]].map(Vec3::from);
        let points = [
            [1.0, 1.0, 2.0],
            [-1.0, -2.0, 2.0],
            [6.0, -1.0, 0.0],
            [2.0, -3.0, 0.0],
            [-3.0, 2.0, 0.0],
            [4.0, 4.0, 0.0],
            [-1.0, 7.0, 1.0],
            [2.0, 2.0, 0.0],
        ];
        let packet = PointPacket::new(points.map(Vec3::from));
        let found = packet.squared_distances(triangle).to_array();
        assert_eq!(found, [4.0, 9.0, 5.0, 9.0, 9.0, 8.0, 11.0, 0.0]);
        let flat = [triangle[0], triangle[1], triangle[0]];
        let expected = [5.0, 9.0, 5.0, 9.0, 13.0, 16.0, 51.0, 4.0];
        assert_eq!(packet.squared_distances(flat).to_array(), expected);
        let around = AxisBox { min: Vec3::ZERO.into(), max: Vec3::new(4.0, 4.0, 1.0).into() };
        let expected = [1.0, 6.0, 5.0, 9.0, 9.0, 0.0, 10.0, 0.0];
        assert_eq!(packet.squared_distances_from_box(around).to_array(), expected);
    }
}
