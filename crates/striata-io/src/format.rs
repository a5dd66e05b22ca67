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
    /// Legacy file of VTK, ASCII or binary.
    Vtk,
    /// Poly data of VTK as XML.
    Vtp,
    /// Unstructured grid of VTK as XML; only its surface cells are read.
    Vtu,
    /// 3D Manufacturing Format, an archive with a scene.
    ThreeMf,
    /// The striata container: recognized, but not read by this crate.
    Striata,
    /// A bare progressive stream of a mesh or a scene: recognized, but not read by this crate.
    Stream,
}

/// Name, extensions, feature and media type of a format.
struct Facts {
    format: Format,
    name: &'static str,
    /// Extensions in lower case; the usual one comes first.
    extensions: &'static [&'static str],
    /// Cargo feature with the reader; empty if another crate reads the format.
    feature: &'static str,
    media_type: &'static str,
}

/// All formats, in the order of [`Format`]'s variants.
const FORMATS: [Facts; 12] = [
    Facts {
        format: Format::Ply,
        name: "PLY",
        extensions: &["ply"],
        feature: "ply",
        media_type: "application/octet-stream",
    },
    Facts { format: Format::Obj, name: "OBJ", extensions: &["obj"], feature: "obj", media_type: "model/obj" },
    Facts { format: Format::Stl, name: "STL", extensions: &["stl"], feature: "stl", media_type: "model/stl" },
    Facts {
        format: Format::Off,
        name: "OFF",
        extensions: &["off", "coff", "noff", "stoff"],
        feature: "off",
        media_type: "application/octet-stream",
    },
    Facts {
        format: Format::Gltf,
        name: "glTF",
        extensions: &["gltf"],
        feature: "gltf",
        media_type: "model/gltf+json",
    },
    Facts {
        format: Format::Glb,
        name: "GLB",
        extensions: &["glb"],
        feature: "gltf",
        media_type: "model/gltf-binary",
    },
    Facts {
        format: Format::Vtk,
        name: "VTK",
        extensions: &["vtk"],
        feature: "vtk",
        media_type: "application/octet-stream",
    },
    Facts {
        format: Format::Vtp,
        name: "VTP",
        extensions: &["vtp"],
        feature: "vtk",
        media_type: "application/xml",
    },
    Facts {
        format: Format::Vtu,
        name: "VTU",
        extensions: &["vtu"],
        feature: "vtk",
        media_type: "application/xml",
    },
    Facts {
        format: Format::ThreeMf,
        name: "3MF",
        extensions: &["3mf"],
        feature: "threemf",
        media_type: "model/3mf",
    },
    Facts {
        format: Format::Striata,
        name: "striata",
        extensions: &["striata"],
        feature: "",
        media_type: "application/octet-stream",
    },
    Facts {
        format: Format::Stream,
        name: "striata stream",
        extensions: &["stri"],
        feature: "",
        media_type: "application/octet-stream",
    },
];

/// First bytes of a striata container.
const STRIATA_MAGIC: &[u8] = b"STRIATA\0";

/// Number of bytes of a text file that are examined to recognize it.
pub(crate) const EXAMINED_BYTES: usize = 4096;

impl Format {
    /// Detects the format of a file, by its content first and by the extension of its name second.
    ///
    /// Compressed data are not unpacked for this: see [`decompressed`](crate::decompressed).
    pub fn detect(bytes: &[u8], name: &str) -> Option<Self> {
        Self::from_content(bytes).or_else(|| {
            #[cfg(not(target_family = "wasm"))]
            if crate::foreign::is_foreign(bytes) && Self::from_extension(name) != Some(Self::ThreeMf) {
                return None;
            }
            Self::from_extension(name)
        })
    }

    /// Returns the format for a name's extension, ignoring a trailing `.gz` or `.zst`.
    pub fn from_extension(name: impl AsRef<Path>) -> Option<Self> {
        let mut path = name.as_ref();
        loop {
            let extension = path.extension()?.to_str()?.to_ascii_lowercase();
            if matches!(extension.as_str(), "gz" | "zst") {
                path = Path::new(path.file_stem()?);
                continue;
            }
            let known = FORMATS.iter().find(|facts| facts.extensions.contains(&extension.as_str()));
            return known.map(|facts| facts.format);
        }
    }

    /// Formats of meshes that this crate reads, if their features are on.
    pub fn meshes() -> impl Iterator<Item = Self> {
        FORMATS.iter().filter(|facts| !facts.feature.is_empty()).map(|facts| facts.format)
    }

    /// Returns the usual extension, without the dot.
    pub fn extension(self) -> &'static str {
        self.facts().extensions[0]
    }

    /// Whether files of this format contain scenes: nodes with transforms and materials.
    pub fn has_scenes(self) -> bool {
        matches!(self, Self::Gltf | Self::Glb | Self::ThreeMf)
    }

    /// Returns the media type for HTTP.
    pub fn media_type(self) -> &'static str {
        self.facts().media_type
    }

    /// Returns the name of the format and the cargo feature with its reader and writer.
    pub(crate) fn name_and_feature(self) -> (&'static str, &'static str) {
        (self.facts().name, self.facts().feature)
    }

    fn facts(self) -> &'static Facts {
        let facts = &FORMATS[self as usize];
        debug_assert!(facts.format == self, "the table is in the order of the variants");
        facts
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
        if bytes.starts_with(b"PK\x03\x04") && names_model_part(bytes) {
            return Some(Self::ThreeMf);
        }
        let head = &bytes[..bytes.len().min(EXAMINED_BYTES)];
        let text = head.strip_prefix(b"\xef\xbb\xbf").unwrap_or(head);
        let is_ply = text.get(..3).is_some_and(|word| word.eq_ignore_ascii_case(b"ply"));
        if is_ply && text.get(3).is_some_and(u8::is_ascii_whitespace) {
            return Some(Self::Ply);
        }
        if is_binary_stl(bytes) {
            return Some(Self::Stl);
        }
        if head.starts_with(b"# vtk DataFile Version") {
            return Some(Self::Vtk);
        }
        if text.starts_with(b"<") {
            let contains = |word: &[u8]| text.windows(word.len()).any(|window| window == word);
            return match contains(b"<VTKFile") {
                true if contains(b"\"PolyData\"") => Some(Self::Vtp),
                true if contains(b"\"UnstructuredGrid\"") => Some(Self::Vtu),
                _ => None,
            };
        }
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

/// Whether an archive has a part like `3D/3dmodel.model`: names are at the end of an archive, and at its start.
fn names_model_part(bytes: &[u8]) -> bool {
    const NAME: &[u8] = b".model";
    const EXAMINED: usize = 64 << 10;
    let parts = [&bytes[..bytes.len().min(EXAMINED)], &bytes[bytes.len().saturating_sub(EXAMINED)..]];
    parts.into_iter().any(|part| part.windows(NAME.len()).any(|window| window.eq_ignore_ascii_case(NAME)))
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
        f.write_str(self.facts().name)
    }
}

/// Returns the usual extensions of the formats of meshes, for messages: `.ply .obj`.
pub(crate) fn mesh_extensions() -> String {
    let dotted: Vec<String> = Format::meshes().map(|format| format!(".{}", format.extension())).collect();
    dotted.join(" ")
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
