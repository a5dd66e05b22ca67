//! Runs the demo and checks its files; all GLB files are checked with the glTF validator of Khronos, and the levels of an
//! ordered one with the reader of the examples.

use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Result, ensure};

use crate::steps;
use crate::{machine, workspace};

/// Some of the files that the demo must write.
const EXPECTED: [&str; 9] = [
    "index.html",
    "viewer.html",
    "nefertiti.striata",
    "nefertiti.stri",
    "levels.png",
    "view.png",
    "amphora.html",
    "amphora.stri",
    "amphora.png",
];

/// Meshes that are also written as triangle strips; the second one has seams.
const STRIPPED: [&str; 2] = ["crates/striata-cli/assets/nefertiti.ply.zst", "assets/spot.obj.zst"];

/// A skinned, animated and textured scene, and what is made of it; `{}` is the folder of the outputs.
const SCENE: &str = "assets/arm.glb";
const SCENE_OUTPUTS: [&str; 9] = [
    "convert SCENE {}/scene.glb",
    "convert SCENE {}/scene-quantized.glb --quantize --texture-max 100",
    "convert SCENE {}/scene-meshopt.glb --meshopt --texture-format webp",
    "convert SCENE {}/scene-draco.glb --draco --texture-format jpeg",
    "simplify SCENE -o {}/scene-{}.glb --levels 50%,1%",
    "simplify SCENE -o {}/scene-chain.glb --levels 50%,1% --lod-chain",
    "build SCENE -o {}/scene-ordered.glb --ranges 8",
    "encode SCENE -o {}/scene-streams.glb",
    "convert {}/scene-streams.glb {}/scene-decoded.glb",
];

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
    write_scenes(&command, &folder)?;
    let mut scenes: Vec<OsString> = Vec::new();
    for entry in std::fs::read_dir(&folder)? {
        let path = entry?.path();
        if path.extension().is_some_and(|extension| extension == "glb") {
            scenes.push(path.into_os_string());
        }
    }
    scenes.sort();
    ensure!(
        scenes.len() > 3 + STRIPPED.len() + SCENE_OUTPUTS.len(),
        "there are only {} GLB files",
        scenes.len()
    );
    let validator = workspace().join("xtask/gltf-validate");
    machine::npm_install(&validator)?;
    let mut arguments = vec![OsString::from("validate.mjs")];
    arguments.append(&mut scenes);
    machine::node(&validator, &arguments)?;
    let ordered = folder.join("scene-ordered.glb").into_os_string();
    machine::node(&workspace().join("examples/ordered-glb"), &[OsString::from("check.mjs"), ordered])?;
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

/// Writes the scene in all forms.
fn write_scenes(command: &Path, folder: &Path) -> Result<()> {
    let scene = workspace().join(SCENE);
    for line in SCENE_OUTPUTS {
        let words = line.split(' ').map(|word| match word.strip_prefix("{}/") {
            Some(name) => folder.join(name).into_os_string(),
            None if word == "SCENE" => scene.clone().into_os_string(),
            None => OsString::from(word),
        });
        steps::run(Command::new(command).args(words))?;
    }
    Ok(())
}

fn scratch_folder() -> PathBuf {
    std::env::temp_dir().join(format!("striata-golden-{}", std::process::id()))
}
