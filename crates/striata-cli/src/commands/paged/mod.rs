//! Builds of meshes that do not fit into memory: `build --memory`, `plan` and `run`.

mod build;
mod info;
mod input;
mod plan;
mod run;
mod source;

pub(crate) use build::{build, build_pages};
pub(crate) use info::info;
pub(crate) use input::{is_generated, is_streamed_only, is_too_large, open_generated};
pub(crate) use plan::plan;
pub(crate) use run::run;
pub(crate) use source::{is_paged_file, open_input};

use striata_command::failure::{Failure, version_hint};
use striata_paged::build::PagedBuildError;
use striata_paged::{HeadDefect, PagedError};

/// Converts an error of a build.
fn failure(error: PagedBuildError) -> Failure {
    match error {
        PagedBuildError::Read(error) => Failure::from(error),
        PagedBuildError::Simplify { .. } | PagedBuildError::NoOwner { .. } => {
            Failure::internal(error.to_string())
        }
        PagedBuildError::DiskSpace { .. } => Failure::user(error.to_string())
            .with_hint("put the work folder on another disk with --work, or free some space"),
        PagedBuildError::Merging { .. } => Failure::user(error.to_string())
            .with_hint("keep positions with --exact, or build it anyway with --allow-merging"),
        PagedBuildError::Base { .. } => {
            Failure::user(format!("--strict: {error}")).with_hint("remove --strict to get the closest level")
        }
        PagedBuildError::InputChanged { .. } => {
            Failure::user(error.to_string()).with_hint("begin again: build with --restart, or plan it anew")
        }
        PagedBuildError::InUse { .. } => Failure::user(error.to_string())
            .with_hint("wait for it, or choose another output or another folder with --work"),
        PagedBuildError::TaskOrder { .. } => Failure::user(error.to_string())
            .with_hint("tasks of a stage may run in any order, but only when the stages before are complete"),
        other => Failure::user(other.to_string()),
    }
}

/// Converts an error of a paged file.
pub(crate) fn failure_of(error: PagedError) -> Failure {
    let failure = Failure::user(error.to_string());
    match error {
        PagedError::Head(HeadDefect::Version(found)) => failure.with_hint(version_hint(found, 1)),
        PagedError::Checksum { .. } | PagedError::Head(_) | PagedError::Page { .. } => {
            failure.with_hint("the file is damaged or cut off; copy it or build it again")
        }
        PagedError::FeatureOff { .. } => {
            failure.with_hint("install the command with `cargo install striata-cli --features remote`")
        }
        _ => failure,
    }
}
