//! Pixels of an image, for drawing it.

use std::sync::Arc;

use super::decode::decode;
use super::encode::encode;
use super::resample::{Pixels, reduce, reduced_size};
use super::role::TextureRole;
use super::{EncodedImage, ImageFormat, TextureError};

/// A decoded image of 8-bit RGBA pixels.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct RgbaImage {
    /// Width, pixels.
    pub width: u32,
    /// Height, pixels.
    pub height: u32,
    /// Four bytes per pixel, row by row from the top. Clones share them.
    pub rgba: Arc<[u8]>,
}

impl RgbaImage {
    /// Decodes PNG, JPEG or WebP and reduces the image, as its role requires, until no side has more than
    /// `max_side` pixels; a limit of 0 counts as 1.
    ///
    /// # Errors
    /// [`TextureError`] if the format cannot be decoded, the image is malformed, or it exceeds the limits of
    /// [`textures`](super), which is checked before any pixel is decoded.
    pub fn decode(bytes: &[u8], role: TextureRole, max_side: u32) -> Result<Self, TextureError> {
        let pixels = decode(bytes)?.pixels;
        let size = reduced_size(pixels.width, pixels.height, max_side.max(1));
        let is_small = size == [pixels.width, pixels.height];
        let Pixels { width, height, rgba } = if is_small { pixels } else { reduce(&pixels, size, role) };
        Ok(Self { width, height, rgba: rgba.into() })
    }

    /// Encodes the image as PNG, JPEG or lossless WebP. JPEG has no alpha, and a quality of 1 to 100.
    ///
    /// # Errors
    /// [`TextureError`] if the format cannot be encoded, or cannot store the image.
    pub fn encode(
        &self,
        format: ImageFormat,
        keeps_alpha: bool,
        quality: u8,
    ) -> Result<EncodedImage, TextureError> {
        let Self { width, height, .. } = *self;
        encode(&Pixels { width, height, rgba: self.rgba.to_vec() }, format, keeps_alpha, quality)
    }
}

#[cfg(test)]
mod tests {
    use super::super::placeholder_png;
    use super::*;

    #[test]
    fn images_are_decoded_or_refused() {
        let one = RgbaImage::decode(&placeholder_png([9, 8, 7, 6]), TextureRole::default(), 0);
        assert_eq!(one, Ok(RgbaImage { width: 1, height: 1, rgba: vec![9, 8, 7, 6].into() }));
        for bytes in [&b""[..], b"\xabKTX 20\xbb\r\n\x1a\n", &placeholder_png([0; 4])[..30]] {
            assert!(RgbaImage::decode(bytes, TextureRole::default(), 64).is_err(), "{bytes:?}");
        }
    }
}
