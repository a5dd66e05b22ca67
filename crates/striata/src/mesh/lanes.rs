//! Eight numbers or vectors at a time.

use glam::Vec3;
use wide::f32x8;

/// Number of lanes of a SIMD vector.
pub(crate) const LANES: usize = 8;

/// Minimum over all lanes.
#[inline]
pub(crate) fn lane_min(lanes: f32x8) -> f32 {
    lanes.to_array().into_iter().fold(f32::INFINITY, f32::min)
}

/// Maximum over all lanes.
#[inline]
pub(crate) fn lane_max(lanes: f32x8) -> f32 {
    lanes.to_array().into_iter().fold(f32::NEG_INFINITY, f32::max)
}

/// Loads eight floats from `index` on; every array is padded to allow that.
#[inline]
pub(crate) fn load_lanes(array: &[f32], index: usize) -> f32x8 {
    f32x8::new(array[index..].first_chunk().copied().unwrap_or([0.0; LANES]))
}

/// Eight 3D vectors.
#[derive(Clone, Copy)]
pub(crate) struct Vec3x8 {
    pub x: f32x8,
    pub y: f32x8,
    pub z: f32x8,
}

impl Vec3x8 {
    #[inline]
    pub(crate) fn load([x, y, z]: [&[f32]; 3], index: usize) -> Self {
        Self { x: load_lanes(x, index), y: load_lanes(y, index), z: load_lanes(z, index) }
    }

    #[inline]
    pub(crate) fn splat(v: Vec3) -> Self {
        Self { x: f32x8::splat(v.x), y: f32x8::splat(v.y), z: f32x8::splat(v.z) }
    }

    #[inline]
    pub(crate) fn dot(self, o: Self) -> f32x8 {
        self.x * o.x + self.y * o.y + self.z * o.z
    }

    #[inline]
    pub(crate) fn cross(self, o: Self) -> Self {
        Self {
            x: self.y * o.z - self.z * o.y,
            y: self.z * o.x - self.x * o.z,
            z: self.x * o.y - self.y * o.x,
        }
    }

    #[inline]
    pub(crate) fn length_squared(self) -> f32x8 {
        self.dot(self)
    }

    #[inline]
    pub(crate) fn scale(self, by: f32x8) -> Self {
        Self { x: by * self.x, y: by * self.y, z: by * self.z }
    }

    #[inline]
    pub(crate) fn sub(self, o: Self) -> Self {
        Self { x: self.x - o.x, y: self.y - o.y, z: self.z - o.z }
    }
}
