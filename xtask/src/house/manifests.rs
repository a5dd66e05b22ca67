//! Dependencies that the workspace names for its packages.

use std::process::Command;

use anyhow::{Context as _, Result};
use toml_edit::DocumentMut;

use super::CountWithPlaces;
use super::sources::RustFiles;
use crate::workspace;

/// Finds entries of `workspace.dependencies` that no package inherits.
pub(super) fn unused(_: &RustFiles) -> Result<CountWithPlaces> {
    let listed = Command::new("git").args(["ls-files", "*Cargo.toml"]).current_dir(workspace()).output()?;
    let (mut shared, mut used) = (Vec::new(), Vec::new());
    for path in String::from_utf8(listed.stdout)?.lines() {
        let text = std::fs::read_to_string(workspace().join(path))?;
        let manifest: DocumentMut = text.parse().with_context(|| path.to_owned())?;
        let names = |table: &toml_edit::Item| -> Vec<String> {
            table
                .as_table_like()
                .into_iter()
                .flat_map(|table| table.iter().map(|(name, _)| name.to_owned()))
                .collect()
        };
        if path == "Cargo.toml" {
            shared = names(&manifest["workspace"]["dependencies"]);
        }
        let mut tables = vec![manifest.as_item()];
        let targets = manifest.get("target").and_then(|item| item.as_table_like());
        tables.extend(targets.into_iter().flat_map(|targets| targets.iter().map(|(_, target)| target)));
        for kind in ["dependencies", "dev-dependencies", "build-dependencies"] {
            used.extend(tables.iter().filter_map(|table| table.get(kind)).flat_map(names));
        }
    }
    let unused: Vec<String> = shared.into_iter().filter(|name| !used.contains(name)).collect();
    Ok(unused.into())
}
