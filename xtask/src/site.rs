//! The site: the guides and results as pages, and a gallery that is also a playground.
//!
//! ```text
//! docs/, README.md, site/gallery.md --stage.py, Zensical--> pages
//! striata demo, encode --> models --striata serve --write-to--> viewer/
//! ```
//!
//! All of it is files: nothing runs on a server, and no page loads anything from other sites.

use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context, Result, ensure};

use crate::command::built_command;
use crate::py::VirtualEnvironment;
use crate::steps;
use crate::{machine, target_folder, workspace};

/// Streams of the gallery that the demo writes.
const OF_DEMO: [&str; 2] = ["nefertiti.stri", "amphora.stri"];

/// Builds the site and opens it in a browser; returns its folder.
///
/// # Errors
/// If a step fails, a link leads nowhere, or a page does not show what it should.
pub(crate) fn run() -> Result<PathBuf> {
    let folder = target_folder()?.join("site");
    machine::remove_folder(&folder)?;
    let site = build_pages(&folder)?;
    build_gallery(&folder, &site)?;
    let web = workspace().join("web");
    machine::npm_install(&web)?;
    let mut test = Command::new("node");
    test.args(["--test", "--test-reporter=spec", "tests/site.mjs"]).current_dir(web);
    steps::run(test.env("STRIATA_SITE", &site))?;
    Ok(site)
}

/// Builds the pages; returns their folder.
fn build_pages(folder: &Path) -> Result<PathBuf> {
    let sources = workspace().join("site");
    let environment = VirtualEnvironment::new(target_folder()?.join("py/site"))?;
    environment.install(&["-r", &sources.join("requirements.txt").to_string_lossy()])?;
    std::fs::create_dir_all(folder)?;
    std::fs::copy(sources.join("mkdocs.yml"), folder.join("mkdocs.yml"))?;
    let (stage, docs) = (sources.join("stage.py"), folder.join("docs"));
    environment.python(&[&stage.to_string_lossy(), &docs.to_string_lossy()])?;
    let config = folder.join("mkdocs.yml");
    environment.python(&["-m", "zensical", "build", "--strict", "-f", &config.to_string_lossy()])?;
    Ok(folder.join("site"))
}

/// Builds the viewer with a few models.
fn build_gallery(folder: &Path, site: &Path) -> Result<()> {
    let command = built_command()?;
    let (demo, models) = (folder.join("demo"), folder.join("gallery"));
    std::fs::create_dir_all(&models)?;
    steps::run(Command::new(&command).arg("demo").arg(&demo).arg("--quiet"))?;
    for name in OF_DEMO {
        std::fs::copy(demo.join(name), models.join(name))
            .with_context(|| format!("the demo has no {name}"))?;
    }
    let assets = workspace().join("assets");
    std::fs::copy(assets.join("arm.glb"), models.join("arm.glb"))?;
    let spot = models.join("spot.stri");
    steps::run(Command::new(&command).arg("encode").arg(assets.join("spot.obj.zst")).arg("-o").arg(spot))?;
    let viewer = site.join("viewer");
    steps::run(Command::new(&command).arg("serve").arg(&models).arg("--write-to").arg(&viewer))?;
    ensure!(viewer.join("models.json").is_file(), "{} has no list of models", viewer.display());
    Ok(())
}
