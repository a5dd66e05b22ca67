//! The HTML page of the demo: a template with placeholders for pictures and tables.

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD as BASE64;

use super::pictures::Picture;
use super::{amphora, viewer};
use striata_command::page::{STYLE, fill, table};

/// The template, with placeholders such as `{{TABLE}}`.
const TEMPLATE: &str = include_str!("page.html");

/// Contents of the page.
pub(super) struct PageContent<'a> {
    /// Introduction, as HTML.
    pub intro: &'a str,
    /// Text above the table.
    pub levels: &'a str,
    /// Header and rows of the table of levels.
    pub table: &'a [Vec<String>],
    /// Names and descriptions of the other files in the folder.
    pub files: &'a [(String, String)],
    /// Pictures in display order.
    pub pictures: &'a [Picture],
}

/// Returns the page, which includes everything that it shows; it needs neither a network nor other files.
pub(super) fn render(content: &PageContent<'_>) -> String {
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
        "VIEWER" => viewer::PAGE.to_owned(),
        "SCENE" => amphora::PAGE.to_owned(),
        unknown => unreachable!("unknown placeholder {unknown}"),
    })
}

/// Returns a picture with its description, as HTML.
fn figure(picture: &Picture) -> String {
    let Picture { what, text, png, .. } = picture;
    let source = BASE64.encode(png);
    format!(
        "<p>{text}</p>\n<div class=\"card\"><img alt=\"The bust: {what}\" \
         src=\"data:image/png;base64,{source}\"></div>\n"
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_placeholder_is_replaced() {
        let page = fill(TEMPLATE, |name| {
            assert!(name.bytes().all(|b| b.is_ascii_uppercase()), "unexpected placeholder {name:?}");
            format!("<<{name}>>")
        });
        assert!(!page.contains("{{") && !page.contains("}}"));
        assert!(page.contains("<<VIEWER>>") && page.ends_with("</html>\n"));
    }
}
