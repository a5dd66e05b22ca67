//! Pixels of PNG files.

/// A decoded PNG file; pixels have four bytes even if the file has no alpha channel.
pub(crate) struct DecodedPng {
    pub width: usize,
    pub height: usize,
    pub pixels: Vec<[u8; 4]>,
}

impl DecodedPng {
    pub(crate) fn of(bytes: &[u8]) -> Self {
        let mut reader = ::png::Decoder::new(std::io::Cursor::new(bytes)).read_info().expect("a PNG file");
        let mut buffer = vec![0; reader.output_buffer_size().expect("a small picture")];
        let info = reader.next_frame(&mut buffer).expect("whole data");
        let channels = info.color_type.samples();
        let pixel = |p: &[u8]| [p[0], p[1], p[2], p.get(3).copied().unwrap_or(255)];
        let pixels = buffer[..info.buffer_size()].chunks_exact(channels).map(pixel).collect();
        Self { width: info.width as usize, height: info.height as usize, pixels }
    }

    pub(crate) fn at(&self, x: usize, y: usize) -> [u8; 4] {
        self.pixels[y * self.width + x]
    }

    /// Counts pixels in some columns that differ from the background, which is the first pixel of the
    /// picture.
    pub(crate) fn drawn(&self, columns: std::ops::Range<usize>) -> usize {
        let inside = |i: &usize| columns.contains(&(i % self.width));
        (0..self.pixels.len()).filter(inside).filter(|&i| self.pixels[i] != self.pixels[0]).count()
    }

    /// Counts pixels that differ considerably from those of another picture.
    pub(crate) fn differing(&self, other: &Self) -> usize {
        let pairs = self.pixels.iter().zip(&other.pixels);
        pairs.filter(|(a, b)| a.iter().zip(*b).any(|(x, y)| x.abs_diff(*y) > 24)).count()
    }
}
