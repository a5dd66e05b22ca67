//! The command with all its features, as the tests build it.

use std::path::PathBuf;

use anyhow::{Result, ensure};

use crate::steps::{self, cargo};
use crate::target_folder;

/// All of the command, its window included.
pub(crate) const FULL: &str = "striata-cli/full";

/// Builds the command with all its features, if the tests have not done it, and says where it lies.
///
/// # Errors
/// Where it does not compile.
pub(crate) fn built_command() -> Result<PathBuf> {
    // The whole workspace is named so that dependencies get the features that they have in the tests.
    steps::run(&mut cargo(&["build", "--workspace", "--features", FULL, "--bin", "striata"]))?;
    let command = target_folder()?.join("debug").join(format!("striata{}", std::env::consts::EXE_SUFFIX));
    ensure!(command.is_file(), "there is no {}", command.display());
    Ok(command)
}
