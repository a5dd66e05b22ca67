//! Encoding of images as PNG, JPEG or WebP.

use image::codecs::jpeg::JpegEncoder;
use image::codecs::png::{CompressionType, FilterType, PngEncoder};
use image::codecs::webp::WebPEncoder;
use image::{ExtendedColorType, ImageEncoder};

use super::resample::Pixels;
use super::{ImageFormat, TextureError};

/// An image as the bytes of a file.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct EncodedImage {
    /// Format of the file.
    pub format: ImageFormat,
    /// Width, pixels.
    pub width: u32,
    /// Height, pixels.
    pub height: u32,
    /// Bytes of the file.
    pub bytes: Vec<u8>,
}

/// Encodes pixels; JPEG has no alpha and stores all channels at full resolution, WebP is lossless.
///
/// # Errors
/// [`TextureError::Encode`] if the format cannot store the image.
pub(super) fn encode(
    pixels: &Pixels,
    format: ImageFormat,
    keeps_alpha: bool,
    quality: u8,
) -> Result<EncodedImage, TextureError> {
    let Pixels { width, height, .. } = *pixels;
    let keeps_alpha = keeps_alpha && format != ImageFormat::Jpeg;
    let opaque: Vec<u8>;
    let (data, color) = if keeps_alpha {
        (&pixels.rgba, ExtendedColorType::Rgba8)
    } else {
        opaque = pixels.rgba.as_chunks::<4>().0.iter().flat_map(|&[r, g, b, _]| [r, g, b]).collect();
        (&opaque, ExtendedColorType::Rgb8)
    };
    let mut bytes = Vec::new();
    let written = match format {
        ImageFormat::Jpeg => {
            JpegEncoder::new_with_quality(&mut bytes, quality).write_image(data, width, height, color)
        }
        ImageFormat::WebP => WebPEncoder::new_lossless(&mut bytes).write_image(data, width, height, color),
        ImageFormat::Png => {
            PngEncoder::new_with_quality(&mut bytes, CompressionType::Best, FilterType::Adaptive)
                .write_image(data, width, height, color)
        }
        other => return Err(TextureError::NotDecoded { format: other.name() }),
    };
    written.map_err(|error| TextureError::Encode { reason: error.to_string() })?;
    Ok(EncodedImage { format, width, height, bytes })
}
