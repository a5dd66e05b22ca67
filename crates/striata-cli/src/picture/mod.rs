//! Pictures without a GPU: a canvas in linear light, text on it, and PNG out of it.

mod font;
mod normals;
#[cfg(feature = "serve")]
mod portrait;
mod raster;

pub(crate) use normals::vertex_normals;
#[cfg(feature = "serve")]
pub(crate) use portrait::{nobody, portrait};
pub(crate) use raster::{Camera, Paint, Surface, draw};

/// A colour in linear light, 0 to 1 a channel.
pub(crate) type Rgb = [f32; 3];

/// A rectangle of pixels in linear light, row by row from the top.
#[derive(Clone, Debug)]
pub(crate) struct Canvas {
    /// Pixels in a row.
    pub(crate) width: usize,
    /// Rows.
    pub(crate) height: usize,
    pixels: Vec<Rgb>,
}

impl Canvas {
    /// A canvas of one colour.
    pub(crate) fn filled(width: usize, height: usize, colour: Rgb) -> Self {
        Self { width, height, pixels: vec![colour; width * height] }
    }

    /// The pixels of one row.
    pub(crate) fn row_mut(&mut self, y: usize) -> &mut [Rgb] {
        &mut self.pixels[y * self.width..][..self.width]
    }

    /// Lays another canvas onto this one with its corner at (x, y); what does not fit is cut off.
    pub(crate) fn paste(&mut self, other: &Self, x: usize, y: usize) {
        let width = other.width.min(self.width.saturating_sub(x));
        for row in 0..other.height.min(self.height.saturating_sub(y)) {
            let source = &other.pixels[row * other.width..][..width];
            self.row_mut(y + row)[x..x + width].copy_from_slice(source);
        }
    }

    /// The canvas shrunk by a whole factor, each pixel the mean of those it covers.
    pub(crate) fn shrunk(&self, factor: usize) -> Self {
        let mut small = Self::filled(self.width / factor, self.height / factor, [0.0; 3]);
        let weight = 1.0 / (factor * factor) as f32;
        for y in 0..small.height {
            for x in 0..small.width {
                let mut sum = [0.0; 3];
                for row in 0..factor {
                    let start = (y * factor + row) * self.width + x * factor;
                    for pixel in &self.pixels[start..start + factor] {
                        sum = [sum[0] + pixel[0], sum[1] + pixel[1], sum[2] + pixel[2]];
                    }
                }
                small.row_mut(y)[x] = sum.map(|s| s * weight);
            }
        }
        small
    }

    /// Writes text centred at a column, its top at a row, each dot of the letters `scale` pixels wide.
    pub(crate) fn text_centred(&mut self, text: &str, [x, y]: [usize; 2], scale: usize, colour: Rgb) {
        let mut left = x.saturating_sub(font::width(text) * scale / 2);
        for letter in text.chars() {
            for (row, line) in font::rows(letter).iter().enumerate() {
                for (column, _) in line.bytes().enumerate().filter(|&(_, dot)| dot == b'#') {
                    self.dot(left + column * scale, y + row * scale, scale, colour);
                }
            }
            left += font::advance(letter) * scale;
        }
    }

    fn dot(&mut self, x: usize, y: usize, size: usize, colour: Rgb) {
        let (right, bottom) = ((x + size).min(self.width), (y + size).min(self.height));
        for row in y..bottom {
            if x < right {
                self.row_mut(row)[x..right].fill(colour);
            }
        }
    }

    /// The canvas as a PNG file in sRGB.
    ///
    /// # Errors
    /// What the encoder reports.
    pub(crate) fn to_png(&self) -> Result<Vec<u8>, png::EncodingError> {
        let bytes: Vec<u8> = self.pixels.iter().flat_map(|p| p.map(to_srgb)).collect();
        let mut file = Vec::new();
        let mut encoder = png::Encoder::new(&mut file, self.width as u32, self.height as u32);
        encoder.set_color(png::ColorType::Rgb);
        encoder.set_depth(png::BitDepth::Eight);
        encoder.set_compression(png::Compression::High);
        let mut writer = encoder.write_header()?;
        writer.write_image_data(&bytes)?;
        writer.finish()?;
        Ok(file)
    }
}

/// The byte that shows so much light on a usual screen.
fn to_srgb(light: f32) -> u8 {
    let x = light.clamp(0.0, 1.0);
    let encoded = if x <= 0.003_130_8 { 12.92 * x } else { 1.055 * x.powf(1.0 / 2.4) - 0.055 };
    (encoded * 255.0 + 0.5) as u8
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shrinking_averages() {
        let mut canvas = Canvas::filled(4, 2, [0.0; 3]);
        canvas.row_mut(0)[0] = [1.0; 3];
        let small = canvas.shrunk(2);
        assert_eq!((small.width, small.height), (2, 1));
        assert_eq!(small.pixels, vec![[0.25; 3], [0.0; 3]]);
    }

    #[test]
    fn pasting_past_the_edge_is_cut_off() {
        let mut canvas = Canvas::filled(2, 2, [0.0; 3]);
        canvas.paste(&Canvas::filled(3, 3, [1.0; 3]), 1, 1);
        assert_eq!(canvas.pixels, vec![[0.0; 3], [0.0; 3], [0.0; 3], [1.0; 3]]);
    }

    #[test]
    fn text_leaves_dots_and_png_decodes_again() {
        let mut canvas = Canvas::filled(60, 12, [1.0; 3]);
        canvas.text_centred("10 %", [30, 1], 1, [0.0; 3]);
        assert!(canvas.pixels.contains(&[0.0; 3]));
        let file = canvas.to_png().expect("memory takes it");
        let mut reader = png::Decoder::new(std::io::Cursor::new(file)).read_info().expect("a PNG header");
        let mut bytes = vec![0; reader.output_buffer_size().expect("a small picture")];
        let info = reader.next_frame(&mut bytes).expect("whole data");
        assert_eq!((info.width, info.height), (60, 12));
        assert_eq!(bytes.iter().filter(|&&b| b == 0).count() % 3, 0);
        assert!(bytes.contains(&0) && bytes.contains(&255));
    }
}
