//! Which files are served, and what they are called in HTTP.

use std::path::Path;

use striata_io::Format;

/// Files that models refer to: buffers, materials, textures.
const COMPANIONS: &[(&str, &str)] = &[
    ("bin", "application/octet-stream"),
    ("mtl", "model/mtl"),
    ("png", "image/png"),
    ("jpg", "image/jpeg"),
    ("jpeg", "image/jpeg"),
    ("webp", "image/webp"),
    ("ktx2", "image/ktx2"),
    ("tga", "image/x-tga"),
    ("bmp", "image/bmp"),
];

/// The viewer's files.
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

/// True for the names of models, plain or compressed.
pub(super) fn is_model(name: &str) -> bool {
    Format::from_extension(name).is_some()
}

/// True for the names of what models refer to.
pub(super) fn is_companion(name: &str) -> bool {
    known(COMPANIONS, name).is_some()
}

/// True for models that consist of several files.
pub(super) fn has_companions(name: &str) -> bool {
    matches!(Format::from_extension(name), Some(Format::Gltf | Format::Obj))
}

/// What a model, or a file that one refers to, is called.
pub(super) fn content_type(name: &str) -> &'static str {
    match extension(name).as_str() {
        "gz" => return "application/gzip",
        "zst" => return "application/zstd",
        _ => {}
    }
    match Format::from_extension(name) {
        Some(Format::Obj) => "model/obj",
        Some(Format::Stl) => "model/stl",
        Some(Format::Gltf) => "model/gltf+json",
        Some(Format::Glb) => "model/gltf-binary",
        Some(_) => "application/octet-stream",
        None => known(COMPANIONS, name).unwrap_or("application/octet-stream"),
    }
}

/// What a file of the viewer is called.
pub(super) fn page_type(name: &str) -> &'static str {
    known(PAGE, name).unwrap_or("application/octet-stream")
}

/// Whether a file is text, which compresses well, told by its name and its first bytes.
pub(super) fn is_text(name: &str, head: &[u8]) -> bool {
    if matches!(extension(name).as_str(), "gz" | "zst") {
        return false;
    }
    match Format::from_extension(name) {
        Some(Format::Obj | Format::Off | Format::Gltf) => !head.contains(&0),
        Some(Format::Ply) => head.windows(12).any(|line| line == b"format ascii"),
        Some(Format::Stl) => head.starts_with(b"solid") && !head.contains(&0),
        Some(_) => false,
        None => extension(name) == "mtl",
    }
}

fn known(table: &[(&str, &'static str)], name: &str) -> Option<&'static str> {
    let extension = extension(name);
    table.iter().find(|(known, _)| *known == extension).map(|&(_, content_type)| content_type)
}

fn extension(name: &str) -> String {
    Path::new(name).extension().unwrap_or_default().to_string_lossy().to_ascii_lowercase()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn text_is_told_from_bytes() {
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
