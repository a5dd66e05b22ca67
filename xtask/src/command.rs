//! Builds the striata command that the checks run.

use std::path::PathBuf;

use anyhow::{Result, ensure};

use crate::steps::{self, cargo};
use crate::target_folder;

/// Features of the complete command.
pub(crate) const FULL: &str = "striata-cli/full";

/// Builds the optimized command with its default features and GPU pictures, unless that has been done, and returns its
/// path.
///
/// # Errors
/// If it does not compile.
pub(crate) fn built_command() -> Result<PathBuf> {
    steps::run(&mut cargo(&["build", "--release", "--package", "striata-cli", "--features", "gpu"]))?;
    let command = target_folder()?.join("release").join(format!("striata{}", std::env::consts::EXE_SUFFIX));
    ensure!(command.is_file(), "{} does not exist", command.display());
    Ok(command)
}
