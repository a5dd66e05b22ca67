//! Compares built assets with the committed ones, and reports their sizes.

use std::collections::BTreeSet;
use std::path::Path;
use std::process::Command;

use anyhow::{Context, Result, bail};

/// Compares the built folder with the committed one.
///
/// # Errors
/// If files differ, or only one of the folders has them.
pub(super) fn compare(built: &Path, committed: &Path) -> Result<()> {
    let mut names = BTreeSet::new();
    for folder in [built, committed] {
        list(folder, "", &mut names)?;
    }
    let differs = |name: &&String| {
        let read = |folder: &Path| std::fs::read(folder.join(name)).ok();
        read(built) != read(committed)
    };
    let stale: Vec<&str> = names.iter().filter(differs).map(String::as_str).collect();
    if stale.is_empty() {
        return Ok(());
    }
    bail!("{} does not match its sources: {}", committed.display(), stale.join(", "))
}

fn list(folder: &Path, prefix: &str, names: &mut BTreeSet<String>) -> Result<()> {
    for entry in std::fs::read_dir(folder).with_context(|| folder.display().to_string())? {
        let entry = entry?;
        let name = format!("{prefix}{}", entry.file_name().to_string_lossy());
        if entry.file_type()?.is_dir() {
            list(&entry.path(), &format!("{name}/"), names)?;
        } else {
            names.insert(name);
        }
    }
    Ok(())
}

/// Returns the sizes of the files that a page must download, one line per file.
///
/// # Errors
/// If Node.js cannot measure them.
pub(super) fn sizes(dist: &Path) -> Result<String> {
    const SCRIPT: &str = "const z = require('node:zlib'), fs = require('node:fs');
for (const file of process.argv.slice(1)) {
  const bytes = fs.readFileSync(file);
  const gzip = z.gzipSync(bytes, { level: 9 }).length, brotli = z.brotliCompressSync(bytes).length;
  console.log(`${file.split('/').pop()}: ${bytes.length} bytes, gzip -9 ${gzip}, brotli ${brotli}`);
}";
    let names = ["striata.wasm", "striata-builder.wasm", "striata-files.wasm", "core.js", "striata.js"];
    let files = names.map(|name| dist.join(name));
    let output =
        Command::new("node").args(["-e", SCRIPT]).args(files).output().context("cannot start node")?;
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    if text.is_empty() {
        bail!("no sizes: {}", String::from_utf8_lossy(&output.stderr));
    }
    Ok(text)
}
