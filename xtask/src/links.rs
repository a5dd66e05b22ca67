//! Checks that links and paths in the documentation lead to files that exist.

use std::path::{Path, PathBuf};
use std::process::Command;

use crate::workspace;

/// Returns the Markdown files of the repository, relative to the workspace.
fn pages() -> Vec<PathBuf> {
    let output = Command::new("git").args(["ls-files", "*.md"]).current_dir(workspace()).output();
    let output = output.expect("git runs in a clone");
    String::from_utf8_lossy(&output.stdout).lines().map(PathBuf::from).collect()
}

/// Returns the targets of the links in a page, without those to other sites.
fn links(text: &str) -> Vec<&str> {
    let targets = text.split("](").skip(1).filter_map(|rest| rest.split([')', ' ']).next());
    targets.filter(|target| !target.contains("://") && !target.contains('`')).collect()
}

/// Whether a page has a heading whose anchor is `anchor`.
fn has_heading(text: &str, anchor: &str) -> bool {
    let anchor_of = |heading: &str| {
        let kept = |c: char| c.is_alphanumeric() || matches!(c, ' ' | '-' | '_');
        heading.trim_start_matches('#').trim().to_lowercase().replace(|c| !kept(c), "").replace(' ', "-")
    };
    text.lines().filter(|line| line.starts_with('#')).any(|line| anchor_of(line) == anchor)
}

/// Returns the defect of a link of a page in words, if it has one.
fn defect(page: &Path, text: &str, link: &str) -> Option<String> {
    let (file, anchor) = link.split_once('#').unwrap_or((link, ""));
    let target = if file.is_empty() { page.to_path_buf() } else { page.parent()?.join(file) };
    if !workspace().join(&target).exists() {
        return Some(format!("{}: {link} does not exist", page.display()));
    }
    let is_page = target.extension().is_some_and(|extension| extension == "md");
    if anchor.is_empty() || !is_page {
        return None;
    }
    let other = std::fs::read_to_string(workspace().join(&target)).ok()?;
    let text = if file.is_empty() { text } else { &other };
    (!has_heading(text, anchor)).then(|| format!("{}: no heading for {link}", page.display()))
}

#[test]
fn links_between_pages_lead_somewhere() {
    let pages = pages();
    assert!(pages.len() > 10, "{} pages", pages.len());
    let mut defects = Vec::new();
    for page in &pages {
        let text = std::fs::read_to_string(workspace().join(page)).expect("a page is text");
        defects.extend(links(&text).into_iter().filter_map(|link| defect(page, &text, link)));
    }
    assert!(defects.is_empty(), "{}", defects.join("\n"));
}

#[test]
fn source_files_that_the_guides_for_contributors_name_exist() {
    for page in ["ARCHITECTURE.md", "CONTRIBUTING.md"] {
        let text = std::fs::read_to_string(workspace().join(page)).expect("a page is text");
        for path in text.split('`').filter(|part| part.starts_with("crates/") || part.starts_with("web/")) {
            let is_pattern = path.contains(['<', '*', ' ', '{']);
            assert!(is_pattern || workspace().join(path).exists(), "{page} names {path}");
        }
    }
}

#[test]
fn anchors_are_those_of_headings() {
    let text = "# One\n\n## What an error means, \"really\"\n";
    assert!(has_heading(text, "what-an-error-means-really") && !has_heading(text, "two"));
    assert_eq!(links("[a](b.md#c) and [d](https://e.f) and ![g](h.png)"), ["b.md#c", "h.png"]);
}
