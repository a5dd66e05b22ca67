//! Densities along an axis, as sums of bumps in 16-bit lanes.

use wide::i16x8;

use super::local::LANES;

/// Bumps along one axis.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Bumps {
    /// Middles, in local units.
    pub(super) at: [i16; LANES],
    /// Weights, up to 2^14.
    pub(super) weight: [i16; LANES],
}

/// How far bumps reach to either side.
#[derive(Clone, Copy, Debug)]
pub(super) struct Width {
    width: i16x8,
    /// What makes 2^14 of it.
    lift: u32,
}

impl Width {
    /// 2 to `log` in local units, 2^14 at most.
    pub(super) fn new(log: u32) -> Self {
        Self { width: i16x8::splat(1 << log), lift: 14 - log }
    }
}

impl Bumps {
    /// How much lies below `x`, in 1/8192 of weights, with bumps of each of these widths.
    #[inline]
    pub(super) fn below<const N: usize>(&self, x: i16, widths: &[Width; N]) -> [i32; N] {
        let off = i16x8::splat(x).saturating_sub(i16x8::new(self.at));
        let weight = i16x8::new(self.weight);
        let mut masses = [0; N];
        for (mass, width) in masses.iter_mut().zip(widths) {
            // With one as 2^14: of a triangle over -1..1, 1/2 + t (2 - |t|) / 2 lies below t.
            let t = off.max(-width.width).min(width.width) << width.lift;
            let below = t.mul_keep_high(i16x8::splat(i16::MAX) - t.abs()) + i16x8::splat(4096);
            *mass = weight.dot(below).to_array().iter().sum();
        }
        masses
    }
}
