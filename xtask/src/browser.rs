//! Runs the browser tests in `web/tests`: the viewer in Chromium, and every kind of file in Firefox, served by the
//! command.

use std::process::Command;

use anyhow::Result;

use crate::steps;
use crate::web::WasmBuild;
use crate::{machine, workspace};

/// Runs the browser tests, which leave no files behind.
///
/// # Errors
/// If tests fail or a tool is missing.
pub(crate) fn run() -> Result<()> {
    run_chromium()?;
    run_firefox()
}

/// Runs the tests of the viewer in Chromium.
///
/// # Errors
/// If tests fail or a tool is missing.
pub(crate) fn run_chromium() -> Result<()> {
    machine::npm_install(&workspace().join("web"))?;
    // A test page imports the library.
    crate::web::prepare_library(WasmBuild::Quick)?;
    run_node(&["tests/run.mjs"])
}

/// Opens every kind of file in Firefox.
///
/// # Errors
/// If tests fail or a tool is missing.
pub(crate) fn run_firefox() -> Result<()> {
    machine::npm_install(&workspace().join("web"))?;
    run_node(&["--test", "--test-reporter=spec", "tests/firefox.mjs"])
}

/// Runs tests with the optimized command.
fn run_node(arguments: &[&str]) -> Result<()> {
    let command = crate::command::built_command()?;
    let mut node = Command::new("node");
    steps::run(node.args(arguments).current_dir(workspace().join("web")).env("STRIATA_BIN", command))
}
