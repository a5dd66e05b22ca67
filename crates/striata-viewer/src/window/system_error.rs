//! Cleans up error messages of the window system.

/// Returns an error message without the source location that it begins with.
pub(super) fn without_location(text: &str) -> String {
    let message = text.split_once(".rs:").and_then(|(_, rest)| rest.split_once(": "));
    message.map_or(text, |(_, message)| message).trim_end_matches('.').to_owned()
}
