//! Out-of-core build: turns a mesh of any size into pages, in tasks that any executor can run.
//!
//! ```text
//!  make plan          Sort             Level 0 .. Level L-1          Encode             Finish
//!  read once,    ->   pieces into  ->  cells to a quarter,      ->   find imports,  ->  one file
//!  partition          cells            survivors into cells          entropy code       or a folder
//! ```
//!
//! The tasks of a stage are independent of each other, and a stage begins when all earlier stages are complete.
//! Every task writes one part file (the task of a level also writes a file of steps) under a temporary name, and
//! renames it when it is complete. So a task can be killed, repeated, or run twice at the same time, on any machine
//! that can read the folder, and the bytes of the result are always the same.

mod encode_task;
mod error;
mod finish_task;
mod input;
mod options;
mod part_file;
mod plan;
mod runner;
mod scan;
mod simplify_task;
mod simulation;
mod sort_task;
mod weld;
mod wire;

use std::fs;
use std::path::{Path, PathBuf};

pub use error::PagedBuildError;
pub use finish_task::is_address;
pub use input::BuildInput;
pub use options::{BuildOptions, Limit};
pub use plan::{BuildStage, BuildTask, PagedPlan, TaskKind};
pub use runner::{run_all, run_stage, run_task};
pub use simulation::{SimulatedStage, Simulation, SimulationOptions, TaskCosts};
use striata::ProgressFn;

/// Bytes of a work folder per triangle of the input, measured on scans and terrains without attributes.
const WORK_BYTES_PER_TRIANGLE: u64 = 60;
/// Bytes of the result per triangle.
const RESULT_BYTES_PER_TRIANGLE: u64 = 3;
/// Further bytes per triangle and attribute component.
const BYTES_PER_COMPONENT: u64 = 8;
/// Memory that one thread needs for a cell of the default size, in bytes.
const THREAD_BYTES: u64 = 250 << 20;

/// Paths to which a build writes.
#[derive(Clone, Copy, Debug)]
pub struct BuildPaths<'a> {
    /// The result: a file, or a folder if the path ends in a separator or has no extension.
    pub output: &'a Path,
    /// The folder of the plan and of intermediate results.
    pub folder: &'a Path,
}

/// Estimated sizes of a build.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Estimate {
    /// Bytes of the work folder.
    pub work_bytes: u64,
    /// Bytes of the result.
    pub result_bytes: u64,
    /// Number of pages.
    pub page_count: u64,
}

impl PagedPlan {
    /// Reads the input once and plans the build of `output`. The plan and all intermediate results are stored in
    /// `folder`.
    ///
    /// # Errors
    /// [`PagedBuildError`] if the input cannot be read or the folder cannot be written.
    pub fn make(
        input: BuildInput,
        options: BuildOptions,
        paths: BuildPaths<'_>,
        threads: usize,
        progress: &mut ProgressFn<'_>,
    ) -> Result<Self, PagedBuildError> {
        let BuildPaths { output, folder } = paths;
        // Report an output that cannot be written before hours of work, not after them.
        finish_task::ResultDestination::of(output)?.check()?;
        let _unused = UnusedFolder::create(folder)?;
        let mut inputs = input.states()?;
        let source = input.open(&options.piece_options(folder))?;
        inputs.extend(input::states_of(&source.summary().companions)?);
        let scanned = scan::scan(source.as_ref(), &options, threads, progress)?;
        input::check_inputs(&inputs)?;
        // Results of an earlier plan would count as those of this one.
        remove_files(folder, is_result)?;
        let mut plan = Self::new(input, inputs, options, scanned, paths);
        plan.warnings = source.warnings();
        plan.save()?;
        // They are in the folder now.
        plan.metadata.images.iter_mut().for_each(|image| image.bytes = Vec::new());
        Ok(plan)
    }

    /// Estimates the bytes of the work folder and of the result, and the number of pages.
    pub fn estimate(&self) -> Estimate {
        let triangles = self.metadata.triangle_count;
        let images: u64 = self.metadata.images.iter().map(|image| image.byte_count).sum();
        let components: u64 = self.metadata.layers.iter().map(|l| u64::from(l.component_count)).sum();
        Estimate {
            work_bytes: triangles * (WORK_BYTES_PER_TRIANGLE + BYTES_PER_COMPONENT * components) + images,
            result_bytes: triangles * (RESULT_BYTES_PER_TRIANGLE + components) + images,
            page_count: self.metadata.cell_counts.iter().map(|&count| u64::from(count)).sum::<u64>() + 1,
        }
    }

    /// Number of triangles of the coarsest level, once all tasks have been run.
    ///
    /// # Errors
    /// [`PagedBuildError`] if the task that encodes it has not been run, or its file is damaged.
    pub fn base_triangle_count(&self) -> Result<u64, PagedBuildError> {
        finish_task::base_triangle_count(self)
    }

    /// Removes the plan and all intermediate results. The folder itself stays if it contains other files.
    ///
    /// # Errors
    /// [`PagedBuildError::Io`] if a file cannot be removed.
    pub fn remove_work(&self) -> Result<(), PagedBuildError> {
        remove_work(&self.folder)
    }
}

/// Number of threads that fit into `memory` bytes: at least 1, at most the number of cores.
pub fn threads_for_memory(memory: u64, cell: usize) -> usize {
    let per_thread = (THREAD_BYTES * cell as u64 / 65_536).max(64 << 20);
    let cores = std::thread::available_parallelism().map_or(1, usize::from) as u64;
    (memory / per_thread).clamp(1, cores) as usize
}

/// Name of the file that a build locks to claim its work folder.
const LOCK_NAME: &str = "lock";

/// Claim on a work folder, which ends when it is dropped.
#[derive(Debug)]
pub struct WorkLock {
    _file: Option<fs::File>,
}

impl WorkLock {
    /// Claims a work folder, and creates it if it does not exist. Claims nothing if the file system has no locks.
    ///
    /// # Errors
    /// [`PagedBuildError::InUse`] if another build works in it, [`PagedBuildError::Io`] if it cannot be created.
    pub fn claim(folder: &Path) -> Result<Self, PagedBuildError> {
        fs::create_dir_all(folder).map_err(|source| PagedBuildError::io(folder, source))?;
        let path = folder.join(LOCK_NAME);
        let file = fs::File::create(&path).map_err(|source| PagedBuildError::io(&path, source))?;
        match file.try_lock() {
            Ok(()) => Ok(Self { _file: Some(file) }),
            Err(fs::TryLockError::WouldBlock) => Err(PagedBuildError::InUse { path: folder.to_owned() }),
            Err(fs::TryLockError::Error(_)) => Ok(Self { _file: None }),
        }
    }
}

/// A new folder, which goes away again when this is dropped, unless something has been written to it.
struct UnusedFolder<'a>(Option<&'a Path>);

impl<'a> UnusedFolder<'a> {
    fn create(folder: &'a Path) -> Result<Self, PagedBuildError> {
        let is_new = !folder.exists();
        fs::create_dir_all(folder).map_err(|source| PagedBuildError::io(folder, source))?;
        Ok(Self(is_new.then_some(folder)))
    }
}

impl Drop for UnusedFolder<'_> {
    fn drop(&mut self) {
        // It stays if it contains files.
        let _ = self.0.map(fs::remove_dir);
    }
}

/// Removes the files of a build from its work folder.
///
/// # Errors
/// [`PagedBuildError::Io`] if a file cannot be removed.
pub fn remove_work(folder: &Path) -> Result<(), PagedBuildError> {
    remove_files(folder, |name| is_result(name) || name == LOCK_NAME || name.starts_with(".part-"))?;
    // The folder may contain other files.
    let _ = fs::remove_dir(folder);
    Ok(())
}

/// Whether a file of a work folder belongs to a plan or is a result of its tasks.
fn is_result(name: &str) -> bool {
    ["plan.json", "partition.bin", "weld.bin", "finished"].contains(&name) || name.ends_with(".part")
}

/// Removes some files of a folder, by name.
fn remove_files(folder: &Path, is_chosen: impl Fn(&str) -> bool) -> Result<(), PagedBuildError> {
    let Ok(files) = fs::read_dir(folder) else { return Ok(()) };
    let is_chosen = |path: &PathBuf| is_chosen(&path.file_name().unwrap_or_default().to_string_lossy());
    for path in files.flatten().map(|file| file.path()).filter(is_chosen) {
        match fs::remove_file(&path) {
            Err(source) if source.kind() != std::io::ErrorKind::NotFound => {
                return Err(PagedBuildError::io(&path, source));
            }
            _ => {}
        }
    }
    Ok(())
}
