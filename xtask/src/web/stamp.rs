//! What something was built from: the Rust, and digests of the sources.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result};
use sha2::{Digest as _, Sha256};

use super::wasm;
use crate::workspace;

/// Sources by name; folders count with all that is in them. What is not there counts as nothing.
const SOURCES: [(&str, &[&str]); 8] = [
    ("library", &["crates/striata/src", "crates/striata/Cargo.toml"]),
    ("streams", &["crates/striata-stream/src", "crates/striata-stream/Cargo.toml"]),
    ("io", &["crates/striata-io/src", "crates/striata-io/Cargo.toml"]),
    ("web-crate", &["crates/striata-web/src", "crates/striata-web/Cargo.toml"]),
    ("rust-packages", &["Cargo.toml", "Cargo.lock"]),
    ("recipe", &["xtask/src/web.rs", "xtask/src/web"]),
    ("page", &["web/src", "web/viewer"]),
    (
        "page-packages",
        &[
            "web/package.json",
            "web/package-lock.json",
            "web/tsconfig.json",
            "web/tsconfig.types.json",
            "web/vite.library.config.ts",
            "web/vite.viewer.config.ts",
        ],
    ),
];

/// Folders among them that do not count: what is built, and tests.
const NO_SOURCES: [&str; 2] = ["web/src/wasm", "web/src/tests"];

/// The stamp of what was built: lines of a name and a value.
pub(super) struct Stamp {
    text: String,
}

impl Stamp {
    /// # Errors
    /// That there is none.
    pub(super) fn read(path: &Path) -> Result<Self> {
        let text = std::fs::read_to_string(path).with_context(|| path.display().to_string())?;
        Ok(Self { text })
    }

    fn value(&self, name: &str) -> Option<&str> {
        self.text.lines().find_map(|line| line.strip_prefix(name)?.strip_prefix(": "))
    }

    /// The compiler, in its own words.
    pub(super) fn rustc(&self) -> &str {
        self.value("rustc").unwrap_or("an unknown rustc")
    }

    /// Whether the rustc of today is the one that built it.
    pub(super) fn is_of_this_rust(&self) -> bool {
        rustc().is_ok_and(|rustc| self.value("rustc") == Some(&rustc))
    }

    /// Names of the sources that have changed since.
    pub(super) fn changed(&self) -> Vec<&'static str> {
        let is_same = |name, paths| digest(paths).is_ok_and(|digest| self.value(name) == Some(&digest));
        SOURCES.iter().filter(|(name, paths)| !is_same(name, paths)).map(|(name, _)| *name).collect()
    }

    /// Whether building again would make the same.
    pub(super) fn is_fresh(&self) -> bool {
        self.is_of_this_rust() && self.changed().is_empty()
    }
}

/// Stamps what has just been built.
///
/// # Errors
/// What the system reports.
pub(super) fn write(path: &Path) -> Result<()> {
    let mut text = format!("rustc: {}\n", rustc()?);
    for (name, paths) in SOURCES {
        // Writing to a string cannot fail.
        let _ = writeln!(text, "{name}: {}", digest(paths)?);
    }
    std::fs::write(path, text).with_context(|| path.display().to_string())
}

fn rustc() -> Result<String> {
    wasm::said_by_rustc(&["--version"])
}

/// The digest of files by their names and bytes, in the order of their names.
fn digest(paths: &[&str]) -> Result<String> {
    let mut files = Vec::new();
    for path in paths {
        list(&workspace().join(path), Path::new(path), &mut files)?;
    }
    files.sort();
    let mut sum = Sha256::new();
    for (name, path) in files {
        let bytes = std::fs::read(&path).with_context(|| path.display().to_string())?;
        for part in [name.as_bytes(), &bytes] {
            sum.update((part.len() as u64).to_le_bytes());
            sum.update(part);
        }
    }
    let mut text = String::new();
    for byte in sum.finalize() {
        // Writing to a string cannot fail.
        let _ = write!(text, "{byte:02x}");
    }
    Ok(text)
}

fn list(path: &Path, name: &Path, files: &mut Vec<(String, PathBuf)>) -> Result<()> {
    if path.is_file() {
        files.push((name.to_string_lossy().replace('\\', "/"), path.to_owned()));
        return Ok(());
    }
    if !path.is_dir() || NO_SOURCES.iter().any(|folder| name == Path::new(folder)) {
        return Ok(());
    }
    for entry in std::fs::read_dir(path)? {
        let entry = entry?;
        list(&entry.path(), &name.join(entry.file_name()), files)?;
    }
    Ok(())
}
