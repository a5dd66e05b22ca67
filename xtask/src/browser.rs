//! Runs the browser tests in `web/tests`: the viewer in Chromium, and every kind of file in Firefox, served by the
//! command.

use std::process::Command;

use anyhow::Result;

use crate::steps;
use crate::{machine, workspace};

/// Runs the browser tests, which leave no files behind.
///
/// # Errors
/// If tests fail or a tool is missing.
pub(crate) fn run() -> Result<()> {
    let command = crate::command::built_command()?;
    let web = workspace().join("web");
    machine::npm_install(&web)?;
    // A test page imports the library.
    crate::web::prepare_library()?;
    steps::run(Command::new("node").arg("tests/run.mjs").current_dir(&web).env("STRIATA_BIN", &command))?;
    let mut firefox = Command::new("node");
    firefox.args(["--test", "--test-reporter=spec", "tests/firefox.mjs"]);
    steps::run(firefox.current_dir(web).env("STRIATA_BIN", command))
}
