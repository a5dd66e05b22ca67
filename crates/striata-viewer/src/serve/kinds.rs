//! Kinds of files that are served, and their MIME types.

use std::path::Path;

use striata_io::Format;

/// Files that models refer to: buffers, materials, pages, textures.
const COMPANIONS: &[(&str, &str)] = &[
    ("bin", "application/octet-stream"),
    ("mtl", "model/mtl"),
    ("page", "application/octet-stream"),
    ("png", "image/png"),
    ("jpg", "image/jpeg"),
    ("jpeg", "image/jpeg"),
    ("webp", "image/webp"),
    ("ktx2", "image/ktx2"),
    ("tga", "image/x-tga"),
    ("bmp", "image/bmp"),
];

/// File types of the viewer page.
const PAGE: &[(&str, &str)] = &[
    ("html", "text/html; charset=utf-8"),
    ("js", "text/javascript; charset=utf-8"),
    ("css", "text/css; charset=utf-8"),
    ("wasm", "application/wasm"),
    ("json", "application/json"),
    ("svg", "image/svg+xml"),
    ("png", "image/png"),
    ("ico", "image/x-icon"),
    ("txt", "text/plain; charset=utf-8"),
];

/// Whether a name is that of a model, plain or compressed.
pub(super) fn is_model(name: &str) -> bool {
    Format::from_extension(name).is_some()
}

/// Whether a name is that of a file that models refer to.
pub(super) fn is_companion(name: &str) -> bool {
    lookup(COMPANIONS, name).is_some()
}

/// Whether a model may consist of several files.
pub(super) fn has_companions(name: &str) -> bool {
    matches!(Format::from_extension(name), Some(Format::Gltf | Format::Obj | Format::Striata))
}

/// MIME type of a model or a file that models refer to.
pub(super) fn content_type(name: &str) -> &'static str {
    match extension(name).as_str() {
        "gz" => return "application/gzip",
        "zst" => return "application/zstd",
        _ => {}
    }
    match Format::from_extension(name) {
        Some(format) => format.media_type(),
        None => lookup(COMPANIONS, name).unwrap_or("application/octet-stream"),
    }
}

/// MIME type of a file of the viewer.
pub(super) fn page_type(name: &str) -> &'static str {
    lookup(PAGE, name).unwrap_or("application/octet-stream")
}

/// Whether a file is text, which compresses well, judging by its name and first bytes.
pub(super) fn is_text(name: &str, head: &[u8]) -> bool {
    if matches!(extension(name).as_str(), "gz" | "zst") {
        return false;
    }
    match Format::from_extension(name) {
        Some(Format::Obj | Format::Off | Format::Gltf) => !head.contains(&0),
        Some(Format::Ply) => head.windows(12).any(|line| line == b"format ascii"),
        Some(Format::Stl) => head.starts_with(b"solid") && !head.contains(&0),
        // Compressed arrays are base64, and appended ones are bytes, which zeros reveal.
        Some(Format::Vtk | Format::Vtp | Format::Vtu) => !head.contains(&0),
        Some(_) => false,
        None => extension(name) == "mtl",
    }
}

fn lookup(table: &[(&str, &'static str)], name: &str) -> Option<&'static str> {
    let extension = extension(name);
    table.iter().find(|(lookup, _)| *lookup == extension).map(|&(_, content_type)| content_type)
}

fn extension(name: &str) -> String {
    Path::new(name).extension().unwrap_or_default().to_string_lossy().to_ascii_lowercase()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn text_is_distinguished_from_binary() {
        for (name, head, expected) in [
            ("a.obj", &b"v 0 0 0"[..], true),
            ("a.obj.gz", b"v 0 0 0", false),
            ("a.PLY", b"ply\nformat ascii 1.0\n", true),
            ("a.ply", b"ply\nformat binary_little_endian 1.0\n", false),
            ("a.stl", b"solid a\n facet", true),
            ("a.stl", b"solid\0\0\0", false),
            ("a.glb", b"glTF", false),
            ("a.stri", b"", false),
            ("a.striata", b"", false),
            ("a.bin", b"abc", false),
            ("a.mtl", b"newmtl", true),
        ] {
            assert_eq!(is_text(name, head), expected, "{name}");
        }
    }
}
