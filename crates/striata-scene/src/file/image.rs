//! Images of a scene as sections: three texts, then the bytes of the image file to the end.

use striata::file::EncodeError;
use striata::mesh::Image;

use super::SceneDecodeError;

/// Encodes an image.
pub(super) fn image_to_bytes(image: &Image) -> Result<Vec<u8>, EncodeError> {
    let texts = [
        ("an image's name", &image.name),
        ("an image's URI", &image.uri),
        ("an image's type", &image.mime_type),
    ];
    let mut out = Vec::with_capacity(image.bytes.len() + 64);
    for (what, text) in texts {
        let length = text.len();
        let word = u32::try_from(length).map_err(|_| EncodeError::TooLong { what, length })?;
        out.extend(word.to_le_bytes());
        out.extend(text.as_bytes());
    }
    out.extend_from_slice(&image.bytes);
    Ok(out)
}

/// Decodes image number `image`.
pub(super) fn image_from_bytes(image: usize, bytes: &[u8]) -> Result<Image, SceneDecodeError> {
    let mut at = 0;
    let mut text = || -> Result<String, SceneDecodeError> {
        let fail = |reason| SceneDecodeError::Image { image, offset: at, reason };
        let rest = &bytes[at..];
        let (length, rest) = rest.split_first_chunk::<4>().ok_or_else(|| fail("ends within a length"))?;
        let length = u32::from_le_bytes(*length) as usize;
        let text = rest.get(..length).ok_or_else(|| fail("ends within a text"))?;
        let text = std::str::from_utf8(text).map_err(|_| fail("a text is not valid UTF-8"))?;
        at += 4 + length;
        Ok(text.to_owned())
    };
    let (name, uri, mime_type) = (text()?, text()?, text()?);
    Ok(Image { name, uri, mime_type, bytes: bytes[at..].to_vec() })
}
