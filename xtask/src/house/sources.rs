//! The Rust files of the workspace.

use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context as _, Result, ensure};
use syn::{Attribute, Meta};

use crate::workspace;

/// All Rust files that are part of the repository.
pub(super) struct RustFiles {
    pub files: Vec<RustFile>,
}

/// A Rust file.
pub(super) struct RustFile {
    /// Relative to the workspace.
    pub path: PathBuf,
    pub line_count: usize,
    pub syntax: syn::File,
}

/// Returns the files that git knows and that match one of the patterns, relative to the workspace.
///
/// # Errors
/// If git does not run.
pub(super) fn listed(patterns: &[&str]) -> Result<Vec<PathBuf>> {
    let listed = Command::new("git").arg("ls-files").args(patterns).current_dir(workspace()).output()?;
    ensure!(listed.status.success(), "git ls-files failed");
    Ok(String::from_utf8(listed.stdout)?.lines().map(PathBuf::from).collect())
}

impl RustFiles {
    /// Reads and parses the files that git knows.
    ///
    /// # Errors
    /// If git does not run, or a file cannot be parsed.
    pub(super) fn read() -> Result<Self> {
        let files = listed(&["*.rs"])?.iter().map(|path| RustFile::read(path)).collect::<Result<_>>()?;
        Ok(Self { files })
    }

    /// Number of lines of all files.
    pub(super) fn line_count(&self) -> usize {
        self.files.iter().map(|file| file.line_count).sum()
    }
}

impl RustFile {
    fn read(path: &Path) -> Result<Self> {
        let text = std::fs::read_to_string(workspace().join(path));
        let text = text.with_context(|| path.display().to_string())?;
        Self::parse(path, &text)
    }

    /// Parses the text of a file.
    ///
    /// # Errors
    /// If it is not Rust.
    pub(super) fn parse(path: &Path, text: &str) -> Result<Self> {
        let syntax = syn::parse_file(text).with_context(|| path.display().to_string())?;
        Ok(Self { path: path.to_owned(), line_count: text.lines().count(), syntax })
    }
}

/// Whether an item exists in tests only.
pub(super) fn is_for_tests(attributes: &[Attribute]) -> bool {
    let is_test = |attribute: &Attribute| match &attribute.meta {
        Meta::List(list) => list.path.is_ident("cfg") && list.tokens.to_string().contains("test"),
        Meta::Path(path) => path.is_ident("test"),
        Meta::NameValue(_) => false,
    };
    attributes.iter().any(is_test)
}
