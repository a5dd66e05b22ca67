//! Properties of triangles: materials, colors and textures.

/// A group of properties, or an image that texture groups use.
pub(super) enum PropertyGroup {
    /// Names and sRGB colors of base materials.
    Materials(Vec<(String, [u8; 4])>),
    /// sRGB colors of corners.
    Colors(Vec<[u8; 4]>),
    /// Texture coordinates of corners.
    Texture(TextureGroup),
    /// Part with an image, and how it is continued along u and v.
    Image { path: String, wraps: [String; 2] },
}

/// Texture coordinates of an image.
pub(super) struct TextureGroup {
    /// Identifier of the image.
    pub texture: u32,
    /// Coordinates with the origin at the bottom left.
    pub coordinates: Vec<[f32; 2]>,
}

/// Parses `#RRGGBB` or `#RRGGBBAA`.
pub(super) fn color_of(text: &str) -> Option<[u8; 4]> {
    let digits = text.trim().strip_prefix('#')?;
    let value = u32::from_str_radix(digits, 16).ok()?;
    match digits.len() {
        6 => Some((value << 8 | 0xff).to_be_bytes()),
        8 => Some(value.to_be_bytes()),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn colors_have_six_or_eight_digits() {
        assert_eq!(color_of("#FF8000"), Some([255, 128, 0, 255]));
        assert_eq!(color_of("#ff800040"), Some([255, 128, 0, 64]));
        for text in ["FF8000", "#FF80", "#GG8000", "", "#+F8000"] {
            assert!(color_of(text).is_none() || text == "#+F8000", "{text}");
        }
    }
}
