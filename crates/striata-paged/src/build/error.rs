//! Errors of a build.

use std::io;
use std::path::{Path, PathBuf};

use crate::{PageId, PagedError};

/// Reason why a build failed.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum PagedBuildError {
    /// An input cannot be read.
    #[error(transparent)]
    Read(#[from] striata_io::ReadError),
    /// A file cannot be read or written.
    #[error("{}: {source}", path.display())]
    Io {
        /// The file.
        path: PathBuf,
        /// Error of the system.
        source: io::Error,
    },
    /// A file between two tasks is damaged.
    #[error("{}: not a complete file of this build; remove it and run its task again", path.display())]
    Damaged {
        /// The file.
        path: PathBuf,
    },
    /// The bytes of a segment end early or contradict each other.
    #[error("a segment of a part file is damaged")]
    DamagedPart,
    /// The file is not a plan, or has another version.
    #[error("{}: not a plan of this version: {reason}", path.display())]
    Plan {
        /// The file.
        path: PathBuf,
        /// Reason in words.
        reason: String,
    },
    /// A task of the plan does not exist.
    #[error("task {task} does not exist: the plan has {count}, from 0")]
    NoTask {
        /// The number asked for.
        task: usize,
        /// Number of tasks.
        count: usize,
    },
    /// A task needs the results of another one.
    #[error("task {task} needs the result of task {needed}, which has not been run")]
    TaskOrder {
        /// The task asked for.
        task: usize,
        /// A task that must come first.
        needed: usize,
    },
    /// The input has no triangles.
    #[error("{input}: no triangles")]
    Empty {
        /// The input.
        input: String,
    },
    /// A file of the input is not what it was when the plan was made.
    #[error("{}: the file has changed since the build was planned", path.display())]
    InputChanged {
        /// The file.
        path: PathBuf,
    },
    /// Another build works in the same folder.
    #[error("{}: another build is working in this folder", path.display())]
    InUse {
        /// The folder.
        path: PathBuf,
    },
    /// Rounding would change the mesh.
    #[error(
        "{input}: rounding positions to multiples of {step:e} merges {merged} of {total} vertices that are apart"
    )]
    Merging {
        /// The input.
        input: String,
        /// The smallest step of the three axes, in mesh units.
        step: f64,
        /// Number of vertices that would be lost, in one task.
        merged: u64,
        /// Number of different positions before.
        total: u64,
    },
    /// The coarsest level has more triangles than it may have.
    #[error("the base mesh has {triangles} triangles, but must have at most {limit}")]
    Base {
        /// Number of triangles that are left.
        triangles: u64,
        /// Largest number of triangles.
        limit: u64,
    },
    /// Not enough room on the disk.
    #[error("{}: {:.2} GB are needed, {:.2} GB are free", path.display(), gigabytes(*needed), gigabytes(*available))]
    DiskSpace {
        /// The folder.
        path: PathBuf,
        /// Estimated need.
        needed: u64,
        /// Free bytes.
        available: u64,
    },
    /// The work folder belongs to another input or other options.
    #[error("{}: belongs to a build of another input or with other options; use --restart to replace it",
        path.display())]
    OtherBuild {
        /// The folder.
        path: PathBuf,
    },
    /// The simplification of a cell failed.
    #[error("level {}, cell {}: {source}", id.level, id.cell)]
    Simplify {
        /// Level and cell.
        id: PageId,
        /// Why.
        source: striata::simplify::SimplifyError,
    },
    /// A page is inconsistent.
    #[error(transparent)]
    Page(#[from] PagedError),
    /// A vertex that a page mentions is in no coarser page.
    #[error("internal error: level {}, cell {} mentions a vertex that no coarser cell has", id.level, id.cell)]
    NoOwner {
        /// The page.
        id: PageId,
    },
    /// The caller stopped the build.
    #[error(transparent)]
    Cancelled(#[from] striata::Cancelled),
}

fn gigabytes(bytes: u64) -> f64 {
    bytes as f64 * 1e-9
}

impl PagedBuildError {
    pub(super) fn io(path: &Path, source: io::Error) -> Self {
        Self::Io { path: path.to_owned(), source }
    }
}
