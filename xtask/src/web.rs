//! The web assets: the wasm, the npm package and the viewer page, built and held against what is committed.
//!
//! ```text
//! crates/striata-web --cargo, wasm-bindgen, wasm-opt--> web/dist/striata.wasm, web/src/wasm (the script that calls it)
//! web/src            --vite, tsc-----------------------> web/dist
//! web/viewer         --vite----------------------------> crates/striata-viewer/viewer, which the command embeds
//! ```
//!
//! All of it is committed, so that whoever builds the command needs neither a wasm target nor Node.js. What is committed has to
//! be what the sources make: the same toolchain makes the same bytes in any folder (paths are remapped, the lock files fix
//! the rest), so where rustc is the one that the assets were built with the check builds them anew and compares. Comments in
//! the library then change nothing. With another rustc the bytes would differ for no fault of anybody's; there the check
//! compares digests of the sources, which is cheap, knows any change, and cannot tell one that matters from one that does not.

mod assets;
mod stamp;
mod wasm;

use std::path::{Path, PathBuf};

use anyhow::{Context, Result, bail};

use crate::machine::{self, WASM_TARGET};
use crate::steps::{self, say};
use crate::workspace;

/// What the check says where it fails.
const CURE: &str = "run `cargo xtask web` and commit what it writes";

/// `cargo xtask web`: builds everything into its place.
///
/// # Errors
/// Where a tool is missing or fails.
pub(crate) fn build() -> Result<()> {
    if !machine::has_wasm_target() {
        bail!("this Rust cannot make {WASM_TARGET} code, and rustup could not add it");
    }
    machine::npm_install(&folder())?;
    let built = wasm::build()?;
    wasm::write(&built, &dist(), &folder().join("src/wasm"))?;
    bundle(&dist(), &viewer())?;
    stamp::write(&dist())?;
    say(&assets::sizes(&dist(), &built)?);
    Ok(())
}

/// Checks that what is committed is what the sources make.
///
/// # Errors
/// What is stale.
pub(crate) fn check() -> Result<()> {
    let stamped = stamp::Stamp::read(&dist()).context(CURE)?;
    if !machine::has_wasm_target() || !stamped.is_of_this_rust()? {
        say("the assets were built with another Rust: comparing digests of the sources");
        return stamped.check().context(CURE);
    }
    machine::npm_install(&folder())?;
    let built = wasm::build()?;
    let scratch = std::env::temp_dir().join(format!("striata-web-{}", std::process::id()));
    machine::remove_folder(&scratch)?;
    let (new_dist, new_viewer) = (scratch.join("dist"), scratch.join("viewer"));
    wasm::write(&built, &new_dist, &scratch.join("wasm"))?;
    // First, since a bundle of another script would differ as well.
    assets::compare(&scratch.join("wasm"), &folder().join("src/wasm")).context(CURE)?;
    bundle(&new_dist, &new_viewer)?;
    assets::compare(&new_dist, &dist()).context(CURE)?;
    if has_viewer() {
        assets::compare(&new_viewer, &viewer()).context(CURE)?;
    }
    machine::npm(&folder(), &["test"])?;
    machine::remove_folder(&scratch)
}

/// Types, then both bundles, beside the wasm that lies in `dist` already.
fn bundle(dist: &Path, viewer: &Path) -> Result<()> {
    let npm = |script: &str| {
        let mut command = std::process::Command::new("npm");
        command.args(["run", "--silent", script]).current_dir(folder());
        steps::run(command.env("STRIATA_WEB_DIST", dist).env("STRIATA_WEB_VIEWER", viewer))
    };
    npm("check")?;
    npm("build:library")?;
    if has_viewer() { npm("build:viewer") } else { Ok(()) }
}

fn has_viewer() -> bool {
    folder().join("viewer/index.html").is_file()
}

fn folder() -> PathBuf {
    workspace().join("web")
}

fn dist() -> PathBuf {
    folder().join("dist")
}

fn viewer() -> PathBuf {
    workspace().join("crates/striata-viewer/viewer")
}
