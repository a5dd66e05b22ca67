//! Where the new vertices are.

use super::super::entropy::{AdaptiveNumber, Coder, Rate};
use super::Effort;
use super::hood::Hood;

/// Adaptive models of grid coordinates.
#[derive(Clone, Debug)]
pub(super) struct PositionModel {
    residuals: AdaptiveNumber,
}

impl PositionModel {
    pub(super) fn new(_effort: Effort) -> Self {
        Self { residuals: AdaptiveNumber::new(40, Rate::Steady) }
    }

    /// Codes the place of the new vertex; a reader ignores `actual`.
    pub(super) fn code<C: Coder>(&mut self, coder: &mut C, hood: &Hood<'_>, actual: [i32; 3]) -> [i32; 3] {
        let (mut sum, mut count) = ([0i64; 3], 0);
        let (mut low, mut high) = ([i32::MAX; 3], [i32::MIN; 3]);
        for place in hood.ring().filter_map(|v| hood.place(v)) {
            count += 1;
            for a in 0..3 {
                sum[a] += i64::from(place[a]);
                low[a] = low[a].min(place[a]);
                high[a] = high[a].max(place[a]);
            }
        }
        let count = i64::from(count.max(1));
        std::array::from_fn(|a| {
            let expected = (sum[a] / count) as i32;
            let spread = (i64::from(high[a]) - i64::from(low[a])).max(0) as u64;
            let key = (64 - spread.leading_zeros()) as usize;
            let residual = actual[a].wrapping_sub(expected);
            expected.wrapping_add(self.residuals.signed(coder, key.min(39), residual))
        })
    }
}
