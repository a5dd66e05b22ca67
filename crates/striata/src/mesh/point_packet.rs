//! Eight points whose distances from a triangle or a box are computed at once.

use glam::{Vec3, Vec3A};
use wide::f32x8;

use super::axis_box::AxisBox;
use super::lanes::{LANES, Vec3x8};

/// Number of points in a packet.
pub(crate) const PACKET: usize = LANES;

/// Eight points, and the box around them.
#[derive(Clone, Copy)]
pub(crate) struct PointPacket {
    points: Vec3x8,
    pub(super) bounds: AxisBox,
}

impl PointPacket {
    pub(crate) fn new(points: [Vec3; PACKET]) -> Self {
        let bounds = points
            .map(Vec3A::from)
            .into_iter()
            .fold(AxisBox::EMPTY, |bounds, point| bounds.union(AxisBox { min: point, max: point }));
        let [x, y, z] = [0, 1, 2].map(|axis| f32x8::new(points.map(|point| point[axis])));
        Self { points: Vec3x8 { x, y, z }, bounds }
    }

    /// Squared distances from a point.
    #[inline]
    pub(crate) fn squared_distances_from(self, point: Vec3) -> f32x8 {
        self.points.sub(Vec3x8::splat(point)).length_squared()
    }

    /// Squared distances from a triangle; if it has no area, those from its sides.
    #[inline]
    pub(crate) fn squared_distances(self, [a, b, c]: [Vec3; 3]) -> f32x8 {
        let floor = f32::MIN_POSITIVE;
        let normal = (b - a).cross(c - a);
        let mut sides = f32x8::splat(f32::INFINITY);
        let mut is_above = f32x8::ZERO.simd_eq(f32x8::ZERO);
        for (start, end) in [(a, b), (b, c), (c, a)] {
            let (side, from) = (end - start, self.points.sub(Vec3x8::splat(start)));
            let along =
                from.dot(Vec3x8::splat(side)) * f32x8::splat(side.length_squared().max(floor).recip());
            let share = along.fast_max(f32x8::ZERO).fast_min(f32x8::ONE);
            sides = sides.fast_min(from.sub(Vec3x8::splat(side).scale(share)).length_squared());
            is_above &= from.dot(Vec3x8::splat(normal.cross(side))).simd_gt(f32x8::ZERO);
        }
        let height = self.points.sub(Vec3x8::splat(a)).dot(Vec3x8::splat(normal));
        let above = height * height * f32x8::splat(normal.length_squared().max(floor).recip());
        is_above.bitselect(above, sides)
    }

    /// Squared distances from a box.
    #[inline]
    pub(super) fn squared_distances_from_box(self, AxisBox { min, max }: AxisBox) -> f32x8 {
        let Vec3x8 { x, y, z } = self.points;
        let away = |at: f32x8, axis: usize| {
            let outside = (f32x8::splat(min[axis]) - at).fast_max(at - f32x8::splat(max[axis]));
            outside.fast_max(f32x8::ZERO)
        };
        Vec3x8 { x: away(x, 0), y: away(y, 1), z: away(z, 2) }.length_squared()
    }
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
