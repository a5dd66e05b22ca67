//! The npm package as it is published.

use std::process::Command;

use anyhow::{Context, Result, ensure};
use serde_json::Value;

use crate::{web, workspace};

/// Builds the package, and checks that what it exports is in it.
///
/// # Errors
/// If it cannot be built or packed, or lacks a file.
pub(crate) fn check() -> Result<()> {
    web::prepare_library(web::WasmBuild::Published)?;
    let folder = workspace().join("web");
    let mut pack = Command::new("npm");
    pack.args(["pack", "--dry-run", "--json", "--ignore-scripts"]).current_dir(&folder);
    let output = pack.output().context("cannot start npm")?;
    ensure!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr).trim_end());
    let packed: Value = serde_json::from_slice(&output.stdout).context("npm pack")?;
    let package: Value = serde_json::from_str(&std::fs::read_to_string(folder.join("package.json"))?)?;
    check_exports(&package, &packed[0]["files"])
}

/// Checks that every exported path is among the packed files.
fn check_exports(package: &Value, files: &Value) -> Result<()> {
    let is_packed = |path: &str| {
        let path = path.trim_start_matches("./");
        files.as_array().into_iter().flatten().any(|file| file["path"] == path)
    };
    let mut paths: Vec<&str> = package["types"].as_str().into_iter().collect();
    for target in package["exports"].as_object().context("package.json has no exports")?.values() {
        match target {
            Value::Object(conditions) => paths.extend(conditions.values().filter_map(Value::as_str)),
            other => paths.extend(other.as_str()),
        }
    }
    for path in paths {
        ensure!(is_packed(path), "the npm package exports {path}, which is not in it");
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    #[test]
    fn exports_without_a_file_are_refused() {
        let package =
            json!({ "types": "./a.d.ts", "exports": { ".": { "default": "./a.js" }, "./w": "./a.wasm" } });
        let all = json!([{ "path": "a.d.ts" }, { "path": "a.js" }, { "path": "a.wasm" }]);
        assert!(check_exports(&package, &all).is_ok());
        let without = json!([{ "path": "a.d.ts" }, { "path": "a.js" }]);
        assert!(check_exports(&package, &without).is_err());
    }
}
