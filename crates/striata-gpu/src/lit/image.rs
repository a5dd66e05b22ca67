//! Decoded images.

use std::sync::Arc;

use crate::gpu_error::GpuError;

/// An image of 8 bits for each of red, green, blue and opacity, row by row from the top.
///
/// Whether the values are sRGB or linear depends on how a material uses the image. Clones share the pixels.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LitImage {
    /// Width in pixels.
    pub width: u32,
    /// Height in pixels.
    pub height: u32,
    /// Pixel bytes, 4 per pixel.
    pub rgba: Arc<[u8]>,
}

impl LitImage {
    /// Checks the size, and that there are as many bytes as pixels need.
    pub(crate) fn check(&self, image: usize) -> Result<(), GpuError> {
        let expected_bytes = 4 * u128::from(self.width) * u128::from(self.height);
        if expected_bytes == 0 || self.rgba.len() as u128 != expected_bytes {
            let (width, height, found_bytes) = (self.width, self.height, self.rgba.len());
            return Err(GpuError::ImageSize { image, width, height, found_bytes });
        }
        Ok(())
    }
}
