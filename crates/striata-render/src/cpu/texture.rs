//! Images with mip maps, sampled in linear light.
//!
//! A sample is
//! interpolated between pixels and between levels. Where a surface is seen at a grazing angle, several
//! samples along the longer axis of a pixel's footprint keep details (anisotropic filtering).

use striata_scene::drawn::{Sampler, Wrap};
use striata_scene::textures::RgbaImage;

use crate::mips::{ImageMeaning, MipLevel, mip_levels};
use crate::srgb::LIGHT_OF_BYTE;

/// Most samples along a footprint.
const MAX_ANISOTROPY: f32 = 8.0;

/// An image and its mip maps.
#[derive(Debug)]
pub(crate) struct Texture {
    levels: Vec<MipLevel>,
    is_srgb: bool,
}

/// Change of texture coordinates from a pixel to the next one, to the right and down.
pub(crate) type Footprint = [[f32; 2]; 2];

impl Texture {
    /// Creates all mip maps of an image.
    pub(crate) fn new(image: &RgbaImage, meaning: ImageMeaning) -> Self {
        let is_srgb = matches!(meaning, ImageMeaning::Color { .. });
        Self { levels: mip_levels(image, meaning, u32::MAX), is_srgb }
    }

    /// Samples the image: linear light, or numbers from 0 to 1, and alpha.
    pub(crate) fn sample(&self, sampler: &Sampler, uv: [f32; 2], footprint: &Footprint) -> [f32; 4] {
        let uv = uv.map(|x| if x.is_finite() { x } else { 0.0 });
        let size = [self.levels[0].width as f32, self.levels[0].height as f32];
        let lengths = footprint.map(|[u, v]| (u * size[0]).hypot(v * size[1]));
        let (major, minor) = (lengths[0].max(lengths[1]), lengths[0].min(lengths[1]));
        if !sampler.has_mip_maps || !major.is_finite() || major <= 1.0 {
            return self.in_level(0, sampler, uv);
        }
        let count = (major / minor.max(1e-6)).min(MAX_ANISOTROPY).min(major).ceil().max(1.0);
        let level = (major / count).max(1.0).log2();
        if count < 2.0 {
            return self.between_levels(level, sampler, uv);
        }
        let along = if lengths[0] > lengths[1] { footprint[0] } else { footprint[1] };
        let mut sum = [0.0; 4];
        for step in 0..count as usize {
            let offset = (step as f32 + 0.5) / count - 0.5;
            let uv = [uv[0] + offset * along[0], uv[1] + offset * along[1]];
            let sample = self.between_levels(level, sampler, uv);
            (0..4).for_each(|k| sum[k] += sample[k] / count);
        }
        sum
    }

    fn between_levels(&self, level: f32, sampler: &Sampler, uv: [f32; 2]) -> [f32; 4] {
        let last = self.levels.len() - 1;
        let lower = (level as usize).min(last);
        let share = level - lower as f32;
        let near = self.in_level(lower, sampler, uv);
        if lower == last || share <= 0.0 {
            return near;
        }
        let far = self.in_level(lower + 1, sampler, uv);
        std::array::from_fn(|k| near[k] + share * (far[k] - near[k]))
    }

    fn in_level(&self, index: usize, sampler: &Sampler, [u, v]: [f32; 2]) -> [f32; 4] {
        let level = &self.levels[index];
        let (width, height) = (level.width as usize, level.height as usize);
        let texels = level.rgba.as_chunks::<4>().0;
        let decode = |[r, g, b, a]: [u8; 4]| {
            let number = |byte: u8| f32::from(byte) * (1.0 / 255.0);
            if self.is_srgb {
                let light = &*LIGHT_OF_BYTE;
                [light[usize::from(r)], light[usize::from(g)], light[usize::from(b)], number(a)]
            } else {
                [number(r), number(g), number(b), number(a)]
            }
        };
        let at = |coordinate: f32, size: usize, wrap: Wrap| within(coordinate, wrap) * size as f32;
        let (x, y) = (at(u, width, sampler.wrap[0]), at(v, height, sampler.wrap[1]));
        if !sampler.is_smooth && index == 0 {
            let texel = |x: f32, size: usize, wrap| wrapped(x.floor() as i64, size, wrap);
            let column = texel(x, width, sampler.wrap[0]);
            let row = texel(y, height, sampler.wrap[1]);
            return decode(texels[row * width + column]);
        }
        let (x, y) = (x - 0.5, y - 0.5);
        let (left, top) = (x.floor(), y.floor());
        let (dx, dy) = (x - left, y - top);
        let columns = [0, 1].map(|k| wrapped(left as i64 + k, width, sampler.wrap[0]));
        let rows = [0, 1].map(|k| wrapped(top as i64 + k, height, sampler.wrap[1]));
        let mut sum = [0.0; 4];
        for (row, weight_y) in rows.into_iter().zip([1.0 - dy, dy]) {
            for (column, weight_x) in columns.into_iter().zip([1.0 - dx, dx]) {
                let texel = decode(texels[row * width + column]);
                (0..4).for_each(|k| sum[k] += weight_x * weight_y * texel[k]);
            }
        }
        sum
    }
}

/// Moves a coordinate close to the unit interval, so that it keeps its precision as a pixel.
fn within(coordinate: f32, wrap: Wrap) -> f32 {
    match wrap {
        Wrap::Repeat => coordinate - coordinate.floor(),
        Wrap::MirroredRepeat => coordinate - 2.0 * (coordinate / 2.0).floor(),
        Wrap::ClampToEdge => coordinate.clamp(-1.0, 2.0),
    }
}

/// Returns the pixel that a position outside the image shows.
fn wrapped(at: i64, size: usize, wrap: Wrap) -> usize {
    let size = size as i64;
    let inside = match wrap {
        Wrap::Repeat => at.rem_euclid(size),
        Wrap::MirroredRepeat => {
            let at = at.rem_euclid(2 * size);
            if at < size { at } else { 2 * size - 1 - at }
        }
        Wrap::ClampToEdge => at.clamp(0, size - 1),
    };
    inside as usize
}

#[cfg(test)]
mod tests {
    use super::*;

    fn board(width: u32, height: u32) -> RgbaImage {
        let texel =
            |i: u32| if (i % width + i / width).is_multiple_of(2) { [0, 0, 0, 255] } else { [255; 4] };
        RgbaImage { width, height, rgba: (0..width * height).flat_map(texel).collect() }
    }

    #[test]
    fn distant_surfaces_show_the_mean_in_linear_light() {
        for meaning in [ImageMeaning::Color { cutoff: None }, ImageMeaning::Linear] {
            let texture = Texture::new(&board(64, 32), meaning);
            let footprint = [[0.5, 0.0], [0.0, 0.5]];
            let [r, _, _, a] = texture.sample(&Sampler::default(), [0.3, 0.7], &footprint);
            assert!((r - 0.5).abs() < 0.01 && a == 1.0, "{r} {a}");
        }
    }

    #[test]
    fn near_surfaces_show_single_texels_interpolated() {
        let texture = Texture::new(&board(2, 2), ImageMeaning::Linear);
        let at = |u: f32, v: f32| texture.sample(&Sampler::default(), [u, v], &[[0.0; 2]; 2])[0];
        assert_eq!((at(0.25, 0.25), at(0.75, 0.25), at(0.75, 0.75)), (0.0, 1.0, 0.0));
        assert!((at(0.5, 0.25) - 0.5).abs() < 1e-6);
        assert_eq!(at(1.25, -0.75), at(0.25, 0.25), "the image repeats");
        assert_eq!(at(f32::NAN, f32::INFINITY), at(0.0, 0.0));
        let nearest = Sampler { is_smooth: false, ..Sampler::default() };
        assert_eq!(texture.sample(&nearest, [0.51, 0.25], &[[0.0; 2]; 2])[0], 1.0);
    }

    #[test]
    fn coordinates_outside_wrap_as_the_sampler_says() {
        let of = |wrap| [-1, 0, 2, 3, 5].map(|at| wrapped(at, 3, wrap));
        assert_eq!(of(Wrap::Repeat), [2, 0, 2, 0, 2]);
        assert_eq!(of(Wrap::MirroredRepeat), [0, 0, 2, 2, 0]);
        assert_eq!(of(Wrap::ClampToEdge), [0, 0, 2, 2, 2]);
        for wrap in [Wrap::Repeat, Wrap::MirroredRepeat, Wrap::ClampToEdge] {
            let x = within(-1e30, wrap);
            assert!((-1.0..=2.0).contains(&x), "{wrap:?}: {x}");
        }
    }

    #[test]
    fn grazing_footprints_keep_detail_across() {
        // Vertical stripes, seen so that a pixel covers one stripe in u but the whole image in v.
        let rgba = (0..64 * 64).flat_map(|i| if i % 64 / 8 % 2 == 0 { [0, 0, 0, 255] } else { [255; 4] });
        let texture =
            Texture::new(&RgbaImage { width: 64, height: 64, rgba: rgba.collect() }, ImageMeaning::Linear);
        let footprint = [[1.0 / 64.0, 0.0], [0.0, 0.125]];
        let sample = |u: f32| texture.sample(&Sampler::default(), [u, 0.5], &footprint)[0];
        assert!(sample(4.0 / 64.0) < 0.1 && sample(12.0 / 64.0) > 0.9);
    }
}
