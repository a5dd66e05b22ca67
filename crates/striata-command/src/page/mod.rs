//! HTML pages that need no network: templates with placeholders, and a style sheet shared by all pages.

use std::fmt::Write as _;

/// The style sheet of all pages, with a light and a dark theme.
pub const STYLE: &str = include_str!("style.css");

/// Replaces each `{{NAME}}` in a template by `content_of(NAME)`. Placeholders inside the contents are not
/// replaced.
pub fn fill(template: &str, content_of: impl Fn(&str) -> String) -> String {
    let mut page = String::new();
    let mut rest = template;
    while let Some((before, after)) = rest.split_once("{{") {
        let (name, after) = after.split_once("}}").unwrap_or((after, ""));
        page.push_str(before);
        page.push_str(&content_of(name));
        rest = after;
    }
    page.push_str(rest);
    page
}

/// Formats rows of HTML cells as a table; the first row is the header if `has_head` is set.
pub fn table(rows: &[Vec<String>], has_head: bool) -> String {
    let mut html = String::from("<table>");
    for (index, row) in rows.iter().enumerate() {
        let cell = if has_head && index == 0 { "th" } else { "td" };
        html.push_str("<tr>");
        for content in row {
            // Writing to a string cannot fail.
            let _ = write!(html, "<{cell}>{content}</{cell}>");
        }
        html.push_str("</tr>");
    }
    html.push_str("</table>");
    html
}

/// Escapes text for HTML, also inside quoted attributes.
pub fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn placeholders_in_contents_are_not_replaced() {
        let page = fill("<p>{{A}}</p>{{B}}!", |name| format!("{{{{{name}}}}}"));
        assert_eq!(page, "<p>{{A}}</p>{{B}}!");
        assert_eq!(fill("no name", |name| name.to_owned()), "no name");
    }

    #[test]
    fn tables_have_one_header_row() {
        let rows = [vec!["a".to_owned()], vec!["1".to_owned()]];
        assert_eq!(table(&rows, true), "<table><tr><th>a</th></tr><tr><td>1</td></tr></table>");
    }

    #[test]
    fn file_names_are_escaped() {
        assert_eq!(escaped("<a href=\"x\">&"), "&lt;a href=&quot;x&quot;&gt;&amp;");
    }
}
