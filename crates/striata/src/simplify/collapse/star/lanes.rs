//! SIMD helpers that process eight triangles at a time.

use wide::f32x4;

pub(super) use crate::mesh::lanes::{LANES, Vec3x8, lane_min, load_lanes};

/// Marks lanes past the last triangle.
pub(super) const NO_TRIANGLE: f32 = 2.0;

/// x, y and z coordinates of many points, as separate arrays.
pub(super) type Coordinates = [Vec<f32>; 3];

/// Returns the start index of each SIMD vector that covers `count` entries.
#[inline]
pub(super) fn vector_starts(count: usize) -> impl Iterator<Item = usize> {
    (0..count).step_by(LANES)
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
