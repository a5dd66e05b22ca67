//! Small previews of images, with their average color.

use super::decode::decode;
use super::encode::{EncodedImage, encode};
use super::resample::{Pixels, reduce, reduced_size};
use super::role::{AlphaUse, TextureRole, TextureTransfer};
use super::{ImageFormat, TextureError};

/// A small version of an image, and what is lost by it.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Preview {
    /// The preview as a PNG or JPEG file.
    pub image: EncodedImage,
    /// Width and height of the whole image, pixels.
    pub full_size: (u32, u32),
    /// Average color, RGBA, for a placeholder.
    pub average: [u8; 4],
    /// Root mean square difference between the pixels of the preview and its average color, 0 to 1.
    pub contrast: f32,
    /// Root mean square difference between the pixels of the image and of the preview, 0 to 1.
    pub lost_contrast: f32,
}

/// JPEG qualities that are tried, in this order.
const QUALITIES: [u8; 3] = [70, 82, 92];

/// Root mean square error of a preview that is still accepted, steps of 1/255: for colors and numbers.
const COLOR_ERROR: f32 = 7.0;
/// Accepted error of a preview of normals, steps of 1/255; less, because their errors show as false highlights.
const NORMAL_ERROR: f32 = 5.0;

/// Makes a preview of which no side is longer than `max_side` pixels.
///
/// It is a JPEG of the lowest quality that is good enough, measured by decoding it, with all channels at full
/// resolution; or a PNG if alpha matters or PNG is smaller, as it is for images of a few colors. [`None`] if
/// `max_side` is 0 or the image cannot be decoded.
pub fn preview(bytes: &[u8], role: TextureRole, max_side: u32) -> Option<Preview> {
    if max_side == 0 {
        return None;
    }
    let decoded = decode(bytes).ok()?;
    let full = &decoded.pixels;
    let small = reduce(full, reduced_size(full.width, full.height, max_side), role);
    let keeps_alpha = decoded.has_alpha && role.alpha != AlphaUse::Unused;
    let image = smallest(&small, role, keeps_alpha).ok()?;
    let pixel = reduce(&small, [1, 1], role);
    Some(Preview {
        image,
        full_size: (full.width, full.height),
        average: [pixel.rgba[0], pixel.rgba[1], pixel.rgba[2], pixel.rgba[3]],
        contrast: lost_contrast(&small, &pixel, keeps_alpha),
        lost_contrast: lost_contrast(full, &small, keeps_alpha),
    })
}

/// Encodes a preview in the smallest form that is good enough.
fn smallest(small: &Pixels, role: TextureRole, keeps_alpha: bool) -> Result<EncodedImage, TextureError> {
    let png = encode(small, ImageFormat::Png, keeps_alpha, 0)?;
    if keeps_alpha {
        return Ok(png);
    }
    let limit = if role.transfer == TextureTransfer::Normal { NORMAL_ERROR } else { COLOR_ERROR };
    let mut jpeg = encode(small, ImageFormat::Jpeg, false, QUALITIES[0])?;
    for &quality in &QUALITIES[1..] {
        let shown = decode(&jpeg.bytes)?.pixels;
        if rms(small, &shown, |at| at) <= limit || jpeg.bytes.len() >= png.bytes.len() {
            break;
        }
        jpeg = encode(small, ImageFormat::Jpeg, false, quality)?;
    }
    Ok(if png.bytes.len() <= jpeg.bytes.len() { png } else { jpeg })
}

/// Root mean square difference of the color channels, in steps of 1/255; `other` maps the index of a pixel
/// to the one it is compared with.
fn rms(image: &Pixels, shown: &Pixels, other: impl Fn(usize) -> usize) -> f32 {
    let (pixels, shown) = (image.rgba.as_chunks::<4>().0, shown.rgba.as_chunks::<4>().0);
    let mut sum = 0u64;
    for (index, pixel) in pixels.iter().enumerate() {
        let shown = shown[other(index)];
        sum += (0..3).map(|channel| u64::from(pixel[channel].abs_diff(shown[channel])).pow(2)).sum::<u64>();
    }
    (sum as f64 / (3 * pixels.len().max(1)) as f64).sqrt() as f32
}

/// Compares an image with a smaller version, enlarged by repeating pixels. If alpha matters, the difference of
/// opacity counts like one of color.
fn lost_contrast(full: &Pixels, small: &Pixels, keeps_alpha: bool) -> f32 {
    let index = |at: usize| {
        let (x, y) = (at as u64 % u64::from(full.width), at as u64 / u64::from(full.width));
        let x = x * u64::from(small.width) / u64::from(full.width);
        let y = y * u64::from(small.height) / u64::from(full.height);
        (y * u64::from(small.width) + x) as usize
    };
    let color = rms(full, small, index) / 255.0;
    if !keeps_alpha {
        return color;
    }
    let (pixels, shown) = (full.rgba.as_chunks::<4>().0, small.rgba.as_chunks::<4>().0);
    let differences =
        pixels.iter().enumerate().map(|(at, pixel)| u64::from(pixel[3].abs_diff(shown[index(at)][3])).pow(2));
    let alpha = (differences.sum::<u64>() as f64 / pixels.len().max(1) as f64).sqrt() as f32 / 255.0;
    color.max(alpha)
}
