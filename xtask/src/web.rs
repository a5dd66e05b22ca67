//! Builds the web assets: the wasm, the npm package and the viewer page.
//!
//! ```text
//! crates/striata-web --cargo, wasm-bindgen, wasm-opt--> web/dist/*.wasm, web/src/wasm (their scripts)
//! the same, with the encoder -------------------------> web/viewer/wasm
//! web/src            --vite, tsc----------------------> web/dist
//! web/viewer         --vite---------------------------> crates/striata-viewer/viewer (embedded)
//! ```
//!
//! The viewer is committed, so that building the command requires neither a wasm target nor Node.js. A file
//! next to it records what it was built from. Everything else is built when it is needed.
//!
//! A given toolchain makes the same bytes in any folder (paths are remapped, lock files fix the rest). So if
//! the current rustc is the one that the viewer was built with, the check builds the viewer again and
//! compares the bytes; comments in the library make no difference. With another rustc the bytes would differ
//! without being wrong. In that case, and if there are no tools to build with, the check compares digests of
//! the sources and only prints a notice if they differ.

mod assets;
mod stamp;
mod wasm;

use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context, Result, bail};

use crate::machine::{self, WASM_TARGET};
use crate::steps::{self, CheckExtent, say};
use crate::workspace;
use stamp::AssetStamp;
use wasm::folder;

pub(crate) use wasm::{WasmBuild, rustc_output};

/// Advice if the check fails.
const ADVICE: &str = "run `cargo xtask web` and commit what it writes";

/// Runs `cargo xtask web`: builds all web assets; the npm package only if it is missing or older than its
/// sources.
///
/// # Errors
/// If a tool is missing or fails.
pub(crate) fn build() -> Result<()> {
    prepare_library(WasmBuild::Published)?;
    build_viewer(&viewer())?;
    stamp::write(&viewer_stamp(), WasmBuild::Published)?;
    say(&assets::sizes(&dist())?);
    Ok(())
}

/// Builds the npm package, unless it exists and was built from the same sources. A published build also serves for tests.
///
/// # Errors
/// If a tool is missing or fails.
pub(crate) fn prepare_library(build: WasmBuild) -> Result<()> {
    let exists = dist().join("striata.js").is_file();
    let serves = |stamp: &AssetStamp| stamp.is_fresh() && (build == WasmBuild::Quick || !stamp.is_quick());
    if exists && AssetStamp::read(&dist_stamp()).is_ok_and(|stamp| serves(&stamp)) {
        return Ok(());
    }
    if let Some(missing) = missing_tool() {
        bail!(missing);
    }
    build_library(build)
}

/// Builds the package, runs its tests, and checks that the committed viewer matches its sources: by the digests of its
/// stamp, or, if they differ or everything is checked, by building it again.
///
/// # Errors
/// If the viewer is out of date, or tests fail.
pub(crate) fn check(extent: CheckExtent) -> Result<()> {
    let stamp = AssetStamp::read(&viewer_stamp()).context(ADVICE)?;
    if let Some(missing) = missing_tool() {
        say(&format!("{missing}: the web package is neither built nor tested"));
        return print_notice(&stamp);
    }
    if extent == CheckExtent::Quick && stamp.is_fresh() {
        prepare_library(WasmBuild::Quick)?;
        return machine::npm(&folder(), &["test"]);
    }
    prepare_library(WasmBuild::Published)?;
    let scratch = std::env::temp_dir().join(format!("striata-viewer-{}", std::process::id()));
    machine::remove_folder(&scratch)?;
    build_viewer(&scratch)?;
    if stamp.is_of_this_rust() {
        assets::compare(&scratch, &viewer()).context(ADVICE)?;
    } else {
        say("the viewer was built by another rustc, so its bytes are not compared");
        print_notice(&stamp)?;
    }
    machine::remove_folder(&scratch)?;
    machine::npm(&folder(), &["test"])
}

/// Prints a notice if the viewer is older than its sources.
fn print_notice(stamp: &AssetStamp) -> Result<()> {
    let changed = stamp.changed()?;
    if !changed.is_empty() {
        let changed = changed.join("; ");
        say(&format!(
            "notice: these have changed since the committed viewer was built: {changed}. Whether the viewer \
             must be built again can be checked with {} and Node.js, as continuous integration does",
            stamp.rustc()
        ));
    }
    Ok(())
}

/// Returns a message about a tool that is missing, if one is.
fn missing_tool() -> Option<String> {
    if !machine::has_wasm_target() {
        return Some(format!("the target {WASM_TARGET} is not installed and rustup could not add it"));
    }
    let missing = ["node", "npm"].into_iter().find(|program| !machine::starts(program))?;
    Some(format!("{missing} is not installed"))
}

/// Builds the wasm, then the types and bundles of the npm package.
fn build_library(build: WasmBuild) -> Result<()> {
    machine::npm_install(&folder())?;
    let built = wasm::MODULES.map(|module| wasm::build(module, build));
    let encoder = wasm::build(wasm::ENCODER, build)?;
    let scripts = folder().join("src/wasm");
    let page = folder().join("viewer/wasm");
    for folder in [&dist(), &scripts, &page] {
        machine::remove_folder(folder)?;
    }
    for built in built {
        wasm::write(&built?, &dist(), &scripts)?;
    }
    wasm::write(&encoder, &page, &page)?;
    machine::npm(&folder(), &["run", "--silent", "check"])?;
    machine::npm(&folder(), &["run", "--silent", "build:library"])?;
    stamp::write(&dist_stamp(), build)
}

/// Builds the viewer page with the wasm in `dist`.
fn build_viewer(into: &Path) -> Result<()> {
    let mut command = Command::new("npm");
    command.args(["run", "--silent", "build:viewer"]).current_dir(folder());
    steps::run(command.env("STRIATA_WEB_VIEWER", into))
}

fn dist() -> PathBuf {
    folder().join("dist")
}

/// Path of the stamp of the npm package; not in `dist`, which is published completely.
fn dist_stamp() -> PathBuf {
    folder().join("src/wasm/built-from.txt")
}

fn viewer() -> PathBuf {
    workspace().join("crates/striata-viewer/viewer")
}

/// Path of the stamp of the viewer; not in its folder, which is embedded completely.
fn viewer_stamp() -> PathBuf {
    workspace().join("crates/striata-viewer/viewer-built-from.txt")
}
