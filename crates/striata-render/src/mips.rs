//! Mip levels: smaller copies of an image, each averaged from the one before.
//!
//! Colors are averaged in linear light, normals get back their length, and the opacity of masked images is
//! scaled so that each level covers as much as the full image. Odd sizes are weighted by the parts of the
//! pixels that each smaller pixel covers.

use std::sync::LazyLock;

use striata_scene::textures::RgbaImage;

use crate::srgb::{LIGHT_OF_BYTE, to_srgb};

/// Meaning of the values of an image, which decides how they are averaged and stored.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum ImageMeaning {
    /// Colors in sRGB with a linear opacity; for masked ones the smallest opacity that is drawn, 1 to 255.
    Color { cutoff: Option<u8> },
    /// Numbers.
    Linear,
    /// Unit vectors.
    Normal,
}

/// One level of an image.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct MipLevel {
    pub width: u32,
    pub height: u32,
    pub rgba: Vec<u8>,
}

/// Returns the levels of an image, from the largest whose sides are at most `limit` pixels down to one pixel.
pub(crate) fn mip_levels(image: &RgbaImage, meaning: ImageMeaning, limit: u32) -> Vec<MipLevel> {
    let coverage = match meaning {
        ImageMeaning::Color { cutoff: Some(cutoff) } => Some((cutoff, coverage(&image.rgba, cutoff))),
        _ => None,
    };
    let mut level = MipLevel { width: image.width, height: image.height, rgba: image.rgba.to_vec() };
    let mut levels = Vec::new();
    loop {
        let smaller = (level.width > 1 || level.height > 1).then(|| halved(&level, meaning));
        if level.width <= limit && level.height <= limit {
            if let Some((cutoff, share)) = coverage.filter(|_| level.width < image.width) {
                keep_coverage(&mut level.rgba, cutoff, share);
            }
            levels.push(level);
        }
        match smaller {
            Some(smaller) => level = smaller,
            None => return levels,
        }
    }
}

/// Pixels that one pixel of the smaller level covers along one axis, with their weights.
struct Taps {
    first: usize,
    weights: [f32; 3],
}

/// Returns the taps of each pixel of the smaller level.
fn taps(size: u32) -> Vec<Taps> {
    let smaller = (size / 2).max(1);
    let tap = |at: u32| {
        let weights = match (size, size % 2) {
            (1, _) => [1.0, 0.0, 0.0],
            (_, 0) => [0.5, 0.5, 0.0],
            _ => [smaller - at, smaller, at + 1].map(|part| part as f32 / size as f32),
        };
        Taps { first: 2 * at as usize, weights }
    };
    (0..smaller).map(tap).collect()
}

fn halved(level: &MipLevel, meaning: ImageMeaning) -> MipLevel {
    if level.width.is_multiple_of(2) && level.height.is_multiple_of(2) {
        return means_of_four(level, &Codec::of(meaning));
    }
    let (columns, rows) = (taps(level.width), taps(level.height));
    let pixels = level.rgba.as_chunks::<4>().0;
    let codec = Codec::of(meaning);
    let mut rgba = Vec::with_capacity(4 * columns.len() * rows.len());
    for row in &rows {
        for column in &columns {
            let mut sum = [0.0; 4];
            for (dy, &row_weight) in row.weights.iter().enumerate().filter(|&(_, &w)| w > 0.0) {
                let start = (row.first + dy) * level.width as usize + column.first;
                for (dx, &weight) in column.weights.iter().enumerate().filter(|&(_, &w)| w > 0.0) {
                    let pixel = pixels[start + dx];
                    for (sum, &byte) in sum[..3].iter_mut().zip(&pixel) {
                        *sum += row_weight * weight * codec.decoded[usize::from(byte)];
                    }
                    sum[3] += row_weight * weight * f32::from(pixel[3]);
                }
            }
            rgba.extend(codec.encoded(sum));
        }
    }
    MipLevel { width: columns.len() as u32, height: rows.len() as u32, rgba }
}

/// Halves a level whose sides are even: the common case, which needs no weights.
fn means_of_four(level: &MipLevel, codec: &Codec) -> MipLevel {
    let (width, height) = (level.width / 2, level.height / 2);
    let row_bytes = 4 * level.width as usize;
    let mut rgba = Vec::with_capacity(4 * width as usize * height as usize);
    for rows in level.rgba.chunks_exact(2 * row_bytes) {
        let (upper, lower) = rows.split_at(row_bytes);
        for (a, b) in upper.as_chunks::<8>().0.iter().zip(lower.as_chunks::<8>().0) {
            let mean = |k: usize| {
                let value = |byte: u8| codec.decoded[usize::from(byte)];
                0.25 * (value(a[k]) + value(a[k + 4]) + value(b[k]) + value(b[k + 4]))
            };
            let opacity = [a[3], a[7], b[3], b[7]].map(f32::from).iter().sum::<f32>() / 4.0;
            rgba.extend(codec.encoded([mean(0), mean(1), mean(2), opacity]));
        }
    }
    MipLevel { width, height, rgba }
}

/// Between the bytes of colors and values that can be averaged.
struct Codec {
    decoded: &'static [f32; 256],
    meaning: ImageMeaning,
}

/// Number of steps in which linear light is looked up; the darkest step of sRGB spans 5 of them.
const LIGHT_STEPS: usize = 1 << 14;

static SRGB_OF_LIGHT: LazyLock<Vec<u8>> =
    LazyLock::new(|| (0..=LIGHT_STEPS).map(|step| to_srgb(step as f32 / LIGHT_STEPS as f32)).collect());
static SIGNED: LazyLock<[f32; 256]> = LazyLock::new(|| std::array::from_fn(|byte| byte as f32 / 127.5 - 1.0));
static UNSIGNED: LazyLock<[f32; 256]> = LazyLock::new(|| std::array::from_fn(|byte| byte as f32));

impl Codec {
    fn of(meaning: ImageMeaning) -> Self {
        let decoded: &'static [f32; 256] = match meaning {
            ImageMeaning::Color { .. } => &LIGHT_OF_BYTE,
            ImageMeaning::Linear => &UNSIGNED,
            ImageMeaning::Normal => &SIGNED,
        };
        Self { decoded, meaning }
    }

    fn encoded(&self, [x, y, z, opacity]: [f32; 4]) -> [u8; 4] {
        let [red, green, blue] = match self.meaning {
            ImageMeaning::Color { .. } => {
                [x, y, z].map(|light| SRGB_OF_LIGHT[(light * LIGHT_STEPS as f32 + 0.5) as usize])
            }
            ImageMeaning::Linear => [x, y, z].map(|value| (value + 0.5) as u8),
            ImageMeaning::Normal => {
                let length = (x * x + y * y + z * z).sqrt();
                let unit = if length > 1e-4 { [x, y, z].map(|a| a / length) } else { [0.0, 0.0, 1.0] };
                unit.map(|a| (127.5 * (a + 1.0) + 0.5) as u8)
            }
        };
        [red, green, blue, (opacity + 0.5) as u8]
    }
}

/// Share of the pixels whose opacity is at least `cutoff`.
fn coverage(rgba: &[u8], cutoff: u8) -> f64 {
    let pixels = rgba.as_chunks::<4>().0;
    let covered = pixels.iter().filter(|pixel| pixel[3] >= cutoff).count();
    covered as f64 / pixels.len().max(1) as f64
}

/// Scales the opacity so that a share of the pixels reaches `cutoff`.
fn keep_coverage(rgba: &mut [u8], cutoff: u8, share: f64) {
    let pixels = rgba.as_chunks_mut::<4>().0;
    let mut counts = [0usize; 256];
    for pixel in pixels.iter() {
        counts[usize::from(pixel[3])] += 1;
    }
    let wanted = (share * pixels.len() as f64).round() as usize;
    // The opacity that as many pixels reach as should be covered.
    let mut reached = 0;
    let threshold = (1..256).rev().find(|&opacity| {
        reached += counts[opacity];
        reached >= wanted.max(1)
    });
    let Some(threshold) = threshold.filter(|_| wanted > 0) else { return };
    let scale = f32::from(cutoff) / threshold as f32;
    for pixel in pixels.iter_mut() {
        pixel[3] = (f32::from(pixel[3]) * scale + 0.5) as u8;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn image(width: u32, height: u32, pixel: impl Fn(u32, u32) -> [u8; 4]) -> RgbaImage {
        let rgba = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
        RgbaImage { width, height, rgba: rgba.flat_map(|(x, y)| pixel(x, y)).collect() }
    }

    const COLOR: ImageMeaning = ImageMeaning::Color { cutoff: None };

    #[test]
    fn colors_are_averaged_in_linear_light() {
        let checkers = image(4, 4, |x, y| if (x + y) % 2 == 0 { [255; 4] } else { [0, 0, 0, 255] });
        let levels = mip_levels(&checkers, COLOR, 4096);
        assert_eq!(levels.len(), 3);
        // Half the light is 188 in sRGB.
        assert!(levels[1].rgba.iter().all(|&byte| byte == 188 || byte == 255), "{:?}", levels[1]);
        let linear = mip_levels(&checkers, ImageMeaning::Linear, 4096);
        assert_eq!(linear[2].rgba, [128, 128, 128, 255]);
    }

    #[test]
    fn uniform_images_of_any_size_stay_as_they_are() {
        for (width, height) in [(1, 1), (1, 9), (7, 5), (3, 16), (257, 2)] {
            for byte in [0, 1, 2, 17, 100, 254, 255] {
                for meaning in [COLOR, ImageMeaning::Linear] {
                    let levels = mip_levels(&image(width, height, |_, _| [byte; 4]), meaning, 4096);
                    assert!(levels.iter().all(|level| level.rgba.iter().all(|&b| b == byte)), "{byte}");
                    let last = levels.last().unwrap();
                    assert_eq!((last.width, last.height), (1, 1));
                }
            }
        }
    }

    #[test]
    fn odd_sizes_keep_the_mean() {
        let ramp = image(9, 1, |x, _| [(28 * x) as u8, 0, 0, 255]);
        let levels = mip_levels(&ramp, ImageMeaning::Linear, 4096);
        assert_eq!(levels[1].width, 4);
        let mean: f32 = levels[1].rgba.chunks(4).map(|pixel| f32::from(pixel[0])).sum::<f32>() / 4.0;
        assert!((mean - 112.0).abs() < 1.0, "{mean}");
    }

    #[test]
    fn normals_keep_their_length() {
        let tilted = image(2, 2, |x, _| if x == 0 { [218, 128, 218, 255] } else { [37, 128, 218, 255] });
        let levels = mip_levels(&tilted, ImageMeaning::Normal, 4096);
        assert_eq!(levels[1].rgba, [128, 128, 255, 255]);
    }

    #[test]
    fn masked_images_keep_their_coverage() {
        // One pixel of 16 is opaque: plain averages of 16 would never reach the cutoff.
        let leaves = image(64, 64, |x, y| [0, 90, 0, if x % 4 == 0 && y % 4 == 0 { 255 } else { 0 }]);
        let share_at = |meaning, level: usize| coverage(&mip_levels(&leaves, meaning, 4096)[level].rgba, 128);
        assert_eq!(share_at(COLOR, 2), 0.0);
        let masked = ImageMeaning::Color { cutoff: Some(128) };
        for level in 0..3 {
            assert!(share_at(masked, level) >= 1.0 / 16.0, "level {level}");
        }
    }

    #[test]
    fn images_beyond_the_limit_start_with_a_smaller_level() {
        let levels = mip_levels(&image(40, 10, |x, _| [x as u8; 4]), COLOR, 16);
        assert_eq!((levels[0].width, levels[0].height), (10, 2));
    }
}
