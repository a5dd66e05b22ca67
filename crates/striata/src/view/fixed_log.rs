//! Logarithms to base 2 as integers, 1,024 per octave, with bounds; the same on every machine.

/// Logarithm of an infinite number.
const HIGHEST: i32 = 1 << 20;

/// Most by which [`log_of`] exceeds the logarithm, and is below it.
pub(super) const EXCESS: i32 = 8;
pub(super) const LACK: i32 = 10;

/// Approximates the logarithm of a positive integer; never falls as `x` grows.
pub(super) fn log_of(x: u32) -> i32 {
    let octave = 31 - x.max(1).leading_zeros();
    let f = ((x << (31 - octave)) >> 19) & 4095;
    // f + 0.34375 f (1 - f), with 2^31 for an octave.
    let part = f * (4096 * 128) + 44 * f * (4096 - f);
    ((octave << 10) + (part >> 21)) as i32
}

/// Upper bound of the logarithm of a positive number.
pub(super) fn log_up(x: f64) -> i32 {
    if x.is_nan() || x <= 0.0 {
        return -HIGHEST;
    }
    if x.is_infinite() {
        return HIGHEST;
    }
    let bits = x.max(f64::MIN_POSITIVE).to_bits();
    let exponent = (bits >> 52) as i32 - 1023;
    // The mantissa, from 1 to 2, with 30 bits after the point, rounded up.
    let mut mantissa = ((bits & ((1 << 52) - 1)) >> 22) + (1 << 30) + 1;
    let mut part = 0;
    for _ in 0..10 {
        mantissa = (mantissa * mantissa) >> 30;
        part <<= 1;
        if mantissa >= 1 << 31 {
            mantissa >>= 1;
            part += 1;
        }
    }
    // The digits that are left out, and the rounding of the squares.
    exponent * 1024 + part + 2
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn logarithms_stay_within_their_bounds_and_never_fall() {
        let dense = 1..100_000u32;
        let sparse = (0..300_000u64).map(|i| (100_000 + i * 14_300) as u32);
        let mut before = i32::MIN;
        for x in dense.chain(sparse) {
            let (found, exact) = (log_of(x), f64::from(x).log2() * 1024.0);
            assert!(found >= before, "{x}");
            before = found;
            assert!(f64::from(found - EXCESS) <= exact && exact <= f64::from(found + LACK), "{x}");
        }
    }

    #[test]
    fn upper_bounds_are_close() {
        for x in [1e-300, 1e-9, 0.3, 0.999_999_999_9, 1.0, 1.5, 7.0, 1e9, 1.9e200] {
            let (found, exact) = (f64::from(log_up(x)), x.log2() * 1024.0);
            assert!(exact <= found && found <= exact + 3.0, "{x}: {found}, {exact}");
        }
        assert_eq!([log_up(0.0), log_up(f64::INFINITY)], [-HIGHEST, HIGHEST]);
    }
}
