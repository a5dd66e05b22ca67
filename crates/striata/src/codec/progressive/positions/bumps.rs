//! Densities along an axis, as sums of bumps in 16-bit lanes.

use super::local::LANES;

/// Bumps along one axis.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Bumps {
    /// Middles, in local units.
    pub(super) at: [i16; LANES],
    /// Weights, up to 2^14.
    pub(super) weight: [i16; LANES],
}

impl Bumps {
    /// How much lies below `x`, in 1/8192 of weights, with bumps that reach 2 to each of `width_logs` to either side,
    /// 2^14 at most.
    #[inline]
    pub(super) fn below<const N: usize>(&self, x: i16, width_logs: &[u32; N], masses: &mut [i32; N]) {
        for (mass, &width_log) in masses.iter_mut().zip(width_logs) {
            let width = 1i16 << width_log;
            let lift = 14 - width_log;
            let mut sum = 0;
            for j in 0..LANES {
                // With one as 2^14: of a triangle over -1..1, 1/2 + t (2 - |t|) / 2 lies below t.
                let t = x.saturating_sub(self.at[j]).max(-width).min(width) << lift;
                let rest = i16::MAX - t.max(-t);
                let below = ((i32::from(t) * i32::from(rest)) >> 16) as i16 + 4096;
                sum += i32::from(self.weight[j]) * i32::from(below);
            }
            *mass = sum;
        }
    }
}
