//! Packs every published crate, and checks for warnings of cargo and files missing in the package.
//!
//! The verification of cargo itself would compile each package with all dependencies again, which takes
//! longer than all tests. Beyond the tests it would only detect included files outside the folder of the
//! crate, which this module checks directly.

use std::collections::BTreeSet;
use std::path::{Component, Path, PathBuf};
use std::process::Command;

use anyhow::{Context, Result, bail, ensure};
use serde_json::Value;

use crate::steps::{cargo, say};

/// Packs all published crates.
///
/// # Errors
/// If cargo fails or warns, or a package lacks an included file.
pub(crate) fn run() -> Result<()> {
    let (published, unpublished) = members()?;
    // `--allow-dirty` packs uncommitted changes, too; continuous integration has none.
    let mut arguments = vec!["package", "--workspace", "--no-verify", "--allow-dirty"];
    arguments.extend(unpublished.iter().flat_map(|name| ["--exclude", name]));
    // Offline works if the workspace has been compiled before.
    let messages =
        stderr_of(cargo(&arguments).arg("--offline")).or_else(|_| stderr_of(&mut cargo(&arguments)))?;
    say(messages.trim_end());
    ensure!(!messages.contains("warning:"), "cargo printed warnings about the packages");
    for package in &published {
        check_includes(package).with_context(|| package.name.clone())?;
    }
    Ok(())
}

struct PublishedPackage {
    name: String,
    folder: PathBuf,
}

/// Returns the published crates, and the names of the unpublished ones.
fn members() -> Result<(Vec<PublishedPackage>, Vec<String>)> {
    let output = cargo(&["metadata", "--format-version", "1", "--no-deps"]).output()?;
    let metadata: Value = serde_json::from_slice(&output.stdout).context("cargo metadata")?;
    let (mut published, mut unpublished) = (Vec::new(), Vec::new());
    for package in metadata["packages"].as_array().context("cargo metadata has no packages")? {
        let name = package["name"].as_str().context("a package has no name")?.to_owned();
        if package["publish"].as_array().is_some_and(Vec::is_empty) {
            unpublished.push(name);
        } else {
            let manifest = Path::new(package["manifest_path"].as_str().unwrap_or_default());
            let folder = manifest.parent().context("a manifest is not in a folder")?.to_owned();
            published.push(PublishedPackage { name, folder });
        }
    }
    Ok((published, unpublished))
}

/// Returns the stderr of a command.
fn stderr_of(command: &mut Command) -> Result<String> {
    let output = command.output().context("cannot start cargo")?;
    let messages = String::from_utf8_lossy(&output.stderr).into_owned();
    if !output.status.success() {
        bail!("{}", messages.trim_end());
    }
    Ok(messages)
}

/// Checks that each file included by the code is part of the package.
fn check_includes(package: &PublishedPackage) -> Result<()> {
    let arguments = ["package", "--list", "--allow-dirty", "--package", &package.name];
    let output = cargo(&arguments).output()?;
    ensure!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr).trim_end());
    let listed = String::from_utf8_lossy(&output.stdout).replace('\\', "/");
    let files: BTreeSet<PathBuf> = listed.lines().map(PathBuf::from).collect();
    for file in files.iter().filter(|file| file.extension().is_some_and(|extension| extension == "rs")) {
        let code =
            std::fs::read_to_string(package.folder.join(file)).with_context(|| file.display().to_string())?;
        let folder = file.parent().unwrap_or(Path::new(""));
        for path in included(&code) {
            let is_in_package = resolve(folder, path).is_some_and(|path| files.contains(&path));
            ensure!(is_in_package, "{} includes {path}, which is not in the package", file.display());
        }
        for path in quoted_after(&code, "#[folder = \"") {
            let is_in_package = files.iter().any(|file| file.starts_with(path));
            ensure!(is_in_package, "{} embeds {path}, which is not in the package", file.display());
        }
    }
    Ok(())
}

/// Returns the paths that code includes when it is built, without READMEs that are included as doc tests.
fn included(code: &str) -> Vec<&str> {
    let lines = code.lines().filter(|line| !line.trim_start().starts_with("#[doc = "));
    let of_line = |line| {
        ["include_str!(\"", "include_bytes!(\"", "include!(\""]
            .into_iter()
            .flat_map(move |opening| quoted_after(line, opening))
    };
    lines.flat_map(of_line).collect()
}

fn quoted_after<'a>(text: &'a str, opening: &str) -> Vec<&'a str> {
    text.split(opening).skip(1).filter_map(|rest| rest.split('"').next()).collect()
}

/// Resolves a path relative to a folder of the package; `None` if it leaves the package.
fn resolve(folder: &Path, path: &str) -> Option<PathBuf> {
    let mut resolved = PathBuf::new();
    for component in folder.join(path).components() {
        match component {
            Component::Normal(name) => resolved.push(name),
            Component::CurDir => {}
            Component::ParentDir => {
                if !resolved.pop() {
                    return None;
                }
            }
            Component::RootDir | Component::Prefix(_) => return None,
        }
    }
    Some(resolved)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn included_files_outside_the_package_are_detected() {
        let code = "const A: &[u8] = include_bytes!(\"../a.bin\");\n\
                    const B: &str = concat!(include_str!(\"b.txt\"), include_str!(\"../../c.txt\"));\n\
                    #[doc = include_str!(\"../../../README.md\")]\n";
        let src = Path::new("src");
        let paths: Vec<_> = included(code).into_iter().map(|path| resolve(src, path)).collect();
        assert_eq!(paths, [Some("a.bin".into()), Some("src/b.txt".into()), None]);
    }

    #[test]
    fn embedded_folders_are_found() {
        assert_eq!(
            quoted_after("#[derive(RustEmbed)]\n#[folder = \"viewer/\"]", "#[folder = \""),
            ["viewer/"]
        );
    }
}
