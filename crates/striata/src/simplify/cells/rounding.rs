//! Rounding of keys and errors, so that they are exact when they are stored in few bits.

/// Low bits of a key that are zero: five explicit bits of the mantissa are left.
const KEY_ZERO_BITS: u32 = 18;
/// Low bits of an error that are zero: six explicit bits of the mantissa are left.
const ERROR_ZERO_BITS: u32 = 17;

/// Rounds a key up to five explicit bits of mantissa; NaN and negative numbers become 0.
pub fn round_key(key: f32) -> f32 {
    round_up(key, KEY_ZERO_BITS)
}

/// The smallest rounded key above a rounded key; the largest key is its own successor.
pub fn next_key(key: f32) -> f32 {
    let next = f32::from_bits(key.to_bits() + (1 << KEY_ZERO_BITS));
    if next.is_finite() { next } else { key }
}

/// Rounds an error up to six explicit bits of mantissa; NaN and negative numbers become 0.
pub fn round_error(error: f32) -> f32 {
    round_up(error, ERROR_ZERO_BITS)
}

fn round_up(x: f32, zero_bits: u32) -> f32 {
    let mask = (1u32 << zero_bits) - 1;
    let largest = f32::from_bits(f32::MAX.to_bits() & !mask);
    if x.is_nan() || x <= 0.0 {
        return 0.0;
    }
    if x >= largest {
        return largest;
    }
    f32::from_bits((x.to_bits() + mask) & !mask)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rounding_goes_up_and_is_stable() {
        for x in [1e-40f32, 1e-30, 0.1, 1.0, 1.01, 3e38] {
            let key = round_key(x);
            assert!(key >= x.min(3.3e38) && key <= x * 1.04 + 1e-39, "{x} {key}");
            assert_eq!(round_key(key), key);
            assert!(next_key(key) > key && round_key(next_key(key)) == next_key(key));
            assert_eq!(round_error(round_error(x)), round_error(x));
        }
        assert_eq!([round_key(f32::NAN), round_key(-1.0), round_key(0.0)], [0.0; 3]);
        assert_eq!(next_key(round_key(f32::INFINITY)), round_key(f32::MAX));
    }
}
