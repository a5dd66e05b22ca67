//! Phrases that make text hard to read: ornament, sentences that begin with a riddle, and British spelling.

use std::path::Path;

use anyhow::{Context as _, Result};

use super::CountWithPlaces;
use super::sources::{RustFiles, listed};
use crate::workspace;

/// Part of a text in which a phrase is forbidden.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Reach {
    /// Whole words, in any case.
    Anywhere,
    /// Beginnings of words, in any case.
    Stem,
    /// Beginnings of sentences.
    Opening,
}

/// The forbidden phrases.
const FORBIDDEN: &[(Reach, &[&str])] = &[
    (Reach::Anywhere, &["tells", "told", "wishes", "hang together", "hangs together", "be it", "so many"]),
    (Reach::Anywhere, &["beside", "aside of", "lives on", "hears of", "is dear", "no matter of"]),
    (Reach::Anywhere, &["whatever becomes", "weigh no more", "weighs no more", "by and by"]),
    (Reach::Anywhere, &["where there is no", "where there are no"]),
    (Reach::Opening, &["What is", "What was", "What has", "What no", "What it", "What a", "What the"]),
    (Reach::Opening, &["Where there", "Where no", "Where it", "Where both", "As above"]),
    (Reach::Stem, &["colour", "centre", "grey", "neighbour", "behaviour", "favour", "licence"]),
    (Reach::Stem, &["normalise", "normalisation", "optimise", "optimisation", "modelled", "labelled"]),
];

/// Files with text that people read.
const PATTERNS: [&str; 7] = ["*.rs", "*.md", "*.py", "*.pyi", "*.ts", "*.mjs", "*.wgsl"];

/// Finds forbidden phrases in documents, comments and messages.
pub(super) fn forbidden(_: &RustFiles) -> Result<CountWithPlaces> {
    let mut places = Vec::new();
    // This folder names what it forbids.
    for path in listed(&PATTERNS)?.iter().filter(|path| !path.starts_with("xtask/src/house")) {
        let text = std::fs::read_to_string(workspace().join(path));
        let text = text.with_context(|| path.display().to_string())?;
        places.extend(
            phrases_of(path, &text).map(|(line, phrase)| format!("{}:{line}: {phrase}", path.display())),
        );
    }
    Ok(places.into())
}

/// Returns the forbidden phrases of a file with their lines, from 1.
fn phrases_of<'t>(path: &Path, text: &'t str) -> impl Iterator<Item = (usize, &'static str)> + use<'t> {
    let extension = path.extension().and_then(|extension| extension.to_str()).unwrap_or_default().to_owned();
    let mut is_fenced = false;
    let prose = move |line: &str| match extension.as_str() {
        "md" => {
            let is_fence = line.trim_start().starts_with("```");
            is_fenced ^= is_fence;
            // Headings may be questions.
            if is_fence || is_fenced || line.starts_with('#') { String::new() } else { line.to_owned() }
        }
        "py" | "pyi" => strings_and_comment(line, true),
        _ if line.trim_start().starts_with(['*', '/']) => line.to_owned(),
        _ => strings_and_comment(line, false),
    };
    let lines = text.lines().map(prose).zip(1..);
    lines.flat_map(|(prose, line)| found(&without_code(&prose)).into_iter().map(move |phrase| (line, phrase)))
}

/// Returns string literals of several words, and the comment; of Python, everything but short string literals.
fn strings_and_comment(line: &str, is_python: bool) -> String {
    let mut texts = Vec::new();
    let mut start = 0;
    for (index, part) in line.split('"').enumerate() {
        if index % 2 == 1 {
            texts.extend(part.contains(' ').then_some(part));
        } else if is_python {
            texts.push(part);
        } else if let Some(at) = part.find("//") {
            texts.push(&line[start + at..]);
            break;
        }
        start += part.len() + 1;
    }
    texts.join(" ")
}

/// Removes code in backticks.
fn without_code(prose: &str) -> String {
    prose.split('`').step_by(2).collect::<Vec<_>>().join(" ")
}

/// Returns the forbidden phrases of a line, one for each occurrence.
fn found(prose: &str) -> Vec<&'static str> {
    let is_word = |c: char| c.is_alphanumeric() || matches!(c, '_' | '-');
    let lower = prose.to_lowercase();
    let mut found = Vec::new();
    for (reach, phrases) in FORBIDDEN {
        let text = if *reach == Reach::Opening { prose } else { &lower };
        for phrase in *phrases {
            let is_forbidden = |(at, _): &(usize, &str)| {
                let (before, after) = (&text[..*at], &text[at + phrase.len()..]);
                let ends = *reach == Reach::Stem || !after.starts_with(is_word);
                let begins = match reach {
                    Reach::Opening => !before.trim_end().ends_with(|c| is_word(c) || matches!(c, ',' | ')')),
                    Reach::Anywhere | Reach::Stem => !before.ends_with(is_word),
                };
                begins && ends
            };
            found.extend(text.match_indices(phrase).filter(is_forbidden).map(|_| *phrase));
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    fn lines(path: &str, text: &str) -> Vec<(usize, &'static str)> {
        phrases_of(Path::new(path), text).collect()
    }

    #[test]
    fn phrases_are_found_in_comments_and_messages_only() {
        let text = "let beside = 1; // beside\nsay(\"it told me\"); f(\"told\");\n/// `told`, untold, Told\n";
        assert_eq!(lines("a.rs", text), [(1, "beside"), (2, "told"), (3, "told")]);
        let text = "x = {\"colour\"}\n\"\"\"A colour of \"\"\"\n# neighbours";
        assert_eq!(lines("a.py", text), [(2, "colour"), (3, "neighbour")]);
        let text = "# What is kept\n```\ntold\n```\nKept. What is not, and what is, is told.\n";
        assert_eq!(lines("a.md", text), [(5, "told"), (5, "What is")]);
    }

    #[test]
    fn openings_count_at_the_beginning_of_sentences_only() {
        assert_eq!(found("* **What a file has** is known: What is left stays"), ["What is", "What a"]);
        assert!(found("He asked What is left, What Nothing").is_empty());
    }
}
