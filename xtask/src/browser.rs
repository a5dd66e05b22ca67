//! The viewer in Chromium, over the command that was just built: `web/tests`.

use std::process::Command;

use anyhow::Result;

use crate::steps;
use crate::{machine, workspace};

/// Runs the browser tests; they leave nothing behind.
///
/// # Errors
/// The tests that failed, or what is missing.
pub(crate) fn run() -> Result<()> {
    let command = crate::command::built_command()?;
    let web = workspace().join("web");
    machine::npm_install(&web)?;
    // A page among the tests imports it.
    crate::web::prepare_library()?;
    steps::run(Command::new("node").arg("tests/run.mjs").current_dir(web).env("STRIATA_BIN", command))
}
