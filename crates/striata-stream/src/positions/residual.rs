//! How far off a prediction is along an axis, as one symbol and the bits below.
//!
//! A symbol is zero, or a sign and a bucket (1, 2 to 3, ..), or far. All else is noise.

use crate::entropy::{AdaptiveNumber, Coder};

/// The symbol of what lies in no bucket.
const FAR: usize = 15;
/// The buckets that have symbols, and the number that lies beyond them.
const NEAR: u32 = 1 << 7;

/// What is known of a residual before it is coded.
#[derive(Clone, Copy)]
pub(super) struct Circumstances {
    /// The class of the size of what is around.
    pub(super) size: usize,
    /// The class of how much predictions disagree.
    pub(super) spread: usize,
    /// How many of the lowest bits are noise.
    pub(super) noise: u32,
}

/// Codes a residual whose symbol is coded by the function that is given, and whose far numbers are learned by size.
#[inline]
pub(super) fn code_residual<C: Coder>(
    coder: &mut C,
    far: &mut AdaptiveNumber,
    Circumstances { size, noise, .. }: Circumstances,
    actual: i32,
    code_symbol: impl FnOnce(&mut C, usize) -> usize,
) -> i32 {
    let high = actual >> noise;
    let distance = high.unsigned_abs();
    let bucket = distance.max(1).ilog2();
    let meant = match distance {
        0 => 0,
        NEAR.. => FAR,
        _ => 1 + 2 * bucket as usize + usize::from(high < 0),
    };
    let symbol = code_symbol(coder, meant);
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
