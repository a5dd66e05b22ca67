//! Decoding of PNG, JPEG and WebP within limits.

use std::io::Cursor;

use image::{DynamicImage, ImageDecoder, ImageReader, Limits};

use super::info::{ImageFormat, MAX_PIXEL_BYTES, MAX_SIDE, image_info};
use super::resample::Pixels;
use super::{ImageInfo, TextureError};

/// A decoded image.
pub(super) struct DecodedImage {
    pub info: ImageInfo,
    pub pixels: Pixels,
    /// Whether any pixel is not opaque.
    pub has_alpha: bool,
}

/// Decodes an image to 8 bits per channel; 16 bits are rounded.
///
/// # Errors
/// [`TextureError`] if the image exceeds the limits of this module, which is checked before any pixel is
/// decoded, or is malformed.
pub(super) fn decode(bytes: &[u8]) -> Result<DecodedImage, TextureError> {
    let info = image_info(bytes)?;
    let format = match info.format {
        ImageFormat::Png => image::ImageFormat::Png,
        ImageFormat::Jpeg => image::ImageFormat::Jpeg,
        ImageFormat::WebP => image::ImageFormat::WebP,
        other => return Err(TextureError::NotDecoded { format: other.name() }),
    };
    info.check_limits(bytes.len(), 1)?;
    let malformed = |error: image::ImageError| TextureError::Malformed { reason: error.to_string() };
    let mut reader = ImageReader::with_format(Cursor::new(bytes), format);
    let mut limits = Limits::default();
    (limits.max_image_width, limits.max_image_height) = (Some(MAX_SIDE), Some(MAX_SIDE));
    limits.max_alloc = Some(2 * MAX_PIXEL_BYTES);
    reader.limits(limits);
    let decoder = reader.into_decoder().map_err(malformed)?;
    let (width, height) = decoder.dimensions();
    // The decoder's own size counts, in case it reads the header differently.
    let info = ImageInfo { width, height, ..info };
    info.check_limits(bytes.len(), u64::from(decoder.color_type().bytes_per_pixel()).max(4))?;
    let image = DynamicImage::from_decoder(decoder).map_err(malformed)?;
    let pixels = Pixels { width, height, rgba: image.into_rgba8().into_raw() };
    let has_alpha = pixels.rgba.iter().skip(3).step_by(4).any(|&alpha| alpha < 255);
    Ok(DecodedImage { info, pixels, has_alpha })
}
