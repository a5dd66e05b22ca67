//! Detection of file formats, by content and by extension.

use std::fmt;
use std::path::Path;

use striata::file::{SCENE_STREAM_MAGIC, STREAM_MAGIC};

/// File format that striata recognizes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Format {
    /// Stanford polygon format, ASCII or binary.
    Ply,
    /// Wavefront OBJ.
    Obj,
    /// Stereolithography, ASCII or binary.
    Stl,
    /// Object File Format of Geomview.
    Off,
    /// glTF 2.0 as JSON.
    Gltf,
    /// glTF 2.0 as one binary file.
    Glb,
    /// The striata container: recognized, but not read by this crate.
    Striata,
    /// A bare progressive stream of a mesh or a scene: recognized, but not read by this crate.
    Stream,
}

/// First bytes of a striata container.
const STRIATA_MAGIC: &[u8] = b"STRIATA\0";

/// Number of bytes of a text file that are examined to recognize it.
const EXAMINED_BYTES: usize = 4096;

impl Format {
    /// Detects the format of a file, by its content first and by the extension of its name second.
    ///
    /// Compressed data are not unpacked for this: see [`decompressed`](crate::decompressed).
    pub fn detect(bytes: &[u8], name: &str) -> Option<Self> {
        Self::from_content(bytes).or_else(|| Self::from_extension(name))
    }

    /// Returns the format for a name's extension, ignoring a trailing `.gz` or `.zst`.
    pub fn from_extension(name: impl AsRef<Path>) -> Option<Self> {
        let mut path = name.as_ref();
        loop {
            let extension = path.extension()?.to_str()?.to_ascii_lowercase();
            return Some(match extension.as_str() {
                "ply" => Self::Ply,
                "obj" => Self::Obj,
                "stl" => Self::Stl,
                "off" | "coff" | "noff" | "stoff" => Self::Off,
                "gltf" => Self::Gltf,
                "glb" => Self::Glb,
                "striata" => Self::Striata,
                "stri" => Self::Stream,
                "gz" | "zst" => {
                    path = Path::new(path.file_stem()?);
                    continue;
                }
                _ => return None,
            });
        }
    }

    /// Returns the usual extension, without the dot.
    pub fn extension(self) -> &'static str {
        match self {
            Self::Ply => "ply",
            Self::Obj => "obj",
            Self::Stl => "stl",
            Self::Off => "off",
            Self::Gltf => "gltf",
            Self::Glb => "glb",
            Self::Striata => "striata",
            Self::Stream => "stri",
        }
    }

    /// Detects the format from the first bytes of a file.
    fn from_content(bytes: &[u8]) -> Option<Self> {
        if bytes.starts_with(STRIATA_MAGIC) {
            return Some(Self::Striata);
        }
        if bytes.starts_with(&STREAM_MAGIC) || bytes.starts_with(&SCENE_STREAM_MAGIC) {
            return Some(Self::Stream);
        }
        if bytes.starts_with(b"glTF") {
            return Some(Self::Glb);
        }
        if bytes.starts_with(b"ply") && bytes.get(3).is_some_and(u8::is_ascii_whitespace) {
            return Some(Self::Ply);
        }
        if is_binary_stl(bytes) {
            return Some(Self::Stl);
        }
        let head = &bytes[..bytes.len().min(EXAMINED_BYTES)];
        let text = head.strip_prefix(b"\xef\xbb\xbf").unwrap_or(head);
        let first_line = text
            .split(|&b| b == b'\n' || b == b'\r')
            .map(<[u8]>::trim_ascii)
            .find(|line| !line.is_empty() && !line.starts_with(b"#"))?;
        let first_word = first_line.split(u8::is_ascii_whitespace).next()?;
        match first_word {
            word if word.eq_ignore_ascii_case(b"solid") || word.eq_ignore_ascii_case(b"facet") => {
                Some(Self::Stl)
            }
            word if is_off_keyword(word) => Some(Self::Off),
            word if word.starts_with(b"{") => Some(Self::Gltf),
            b"v" | b"vt" | b"vn" | b"f" | b"o" | b"g" | b"usemtl" | b"mtllib" => Some(Self::Obj),
            _ => None,
        }
    }
}

/// Whether a word is `OFF` with any of its prefixes and perhaps a count, such as `STCNOFF`, `4OFF` or `off8`.
fn is_off_keyword(word: &[u8]) -> bool {
    let digits = word.iter().rev().take_while(|b| b.is_ascii_digit()).count();
    let lower = word[..word.len() - digits].to_ascii_lowercase();
    let Some(mut prefix) = lower.strip_suffix(b"off") else { return false };
    while let Some((part, rest)) = prefix.split_first() {
        prefix = match part {
            b's' => rest.strip_prefix(b"t").unwrap_or(b"?"),
            b'c' | b'n' | b'4' => rest,
            _ => return false,
        };
    }
    true
}

/// Whether the length is exactly that of a binary STL with the triangle count in its header.
pub(crate) fn is_binary_stl(bytes: &[u8]) -> bool {
    let Some(count) = bytes.get(80..84).and_then(|b| b.first_chunk::<4>()) else { return false };
    84 + 50 * u64::from(u32::from_le_bytes(*count)) == bytes.len() as u64
}

impl fmt::Display for Format {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Ply => "PLY",
            Self::Obj => "OBJ",
            Self::Stl => "STL",
            Self::Off => "OFF",
            Self::Gltf => "glTF",
            Self::Glb => "GLB",
            Self::Striata => "striata",
            Self::Stream => "striata stream",
        })
    }
}

/// Returns the names of a format and its cargo feature.
#[cfg(not(all(feature = "ply", feature = "obj", feature = "stl", feature = "off", feature = "gltf")))]
pub(crate) fn feature_of(format: Format) -> (&'static str, &'static str) {
    match format {
        Format::Ply => ("PLY", "ply"),
        Format::Obj => ("OBJ", "obj"),
        Format::Stl => ("STL", "stl"),
        Format::Off => ("OFF", "off"),
        Format::Gltf | Format::Glb => ("glTF", "gltf"),
        Format::Striata | Format::Stream => ("striata container", ""),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn content_wins_over_the_name() {
        let cases: [(&[u8], &str, Option<Format>); 22] = [
            (b"ply\nformat ascii 1.0\n", "x.obj", Some(Format::Ply)),
            (b"plywood", "x.txt", None),
            (b"glTF\x02\0\0\0", "x", Some(Format::Glb)),
            (b" \n{ \"asset\": {} }", "x", Some(Format::Gltf)),
            (b"# made by hand\n\nv 0 0 0\n", "x.stl", Some(Format::Obj)),
            (b"solid thing\n", "x", Some(Format::Stl)),
            (b"SOLID thing\n", "x", Some(Format::Stl)),
            (b"\xef\xbb\xbf# by a tool\rSolid thing\r", "x", Some(Format::Stl)),
            (b"facet normal 0 0 1\n", "x", Some(Format::Stl)),
            (b"OFF8 6 12\n", "x", Some(Format::Off)),
            (b"coff\n", "x", Some(Format::Off)),
            (b"Soff\n", "x", None),
            (b"coffee\n", "x", None),
            (b"STCOFF\n", "x", Some(Format::Off)),
            (b"OFF 8 6 12\n", "x", Some(Format::Off)),
            (b"STRIATA\0....", "x.ply", Some(Format::Striata)),
            (b"\x89STR\x01", "x.ply", Some(Format::Stream)),
            (b"\x89SCN\x01", "x.ply", Some(Format::Stream)),
            (b"hello", "x.stri", Some(Format::Stream)),
            (b"hello", "x.PLY", Some(Format::Ply)),
            (b"hello", "a.b/x.off.gz", Some(Format::Off)),
            (b"", "x.png", None),
        ];
        for (bytes, name, expected) in cases {
            assert_eq!(Format::detect(bytes, name), expected, "{name}: {}", String::from_utf8_lossy(bytes));
        }
        let mut stl = vec![0u8; 84 + 50];
        stl[..5].copy_from_slice(b"solid");
        stl[80] = 1;
        assert_eq!(Format::detect(&stl, "x"), Some(Format::Stl));
    }
}
