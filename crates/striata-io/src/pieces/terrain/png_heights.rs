//! Gray PNG images with 8 or 16 bits: the value of a pixel is its height.

use std::fs::File;
use std::io::BufReader;
use std::path::Path;

use super::raster::{Raster, RasterPlacement, malformed};
use crate::ReadError;

/// Images larger than this are refused, in pixels: they have to be decoded as a whole.
const MAX_PIXELS: u64 = 1 << 29;

/// A gray image, decoded.
pub(super) struct PngHeights {
    name: String,
    size: [u64; 2],
    values: Vec<u16>,
    placement: RasterPlacement,
}

impl PngHeights {
    pub(super) fn open(path: &Path) -> Result<Self, ReadError> {
        let name = path.display().to_string();
        let file = File::open(path).map_err(|source| ReadError::Io { file: name.clone(), source })?;
        let wrong = |error: png::DecodingError| malformed(&name, error.to_string());
        let limits = png::Limits { bytes: 3 * MAX_PIXELS as usize };
        let mut reader =
            png::Decoder::new_with_limits(BufReader::new(file), limits).read_info().map_err(wrong)?;
        let info = reader.info();
        let size = [u64::from(info.width), u64::from(info.height)];
        if size[0] * size[1] > MAX_PIXELS {
            return Err(malformed(&name, format!("{} by {} pixels are too many", size[0], size[1])));
        }
        let is_gray = info.color_type == png::ColorType::Grayscale;
        let is_deep = info.bit_depth == png::BitDepth::Sixteen;
        if !is_gray || !(is_deep || info.bit_depth == png::BitDepth::Eight) {
            return Err(malformed(&name, "heights are read from gray images with 8 or 16 bits only"));
        }
        let Some(bytes) = reader.output_buffer_size() else {
            return Err(malformed(&name, "the image is too large"));
        };
        let mut pixels = vec![0; bytes];
        reader.next_frame(&mut pixels).map_err(wrong)?;
        let values = if is_deep {
            pixels.chunks_exact(2).map(|b| u16::from_be_bytes([b[0], b[1]])).collect()
        } else {
            pixels.into_iter().map(u16::from).collect()
        };
        let north = (size[1] - 1) as f64;
        let placement =
            RasterPlacement { west: 0.0, north, step: [1.0; 2], is_geographic: false, epsg: None };
        Ok(Self { name, size, values, placement })
    }
}

impl Raster for PngHeights {
    fn name(&self) -> &str {
        &self.name
    }

    fn size(&self) -> [u64; 2] {
        self.size
    }

    fn placement(&self) -> &RasterPlacement {
        &self.placement
    }

    fn read(&self, at: [u64; 2], [width, height]: [u64; 2]) -> Result<Vec<f32>, ReadError> {
        let row = |y: u64| {
            let from = (y * self.size[0] + at[0]) as usize;
            self.values[from..from + width as usize].iter().map(|&value| f32::from(value))
        };
        Ok((at[1]..at[1] + height).flat_map(row).collect())
    }
}
