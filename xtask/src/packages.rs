//! What would be published: cargo packs each crate without a warning, and files that its code includes are in
//! the package.
//!
//! Cargo's own verification compiles each package with all that it depends on once more, which takes longer
//! than all tests; what it finds beyond the tests is files outside of a crate's folder, and these are looked
//! for here.

use std::collections::BTreeSet;
use std::path::{Component, Path, PathBuf};
use std::process::Command;

use anyhow::{Context, Result, bail, ensure};
use serde_json::Value;

use crate::steps::{cargo, say};

/// Packs all crates that are not marked as unpublished.
///
/// # Errors
/// What cargo reports, warnings among it, and files that a package lacks.
pub(crate) fn run() -> Result<()> {
    let (published, unpublished) = members()?;
    // What is not committed yet is packed too: the check is about the files, and continuous integration has
    // no others.
    let mut arguments = vec!["package", "--workspace", "--no-verify", "--allow-dirty"];
    arguments.extend(unpublished.iter().flat_map(|name| ["--exclude", name]));
    // Whoever has compiled the workspace has all that it takes.
    let said = said_by(cargo(&arguments).arg("--offline")).or_else(|_| said_by(&mut cargo(&arguments)))?;
    say(said.trim_end());
    ensure!(!said.contains("warning:"), "cargo warns of the packages");
    for package in &published {
        check_includes(package).with_context(|| package.name.clone())?;
    }
    Ok(())
}

struct Package {
    name: String,
    folder: PathBuf,
}

/// Published crates, and names of those that are not.
fn members() -> Result<(Vec<Package>, Vec<String>)> {
    let output = cargo(&["metadata", "--format-version", "1", "--no-deps"]).output()?;
    let metadata: Value = serde_json::from_slice(&output.stdout).context("cargo metadata")?;
    let (mut published, mut unpublished) = (Vec::new(), Vec::new());
    for package in metadata["packages"].as_array().context("cargo metadata has no packages")? {
        let name = package["name"].as_str().context("a package has no name")?.to_owned();
        if package["publish"].as_array().is_some_and(Vec::is_empty) {
            unpublished.push(name);
        } else {
            let manifest = Path::new(package["manifest_path"].as_str().unwrap_or_default());
            let folder = manifest.parent().context("a manifest lies in no folder")?.to_owned();
            published.push(Package { name, folder });
        }
    }
    Ok((published, unpublished))
}

/// What a command writes to stderr.
fn said_by(command: &mut Command) -> Result<String> {
    let output = command.output().context("cannot start cargo")?;
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    if !output.status.success() {
        bail!("{}", said.trim_end());
    }
    Ok(said)
}

/// Looks for each file that code includes among those of the package.
fn check_includes(package: &Package) -> Result<()> {
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
            let is_there = within(folder, path).is_some_and(|path| files.contains(&path));
            ensure!(is_there, "{} includes {path}, which is not in the package", file.display());
        }
        for path in quoted_after(&code, "#[folder = \"") {
            let is_there = files.iter().any(|file| file.starts_with(path));
            ensure!(is_there, "{} embeds {path}, which is not in the package", file.display());
        }
    }
    Ok(())
}

/// Paths that code includes when it is built. Readmes whose examples are tested are not among them.
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

/// The path that one in a folder leads to; none if it leaves the package.
fn within(folder: &Path, path: &str) -> Option<PathBuf> {
    let mut place = PathBuf::new();
    for component in folder.join(path).components() {
        match component {
            Component::Normal(name) => place.push(name),
            Component::CurDir => {}
            Component::ParentDir => {
                if !place.pop() {
                    return None;
                }
            }
            Component::RootDir | Component::Prefix(_) => return None,
        }
    }
    Some(place)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn files_outside_of_a_package_are_found() {
        let code = "const A: &[u8] = include_bytes!(\"../a.bin\");\n\
                    const B: &str = concat!(include_str!(\"b.txt\"), include_str!(\"../../c.txt\"));\n\
                    #[doc = include_str!(\"../../../README.md\")]\n";
        let src = Path::new("src");
        let places: Vec<_> = included(code).into_iter().map(|path| within(src, path)).collect();
        assert_eq!(places, [Some("a.bin".into()), Some("src/b.txt".into()), None]);
    }

    #[test]
    fn embedded_folders_are_found() {
        assert_eq!(
            quoted_after("#[derive(RustEmbed)]\n#[folder = \"viewer/\"]", "#[folder = \""),
            ["viewer/"]
        );
    }
}
