//! Pages that open without a network: a template, filled; one style for all.

use std::fmt::Write as _;

/// What all pages look like, in light and dark.
pub const STYLE: &str = include_str!("style.css");

/// The template with each `{{NAME}}` replaced by what `content_of` says; contents are not looked into.
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

/// Rows of HTML as a table, the first one being its head where it has one.
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

/// Text as HTML that shows just this text, in quotes too.
pub fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn contents_are_not_looked_into() {
        let page = fill("<p>{{A}}</p>{{B}}!", |name| format!("{{{{{name}}}}}"));
        assert_eq!(page, "<p>{{A}}</p>{{B}}!");
        assert_eq!(fill("no name", |name| name.to_owned()), "no name");
    }

    #[test]
    fn tables_have_one_head() {
        let rows = [vec!["a".to_owned()], vec!["1".to_owned()]];
        assert_eq!(table(&rows, true), "<table><tr><th>a</th></tr><tr><td>1</td></tr></table>");
    }

    #[test]
    fn names_of_files_are_only_text() {
        assert_eq!(escaped("<a href=\"x\">&"), "&lt;a href=&quot;x&quot;&gt;&amp;");
    }
}
