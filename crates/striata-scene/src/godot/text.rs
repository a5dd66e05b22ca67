//! Texts and names as Godot's files have them.

use std::collections::{BTreeMap, BTreeSet};

/// Names of the nodes below the root, which must differ.
#[derive(Default)]
pub(super) struct NodeNames {
    taken: BTreeSet<String>,
    /// Last number that was added to a name.
    last_numbers: BTreeMap<String, usize>,
}

impl NodeNames {
    /// Returns a name, with a number if another node has it.
    pub(super) fn unused(&mut self, name: String) -> String {
        let mut found = name.clone();
        let number = self.last_numbers.entry(name.clone()).or_insert(1);
        while !self.taken.insert(found.clone()) {
            *number += 1;
            found = format!("{name}{number}");
        }
        found
    }
}

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
