//! The npm package as it is published.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context, Result, ensure};
use serde_json::{Value, json};

use crate::{machine, steps, target_folder, web, workspace};

/// A page of a new project, with the example of the package's README.
const PAGE: &str = "<!doctype html><script type=\"module\" src=\"./main.js\"></script>";
const SCRIPT: &str = "import { Scene } from 'three';
import { StriataLoader, studioEnvironment } from 'striata';
const [scene, loader] = [new Scene(), new StriataLoader()];
scene.environment = studioEnvironment();
scene.add(await loader.loadAsync('helmet.stri'));
";

/// Builds the package, checks that what it exports is in it, and uses it in a new project.
///
/// # Errors
/// If it cannot be built, packed or used, or lacks a file.
pub(crate) fn check() -> Result<()> {
    web::prepare_library(web::WasmBuild::Published)?;
    let kit = target_folder()?.join("release-kit/npm");
    machine::remove_folder(&kit)?;
    fs::create_dir_all(&kit)?;
    let mut pack = Command::new("npm");
    pack.args(["pack", "--json", "--ignore-scripts", "--pack-destination"]).arg(&kit);
    let output = pack.current_dir(workspace().join("web")).output().context("cannot start npm")?;
    ensure!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr).trim_end());
    let packed: Value = serde_json::from_slice(&output.stdout).context("npm pack")?;
    let package = package()?;
    check_exports(&package, &packed[0]["files"])?;
    let name = packed[0]["filename"].as_str().context("npm pack names no file")?;
    check_project(&package, &kit, &kit.join(name))
}

fn package() -> Result<Value> {
    Ok(serde_json::from_str(&fs::read_to_string(workspace().join("web/package.json"))?)?)
}

/// Installs the packed package in a new project as its users do, and builds a page with Vite.
fn check_project(package: &Value, kit: &Path, tarball: &Path) -> Result<()> {
    let folder = kit.join("project");
    fs::create_dir_all(&folder)?;
    let versions = &package["devDependencies"];
    let project = json!({
        "private": true,
        "type": "module",
        "dependencies": { "striata": format!("file:{}", tarball.display()), "three": versions["three"] },
        "devDependencies": { "vite": versions["vite"] },
        "overrides": package["overrides"],
    });
    fs::write(folder.join("package.json"), project.to_string())?;
    fs::write(folder.join("index.html"), PAGE)?;
    fs::write(folder.join("main.js"), SCRIPT)?;
    steps::run_twice(Command::new("npm").args(["install", "--no-audit", "--no-fund"]).current_dir(&folder))?;
    steps::run(Command::new("npx").args(["vite", "build", "--target", "es2022"]).current_dir(&folder))?;
    let built = files(&folder.join("dist/assets"))?;
    for module in files(&workspace().join("web/dist"))?.iter().filter_map(|file| wasm_stem(file)) {
        let is_built = built.iter().filter_map(|file| wasm_stem(file)).any(|name| is_hashed(name, module));
        ensure!(is_built, "the built project has no {module}.wasm");
    }
    Ok(())
}

/// Name of a wasm file without its extension.
fn wasm_stem(file: &Path) -> Option<&str> {
    file.file_name()?.to_str()?.strip_suffix(".wasm")
}

/// Whether a name is another one with a hash, as Vite appends: a dash and eight characters.
fn is_hashed(name: &str, original: &str) -> bool {
    name.strip_prefix(original).is_some_and(|hash| hash.len() == 9 && hash.starts_with('-'))
}

fn files(folder: &Path) -> Result<Vec<PathBuf>> {
    let entries = fs::read_dir(folder).with_context(|| folder.display().to_string())?;
    entries.map(|entry| Ok(entry?.path())).collect()
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
    fn hashed_names_are_those_of_one_file() {
        assert!(is_hashed("striata-DBfLg-EI", "striata"));
        assert!(!is_hashed("striata-builder-BocNRUEp", "striata") && !is_hashed("striata", "striata"));
    }

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
