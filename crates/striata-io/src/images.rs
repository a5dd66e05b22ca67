//! Image files: their media types, and limits on the memory that they may take.

use std::fmt;
use std::fs::File;
use std::io::{self, Read};

/// Memory that images may take regardless of the size of the file that refers to them, in bytes.
const ALWAYS_ALLOWED_BYTES: u64 = 1 << 30;

/// Additional memory allowed per byte of that file.
const BYTES_PER_INPUT_BYTE: u64 = 64;

/// Memory that the images of one file have taken, and the limit.
pub(crate) struct ImageBudget {
    input_bytes: u64,
    used_bytes: u64,
}

/// Reason why the bytes of an image are not there.
#[derive(Debug)]
pub(crate) enum ImageError {
    TooLarge { image_bytes: u64, input_bytes: u64 },
    Io(io::Error),
}

impl fmt::Display for ImageError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::TooLarge { image_bytes, input_bytes } => {
                write!(f, "{image_bytes} bytes of images in a file of {input_bytes} bytes")
            }
            Self::Io(error) => write!(f, "{error}"),
        }
    }
}

impl ImageBudget {
    /// Creates the budget for a file of `input_bytes`.
    pub(crate) fn new(input_bytes: u64) -> Self {
        Self { input_bytes, used_bytes: 0 }
    }

    /// Counts an image, or refuses it if all images together would become too large.
    pub(crate) fn take(&mut self, image_bytes: u64) -> Result<(), ImageError> {
        let limit = ALWAYS_ALLOWED_BYTES.max(self.input_bytes.saturating_mul(BYTES_PER_INPUT_BYTE));
        let image_bytes = self.used_bytes.saturating_add(image_bytes);
        if image_bytes > limit {
            return Err(ImageError::TooLarge { image_bytes, input_bytes: self.input_bytes });
        }
        self.used_bytes = image_bytes;
        Ok(())
    }

    /// Reads a regular file and counts its bytes. The size is checked before anything is read.
    pub(crate) fn read(&mut self, file: File) -> Result<Vec<u8>, ImageError> {
        let size = file.metadata().map_err(ImageError::Io)?.len();
        self.take(size)?;
        let mut bytes = Vec::new();
        // The file may grow while it is read.
        file.take(size).read_to_end(&mut bytes).map_err(ImageError::Io)?;
        Ok(bytes)
    }
}

/// Refuses a file outside the folder of the source that is no image: a name must not include any file of the
/// machine in what is made of the source.
pub(crate) fn image_from_afar(bytes: Vec<u8>, name: &str, is_outside: bool) -> Result<Vec<u8>, String> {
    match is_outside && media_type(&bytes).is_empty() && png_of(&bytes, name).is_none_or(|png| png.is_err()) {
        true => Err("not an image, and outside the folder of the file".to_owned()),
        false => Ok(bytes),
    }
}

/// Converts TGA and BMP, which glTF cannot store, to PNG; [`None`] if the file is neither.
#[cfg(feature = "images")]
pub(crate) fn png_of(bytes: &[u8], name: &str) -> Option<Result<Vec<u8>, String>> {
    if !media_type(bytes).is_empty() {
        return None;
    }
    let converted = crate::image_pixels::png_of(bytes, name)?;
    Some(converted.map_err(|reason| format!("the image is damaged: {reason}")))
}

/// Nothing is converted without the feature `images`.
#[cfg(not(feature = "images"))]
pub(crate) fn png_of(_bytes: &[u8], _name: &str) -> Option<Result<Vec<u8>, String>> {
    None
}

/// Detects the media type of an image by its first bytes; empty if it is unknown.
pub(crate) fn media_type(bytes: &[u8]) -> &'static str {
    match bytes {
        [0x89, b'P', b'N', b'G', ..] => "image/png",
        [0xff, 0xd8, 0xff, ..] => "image/jpeg",
        [b'R', b'I', b'F', b'F', _, _, _, _, b'W', b'E', b'B', b'P', ..] => "image/webp",
        [0xab, b'K', b'T', b'X', b' ', b'2', b'0', ..] => "image/ktx2",
        [b'D', b'D', b'S', b' ', ..] => "image/vnd-ms.dds",
        _ => "",
    }
}

/// Offset of the color type in a PNG file, after the signature, the chunk's head, and 9 bytes of `IHDR`.
#[cfg(feature = "obj")]
const PNG_COLOR_TYPE: usize = 8 + 8 + 9;

/// Whether a PNG or JPEG has only one color channel; false if the header is unusual.
#[cfg(feature = "obj")]
pub(crate) fn is_gray(bytes: &[u8]) -> bool {
    match media_type(bytes) {
        "image/png" => matches!(bytes.get(PNG_COLOR_TYPE), Some(0 | 4)),
        "image/jpeg" => jpeg_channel_count(bytes) == Some(1),
        _ => false,
    }
}

/// Whether a PNG has an alpha channel.
#[cfg(feature = "obj")]
pub(crate) fn has_alpha(bytes: &[u8]) -> bool {
    media_type(bytes) == "image/png" && matches!(bytes.get(PNG_COLOR_TYPE), Some(4 | 6))
}

/// Returns the number of channels that a JPEG's frame header declares.
#[cfg(feature = "obj")]
fn jpeg_channel_count(bytes: &[u8]) -> Option<u8> {
    let mut at = 2;
    loop {
        let &[0xff, marker, high, low] = bytes.get(at..at + 4)?.first_chunk::<4>()? else { return None };
        match marker {
            // Fill bytes may precede a marker.
            0xff => at += 1,
            // Frame headers; the gaps are tables and an extension.
            0xc0..=0xc3 | 0xc5..=0xc7 | 0xc9..=0xcb | 0xcd..=0xcf => return bytes.get(at + 9).copied(),
            _ => at += 2 + usize::from(u16::from_be_bytes([high, low])),
        }
    }
}

#[cfg(all(test, feature = "obj"))]
mod tests {
    use super::*;

    fn png(color_type: u8) -> Vec<u8> {
        let mut bytes = b"\x89PNG\r\n\x1a\n\0\0\0\x0dIHDR".to_vec();
        bytes.extend_from_slice(&[0, 0, 0, 1, 0, 0, 0, 1, 8, color_type]);
        bytes
    }

    #[test]
    fn channels_are_read_from_the_header() {
        assert_eq!([0, 2, 3, 4, 6].map(|t| is_gray(&png(t))), [true, false, false, true, false]);
        assert_eq!([0, 2, 3, 4, 6].map(|t| has_alpha(&png(t))), [false, false, false, true, true]);
        let jpeg = |channels: u8| {
            let mut bytes = vec![0xff, 0xd8, 0xff, 0xe0, 0, 4, 1, 2, 0xff, 0xff, 0xc2, 0, 11, 8, 0, 1, 0, 1];
            bytes.push(channels);
            bytes
        };
        assert!(is_gray(&jpeg(1)) && !is_gray(&jpeg(3)));
        for length in 0..jpeg(1).len() {
            assert!(!is_gray(&jpeg(1)[..length]), "{length}");
        }
        // Segments of length 0 must not loop.
        assert!(!is_gray(&[0xff, 0xd8, 0xff, 0xe0, 0, 0, 0xff, 0xe0, 0, 0]));
    }

    #[test]
    fn images_have_a_budget() {
        let mut budget = ImageBudget::new(1);
        budget.take(ALWAYS_ALLOWED_BYTES).unwrap();
        let message = budget.take(1).unwrap_err().to_string();
        assert_eq!(message, "1073741825 bytes of images in a file of 1 bytes");
        let mut file = tempfile::tempfile().unwrap();
        io::Write::write_all(&mut file, b"x").unwrap();
        assert!(matches!(budget.read(file), Err(ImageError::TooLarge { .. })));
    }
}
