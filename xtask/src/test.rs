//! Runs all checks that must pass before a change is merged.
//!
//! The release build of the command comes first, before anything is installed on the machine. All other steps
//! use the same profile, so that nothing is compiled twice: `clippy` reuses the results of `check`, and the
//! golden step uses the command that the tests have built.

use anyhow::Result;

use crate::command::FULL;
use crate::machine::{self, WASM_TARGET};
use crate::steps::{self, CiSteps, cargo, say};
use crate::{bare, browser, golden, house, licenses, oldest_rust, packages, py, web};

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
    ("striata-lab", ""),
    ("striata-lab", "peers"),
];

/// Runs all steps and stops at the first failure.
///
/// # Errors
/// The failure of that step.
fn run_all(steps: &mut CiSteps) -> Result<()> {
    // This comes first, since the next step may install libraries that a new machine lacks.
    steps.step("bare machines", bare::run)?;
    steps.step("machine", machine::prepare)?;
    steps.step("format", || steps::run(&mut cargo(&["fmt", "--all", "--check"])))?;
    steps.step("shape of the code", || house::check(false))?;
    steps.step("clippy", || {
        steps::run(&mut cargo(&[
            "clippy",
            "--workspace",
            "--all-targets",
            "--features",
            FULL,
            "--",
            "-D",
            "warnings",
        ]))
    })?;
    // Mesa's device selection layer looks for a Wayland display, and prints errors if there is none.
    let quiet = ("NODEVICE_SELECT", "1");
    steps.step("tests and doc tests", || {
        steps::run(cargo(&["test", "--workspace", "--features", FULL]).env(quiet.0, quiet.1))
    })?;
    steps.step("documentation", || {
        let arguments = ["doc", "--workspace", "--no-deps", "--features", FULL];
        steps::run(cargo(&arguments).env("RUSTDOCFLAGS", "-D warnings"))
    })?;
    steps.step("each feature alone", check_features)?;
    match oldest_rust::obstacle() {
        None => steps.step("oldest Rust", oldest_rust::check)?,
        Some(reason) => steps.skip("oldest Rust", &reason),
    }
    steps.step("packages", packages::run)?;
    match licenses::obstacle() {
        None => steps.step("licenses", licenses::check)?,
        Some(reason) => steps.skip("licenses", reason),
    }
    if machine::has_wasm_target() {
        steps.step("wasm32", check_wasm)?;
    } else {
        steps.skip(WASM_TARGET, "the target is not installed and rustup could not add it");
    }
    steps.step("web assets", web::check)?;
    steps.step("fuzz targets", check_fuzz)?;
    steps.step("golden", golden::run)?;
    steps.step("Python", py::run)?;
    steps.step("browser", browser::run)
}

/// Runs `cargo xtask test`.
///
/// # Errors
/// The failure of the first step that fails.
pub(crate) fn run() -> Result<()> {
    let mut steps = CiSteps::default();
    run_all(&mut steps)?;
    say(&steps.summary());
    Ok(())
}

fn check_features() -> Result<()> {
    for (package, features) in FEATURES_ALONE {
        steps::run(&mut cargo(&["check", "-p", package, "--no-default-features", "--features", features]))?;
    }
    Ok(())
}

/// Checks the fuzz targets, which are a separate workspace. Running them requires a nightly toolchain.
fn check_fuzz() -> Result<()> {
    let arguments = ["clippy", "--manifest-path", "fuzz/Cargo.toml", "--all-targets", "--", "-D", "warnings"];
    steps::run(&mut cargo(&arguments))
}

fn check_wasm() -> Result<()> {
    let check =
        ["check", "-p", "striata", "-p", "striata-stream", "-p", "striata-scene", "--target", WASM_TARGET];
    steps::run(&mut cargo(&check))?;
    steps::run(cargo(&check).arg("--no-default-features"))
}
