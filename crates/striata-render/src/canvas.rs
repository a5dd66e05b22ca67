//! An image in linear light with opacity, and its encoding as PNG.

#[cfg(feature = "gpu")]
use crate::srgb::from_srgb;
use crate::srgb::to_srgb;

/// Premultiplied linear light, 0 to 1 per channel, followed by opacity.
pub type Rgba = [f32; 4];

/// An image, stored row by row from the top.
#[derive(Clone, Debug, PartialEq)]
pub struct Canvas {
    /// Width in pixels.
    pub width: usize,
    /// Height in pixels.
    pub height: usize,
    pixels: Vec<Rgba>,
}

/// A drawn picture. Pixels not covered by the model are transparent.
#[derive(Clone, Debug)]
pub struct Drawn {
    /// The picture.
    pub canvas: Canvas,
    /// Time to draw one frame, not counting setup, seconds.
    pub secs: f64,
}

impl Canvas {
    /// Creates a canvas of one color.
    pub fn filled(width: usize, height: usize, color: Rgba) -> Self {
        Self { width, height, pixels: vec![color; width * height] }
    }

    /// Creates a canvas from sRGB bytes that encode premultiplied light, as GPUs produce them.
    #[cfg(feature = "gpu")]
    pub fn from_srgb(width: usize, height: usize, rgba: &[u8]) -> Self {
        let pixel = |p: &[u8]| {
            let [r, g, b] = [p[0], p[1], p[2]].map(from_srgb);
            [r, g, b, f32::from(p[3]) / 255.0]
        };
        Self { width, height, pixels: rgba.chunks_exact(4).map(pixel).collect() }
    }

    /// The pixels, row by row.
    pub fn pixels(&self) -> &[Rgba] {
        &self.pixels
    }

    /// The pixels of one row.
    pub fn row_mut(&mut self, y: usize) -> &mut [Rgba] {
        &mut self.pixels[y * self.width..][..self.width]
    }

    /// Blends another canvas over this one with its top left corner at (x, y), clipped to this canvas.
    pub fn blend(&mut self, other: &Self, x: usize, y: usize) {
        let x = x.min(self.width);
        let width = other.width.min(self.width - x);
        for row in 0..other.height.min(self.height.saturating_sub(y)) {
            let source = &other.pixels[row * other.width..][..width];
            for (below, &above) in self.row_mut(y + row)[x..x + width].iter_mut().zip(source) {
                *below = over(above, *below);
            }
        }
    }

    /// Blends a fraction of a color over one pixel; coordinates outside the canvas are ignored.
    pub fn tint(&mut self, [x, y]: [i64; 2], color: Rgba, amount: f32) {
        if let (Ok(x), Ok(y)) = (usize::try_from(x), usize::try_from(y))
            && x < self.width
            && y < self.height
        {
            let pixel = &mut self.row_mut(y)[x];
            *pixel = over(color.map(|c| c * amount), *pixel);
        }
    }

    /// Downsamples by an integer factor; each pixel is the mean of those it covers.
    pub fn downsampled(&self, factor: usize) -> Self {
        let mut small = Self::filled(self.width / factor, self.height / factor, [0.0; 4]);
        let weight = 1.0 / (factor * factor) as f32;
        for y in 0..small.height {
            for x in 0..small.width {
                let mut sum = [0.0; 4];
                for row in 0..factor {
                    let start = (y * factor + row) * self.width + x * factor;
                    for pixel in &self.pixels[start..start + factor] {
                        sum = std::array::from_fn(|k| sum[k] + pixel[k]);
                    }
                }
                small.row_mut(y)[x] = sum.map(|s| s * weight);
            }
        }
        small
    }

    /// Encodes the canvas as a PNG file in sRGB, with an alpha channel only if some pixels are transparent.
    ///
    /// # Errors
    /// If encoding fails.
    pub fn to_png(&self) -> Result<Vec<u8>, png::EncodingError> {
        let is_opaque = self.pixels.iter().all(|p| p[3] > 0.999);
        let color = if is_opaque { png::ColorType::Rgb } else { png::ColorType::Rgba };
        let channels = if is_opaque { 3 } else { 4 };
        let mut bytes = Vec::with_capacity(channels * self.pixels.len());
        self.pixels.iter().for_each(|&p| bytes.extend_from_slice(&to_bytes(p)[..channels]));
        let mut file = Vec::new();
        let mut encoder = png::Encoder::new(&mut file, self.width as u32, self.height as u32);
        encoder.set_color(color);
        encoder.set_depth(png::BitDepth::Eight);
        encoder.set_compression(png::Compression::High);
        encoder.set_source_srgb(png::SrgbRenderingIntent::Perceptual);
        let mut writer = encoder.write_header()?;
        writer.write_image_data(&bytes)?;
        writer.finish()?;
        Ok(file)
    }
}

/// Blends a pixel over another.
pub(crate) fn over(above: Rgba, below: Rgba) -> Rgba {
    std::array::from_fn(|k| above[k] + (1.0 - above[3]) * below[k])
}

/// Converts a pixel to straight (not premultiplied) sRGB bytes, as PNG stores it.
fn to_bytes([r, g, b, a]: Rgba) -> [u8; 4] {
    let whole = if a > 0.0 { 1.0 / a } else { 0.0 };
    let [r, g, b] = [r, g, b].map(|light| to_srgb(light * whole));
    [r, g, b, (255.0 * a.clamp(0.0, 1.0) + 0.5) as u8]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn downsampling_averages() {
        let mut canvas = Canvas::filled(4, 2, [0.0; 4]);
        canvas.row_mut(0)[0] = [1.0; 4];
        let small = canvas.downsampled(2);
        assert_eq!((small.width, small.height), (2, 1));
        assert_eq!(small.pixels, vec![[0.25; 4], [0.0; 4]]);
    }

    #[test]
    fn blending_is_clipped_and_respects_opacity() {
        let mut canvas = Canvas::filled(2, 2, [0.0, 0.0, 0.0, 1.0]);
        canvas.blend(&Canvas::filled(3, 3, [0.5, 0.0, 0.0, 0.5]), 1, 1);
        assert_eq!(canvas.pixels[..3], [[0.0, 0.0, 0.0, 1.0]; 3]);
        assert_eq!(canvas.pixels[3], [0.5, 0.0, 0.0, 1.0]);
    }

    #[test]
    fn bytes_are_not_premultiplied() {
        assert_eq!(to_bytes([0.25, 0.0, 0.0, 0.25]), [255, 0, 0, 64]);
        assert_eq!(to_bytes([0.0; 4]), [0; 4]);
    }

    #[test]
    fn png_decodes_again_with_opacity_where_there_is_some() {
        for (corner, color) in [([0.0, 0.0, 0.0, 1.0], png::ColorType::Rgb), ([0.0; 4], png::ColorType::Rgba)]
        {
            let mut canvas = Canvas::filled(60, 12, [1.0; 4]);
            canvas.row_mut(0)[0] = corner;
            let file = canvas.to_png().expect("memory takes it");
            let mut reader = png::Decoder::new(std::io::Cursor::new(file)).read_info().expect("a PNG header");
            let mut bytes = vec![0; reader.output_buffer_size().expect("a small picture")];
            let info = reader.next_frame(&mut bytes).expect("whole data");
            assert_eq!((info.width, info.height, info.color_type), (60, 12, color));
            assert!(bytes[..3] == [0; 3] && bytes.last() == Some(&255));
        }
    }
}
