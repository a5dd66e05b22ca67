//! Texts and names as Godot's files have them.

/// A text in quotes.
pub(super) fn quoted(text: &str) -> String {
    let mut out = String::from("\"");
    for character in text.chars() {
        match character {
            '"' | '\\' => out.extend(['\\', character]),
            '\n' | '\r' | '\t' | '\0' => out.push(' '),
            other => out.push(other),
        }
    }
    out.push('"');
    out
}

/// A name without the characters that names of nodes cannot have.
pub(super) fn node_name(name: &str, default: &str) -> String {
    let name: String =
        name.chars().map(|c| if ".:@/\"%".contains(c) || c.is_control() { '_' } else { c }).collect();
    let name = name.trim();
    if name.is_empty() { default.to_owned() } else { name.to_owned() }
}
