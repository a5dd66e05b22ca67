//! Resizing and re-encoding of a single image.

use super::decode::{DecodedImage, decode};
use super::encode::encode;
use super::info::{ImageFormat, image_info};
use super::resample::{reduce, reduced_size};
use super::role::{AlphaUse, TextureRole};
use super::{EncodedImage, TextureError};

/// Format of a re-encoded texture.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum TextureFormat {
    /// JPEG, which has no alpha: images whose alpha matters become PNG instead.
    Jpeg,
    /// PNG, lossless.
    Png,
    /// WebP, lossless.
    WebP,
}

/// How textures are re-encoded.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct TextureOptions {
    /// Longest side of an image, 1 or more pixels; larger images are reduced. Default: no limit.
    pub max_side: Option<u32>,
    /// Format of the images; default: that of each image.
    pub format: Option<TextureFormat>,
    /// Quality of JPEG, 1 to 100; default 90.
    pub quality: u8,
}

impl Default for TextureOptions {
    fn default() -> Self {
        Self { max_side: None, format: None, quality: 90 }
    }
}

impl TextureOptions {
    /// Sets [`Self::max_side`].
    pub fn with_max_side(self, max_side: Option<u32>) -> Self {
        Self { max_side, ..self }
    }

    /// Sets [`Self::format`].
    pub fn with_format(self, format: Option<TextureFormat>) -> Self {
        Self { format, ..self }
    }

    /// Sets [`Self::quality`].
    pub fn with_quality(self, quality: u8) -> Self {
        Self { quality, ..self }
    }

    /// Checks that all options are within their ranges.
    ///
    /// # Errors
    /// [`TextureError::Parameter`] for the first one that is not.
    pub fn check(&self) -> Result<(), TextureError> {
        let fail = |what, value, range| Err(TextureError::Parameter { what, value, range });
        match self {
            Self { max_side: Some(0), .. } => fail("the longest side", 0, "at least 1 pixel"),
            Self { quality, .. } if !(1..=100).contains(quality) => {
                fail("the quality", u32::from(*quality), "1 to 100")
            }
            _ => Ok(()),
        }
    }
}

/// Result of re-encoding an image.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum RecodedImage {
    /// It is small enough and has the requested format: its bytes stay as they are.
    Unchanged,
    /// It cannot be decoded, such as KTX2 and DDS, and stays as it is although it is not as requested.
    Carried {
        /// Reason in words.
        reason: String,
    },
    /// It was reduced or converted.
    Changed(EncodedImage),
}

/// Resizes and re-encodes an image.
///
/// Colors are averaged in linear light, other maps as plain numbers, and normals have unit length
/// afterward. An image that is already as requested is not touched. Sizes need not be powers of two.
///
/// # Errors
/// [`TextureError`] if an option is out of range, or the image exceeds the limits or is malformed.
pub fn recode(
    bytes: &[u8],
    role: TextureRole,
    options: &TextureOptions,
) -> Result<RecodedImage, TextureError> {
    options.check()?;
    let info = image_info(bytes)?;
    let wanted = match options.format {
        Some(TextureFormat::Jpeg) => ImageFormat::Jpeg,
        Some(TextureFormat::Png) => ImageFormat::Png,
        Some(TextureFormat::WebP) => ImageFormat::WebP,
        None => info.format,
    };
    let size = reduced_size(info.width, info.height, options.max_side.unwrap_or(u32::MAX));
    if wanted == info.format && size == [info.width, info.height] {
        return Ok(RecodedImage::Unchanged);
    }
    if !info.format.is_decoded() {
        let reason = format!("{} images are carried as they are", info.format);
        return Ok(RecodedImage::Carried { reason });
    }
    let DecodedImage { info, pixels, has_alpha } = decode(bytes)?;
    let size = reduced_size(info.width, info.height, options.max_side.unwrap_or(u32::MAX));
    let keeps_alpha = has_alpha && role.alpha != AlphaUse::Unused;
    let format = if keeps_alpha && wanted == ImageFormat::Jpeg { ImageFormat::Png } else { wanted };
    if format == info.format && size == [info.width, info.height] {
        return Ok(RecodedImage::Unchanged);
    }
    let reduced = if size == [info.width, info.height] { pixels } else { reduce(&pixels, size, role) };
    Ok(RecodedImage::Changed(encode(&reduced, format, keeps_alpha, options.quality)?))
}
