//! What the assets were built from: the Rust, and digests of the sources.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result, bail};
use sha2::{Digest as _, Sha256};

use super::wasm;
use crate::workspace;

const NAME: &str = "built-from.txt";

/// Sources by name; folders count with all that is in them.
const SOURCES: [(&str, &[&str]); 7] = [
    ("library", &["crates/striata/src", "crates/striata/Cargo.toml"]),
    ("stream", &["crates/striata-stream/src", "crates/striata-stream/Cargo.toml"]),
    ("io", &["crates/striata-io/src", "crates/striata-io/Cargo.toml"]),
    ("web-crate", &["crates/striata-web/src", "crates/striata-web/Cargo.toml"]),
    ("rust-packages", &["Cargo.toml", "Cargo.lock"]),
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

/// The stamp of some assets: lines of a name and a value.
pub(super) struct Stamp {
    text: String,
}

impl Stamp {
    /// # Errors
    /// Where there is none.
    pub(super) fn read(dist: &Path) -> Result<Self> {
        let path = dist.join(NAME);
        let text = std::fs::read_to_string(&path).with_context(|| path.display().to_string())?;
        Ok(Self { text })
    }

    fn value(&self, name: &str) -> Option<&str> {
        self.text.lines().find_map(|line| line.strip_prefix(name)?.strip_prefix(": "))
    }

    /// Whether the rustc of today is the one that made the assets.
    ///
    /// # Errors
    /// Where it does not start.
    pub(super) fn is_of_this_rust(&self) -> Result<bool> {
        Ok(self.value("rustc") == Some(&rustc()?))
    }

    /// Compares digests of all sources.
    ///
    /// # Errors
    /// Names of what has changed.
    pub(super) fn check(&self) -> Result<()> {
        let mut stale = Vec::new();
        for (name, paths) in SOURCES {
            if self.value(name) != Some(&digest(paths)?) {
                stale.push(format!("{name} ({})", paths.join(", ")));
            }
        }
        if stale.is_empty() {
            return Ok(());
        }
        bail!("changed since the web assets were built: {}", stale.join("; "))
    }
}

/// Stamps what has just been built.
///
/// # Errors
/// What the system reports.
pub(super) fn write(dist: &Path) -> Result<()> {
    let mut text = format!("rustc: {}\n", rustc()?);
    for (name, paths) in SOURCES {
        // Writing to a string cannot fail.
        let _ = writeln!(text, "{name}: {}", digest(paths)?);
    }
    Ok(std::fs::write(dist.join(NAME), text)?)
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
    if !path.is_dir() {
        return Ok(());
    }
    for entry in std::fs::read_dir(path)? {
        let entry = entry?;
        list(&entry.path(), &name.join(entry.file_name()), files)?;
    }
    Ok(())
}
