//! Contrast of base color textures, which determines how visible it is if a texture slides on the surface.

use std::collections::HashMap;
use std::io::Cursor;

use serde_json::Value;
use striata::mesh::{Appearance, Material};
use zune_core::colorspace::ColorSpace;
use zune_core::options::DecoderOptions;
use zune_jpeg::JpegDecoder;

/// Smallest factor.
const MIN_FACTOR: f32 = 0.1;
/// Largest factor.
const MAX_FACTOR: f32 = 2.0;
/// Contrast that gives a factor of 1.
const TYPICAL_CONTRAST: f32 = 0.1;
/// Distances at which pixels are compared, as fractions of the width or height. There are several, so that a
/// regular pattern whose period is one of them is still detected.
const DISTANCES: [f32; 3] = [0.01, 0.02, 0.04];
/// Width and height in pixels to which larger images are averaged down, so that fine noise has little effect.
const MAX_SIDE: usize = 256;
/// Largest width and height that are decoded, pixels.
const MAX_DECODED_SIDE: usize = 8192;
/// Memory limit of the PNG decoder, bytes.
const PNG_LIMIT: usize = 1 << 29;

/// Returns the contrast of the base color texture of each material, divided by a typical contrast of 0.1 and
/// clamped to 0.1 to 2. The value is `None` if the material has no such texture or the image cannot be
/// decoded (neither PNG nor JPEG, damaged, missing, or larger than 8192 pixels).
///
/// The contrast is the root mean square difference of pixels that are 1, 2 and 4 % of the width or height
/// apart, averaged over red, green and blue as stored (sRGB) in [0, 1]. This is the visible change if the
/// texture slides by that distance. If the material is masked or blended, colors are multiplied by alpha, and
/// alpha counts as another channel. The whole image counts, whether or not the mesh uses all of it.
pub fn texture_contrasts(appearance: &Appearance) -> Vec<Option<f32>> {
    let mut known = HashMap::new();
    let mut factor = |material: &Material| {
        let (image, has_alpha) = base_color_image(appearance, material)?;
        *known.entry((image, has_alpha)).or_insert_with(|| {
            let pixels = decode(&appearance.images.get(image)?.bytes)?;
            Some((pixels.contrast(has_alpha) / TYPICAL_CONTRAST).clamp(MIN_FACTOR, MAX_FACTOR))
        })
    };
    appearance.materials.iter().map(&mut factor).collect()
}

/// Returns the index of a material's base color image, and whether its alpha is visible.
fn base_color_image(appearance: &Appearance, material: &Material) -> Option<(usize, bool)> {
    let json: Value = serde_json::from_str(&material.gltf_json).ok()?;
    let texture = json.pointer("/pbrMetallicRoughness/baseColorTexture/index")?.as_u64()?;
    let texture: Value = serde_json::from_str(appearance.textures_json.get(texture as usize)?).ok()?;
    let has_alpha = matches!(json["alphaMode"].as_str(), Some("MASK" | "BLEND"));
    Some((texture["source"].as_u64()? as usize, has_alpha))
}

/// An RGBA image with values in [0, 1].
struct Pixels {
    width: usize,
    height: usize,
    rgba: Vec<[f32; 4]>,
}

impl Pixels {
    /// Averages an image with 1 to 4 channels of 8 bits down to at most [`MAX_SIDE`]; `None` if there are too
    /// few bytes.
    fn new(bytes: &[u8], (source_width, source_height): (usize, usize), channels: usize) -> Option<Self> {
        if bytes.len() < source_width.checked_mul(source_height)?.checked_mul(channels)? || bytes.is_empty() {
            return None;
        }
        let (width, height) = (source_width.min(MAX_SIDE), source_height.min(MAX_SIDE));
        let mut sums = vec![([0u32; 4], 0u32); width * height];
        for (i, pixel) in bytes.chunks_exact(channels).take(source_width * source_height).enumerate() {
            let (x, y) = (i % source_width * width / source_width, i / source_width * height / source_height);
            let rgba = match *pixel {
                [gray] => [gray, gray, gray, 255],
                [gray, alpha] => [gray, gray, gray, alpha],
                [red, green, blue] => [red, green, blue, 255],
                [red, green, blue, alpha, ..] => [red, green, blue, alpha],
                [] => return None,
            };
            let (sum, count) = &mut sums[y * width + x];
            *count += 1;
            for (sum, channel) in sum.iter_mut().zip(rgba) {
                *sum += u32::from(channel);
            }
        }
        let mean = |(sum, count): ([u32; 4], u32)| sum.map(|sum| sum as f32 / (255.0 * count as f32));
        Some(Self { width, height, rgba: sums.into_iter().map(mean).collect() })
    }

    /// Returns the root mean square difference of pixels at all [`DISTANCES`], 0 to about 1.
    fn contrast(&self, has_alpha: bool) -> f32 {
        let visible = |x: usize, y: usize| {
            let [red, green, blue, alpha] = self.rgba[y * self.width + x];
            if has_alpha {
                [red * alpha, green * alpha, blue * alpha, alpha]
            } else {
                [red, green, blue, 0.0]
            }
        };
        let (mut sum, mut count) = (0.0, 0u64);
        for distance in DISTANCES {
            let apart = |side: usize| ((distance * side as f32).round() as usize).max(1);
            for (dx, dy) in [(apart(self.width), 0), (0, apart(self.height))] {
                for y in 0..self.height.saturating_sub(dy) {
                    for x in 0..self.width.saturating_sub(dx) {
                        let pairs = visible(x, y).into_iter().zip(visible(x + dx, y + dy));
                        sum += pairs.map(|(a, b)| f64::from((a - b) * (a - b))).sum::<f64>();
                        count += 1;
                    }
                }
            }
        }
        (sum / (3 * count.max(1)) as f64).sqrt() as f32
    }
}

/// Decodes a PNG or JPEG file, which it recognizes by its first bytes; `None` if that fails.
fn decode(bytes: &[u8]) -> Option<Pixels> {
    match bytes {
        [0x89, b'P', b'N', b'G', ..] => decode_png(bytes),
        [0xff, 0xd8, 0xff, ..] => decode_jpeg(bytes),
        _ => None,
    }
}

fn decode_png(bytes: &[u8]) -> Option<Pixels> {
    let mut decoder = png::Decoder::new_with_limits(Cursor::new(bytes), png::Limits { bytes: PNG_LIMIT });
    decoder.set_transformations(png::Transformations::normalize_to_color8());
    let mut reader = decoder.read_info().ok()?;
    let (width, height) = (reader.info().width as usize, reader.info().height as usize);
    if width.max(height) > MAX_DECODED_SIDE {
        return None;
    }
    let mut buffer = vec![0; reader.output_buffer_size()?];
    let frame = reader.next_frame(&mut buffer).ok()?;
    Pixels::new(&buffer, (width, height), frame.color_type.samples())
}

fn decode_jpeg(bytes: &[u8]) -> Option<Pixels> {
    let options = DecoderOptions::default()
        .set_max_width(MAX_DECODED_SIDE)
        .set_max_height(MAX_DECODED_SIDE)
        .jpeg_set_out_colorspace(ColorSpace::RGB);
    let mut decoder = JpegDecoder::new_with_options(Cursor::new(bytes), options);
    let buffer = decoder.decode().ok()?;
    Pixels::new(&buffer, decoder.dimensions()?, 3)
}

#[cfg(test)]
mod tests {
    use striata::mesh::Image;

    use super::*;

    const SIDE: u32 = 100;

    /// A square gray PNG.
    fn png_of(gray: impl Fn(u32, u32) -> u8) -> Vec<u8> {
        let mut file = Vec::new();
        let mut encoder = png::Encoder::new(&mut file, SIDE, SIDE);
        encoder.set_color(png::ColorType::Grayscale);
        let mut writer = encoder.write_header().expect("writing to memory succeeds");
        let pixels: Vec<u8> = (0..SIDE * SIDE).map(|i| gray(i % SIDE, i / SIDE)).collect();
        writer.write_image_data(&pixels).expect("writing to memory succeeds");
        writer.finish().expect("writing to memory succeeds");
        file
    }

    /// Returns the factor of a material with this file as its base color texture.
    fn factor_of(bytes: Vec<u8>) -> Option<f32> {
        let gltf_json = r#"{"pbrMetallicRoughness":{"baseColorTexture":{"index":1}}}"#.to_owned();
        let appearance = Appearance {
            materials: vec![Material::default(), Material { name: String::new(), gltf_json }],
            textures_json: vec!["{}".to_owned(), r#"{"source":0}"#.to_owned()],
            images: vec![Image { bytes, ..Image::default() }],
            ..Appearance::default()
        };
        let factors = texture_contrasts(&appearance);
        assert_eq!((factors.len(), factors[0]), (2, None), "the first material has no texture");
        factors[1]
    }

    #[test]
    fn contrast_distinguishes_textures() {
        let uniform = factor_of(png_of(|_, _| 200));
        assert_eq!(uniform, Some(MIN_FACTOR));
        let gradient = factor_of(png_of(|x, y| (x + y) as u8)).expect("a PNG");
        let checkerboard = factor_of(png_of(|x, y| 255 * ((x / 10 + y / 10) % 2) as u8)).expect("a PNG");
        assert!(gradient < 0.5 && 2.0 * gradient < checkerboard, "{gradient}, {checkerboard}");
        assert_eq!(checkerboard, MAX_FACTOR);
    }

    #[test]
    fn jpeg_files_are_read() {
        // One gray block of 8 by 8 pixels: both Huffman tables have a single code, the bit 0, for "no
        // difference".
        let huffman = |class: u8| [&[0xff, 0xc4, 0, 20, class, 1][..], &[0; 16]].concat();
        let file = [
            &[0xff, 0xd8, 0xff, 0xdb, 0, 67, 0][..],
            &[1; 64],
            &[0xff, 0xc0, 0, 11, 8, 0, 8, 0, 8, 1, 1, 0x11, 0],
            &huffman(0x00),
            &huffman(0x10),
            &[0xff, 0xda, 0, 8, 1, 1, 0, 0, 63, 0, 0x3f, 0xff, 0xd9],
        ];
        assert_eq!(factor_of(file.concat()), Some(MIN_FACTOR));
    }

    #[test]
    fn broken_images_have_no_contrast() {
        let whole = png_of(|x, _| x as u8);
        for bytes in
            [Vec::new(), b"no image".to_vec(), whole[..60].to_vec(), vec![0xff, 0xd8, 0xff, 0xe0, 0, 16]]
        {
            assert_eq!(factor_of(bytes), None);
        }
    }

    #[test]
    fn alpha_counts_only_if_it_is_visible() {
        let bytes: Vec<u8> = (0..400).flat_map(|i| [90, 90, 90, 255 * (i / 10 % 2) as u8]).collect();
        let pixels = Pixels::new(&bytes, (20, 20), 4).expect("the pixels are complete");
        assert!(pixels.contrast(false) < 1e-6 && pixels.contrast(true) > 0.1);
    }
}
