//! Builds of meshes that do not fit into memory: `build --memory`, `plan` and `run`.

mod build;
mod input;
mod plan;
mod run;

pub(crate) use build::build;
pub(crate) use input::{is_streamed_only, is_too_large};
pub(crate) use plan::plan;
pub(crate) use run::run;

use striata_command::failure::Failure;
use striata_paged::build::BuildError;

/// Converts an error of a build.
fn failure(error: BuildError) -> Failure {
    match error {
        BuildError::Read(error) => Failure::from(error),
        BuildError::Simplify { .. } | BuildError::NoOwner { .. } => Failure::internal(error.to_string()),
        BuildError::DiskSpace { .. } => Failure::user(error.to_string())
            .with_hint("put the work folder on another disk with --work, or free some space"),
        BuildError::TaskOrder { .. } => Failure::user(error.to_string())
            .with_hint("tasks of a stage may run in any order, but only when the stages before are complete"),
        other => Failure::user(other.to_string()),
    }
}

/// One thread per core.
fn core_count() -> usize {
    std::thread::available_parallelism().map_or(1, usize::from)
}
