//! Codes the residual of a prediction along an axis, as one symbol and its low bits.
//!
//! The symbol is zero, a sign with a bucket (1, 2 to 3, 4 to 7, ..), or an escape for large residuals.
//! All bits below it are noise.

use crate::entropy::{AdaptiveNumber, AdaptiveSymbol, Coder, Rate, code_by_two};

/// Number of size classes.
pub(super) const SIZES: usize = 64;

/// Escape symbol of a residual beyond the last bucket.
const FAR: usize = 15;
/// First magnitude beyond the last bucket.
const NEAR: u32 = 1 << 7;
/// Final learning rate of symbols, as a right shift.
const LAST_SHIFT: u32 = 7;

/// Context of a residual.
#[derive(Clone, Copy)]
pub(super) struct ResidualContext {
    /// Size class of the surroundings.
    pub size: usize,
    /// Class of how much predictions disagree.
    pub spread: usize,
    /// Number of lowest bits that are noise.
    pub noise: u32,
}

/// Codes residuals along an axis.
#[derive(Clone, Debug)]
pub(super) struct ResidualAxis {
    by_size: Vec<AdaptiveSymbol>,
    by_spread: Vec<AdaptiveSymbol>,
    /// Residuals beyond the last bucket, by size class.
    far: AdaptiveNumber,
}

impl ResidualAxis {
    /// Creates an untrained model.
    pub(super) fn new(spread_count: usize) -> Self {
        Self {
            by_size: vec![AdaptiveSymbol::new(16); SIZES],
            by_spread: vec![AdaptiveSymbol::new(16); spread_count],
            far: AdaptiveNumber::new(SIZES, Rate::Steady),
        }
    }

    /// Codes the residual of a prediction.
    #[inline]
    pub(super) fn code<C: Coder>(&mut self, coder: &mut C, at: ResidualContext, actual: i32) -> i32 {
        let ResidualContext { size, spread, noise } = at;
        let high = actual >> noise;
        let distance = high.unsigned_abs();
        let bucket = distance.max(1).ilog2();
        let actual_symbol = match distance {
            0 => 0,
            NEAR.. => FAR,
            _ => 1 + 2 * bucket as usize + usize::from(high < 0),
        };
        let models = [&mut self.by_size[size], &mut self.by_spread[spread]];
        let symbol = code_by_two(coder, models, actual_symbol, LAST_SHIFT);
        if symbol == FAR {
            return self.code_far(coder, size, noise, actual);
        }
        let bucket = (symbol.max(1) as u32 - 1) / 2;
        let bits = bucket + noise;
        let below = distance << noise | actual as u32 & ((1 << noise) - 1);
        let below = if bits == 0 { 0 } else { coder.raw(below, bits) };
        let top = i32::from(symbol > 0) << bucket | (below >> noise) as i32;
        let high = if symbol.is_multiple_of(2) { -top } else { top };
        high.wrapping_shl(noise) | (below & ((1 << noise) - 1)) as i32
    }

    /// Codes a residual beyond the last bucket.
    #[cold]
    fn code_far<C: Coder>(&mut self, coder: &mut C, size: usize, noise: u32, actual: i32) -> i32 {
        let below = if noise == 0 { 0 } else { coder.raw(actual as u32, noise) };
        self.far.signed(coder, size, actual >> noise).wrapping_shl(noise) | below as i32
    }
}
