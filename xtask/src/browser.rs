//! The viewer in Chromium, over the command that was just built: `web/tests`.

use std::process::Command;

use anyhow::{Result, ensure};

use crate::steps::{self, cargo};
use crate::{machine, workspace};

/// Runs the browser tests; they leave nothing behind.
///
/// # Errors
/// The tests that failed, or what is missing.
pub(crate) fn run() -> Result<()> {
    steps::run(&mut cargo(&["build", "--package", "striata-cli"]))?;
    // Cargo puts the command beside the program that this is.
    let command = std::env::current_exe()?.with_file_name(format!("striata{}", std::env::consts::EXE_SUFFIX));
    ensure!(command.is_file(), "there is no {}", command.display());
    let web = workspace().join("web");
    machine::npm_install(&web)?;
    steps::run(Command::new("node").arg("tests/run.mjs").current_dir(web).env("STRIATA_BIN", command))
}
