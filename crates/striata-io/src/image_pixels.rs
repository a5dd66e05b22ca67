//! Pixels of images that glTF cannot store as they are: TGA and BMP, and base colors whose opacity is in an
//! image of its own.
//!
//! Sizes are checked before any pixel is decoded: an image may take a fixed amount of memory, and more only in
//! proportion to its file.

use std::io::Cursor;

use image::imageops::{FilterType, resize};
use image::{DynamicImage, GrayImage, ImageDecoder, ImageFormat, ImageReader, Limits, RgbaImage};

use crate::images::media_type;

/// Largest width and height, pixels.
const MAX_SIDE: u32 = 1 << 15;

/// Memory that the pixels of an image may take regardless of the size of its file, bytes.
const ALWAYS_ALLOWED: u64 = 1 << 26;

/// Additional memory allowed per byte of the file; run lengths compress to a fraction of this.
const BYTES_PER_FILE_BYTE: u64 = 256;

/// Largest memory of the pixels of an image, bytes.
const MAX_PIXEL_BYTES: u64 = 1 << 30;

/// Length of the smallest header of a TGA file.
const TGA_HEADER: usize = 18;

/// Text at the end of newer TGA files.
const TGA_FOOTER: &[u8] = b"TRUEVISION-XFILE.\0";

/// A base color image with the opacity of a mask.
pub(crate) struct Masked {
    /// The image as PNG.
    pub png: Vec<u8>,
    /// Whether most pixels are neither opaque nor transparent, so that cutting out would not do.
    pub is_translucent: bool,
}

/// Converts a TGA or BMP file to PNG; [`None`] if it is neither. TGA files have no signature, so that their
/// names count, too.
pub(crate) fn png_of(bytes: &[u8], name: &str) -> Option<Result<Vec<u8>, String>> {
    let format = match bytes {
        _ if is_bmp(bytes) => ImageFormat::Bmp,
        _ if is_tga(bytes, name) => ImageFormat::Tga,
        _ => return None,
    };
    Some(decoded(bytes, format).map(without_empty_alpha).and_then(|image| encoded(&image)))
}

fn is_bmp(bytes: &[u8]) -> bool {
    const HEADER_SIZES: [u8; 7] = [12, 40, 52, 56, 64, 108, 124];
    let size = bytes.get(14..18);
    bytes.starts_with(b"BM")
        && size.is_some_and(|size| HEADER_SIZES.contains(&size[0]) && size[1..] == [0; 3])
}

fn is_tga(bytes: &[u8], name: &str) -> bool {
    let &[_, map, kind, _, _, _, _, _, _, _, _, _, w0, w1, h0, h1, depth, _, ..] = bytes else {
        return false;
    };
    let is_header = bytes.len() > TGA_HEADER
        && map <= 1
        && matches!(kind, 1..=3 | 9..=11)
        && matches!(depth, 8 | 15 | 16 | 24 | 32)
        && [w0, w1] != [0, 0]
        && [h0, h1] != [0, 0];
    let name = name.split(['?', '#']).next().unwrap_or(name).to_ascii_lowercase();
    let is_name = [".tga", ".icb", ".vda", ".vst"].iter().any(|extension| name.ends_with(extension));
    is_header && (is_name || bytes.ends_with(TGA_FOOTER))
}

/// Decodes an image, if its size is within the limits.
fn decoded(bytes: &[u8], format: ImageFormat) -> Result<DynamicImage, String> {
    let mut reader = ImageReader::with_format(Cursor::new(bytes), format);
    let largest = ALWAYS_ALLOWED.max(bytes.len() as u64 * BYTES_PER_FILE_BYTE).min(MAX_PIXEL_BYTES);
    let mut limits = Limits::default();
    (limits.max_image_width, limits.max_image_height) = (Some(MAX_SIDE), Some(MAX_SIDE));
    limits.max_alloc = Some(largest);
    reader.limits(limits);
    let decoder = reader.into_decoder().map_err(|error| error.to_string())?;
    let (width, height) = decoder.dimensions();
    // Masks are combined with four bytes per pixel.
    if width > MAX_SIDE || height > MAX_SIDE || u64::from(width) * u64::from(height) * 4 > largest {
        return Err(format!("{width} x {height} pixels in a file of {} bytes", bytes.len()));
    }
    DynamicImage::from_decoder(decoder).map_err(|error| error.to_string())
}

/// Drops an alpha channel that is 0 everywhere: programs that write it do not use it.
fn without_empty_alpha(image: DynamicImage) -> DynamicImage {
    let has_alpha = image.color().has_alpha();
    if has_alpha && image.to_rgba8().pixels().all(|pixel| pixel[3] == 0) {
        return DynamicImage::from(image.into_rgb8());
    }
    image
}

fn encoded(image: &DynamicImage) -> Result<Vec<u8>, String> {
    let mut png = Cursor::new(Vec::new());
    image.write_to(&mut png, ImageFormat::Png).map_err(|error| error.to_string())?;
    Ok(png.into_inner())
}

/// Decodes any image that can be combined.
fn any_decoded(bytes: &[u8]) -> Result<DynamicImage, String> {
    let format = match media_type(bytes) {
        "image/png" => ImageFormat::Png,
        "image/jpeg" => ImageFormat::Jpeg,
        "image/webp" => ImageFormat::WebP,
        _ => return Err("not PNG, JPEG or WebP".to_owned()),
    };
    decoded(bytes, format)
}

/// Gives a base color image, white if there is none, the opacity of a mask; `channel` names one of its
/// channels. The mask is scaled to the size of the base color.
pub(crate) fn masked(color: Option<&[u8]>, mask: &[u8], channel: Option<u8>) -> Result<Masked, String> {
    let mask = opacity_of(any_decoded(mask)?, channel);
    let mut image = match color {
        Some(color) => any_decoded(color)?.into_rgba8(),
        None => RgbaImage::from_pixel(mask.width(), mask.height(), image::Rgba([255; 4])),
    };
    let (width, height) = image.dimensions();
    let mask = match mask.dimensions() == (width, height) {
        true => mask,
        false => resize(&mask, width, height, FilterType::Triangle),
    };
    let mut partial_count = 0u64;
    for (pixel, opacity) in image.pixels_mut().zip(mask.pixels()) {
        pixel[3] = opacity[0];
        partial_count += u64::from((26..230).contains(&opacity[0]));
    }
    let is_translucent = partial_count * 2 > u64::from(width) * u64::from(height);
    Ok(Masked { png: encoded(&DynamicImage::from(image))?, is_translucent })
}

/// Returns the opacity of a mask: the channel, its alpha if it has one, otherwise its brightness.
fn opacity_of(mask: DynamicImage, channel: Option<u8>) -> GrayImage {
    let index = match channel {
        Some(b'r') => Some(0),
        Some(b'g') => Some(1),
        Some(b'b') => Some(2),
        Some(b'm') => Some(3),
        Some(b'l') => None,
        _ if mask.color().has_alpha() => Some(3),
        _ => None,
    };
    let Some(index) = index else { return mask.into_luma8() };
    let pixels = mask.into_rgba8();
    let (width, height) = pixels.dimensions();
    GrayImage::from_fn(width, height, |x, y| image::Luma([pixels.get_pixel(x, y)[index]]))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A TGA of two by one pixels.
    fn tga(depth: u8, pixels: &[u8]) -> Vec<u8> {
        let mut out = vec![0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 2, 0, 1, 0, depth, 0x20];
        out.extend_from_slice(pixels);
        out
    }

    fn png(width: u32, height: u32, pixel: [u8; 3]) -> Vec<u8> {
        encoded(&DynamicImage::from(image::RgbImage::from_pixel(width, height, image::Rgb(pixel)))).unwrap()
    }

    #[test]
    fn tga_becomes_png() {
        let found = png_of(&tga(24, &[1, 2, 3, 40, 50, 60]), "Wood.TGA?v=1").unwrap().unwrap();
        let pixels = any_decoded(&found).unwrap();
        assert_eq!(
            (pixels.color(), pixels.into_rgb8().into_raw()),
            (image::ColorType::Rgb8, vec![3, 2, 1, 60, 50, 40])
        );
        // An alpha of 0 everywhere means nothing.
        let found = png_of(&tga(32, &[1, 2, 3, 0, 40, 50, 60, 0]), "a.tga").unwrap().unwrap();
        assert!(!any_decoded(&found).unwrap().color().has_alpha());
        assert!(png_of(&tga(24, &[0; 6]), "a.dat").is_none());
        let with_footer = [tga(24, &[0; 6]), TGA_FOOTER.to_vec()].concat();
        assert!(png_of(&with_footer, "a.dat").is_some());
    }

    #[test]
    fn damaged_and_huge_images_are_refused() {
        assert!(png_of(&tga(24, &[1]), "a.tga").unwrap().is_err());
        let mut huge = tga(24, &[0; 6]);
        huge[12..16].fill(0x7f);
        let reason = png_of(&huge, "a.tga").unwrap().unwrap_err();
        assert!(reason.contains("pixels in a file of 24 bytes"), "{reason}");
        let whole = tga(32, &[7; 8]);
        for length in 0..whole.len() {
            if let Some(found) = png_of(&whole[..length], "a.tga") {
                assert!(found.is_err(), "{length}");
            }
        }
        for at in 0..whole.len() * 8 {
            let mut bytes = whole.clone();
            bytes[at / 8] ^= 1 << (at % 8);
            let _ = png_of(&bytes, "a.tga");
        }
    }

    #[test]
    fn masks_become_alpha() {
        let mask = encoded(&DynamicImage::from(GrayImage::from_raw(2, 1, vec![0, 255]).unwrap())).unwrap();
        let found = masked(Some(&png(4, 2, [9, 8, 7])), &mask, None).unwrap();
        assert!(!found.is_translucent);
        let pixels = any_decoded(&found.png).unwrap().into_rgba8();
        assert_eq!((pixels.dimensions(), pixels.get_pixel(0, 0).0), ((4, 2), [9, 8, 7, 0]));
        assert_eq!(pixels.get_pixel(3, 1).0, [9, 8, 7, 255]);
        let soft = masked(None, &png(1, 1, [10, 100, 200]), Some(b'g')).unwrap();
        assert!(soft.is_translucent);
        assert_eq!(any_decoded(&soft.png).unwrap().into_rgba8().into_raw(), [255, 255, 255, 100]);
        assert!(masked(None, b"no image", None).is_err());
    }
}
