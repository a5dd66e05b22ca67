//! Conversion between sRGB bytes and linear light.
//!
//! The tables are computed with basic operations only, so that all machines agree on every byte.

use std::sync::OnceLock;

/// Linear light of each sRGB byte, 0 to 1.
pub(super) fn linear_of_bytes() -> &'static [f32; 256] {
    static TABLE: OnceLock<[f32; 256]> = OnceLock::new();
    TABLE.get_or_init(|| std::array::from_fn(|byte| linear(byte as f64 / 255.0) as f32))
}

/// Returns the sRGB byte nearest to a linear value.
pub(super) fn srgb_byte(value: f32) -> u8 {
    /// Linear values halfway between neighboring bytes.
    static LIMITS: OnceLock<[f32; 255]> = OnceLock::new();
    let limits =
        LIMITS.get_or_init(|| std::array::from_fn(|byte| linear((byte as f64 + 0.5) / 255.0) as f32));
    limits.partition_point(|&limit| limit <= value) as u8
}

/// Returns the linear light of an sRGB value, both 0 to 1.
fn linear(value: f64) -> f64 {
    if value <= 0.04045 {
        return value / 12.92;
    }
    // x^2.4 = x^2 (x^2)^(1/5)
    let x = (value + 0.055) / 1.055;
    x * x * fifth_root(x * x)
}

/// Returns the fifth root of a number from 0 to 1, by Newton's method.
fn fifth_root(number: f64) -> f64 {
    let mut root = 1.0;
    for _ in 0..40 {
        let fourth: f64 = root * root * root * root;
        root -= (root - number / fourth) / 5.0;
    }
    root
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bytes_round_trip_and_known_values_match() {
        let table = linear_of_bytes();
        for byte in 0..=255u8 {
            assert_eq!(srgb_byte(table[byte as usize]), byte);
        }
        assert!((f64::from(table[188]) - 0.502_886_458).abs() < 1e-6);
        assert!((f64::from(table[10]) - 0.003_035_27).abs() < 1e-6);
        assert_eq!((srgb_byte(-1.0), srgb_byte(2.0)), (0, 255));
    }
}
