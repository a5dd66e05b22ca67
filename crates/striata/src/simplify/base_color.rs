//! Base color of a material, as the cost of a collapse sees it.
//!
//! Differences of colors are those of sRGB values, which are roughly as large as they look. Light is what is
//! averaged, and a square root stands for the curve of sRGB: it is the same on every machine, and the exact
//! curve would change no order of steps that can be seen.

use std::sync::Arc;

use glam::Vec4;

/// Larger images are halved until no side has more pixels.
const MAX_SIDE: u32 = 512;

/// Continuation of an image outside the unit square of texture coordinates.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Wrap {
    /// The image repeats.
    #[default]
    Repeat,
    /// The image repeats, and every other copy is mirrored.
    MirroredRepeat,
    /// The outermost pixels continue.
    ClampToEdge,
}

/// An image with its reduced copies, each of which has half the size of the one before.
///
/// No side has more than 512 pixels: larger images are reduced first. Clones share the pixels.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct TextureLevels {
    levels: Arc<[ColorLevel]>,
}

#[derive(Debug, PartialEq, Eq)]
struct ColorLevel {
    width: u32,
    height: u32,
    /// sRGB and alpha, row by row from the top.
    pixels: Vec<[u8; 4]>,
}

impl TextureLevels {
    /// Creates the levels of an image of 8-bit sRGB pixels with alpha, row by row from the top; [`None`] if
    /// it is empty, or if the number of pixels differs from its size.
    ///
    /// Without `has_alpha`, the image is opaque. With it, colors are multiplied by alpha, and a difference of
    /// alpha counts as much as that of a color channel.
    pub fn new(width: u32, height: u32, pixels: &[[u8; 4]], has_alpha: bool) -> Option<Self> {
        if pixels.is_empty() || u64::from(width) * u64::from(height) != pixels.len() as u64 {
            return None;
        }
        let visible = |&[r, g, b, a]: &[u8; 4]| match a {
            _ if !has_alpha => [r, g, b, u8::MAX],
            u8::MAX => [r, g, b, a],
            _ => {
                let factor = (f32::from(a) / 255.0).sqrt();
                let [r, g, b] = [r, g, b].map(|channel| (f32::from(channel) * factor + 0.5) as u8);
                [r, g, b, a]
            }
        };
        let mut level = ColorLevel { width, height, pixels: pixels.iter().map(visible).collect() };
        let mut levels = Vec::new();
        while level.width.max(level.height) > 1 {
            let next = level.halved();
            if level.width.max(level.height) <= MAX_SIDE {
                levels.push(level);
            }
            level = next;
        }
        levels.push(level);
        Some(Self { levels: levels.into() })
    }
}

impl ColorLevel {
    /// Returns the image with each side halved, rounded up.
    fn halved(&self) -> Self {
        let (width, height) = (self.width.div_ceil(2), self.height.div_ceil(2));
        let mut pixels = Vec::with_capacity(width as usize * height as usize);
        for y in 0..height {
            let rows = [2 * y, (2 * y + 1).min(self.height - 1)];
            for x in 0..width {
                let columns = [2 * x, (2 * x + 1).min(self.width - 1)];
                pixels.push(mean(rows.map(|row| columns.map(|column| self.pixel(column, row)))));
            }
        }
        Self { width, height, pixels }
    }

    fn pixel(&self, x: u32, y: u32) -> [u8; 4] {
        self.pixels[y as usize * self.width as usize + x as usize]
    }

    /// Returns the pixel at texture coordinates, channels from 0 to 255.
    #[inline]
    fn at(&self, uv: [f32; 2], wrap: [Wrap; 2]) -> Vec4 {
        let (x, y) = (pixel_index(uv[0], self.width, wrap[0]), pixel_index(uv[1], self.height, wrap[1]));
        let [r, g, b, a] = self.pixel(x, y);
        Vec4::new(f32::from(r), f32::from(g), f32::from(b), f32::from(a))
    }
}

/// Mean light of four pixels.
fn mean(four: [[[u8; 4]; 2]; 2]) -> [u8; 4] {
    std::array::from_fn(|channel| {
        let values = four.as_flattened().iter().map(|pixel| u32::from(pixel[channel]));
        match channel {
            3 => ((values.sum::<u32>() + 2) / 4) as u8,
            _ => ((values.map(|value| value * value).sum::<u32>() as f32 / 4.0).sqrt() + 0.5) as u8,
        }
    })
}

/// Returns the pixel of a row or column at a coordinate; the first one if it is not finite.
#[inline]
fn pixel_index(coordinate: f32, size: u32, wrap: Wrap) -> u32 {
    let unit = match wrap {
        Wrap::Repeat => coordinate - floor(coordinate),
        Wrap::MirroredRepeat => {
            let in_two = coordinate - 2.0 * floor(0.5 * coordinate);
            in_two.min(2.0 - in_two)
        }
        Wrap::ClampToEdge => coordinate,
    };
    // Conversion from floats saturates.
    ((unit * size as f32) as u32).min(size - 1)
}

/// Largest integer below a number, without a call into the platform's library.
#[inline]
fn floor(number: f32) -> f32 {
    let toward_zero = number as i32 as f32;
    if toward_zero > number { toward_zero - 1.0 } else { toward_zero }
}

/// Base color of a material: a texture, how it is sampled, and a factor.
#[derive(Clone, Debug, PartialEq)]
pub struct BaseColor {
    /// The image.
    pub texture: TextureLevels,
    /// Behavior outside the image, along u and v.
    pub wrap: [Wrap; 2],
    /// Set of texture coordinates.
    pub texcoord_set: u8,
    /// Transform of the texture coordinates: two rows of a 2 x 3 matrix.
    pub transform: [[f32; 3]; 2],
    /// Factor of red, green and blue, linear light from 0 to 1.
    pub factor: [f32; 3],
}

impl BaseColor {
    /// Creates a repeating texture for the first set of texture coordinates.
    pub fn new(texture: TextureLevels) -> Self {
        let transform = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
        Self { texture, wrap: [Wrap::Repeat; 2], texcoord_set: 0, transform, factor: [1.0; 3] }
    }

    /// Number of pixels of the largest level.
    pub(super) fn pixel_count(&self) -> f32 {
        self.texture.levels[0].pixels.len() as f32
    }

    /// Texture coordinates after the transform.
    pub(super) fn transformed(&self, [u, v]: [f32; 2]) -> [f32; 2] {
        self.transform.map(|[a, b, c]| a * u + b * v + c)
    }

    /// Factor of sRGB values and of alpha.
    pub(super) fn shown_factor(&self) -> Vec4 {
        let [r, g, b] = self.factor.map(|factor| factor.max(0.0).sqrt());
        Vec4::new(r, g, b, 1.0)
    }

    /// Returns the level whose pixels cover a quarter to the whole of an area, which is in pixels of the
    /// largest level.
    #[inline]
    fn level(&self, pixel_area: f32) -> &ColorLevel {
        let levels = &self.texture.levels;
        // Half the exponent: the pixels of a level have four times the area of those of the one before.
        let level = (pixel_area.max(1.0).to_bits() >> 23).saturating_sub(127) as usize / 2;
        &levels[level.min(levels.len() - 1)]
    }

    /// Texture at transformed coordinates, averaged over about `pixel_area` pixels of the largest level,
    /// without the factor.
    #[inline]
    pub(super) fn at(&self, uv: [f32; 2], pixel_area: f32) -> Vec4 {
        self.level(pixel_area).at(uv, self.wrap) / 255.0
    }

    /// Whether two points are less than half a pixel apart in the level for an area.
    #[inline]
    pub(super) fn is_close(&self, a: [f32; 2], b: [f32; 2], pixel_area: f32) -> bool {
        let level = self.level(pixel_area);
        let is_near = |axis: usize, size: u32| (a[axis] - b[axis]).abs() * (size as f32) < 0.5;
        is_near(0, level.width) && is_near(1, level.height)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn row(grays: &[u8]) -> TextureLevels {
        let pixels: Vec<[u8; 4]> = grays.iter().map(|&gray| [gray, gray, gray, 255]).collect();
        TextureLevels::new(grays.len() as u32, 1, &pixels, false).expect("the size is right")
    }

    #[test]
    fn coordinates_outside_the_image_wrap() {
        let texture = row(&[0, 51, 102, 255]);
        let at = |wrap, u: f32| {
            let color = BaseColor { wrap: [wrap; 2], ..BaseColor::new(texture.clone()) };
            (255.0 * color.at([u, 0.5], 0.0).x).round() as u8
        };
        let centers = [-0.375, 0.125, 0.375, 0.625, 0.875, 1.125, 2.125];
        assert_eq!(centers.map(|u| at(Wrap::Repeat, u)), [102, 0, 51, 102, 255, 0, 0]);
        assert_eq!(centers.map(|u| at(Wrap::MirroredRepeat, u)), [51, 0, 51, 102, 255, 255, 0]);
        assert_eq!(centers.map(|u| at(Wrap::ClampToEdge, u)), [0, 0, 51, 102, 255, 255, 255]);
        for u in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY, 1e30, -1e30] {
            for wrap in [Wrap::Repeat, Wrap::MirroredRepeat, Wrap::ClampToEdge] {
                at(wrap, u);
            }
        }
    }

    #[test]
    fn large_areas_show_the_mean_light() {
        let color = BaseColor::new(row(&[0, 255, 0, 255]));
        let gray = |pixel_area: f32| color.at([0.375, 0.5], pixel_area).x;
        assert_eq!(gray(1.0), 1.0);
        assert!((gray(4.0) - 0.5f32.sqrt()).abs() < 0.01, "{}", gray(4.0));
        assert_eq!(gray(f32::INFINITY), gray(16.0));
    }

    #[test]
    fn images_are_reduced_and_checked() {
        let large = TextureLevels::new(1025, 3, &vec![[7, 8, 9, 255]; 3075], false).expect("a texture");
        let sizes: Vec<_> = large.levels.iter().map(|level| (level.width, level.height)).collect();
        assert_eq!(sizes[..2], [(257, 1), (129, 1)]);
        assert!(large.levels.iter().flat_map(|level| &level.pixels).all(|&p| p == [7, 8, 9, 255]));
        assert_eq!(TextureLevels::new(2, 2, &[[0; 4]; 3], false), None);
        assert_eq!(TextureLevels::new(0, 0, &[], false), None);
    }

    #[test]
    fn alpha_counts_if_it_is_visible() {
        let pixels = [[200, 100, 0, 64]];
        let shown = |has_alpha| TextureLevels::new(1, 1, &pixels, has_alpha).map(|t| t.levels[0].pixels[0]);
        assert_eq!(shown(false), Some([200, 100, 0, 255]));
        assert_eq!(shown(true), Some([100, 50, 0, 64]));
    }

    #[test]
    fn transforms_apply_before_wrapping() {
        let transform = [[2.0, 0.0, 0.5], [0.0, 1.0, -0.25]];
        let color = BaseColor { transform, ..BaseColor::new(row(&[1])) };
        assert_eq!(color.transformed([0.25, 0.5]), [1.0, 0.25]);
    }
}
