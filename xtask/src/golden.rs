//! The demo from end to end, and its files judged by others: every GLB by Khronos' glTF validator.

use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Result, ensure};

use crate::steps;
use crate::{machine, workspace};

/// Files that the demo must leave, among others.
const EXPECTED: [&str; 6] =
    ["index.html", "viewer.html", "nefertiti.striata", "nefertiti.stri", "levels.png", "view.png"];

/// Meshes of the repository that are also written as triangle strips; the latter has seams.
const STRIPPED: [&str; 2] = ["crates/striata-cli/assets/nefertiti.ply.zst", "assets/spot.obj.zst"];

/// Runs the demo into a folder of its own and checks what it wrote.
///
/// # Errors
/// What is missing or wrong.
pub(crate) fn run() -> Result<()> {
    let folder = scratch_folder();
    machine::remove_folder(&folder)?;
    let command = crate::command::built_command()?;
    steps::run(Command::new(&command).arg("demo").arg(&folder))?;
    for name in EXPECTED {
        let file = folder.join(name);
        ensure!(file.metadata().is_ok_and(|m| m.len() > 0), "the demo wrote no {name}");
    }
    strip_scenes(&command, &folder)?;
    let mut scenes: Vec<OsString> = Vec::new();
    for entry in std::fs::read_dir(&folder)? {
        let path = entry?.path();
        if path.extension().is_some_and(|extension| extension == "glb") {
            scenes.push(path.into_os_string());
        }
    }
    scenes.sort();
    ensure!(scenes.len() >= 3 + STRIPPED.len(), "there are only {} GLB files", scenes.len());
    let validator = workspace().join("xtask/gltf-validate");
    machine::npm_install(&validator)?;
    let mut arguments = vec![OsString::from("validate.mjs")];
    arguments.append(&mut scenes);
    machine::node(&validator, &arguments)?;
    machine::remove_folder(&folder)
}

/// Writes triangle strips as GLB, one file an asset.
fn strip_scenes(command: &Path, folder: &Path) -> Result<()> {
    for asset in STRIPPED {
        let asset = workspace().join(asset);
        let name = asset.file_name().unwrap_or_default().to_string_lossy();
        let out = folder.join(format!("{name}.strips.glb"));
        steps::run(Command::new(command).arg("strip").arg(&asset).arg("-o").arg(out))?;
    }
    Ok(())
}

fn scratch_folder() -> PathBuf {
    std::env::temp_dir().join(format!("striata-golden-{}", std::process::id()))
}
