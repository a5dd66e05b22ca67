//! Stamps that record what an asset was built from: the Rust version, and digests of the sources.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result};
use sha2::{Digest as _, Sha256};

use super::wasm::{self, WasmBuild};
use crate::workspace;

/// Value of quickly built wasm.
const QUICK: &str = "quick";

/// Crate that is compiled to wasm.
const WASM_CRATE: &str = "striata-web";

/// Sources other than crates, by name. Folders include all of their contents; missing paths are ignored.
const SOURCES: [(&str, &[&str]); 4] = [
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

/// Excluded folders: built files and tests.
const EXCLUDED: [&str; 3] = ["web/src/wasm", "web/viewer/wasm", "web/src/tests"];

/// The stamp of an asset: lines of a name and a value.
pub(super) struct AssetStamp {
    text: String,
}

impl AssetStamp {
    /// Reads a stamp.
    ///
    /// # Errors
    /// If it does not exist.
    pub(super) fn read(path: &Path) -> Result<Self> {
        let text = std::fs::read_to_string(path).with_context(|| path.display().to_string())?;
        Ok(Self { text })
    }

    fn value(&self, name: &str) -> Option<&str> {
        self.text.lines().find_map(|line| line.strip_prefix(name)?.strip_prefix(": "))
    }

    /// Returns the version of the compiler, as printed by rustc.
    pub(super) fn rustc(&self) -> &str {
        self.value("rustc").unwrap_or("an unknown rustc")
    }

    /// Whether the asset was built by the current rustc.
    pub(super) fn is_of_this_rust(&self) -> bool {
        rustc().is_ok_and(|rustc| self.value("rustc") == Some(&rustc))
    }

    /// Returns the names of the sources that have changed since.
    ///
    /// # Errors
    /// If a manifest cannot be read.
    pub(super) fn changed(&self) -> Result<Vec<String>> {
        let is_same = |name: &str, paths: &[String]| {
            digest(paths).is_ok_and(|digest| self.value(name) == Some(&digest))
        };
        let changed = sources()?.into_iter().filter(|(name, paths)| !is_same(name, paths));
        Ok(changed.map(|(name, _)| name).collect())
    }

    /// Whether building again would give the same result.
    pub(super) fn is_fresh(&self) -> bool {
        self.is_of_this_rust() && self.changed().is_ok_and(|changed| changed.is_empty())
    }

    /// Whether the wasm was built quickly, for tests.
    pub(super) fn is_quick(&self) -> bool {
        self.value("wasm") == Some(QUICK)
    }
}

/// Writes the stamp of an asset that has just been built.
///
/// # Errors
/// If a source cannot be read or the stamp cannot be written.
pub(super) fn write(path: &Path, build: WasmBuild) -> Result<()> {
    let mut text = format!("rustc: {}\n", rustc()?);
    if build == WasmBuild::Quick {
        // Writing to a string cannot fail.
        let _ = writeln!(text, "wasm: {QUICK}");
    }
    for (name, paths) in sources()? {
        let _ = writeln!(text, "{name}: {}", digest(&paths)?);
    }
    std::fs::write(path, text).with_context(|| path.display().to_string())
}

fn rustc() -> Result<String> {
    wasm::rustc_output(&["--version"])
}

/// Lists all sources: the crates of the workspace that the wasm is built from, and the others.
fn sources() -> Result<Vec<(String, Vec<String>)>> {
    let mut crates = vec![WASM_CRATE.to_owned()];
    let mut sources = Vec::new();
    while let Some(name) = crates.get(sources.len()).cloned() {
        for dependency in dependencies(&name)? {
            if !crates.contains(&dependency) {
                crates.push(dependency);
            }
        }
        sources.push((name.clone(), vec![format!("crates/{name}/src"), format!("crates/{name}/Cargo.toml")]));
    }
    let others = SOURCES
        .iter()
        .map(|(name, paths)| ((*name).to_owned(), paths.iter().map(|path| (*path).to_owned()).collect()));
    sources.extend(others);
    Ok(sources)
}

/// Returns the crates of the workspace that a crate is built from: dependencies named by their path.
fn dependencies(name: &str) -> Result<Vec<String>> {
    let path = workspace().join(format!("crates/{name}/Cargo.toml"));
    let text = std::fs::read_to_string(&path).with_context(|| path.display().to_string())?;
    let manifest: toml_edit::DocumentMut = text.parse().with_context(|| path.display().to_string())?;
    let dependencies = manifest.get("dependencies").and_then(toml_edit::Item::as_table_like);
    let named = dependencies.into_iter().flat_map(toml_edit::TableLike::iter);
    Ok(named.filter(|(_, item)| item.get("path").is_some()).map(|(name, _)| name.to_owned()).collect())
}

/// Computes a digest of the names and bytes of files, in the order of their names.
fn digest(paths: &[String]) -> Result<String> {
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
    if !path.is_dir() || EXCLUDED.iter().any(|folder| name == Path::new(folder)) {
        return Ok(());
    }
    for entry in std::fs::read_dir(path)? {
        let entry = entry?;
        list(&entry.path(), &name.join(entry.file_name()), files)?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sources_are_all_crates_that_the_wasm_is_built_from() -> Result<()> {
        let names: Vec<String> = sources()?.into_iter().map(|(name, _)| name).collect();
        for name in ["striata", "striata-paged", "striata-strip", "striata-web", "rust-packages", "page"] {
            assert!(names.iter().any(|named| named == name), "{name} is not in {names:?}");
        }
        Ok(())
    }
}
