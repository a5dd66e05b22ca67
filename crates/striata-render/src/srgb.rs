//! The sRGB curve, between bytes as files store them and linear light.

use std::sync::LazyLock;

/// Linear light of each byte.
pub(crate) static LIGHT_OF_BYTE: LazyLock<[f32; 256]> = LazyLock::new(|| {
    std::array::from_fn(|byte| {
        let x = byte as f32 / 255.0;
        if x <= 0.040_45 { x / 12.92 } else { ((x + 0.055) / 1.055).powf(2.4) }
    })
});

/// Decodes an sRGB byte to linear light.
pub(crate) fn from_srgb(byte: u8) -> f32 {
    LIGHT_OF_BYTE[usize::from(byte)]
}

/// Encodes linear light, 0 to 1, as an sRGB byte.
pub fn to_srgb(light: f32) -> u8 {
    let x = light.clamp(0.0, 1.0);
    let encoded = if x <= 0.003_130_8 { 12.92 * x } else { 1.055 * x.powf(1.0 / 2.4) - 0.055 };
    (encoded * 255.0 + 0.5) as u8
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bytes_and_light_convert_back_and_forth() {
        for byte in 0..=255 {
            assert_eq!(to_srgb(from_srgb(byte)), byte);
        }
    }
}
