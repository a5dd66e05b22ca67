//! Densities along an axis, as sums of triangular bumps in 16-bit lanes.

use wide::{i16x8, i32x4};

use super::local::LANES;

/// Bumps along one axis.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Bumps {
    /// Centers, in local units.
    pub at: [i16; LANES],
    /// Weights, up to 2^14.
    pub weight: [i16; LANES],
}

/// Extent of bumps to either side of their center.
#[derive(Clone, Copy, Debug)]
pub(super) struct Width {
    width: i16x8,
    /// Left shift that scales the width to 2^14.
    lift: u32,
}

impl Width {
    /// Creates a width of 2 to the power of `log` in local units; `log` is at most 14.
    pub(super) fn new(log: u32) -> Self {
        Self { width: i16x8::splat(1 << log), lift: 14 - log }
    }

    /// Returns the part of a bump that lies below a point, in 1/8192. `off` is the distance of the point
    /// above the bump's center.
    #[inline]
    pub(super) fn below(self, off: i16x8) -> i16x8 {
        // For a triangular bump over -1..1, the share 1/2 + t (2 - |t|) / 2 lies below t; here 1 is 2^14.
        let t = off.max(-self.width).min(self.width) << self.lift;
        t.mul_keep_high(i16x8::splat(i16::MAX) - t.abs()) + i16x8::splat(4096)
    }
}

/// Returns the mass of a density below `x`, in 1/8192 of the weights of its bumps.
#[inline]
pub(super) fn below(density: &[Bumps], x: i16, width: Width) -> i32 {
    let mut sum = i32x4::ZERO;
    for bumps in density {
        let off = i16x8::splat(x).saturating_sub(i16x8::new(bumps.at));
        sum += i16x8::new(bumps.weight).dot(width.below(off));
    }
    sum.to_array().iter().sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn mass_grows_from_zero_to_the_total() {
        let bumps = Bumps { at: [-900, 0, 0, 5, 900, 0, 0, 0], weight: [100, 3000, 0, 7, 2000, 0, 0, 0] };
        for width in 0..=13 {
            let width = Width::new(width);
            let masses: Vec<i32> = (-20_000..20_000).step_by(7).map(|x| below(&[bumps], x, width)).collect();
            assert!(masses.is_sorted());
            assert_eq!(masses[0], 0);
            let all = masses[masses.len() - 1];
            assert!((8190 * 5107..=8192 * 5107).contains(&all), "{all}");
        }
    }

    #[test]
    fn half_of_a_bump_lies_below_its_middle() {
        let bumps = Bumps { at: [100; LANES], weight: [1000, 0, 0, 0, 0, 0, 0, 0] };
        let widths = [Width::new(6), Width::new(10)];
        assert_eq!(widths.map(|width| below(&[bumps], 100, width)), [4096 * 1000; 2]);
        // A triangle: an eighth lies beyond half its reach.
        let [narrow, wide] = widths.map(|width| below(&[bumps; 2], 132, width));
        assert!((narrow - 7168 * 2000).abs() <= 4000, "{narrow}");
        assert!(wide < 5000 * 2000, "{wide}");
    }
}
