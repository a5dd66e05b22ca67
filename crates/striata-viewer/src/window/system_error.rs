//! Errors of the window system.

/// What an error of the window system says, without the line of its source code that it begins with.
pub(super) fn without_place(text: &str) -> String {
    let said = text.split_once(".rs:").and_then(|(_, rest)| rest.split_once(": "));
    said.map_or(text, |(_, said)| said).trim_end_matches('.').to_owned()
}
