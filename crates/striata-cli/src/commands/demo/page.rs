//! The page that the demo leaves: a template, filled with pictures, tables and the mesh itself.

use striata::mesh::RefinableMesh;

use super::pictures::Picture;
use crate::page::{STYLE, fill, table};

/// The page with `{{NAMES}}` where content goes.
const TEMPLATE: &str = include_str!("page.html");

/// The script that draws the mesh in the page.
const VIEWER: &str = include_str!("viewer.js");

/// What goes into the page besides the mesh.
pub(super) struct Content<'a> {
    /// What the reader sees, as HTML.
    pub(super) intro: &'a str,
    /// A sentence above the table.
    pub(super) levels: &'a str,
    /// Head and rows of the table of levels.
    pub(super) table: &'a [Vec<String>],
    /// Names and descriptions of the files beside the page.
    pub(super) files: &'a [(String, String)],
    /// Pictures, in order.
    pub(super) pictures: &'a [Picture],
}

/// The page, complete in itself: it needs neither a network nor another file.
pub(super) fn render(content: &Content<'_>, refinable: &RefinableMesh) -> String {
    let sequence = &refinable.sequence;
    debug_assert!(sequence.positions().is_identity(), "the viewer knows one vertex a position");
    let floats = |values: &[f32]| base64(&little_endian(values, |x| x.to_le_bytes()));
    let indices = |values: &[u32]| base64(&little_endian(values, |x| x.to_le_bytes()));
    let files: Vec<Vec<String>> = content
        .files
        .iter()
        .map(|(name, what)| vec![format!("<a href=\"{name}\">{name}</a>"), what.clone()])
        .collect();
    fill(TEMPLATE, |name| match name {
        "STYLE" => STYLE.to_owned(),
        "INTRO" => content.intro.to_owned(),
        "LEVELS" => content.levels.to_owned(),
        "TABLE" => table(content.table, true),
        "FILES" => table(&files, false),
        "PICTURES" => content.pictures.iter().map(figure).collect(),
        "POSITIONS" => floats(refinable.mesh.positions.as_flattened()),
        "TARGETS" => indices(sequence.targets()),
        "TRIANGLES" => indices(refinable.mesh.triangles.as_flattened()),
        "ERRORS" => floats(sequence.errors()),
        "VIEWER" => VIEWER.to_owned(),
        unknown => unreachable!("the template asks for {unknown}"),
    })
}

/// A picture with what is said of it, as HTML.
fn figure(picture: &Picture) -> String {
    let Picture { what, text, png, .. } = picture;
    let source = base64(png);
    format!(
        "<p>{text}</p>\n<div class=\"card\"><img alt=\"The bust: {what}\" src=\"data:image/png;base64,{source}\"></div>\n"
    )
}

fn little_endian<T: Copy, const N: usize>(values: &[T], bytes_of: impl Fn(T) -> [u8; N]) -> Vec<u8> {
    values.iter().flat_map(|&value| bytes_of(value)).collect()
}

/// Bytes as text, the standard alphabet with padding.
fn base64(bytes: &[u8]) -> String {
    const ALPHABET: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let mut text = String::with_capacity(bytes.len().div_ceil(3) * 4);
    for chunk in bytes.chunks(3) {
        let word = (0..3).fold(0u32, |word, i| word << 8 | u32::from(chunk.get(i).copied().unwrap_or(0)));
        for i in 0..4 {
            let digit = ALPHABET[(word >> (18 - 6 * i) & 63) as usize];
            text.push(if i <= chunk.len() { char::from(digit) } else { '=' });
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn base64_is_what_browsers_decode() {
        for (bytes, text) in
            [("", ""), ("f", "Zg=="), ("fo", "Zm8="), ("foo", "Zm9v"), ("foobar", "Zm9vYmFy")]
        {
            assert_eq!(base64(bytes.as_bytes()), text);
        }
        assert_eq!(base64(&[0xfb, 0xff, 0xbf]), "+/+/");
    }

    #[test]
    fn every_name_of_the_template_is_filled() {
        let page = fill(TEMPLATE, |name| {
            assert!(name.bytes().all(|b| b.is_ascii_uppercase()), "odd name {name:?}");
            format!("<<{name}>>")
        });
        assert!(!page.contains("{{") && !page.contains("}}"));
        assert!(page.contains("<<VIEWER>>") && page.ends_with("</html>\n"));
    }
}
