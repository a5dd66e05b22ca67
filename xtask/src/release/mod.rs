//! The release kit: what `.github/workflows/release.yml` publishes, built and inspected as far as this machine can.
//!
//! `--archive` packs the command for one platform, as the workflow does on each. `--dry-run` checks the workflows and
//! the metadata of all packages, packs the crates, and builds, installs and runs what is published for this machine.

mod binary;
mod metadata;
mod npm;
mod workflows;

use anyhow::Result;
use clap::Args;

use crate::steps::{CiSteps, say};
use crate::{packages, py};

/// Arguments of `cargo xtask release`.
#[derive(Debug, Args)]
#[group(required = true)]
pub(crate) struct ReleaseArgs {
    /// Build and inspect everything that is published for this machine; publish nothing
    #[arg(long)]
    dry_run: bool,
    /// With --dry-run: leave out what takes minutes to build (binary, npm package, wheel)
    #[arg(long, requires = "dry_run")]
    quick: bool,
    /// Build the command for a platform, and pack it for the release
    #[arg(long, value_name = "TARGET", conflicts_with = "dry_run")]
    archive: Option<String>,
    /// With --archive: link with Zig, to the C library of Linux distributions of 2014
    #[arg(long, requires = "archive")]
    zig: bool,
}

/// Runs `cargo xtask release`.
///
/// # Errors
/// If something cannot be built, or would not be published as it should be.
pub(crate) fn run(args: &ReleaseArgs) -> Result<()> {
    if let Some(target) = &args.archive {
        let path = binary::archive(target, args.zig)?;
        say(&format!("packed {}", path.display()));
        return Ok(());
    }
    let mut steps = CiSteps::default();
    check_files(&mut steps)?;
    steps.step("crates", packages::run)?;
    if args.quick {
        steps.skip("binary, npm package, wheel", "--quick was given");
    } else {
        steps.step("binary", binary::check)?;
        steps.step("npm package", npm::check)?;
        steps.step("wheel", py::check_wheel)?;
    }
    say(&steps.summary());
    Ok(())
}

/// Checks what needs no build.
///
/// # Errors
/// If a workflow or the metadata of a package are not as they should be.
fn check_files(steps: &mut CiSteps) -> Result<()> {
    steps.step("workflows", workflows::check)?;
    steps.step("metadata", metadata::check)
}
