//! The page that the demo leaves: a template, filled with pictures and tables.

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD as BASE64;

use super::pictures::Picture;
use super::viewer;
use striata_command::page::{STYLE, fill, table};

/// The page with `{{NAMES}}` where content goes.
const TEMPLATE: &str = include_str!("page.html");

/// What goes into the page.
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

/// The page; what it shows is in it, and needs neither a network nor another file.
pub(super) fn render(content: &Content<'_>) -> String {
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
        unknown => unreachable!("the template asks for {unknown}"),
    })
}

/// A picture with what is said of it, as HTML.
fn figure(picture: &Picture) -> String {
    let Picture { what, text, png, .. } = picture;
    let source = BASE64.encode(png);
    format!(
        "<p>{text}</p>\n<div class=\"card\"><img alt=\"The bust: {what}\" src=\"data:image/png;base64,{source}\"></div>\n"
    )
}

#[cfg(test)]
mod tests {
    use super::*;

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
