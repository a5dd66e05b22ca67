//! Codes the residual of a prediction along an axis, as one symbol and its low bits.
//!
//! The symbol is zero, a sign with a bucket (1, 2 to 3, 4 to 7, ..), or an escape for large residuals.
//! All bits below it are noise.

use crate::entropy::{AdaptiveNumber, Coder};

/// Escape symbol of a residual beyond the last bucket.
const FAR: usize = 15;
/// First magnitude beyond the last bucket.
const NEAR: u32 = 1 << 7;

/// Context of a residual.
#[derive(Clone, Copy)]
pub(super) struct ResidualContext {
    /// Size class of the surroundings.
    pub(super) size: usize,
    /// Class of how much predictions disagree.
    pub(super) spread: usize,
    /// Number of lowest bits that are noise.
    pub(super) noise: u32,
}

/// Codes a residual. `code_symbol` codes its symbol; large residuals are coded by `far`, in the context
/// of the size class.
#[inline]
pub(super) fn code_residual<C: Coder>(
    coder: &mut C,
    far: &mut AdaptiveNumber,
    ResidualContext { size, noise, .. }: ResidualContext,
    actual: i32,
    code_symbol: impl FnOnce(&mut C, usize) -> usize,
) -> i32 {
    let high = actual >> noise;
    let distance = high.unsigned_abs();
    let bucket = distance.max(1).ilog2();
    let actual_symbol = match distance {
        0 => 0,
        NEAR.. => FAR,
        _ => 1 + 2 * bucket as usize + usize::from(high < 0),
    };
    let symbol = code_symbol(coder, actual_symbol);
    if symbol == FAR {
        return code_far(coder, far, (size, noise), actual);
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
fn code_far<C: Coder>(
    coder: &mut C,
    far: &mut AdaptiveNumber,
    (size, noise): (usize, u32),
    actual: i32,
) -> i32 {
    let below = if noise == 0 { 0 } else { coder.raw(actual as u32, noise) };
    far.signed(coder, size, actual >> noise).wrapping_shl(noise) | below as i32
}
