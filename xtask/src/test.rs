//! Runs the checks that must pass before a change is merged, or all that there are.
//!
//! The release build of the command comes first, before anything is installed on the machine. All other steps
//! use the same profile, so that nothing is compiled twice: `clippy` reuses the results of `check`, and the
//! golden step uses the command that the tests have built.

use anyhow::Result;

use crate::command::{FULL, built_command};
use crate::machine::{self, WASM_TARGET};
use crate::steps::{self, CheckExtent, CiSteps, cargo, say};
use crate::{bare, browser, golden, house, licenses, oldest_rust, packages, py, site, web};

/// Crates and feature sets that must compile separately.
const FEATURES_ALONE: &[(&str, &str)] = &[
    ("striata", ""),
    ("striata", "parallel"),
    ("striata-stream", ""),
    ("striata-stream", "parallel"),
    ("striata-io", ""),
    ("striata-io", "ply"),
    ("striata-io", "obj"),
    ("striata-io", "stl"),
    ("striata-io", "off"),
    ("striata-io", "gltf"),
    ("striata-io", "threemf"),
    ("striata-io", "vtk"),
    ("striata-io", "meshopt"),
    ("striata-io", "draco"),
    ("striata-io", "compressed"),
    ("striata-io", "blocks"),
    ("striata-io", "pieces"),
    ("striata-io", "terrain"),
    ("striata-paged", ""),
    ("striata-paged", "build"),
    ("striata-paged", "remote"),
    ("striata-render", ""),
    ("striata-scene", ""),
    ("striata-tiles", ""),
    ("striata-scene", "textures"),
    ("striata-scene", "parallel"),
    ("striata-strip", ""),
    ("striata-cli", ""),
    ("striata-cli", "gpu"),
    ("striata-cli", "remote"),
    ("striata-cli", "serve"),
    ("striata-py", ""),
];

/// The lab, which is a workspace of its own.
const LAB: [&str; 2] = ["--manifest-path", "lab/Cargo.toml"];

/// Runs the steps and stops at the first failure.
///
/// # Errors
/// The failure of that step.
fn run_steps(steps: &mut CiSteps, extent: CheckExtent) -> Result<()> {
    // This comes first, since the next step may install libraries that a new machine lacks.
    steps.step("bare machines", bare::run)?;
    steps.step("machine", machine::prepare)?;
    steps.step("format", check_format)?;
    steps.step("shape of the code", || house::check(false))?;
    steps.step("clippy", || lint(&["--workspace", "--features", FULL]))?;
    steps.step("tests and doc tests", || test(&["--workspace", "--features", FULL], extent))?;
    steps.step("documentation", || {
        let arguments = ["doc", "--workspace", "--no-deps", "--features", FULL];
        steps::run(cargo(&arguments).env("RUSTDOCFLAGS", "-D warnings"))
    })?;
    steps.step("packages", packages::run)?;
    if machine::has_wasm_target() {
        steps.step("wasm32", check_wasm)?;
    } else {
        steps.skip(WASM_TARGET, "the target is not installed and rustup could not add it");
    }
    steps.step("web assets", || web::check(extent))?;
    steps.step("golden", golden::run)?;
    steps.step("Python", py::run)?;
    steps.step("Chromium", browser::run_chromium)?;
    if extent == CheckExtent::All { run_rare_steps(steps) } else { Ok(()) }
}

/// Runs the steps of [`CheckExtent::All`].
///
/// # Errors
/// The failure of the first step that fails.
fn run_rare_steps(steps: &mut CiSteps) -> Result<()> {
    steps.step("Firefox", browser::run_firefox)?;
    steps.step("lab", || {
        lint(&[&LAB[..], &["--features", "peers"]].concat())?;
        test(&LAB, CheckExtent::All)
    })?;
    steps.step("each feature alone", check_features)?;
    match oldest_rust::obstacle() {
        None => steps.step("oldest Rust", oldest_rust::check)?,
        Some(reason) => steps.skip("oldest Rust", &reason),
    }
    match licenses::obstacle() {
        None => steps.step("licenses", licenses::check)?,
        Some(reason) => steps.skip("licenses", reason),
    }
    steps.step("site", || site::run().map(drop))?;
    steps.step("fuzz targets", || lint(&["--manifest-path", "fuzz/Cargo.toml"]))
}

/// Runs `cargo xtask test`.
///
/// # Errors
/// The failure of the first step that fails.
pub(crate) fn run(extent: CheckExtent) -> Result<()> {
    let mut steps = CiSteps::default();
    run_steps(&mut steps, extent)?;
    say(&steps.summary());
    Ok(())
}

/// Checks the format of all workspaces.
fn check_format() -> Result<()> {
    for manifest in ["Cargo.toml", "lab/Cargo.toml", "fuzz/Cargo.toml"] {
        steps::run(&mut cargo(&["fmt", "--all", "--check", "--manifest-path", manifest]))?;
    }
    Ok(())
}

/// Runs clippy over all targets of what the arguments name; warnings count as errors.
fn lint(subject: &[&str]) -> Result<()> {
    steps::run(&mut cargo(&[&["clippy", "--all-targets"], subject, &["--", "-D", "warnings"]].concat()))
}

/// Runs the tests of what the arguments name; those that run many commands use the optimized one.
fn test(subject: &[&str], extent: CheckExtent) -> Result<()> {
    let mut command = cargo(&[&["test"], subject].concat());
    if extent == CheckExtent::All {
        command.env("STRIATA_TEST_ALL", "1");
    }
    // Mesa's device selection layer looks for a Wayland display, and prints errors if there is none.
    steps::run(command.env("NODEVICE_SELECT", "1").env("STRIATA_OPTIMIZED", built_command()?))
}

fn check_features() -> Result<()> {
    for (package, features) in FEATURES_ALONE {
        steps::run(&mut cargo(&["check", "-p", package, "--no-default-features", "--features", features]))?;
    }
    Ok(())
}

fn check_wasm() -> Result<()> {
    let check =
        ["check", "-p", "striata", "-p", "striata-stream", "-p", "striata-scene", "--target", WASM_TARGET];
    steps::run(&mut cargo(&check))?;
    steps::run(cargo(&check).arg("--no-default-features"))
}
