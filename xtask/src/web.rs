//! The web assets: the wasm, the npm package and the viewer page.
//!
//! ```text
//! crates/striata-web --cargo, wasm-bindgen, wasm-opt--> web/dist/striata.wasm, web/src/wasm (the script that
//! calls it) web/src            --vite, tsc-----------------------> web/dist
//! web/viewer         --vite----------------------------> crates/striata-viewer/viewer, which the command
//! embeds
//! ```
//!
//! The viewer is committed, so that whoever builds the command needs neither a wasm target nor Node.js; a
//! file next to it says what it was built from. All else is built when it is needed.
//!
//! The same toolchain makes the same bytes in any folder (paths are remapped, the lock files fix the rest),
//! so if rustc is the one that the viewer was built with, the check builds it anew and compares, and comments
//! in the library change nothing. With another rustc the bytes would differ for no fault of anybody's; then,
//! and if there are no tools to build with, the check compares digests of the sources and says if they
//! differ, which is no failure.

mod assets;
mod stamp;
mod wasm;

use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context, Result, bail};

use crate::machine::{self, WASM_TARGET};
use crate::steps::{self, say};
use crate::workspace;
use stamp::Stamp;

pub(crate) use wasm::said_by_rustc;

/// What the check says if it fails.
const CURE: &str = "run `cargo xtask web` and commit what it writes";

/// `cargo xtask web`: builds everything into its place; the npm package only if it is not there or older than
/// its sources.
///
/// # Errors
/// What the tools lack or report.
pub(crate) fn build() -> Result<()> {
    prepare_library()?;
    build_viewer(&viewer())?;
    stamp::write(&viewer_stamp())?;
    say(&assets::sizes(&dist())?);
    Ok(())
}

/// Builds the npm package, unless it is there and was built from the same sources.
///
/// # Errors
/// What the tools lack or report.
pub(crate) fn prepare_library() -> Result<()> {
    let is_there = dist().join("striata.js").is_file();
    if is_there && Stamp::read(&dist_stamp()).is_ok_and(|stamp| stamp.is_fresh()) {
        return Ok(());
    }
    if let Some(missing) = missing_tool() {
        bail!(missing);
    }
    build_library()
}

/// Builds the package, runs its tests, and checks that the committed viewer is what the sources make.
///
/// # Errors
/// What is stale, and what the tests report.
pub(crate) fn check() -> Result<()> {
    let stamp = Stamp::read(&viewer_stamp()).context(CURE)?;
    if let Some(missing) = missing_tool() {
        say(&format!("{missing}: the web package is neither built nor tested"));
        notice(&stamp);
        return Ok(());
    }
    prepare_library()?;
    let scratch = std::env::temp_dir().join(format!("striata-viewer-{}", std::process::id()));
    machine::remove_folder(&scratch)?;
    build_viewer(&scratch)?;
    if stamp.is_of_this_rust() {
        assets::compare(&scratch, &viewer()).context(CURE)?;
    } else {
        say("another rustc built the viewer, so the bytes are not compared");
        notice(&stamp);
    }
    machine::remove_folder(&scratch)?;
    machine::npm(&folder(), &["test"])
}

/// Says if the viewer is older than its sources.
fn notice(stamp: &Stamp) {
    let changed = stamp.changed();
    if !changed.is_empty() {
        let changed = changed.join("; ");
        say(&format!(
            "notice: these have changed since the committed viewer was built: {changed}. Continuous integration, or \
             whoever has {} and Node.js, can tell whether it makes a difference",
            stamp.rustc()
        ));
    }
}

/// What there is nothing to build with, as a sentence.
fn missing_tool() -> Option<String> {
    if !machine::has_wasm_target() {
        return Some(format!("this Rust cannot make {WASM_TARGET} code, and rustup could not add it"));
    }
    let missing = ["node", "npm"].into_iter().find(|program| !machine::starts(program))?;
    Some(format!("there is no {missing}"))
}

/// The wasm, then types and bundles of the package.
fn build_library() -> Result<()> {
    machine::npm_install(&folder())?;
    let built = wasm::build()?;
    let scripts = folder().join("src/wasm");
    machine::remove_folder(&dist())?;
    machine::remove_folder(&scripts)?;
    wasm::write(&built, &dist(), &scripts)?;
    machine::npm(&folder(), &["run", "--silent", "check"])?;
    machine::npm(&folder(), &["run", "--silent", "build:library"])?;
    stamp::write(&dist_stamp())
}

/// The page, of the wasm in `dist`.
fn build_viewer(into: &Path) -> Result<()> {
    let mut command = Command::new("npm");
    command.args(["run", "--silent", "build:viewer"]).current_dir(folder());
    steps::run(command.env("STRIATA_WEB_VIEWER", into))
}

fn folder() -> PathBuf {
    workspace().join("web")
}

fn dist() -> PathBuf {
    folder().join("dist")
}

/// Not in `dist`, all of which is published.
fn dist_stamp() -> PathBuf {
    folder().join("src/wasm/built-from.txt")
}

fn viewer() -> PathBuf {
    workspace().join("crates/striata-viewer/viewer")
}

/// Outside of the folder, since all that is in there is embedded.
fn viewer_stamp() -> PathBuf {
    workspace().join("crates/striata-viewer/viewer-built-from.txt")
}
