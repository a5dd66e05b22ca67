//! Runs the demo and checks its files; all GLB files are checked with the glTF validator of Khronos.

use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Result, ensure};

use crate::steps;
use crate::{machine, workspace};

/// Some of the files that the demo must write.
const EXPECTED: [&str; 6] =
    ["index.html", "viewer.html", "nefertiti.striata", "nefertiti.stri", "levels.png", "view.png"];

/// Meshes that are also written as triangle strips; the second one has seams.
const STRIPPED: [&str; 2] = ["crates/striata-cli/assets/nefertiti.ply.zst", "assets/spot.obj.zst"];

/// Runs the demo in a temporary folder and checks the files.
///
/// # Errors
/// If a file is missing or invalid.
pub(crate) fn run() -> Result<()> {
    let folder = scratch_folder();
    machine::remove_folder(&folder)?;
    let command = crate::command::built_command()?;
    steps::run(Command::new(&command).arg("demo").arg(&folder))?;
    for name in EXPECTED {
        let file = folder.join(name);
        ensure!(file.metadata().is_ok_and(|m| m.len() > 0), "the demo did not write {name}");
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

/// Writes each mesh as triangle strips to a GLB file.
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
