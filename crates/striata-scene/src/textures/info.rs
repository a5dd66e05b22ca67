//! Format and size of an image, read from its header only.

use std::fmt;

use super::TextureError;

/// Largest width or height of an image that is decoded, pixels.
pub const MAX_SIDE: u32 = 16_384;

/// Largest size of the pixels of an image that is decoded, bytes.
pub const MAX_PIXEL_BYTES: u64 = 1 << 28;

/// Images up to this size are decoded whatever the size of their file is, bytes of pixels.
const ALWAYS_ALLOWED_BYTES: u64 = 1 << 26;

/// Largest number of bytes of pixels for each byte of a file, beyond [`ALWAYS_ALLOWED_BYTES`].
const MAX_EXPANSION: u64 = 2048;

/// File format of an image.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum ImageFormat {
    /// Portable Network Graphics.
    Png,
    /// JPEG.
    Jpeg,
    /// WebP.
    WebP,
    /// Khronos texture container, with blocks compressed for GPUs.
    Ktx2,
    /// DirectDraw surface, with blocks compressed for GPUs.
    Dds,
}

impl ImageFormat {
    /// Detects the format by the first bytes of a file.
    pub fn detect(bytes: &[u8]) -> Option<Self> {
        match bytes {
            [0x89, b'P', b'N', b'G', 0x0d, 0x0a, 0x1a, 0x0a, ..] => Some(Self::Png),
            [0xff, 0xd8, 0xff, ..] => Some(Self::Jpeg),
            [b'R', b'I', b'F', b'F', _, _, _, _, b'W', b'E', b'B', b'P', ..] => Some(Self::WebP),
            [0xab, b'K', b'T', b'X', b' ', b'2', b'0', 0xbb, ..] => Some(Self::Ktx2),
            [b'D', b'D', b'S', b' ', ..] => Some(Self::Dds),
            _ => None,
        }
    }

    /// Returns the MIME type that glTF uses for the format.
    pub fn mime_type(self) -> &'static str {
        match self {
            Self::Png => "image/png",
            Self::Jpeg => "image/jpeg",
            Self::WebP => "image/webp",
            Self::Ktx2 => "image/ktx2",
            Self::Dds => "image/vnd-ms.dds",
        }
    }

    /// Returns the name of the format.
    pub fn name(self) -> &'static str {
        match self {
            Self::Png => "PNG",
            Self::Jpeg => "JPEG",
            Self::WebP => "WebP",
            Self::Ktx2 => "KTX2",
            Self::Dds => "DDS",
        }
    }

    /// Whether [`preview`](super::preview) and [`recode`](super::recode) can decode the format.
    pub fn is_decoded(self) -> bool {
        matches!(self, Self::Png | Self::Jpeg | Self::WebP)
    }
}

impl fmt::Display for ImageFormat {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// Format and size of an image, from its header.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct ImageInfo {
    /// File format.
    pub format: ImageFormat,
    /// Width, pixels.
    pub width: u32,
    /// Height, pixels.
    pub height: u32,
}

impl ImageInfo {
    /// Checks that the image may be decoded, given the length of its file and the size of a pixel in bytes.
    #[cfg_attr(not(feature = "textures"), expect(dead_code, reason = "only decoders need it"))]
    pub(super) fn check_limits(&self, file_bytes: usize, pixel_bytes: u64) -> Result<(), TextureError> {
        let Self { width, height, .. } = *self;
        let fail = |limit: String| Err(TextureError::TooLarge { width, height, limit });
        if width > MAX_SIDE || height > MAX_SIDE {
            return fail(format!("{MAX_SIDE} pixels per side"));
        }
        let by_file = (file_bytes as u64).saturating_mul(MAX_EXPANSION).max(ALWAYS_ALLOWED_BYTES);
        let limit = MAX_PIXEL_BYTES.min(by_file);
        if u64::from(width) * u64::from(height) * pixel_bytes > limit {
            return fail(format!("{limit} bytes of pixels for a file of {file_bytes} bytes"));
        }
        Ok(())
    }
}

/// Reads the format and the size of an image from its header.
///
/// # Errors
/// [`TextureError`] if the format is unknown, or the header is malformed or states a size of zero.
///
/// # Example
/// ```
/// let png = striata_scene::textures::placeholder_png([255, 0, 0, 255]);
/// let info = striata_scene::textures::image_info(&png)?;
/// assert_eq!((info.width, info.height), (1, 1));
/// # Ok::<(), striata_scene::textures::TextureError>(())
/// ```
pub fn image_info(bytes: &[u8]) -> Result<ImageInfo, TextureError> {
    let format = ImageFormat::detect(bytes)
        .ok_or_else(|| TextureError::Format { found: bytes[..bytes.len().min(8)].to_vec() })?;
    let malformed = || TextureError::Header { format: format.name() };
    let (width, height) = match format {
        ImageFormat::Png if bytes.get(12..16) == Some(b"IHDR") => {
            (u32_at(bytes, 16).map(u32::from_be), u32_at(bytes, 20).map(u32::from_be))
        }
        ImageFormat::Png => (None, None),
        ImageFormat::Ktx2 => (u32_at(bytes, 20), u32_at(bytes, 24)),
        // The height precedes the width.
        ImageFormat::Dds => (u32_at(bytes, 16), u32_at(bytes, 12)),
        ImageFormat::Jpeg | ImageFormat::WebP => {
            let size = imagesize::blob_size(bytes).map_err(|_| malformed())?;
            (u32::try_from(size.width).ok(), u32::try_from(size.height).ok())
        }
    };
    match width.zip(height) {
        Some((width, height)) if width > 0 && height > 0 => Ok(ImageInfo { format, width, height }),
        _ => Err(malformed()),
    }
}

/// Reads a little-endian number of a header.
fn u32_at(bytes: &[u8], offset: usize) -> Option<u32> {
    bytes.get(offset..)?.first_chunk::<4>().map(|chunk| u32::from_le_bytes(*chunk))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Headers without any pixels, all of 300 x 200.
    fn headers() -> Vec<(ImageFormat, Vec<u8>)> {
        let mut png = b"\x89PNG\r\n\x1a\n\0\0\0\x0dIHDR".to_vec();
        png.extend(300u32.to_be_bytes().into_iter().chain(200u32.to_be_bytes()));
        png.extend([8, 6, 0, 0, 0, 0, 0, 0, 0]);
        let jpeg = b"\xff\xd8\xff\xe0\0\x04ab\xff\xc0\0\x11\x08\0\xc8\x01\x2c\x03".to_vec();
        let mut webp = b"RIFF\x1e\0\0\0WEBPVP8X\x0a\0\0\0\0\0\0\0".to_vec();
        webp.extend([43, 1, 0, 199, 0, 0]);
        let mut ktx2 = b"\xabKTX 20\xbb\r\n\x1a\n".to_vec();
        for word in [0u32, 1, 300, 200, 0, 0, 1, 1, 1] {
            ktx2.extend(word.to_le_bytes());
        }
        let mut dds = b"DDS ".to_vec();
        for word in [124u32, 0x1007, 200, 300] {
            dds.extend(word.to_le_bytes());
        }
        dds.resize(128, 0);
        vec![
            (ImageFormat::Png, png),
            (ImageFormat::Jpeg, jpeg),
            (ImageFormat::WebP, webp),
            (ImageFormat::Ktx2, ktx2),
            (ImageFormat::Dds, dds),
        ]
    }

    #[test]
    fn reads_the_size_from_every_header() {
        for (format, bytes) in headers() {
            let info = image_info(&bytes).unwrap();
            assert_eq!((info.format, info.width, info.height), (format, 300, 200));
        }
    }

    #[test]
    fn truncated_and_damaged_headers_are_errors_or_sizes() {
        for (format, bytes) in headers() {
            for length in 0..bytes.len() {
                match image_info(&bytes[..length]) {
                    Ok(info) => assert_eq!((info.width, info.height), (300, 200), "{format} {length}"),
                    Err(error) => assert!(!error.to_string().is_empty()),
                }
            }
            for at in 0..bytes.len() {
                let mut bad = bytes.clone();
                bad[at] ^= 0xff;
                if let Ok(info) = image_info(&bad) {
                    assert!(info.width > 0 && info.height > 0);
                }
            }
        }
        assert!(matches!(image_info(b""), Err(TextureError::Format { .. })));
    }

    #[test]
    fn limits_depend_on_the_file() {
        let info = |width, height| ImageInfo { format: ImageFormat::Png, width, height };
        assert!(info(4096, 4096).check_limits(100, 4).is_ok());
        assert!(info(8192, 8192).check_limits(100, 4).is_err());
        assert!(info(8192, 8192).check_limits(1 << 20, 4).is_ok());
        assert!(info(16_384, 16_384).check_limits(1 << 30, 4).is_err());
        assert!(info(16_385, 1).check_limits(1 << 30, 4).is_err());
    }
}
