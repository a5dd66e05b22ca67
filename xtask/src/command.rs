//! Builds the striata command with all features, as the tests use it.

use std::path::PathBuf;

use anyhow::{Result, ensure};

use crate::steps::{self, cargo};
use crate::target_folder;

/// Features of the complete command.
pub(crate) const FULL: &str = "striata-cli/full";

/// Builds the command with all features, unless the tests have built it, and returns its path.
///
/// # Errors
/// If it does not compile.
pub(crate) fn built_command() -> Result<PathBuf> {
    // Building the whole workspace gives dependencies the same features as in the tests.
    steps::run(&mut cargo(&["build", "--workspace", "--features", FULL, "--bin", "striata"]))?;
    let command = target_folder()?.join("debug").join(format!("striata{}", std::env::consts::EXE_SUFFIX));
    ensure!(command.is_file(), "{} does not exist", command.display());
    Ok(command)
}
