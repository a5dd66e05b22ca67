//! SIMD helpers that process eight triangles at a time.

use glam::Vec3;
use wide::{f32x4, f32x8};

/// Number of triangles in one SIMD vector.
pub(super) const LANES: usize = 8;

/// Marks lanes past the last triangle.
pub(super) const NO_TRIANGLE: f32 = 2.0;

/// x, y and z coordinates of many points, as separate arrays.
pub(super) type Coordinates = [Vec<f32>; 3];

/// Returns the start index of each SIMD vector that covers `count` entries.
#[inline]
pub(super) fn vector_starts(count: usize) -> impl Iterator<Item = usize> {
    (0..count).step_by(LANES)
}

/// Minimum over all lanes.
#[inline]
pub(super) fn lane_min(lanes: f32x8) -> f32 {
    lanes.to_array().into_iter().fold(f32::INFINITY, f32::min)
}

/// Loads eight floats from `index` on; every array is padded to allow that.
#[inline]
pub(super) fn load_lanes(array: &[f32], index: usize) -> f32x8 {
    f32x8::new(array[index..].first_chunk().copied().unwrap_or([0.0; LANES]))
}

/// Loads four floats from `index` on.
#[inline]
pub(super) fn load_four(array: &[f32], index: usize) -> f32x4 {
    f32x4::new(array[index..].first_chunk().copied().unwrap_or([0.0; 4]))
}

/// Sum of all lanes, in a fixed order.
#[inline]
pub(super) fn lane_sum(sums: f32x4) -> f32 {
    let [a, b, c, d] = sums.to_array();
    (a + c) + (b + d)
}

/// Eight 3D vectors.
#[derive(Clone, Copy)]
pub(super) struct Vec3x8 {
    pub x: f32x8,
    pub y: f32x8,
    pub z: f32x8,
}

impl Vec3x8 {
    #[inline]
    pub(super) fn load([x, y, z]: [&[f32]; 3], index: usize) -> Self {
        Self { x: load_lanes(x, index), y: load_lanes(y, index), z: load_lanes(z, index) }
    }

    #[inline]
    pub(super) fn splat(v: Vec3) -> Self {
        Self { x: f32x8::splat(v.x), y: f32x8::splat(v.y), z: f32x8::splat(v.z) }
    }

    #[inline]
    pub(super) fn dot(self, o: Self) -> f32x8 {
        self.x * o.x + self.y * o.y + self.z * o.z
    }

    #[inline]
    pub(super) fn cross(self, o: Self) -> Self {
        Self {
            x: self.y * o.z - self.z * o.y,
            y: self.z * o.x - self.x * o.z,
            z: self.x * o.y - self.y * o.x,
        }
    }

    #[inline]
    pub(super) fn sub(self, o: Self) -> Self {
        Self { x: self.x - o.x, y: self.y - o.y, z: self.z - o.z }
    }
}

/// Slices of the three coordinate arrays from `first` on.
#[inline]
pub(super) fn slices(arrays: &Coordinates, first: usize) -> [&[f32]; 3] {
    [&arrays[0][first..], &arrays[1][first..], &arrays[2][first..]]
}

/// Makes the array at least `len` long; existing entries stay, new ones are zero.
pub(super) fn ensure_len(array: &mut Vec<f32>, len: usize) {
    if array.len() < len {
        array.resize(2 * len, 0.0);
    }
}
