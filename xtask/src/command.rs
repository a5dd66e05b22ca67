//! Builds the striata command as a new user does.

use std::path::PathBuf;

use anyhow::{Result, ensure};

use crate::steps::{self, cargo};
use crate::target_folder;

/// Features of the complete command.
pub(crate) const FULL: &str = "striata-cli/full";

/// Builds the optimized command with its default features, unless that has been done, and returns its path.
///
/// # Errors
/// If it does not compile.
pub(crate) fn built_command() -> Result<PathBuf> {
    steps::run(&mut cargo(&["build", "--release", "--package", "striata-cli"]))?;
    let command = target_folder()?.join("release").join(format!("striata{}", std::env::consts::EXE_SUFFIX));
    ensure!(command.is_file(), "{} does not exist", command.display());
    Ok(command)
}
