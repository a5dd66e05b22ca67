//! The plan of a build: its stages and tasks, and where their results are.

use std::fs;
use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};
use striata::simplify::cells::Partition;

use super::{BuildError, BuildInput, BuildOptions};
use crate::Metadata;

/// Version of the plan and of all part files.
const VERSION: u32 = 1;
/// Name of the plan in its folder.
pub(super) const PLAN_NAME: &str = "plan.json";
/// Name of the partition in the same folder.
const PARTITION_NAME: &str = "partition.bin";

/// One step of a build. A stage may begin when all tasks of the stages before it are done.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Stage {
    /// Read pieces of the input and sort their triangles into cells.
    Sort,
    /// Simplify the cells of a level.
    Level(u8),
    /// Encode the pages of a level.
    Encode(u8),
    /// Write the result.
    Finish,
}

/// One task: it reads results of earlier stages and writes one file.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Task {
    /// Stage that the task belongs to.
    pub stage: Stage,
    /// First piece or cell.
    pub first: u64,
    /// Number of pieces or cells.
    pub count: u64,
}

/// Everything that tasks need to know.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Plan {
    version: u32,
    /// What is read.
    pub input: BuildInput,
    /// How it is built.
    pub options: BuildOptions,
    /// What the result says about the mesh.
    pub metadata: Metadata,
    /// Where the result goes: a file, or a folder if the path ends in a separator or has no extension.
    pub output: PathBuf,
    /// All tasks, by stage.
    pub tasks: Vec<Task>,
    /// Folder of the plan and of the results of tasks.
    #[serde(skip)]
    pub folder: PathBuf,
    #[serde(skip)]
    partition: Option<Partition>,
}

/// What is known about an input once it has been read for the first time.
pub(super) struct Scanned {
    pub(super) metadata: Metadata,
    pub(super) partition: Partition,
    pub(super) piece_count: u64,
}

impl Plan {
    pub(super) fn new(
        (input, options): (BuildInput, BuildOptions),
        scanned: Scanned,
        (output, folder): (PathBuf, PathBuf),
    ) -> Self {
        let Scanned { metadata, partition, piece_count } = scanned;
        let mut tasks = Vec::new();
        let mut bundle = |stage: Stage, count: u64, size: u64| {
            for first in (0..count).step_by(size as usize) {
                tasks.push(Task { stage, first, count: size.min(count - first) });
            }
        };
        bundle(Stage::Sort, piece_count, options.pieces_per_task);
        let cells = |level: usize| u64::from(partition.levels()[level].cell_count());
        let level_count = partition.levels().len();
        for level in 0..level_count {
            bundle(Stage::Level(level as u8), cells(level), options.cells_per_task);
        }
        bundle(Stage::Encode(level_count as u8), 1, 1);
        for level in (0..level_count).rev() {
            bundle(Stage::Encode(level as u8), cells(level), options.cells_per_task);
        }
        bundle(Stage::Finish, 1, 1);
        Self { version: VERSION, input, options, metadata, output, tasks, folder, partition: Some(partition) }
    }

    /// Writes the plan into its folder.
    pub(super) fn save(&self) -> Result<(), BuildError> {
        let partition_path = self.folder.join(PARTITION_NAME);
        write_whole(&partition_path, &self.partition()?.to_bytes())?;
        let path = self.folder.join(PLAN_NAME);
        let json = serde_json::to_vec_pretty(self)
            .map_err(|error| BuildError::Plan { path: path.clone(), reason: error.to_string() })?;
        write_whole(&path, &json)
    }

    /// Reads a plan from its folder or its file.
    ///
    /// # Errors
    /// [`BuildError::Plan`] if it is not a plan of this version.
    pub fn open(path: &Path) -> Result<Self, BuildError> {
        let path = if path.is_dir() { path.join(PLAN_NAME) } else { path.to_owned() };
        let json = fs::read(&path).map_err(|source| BuildError::io(&path, source))?;
        let wrong = |reason: String| BuildError::Plan { path: path.clone(), reason };
        let mut plan: Self = serde_json::from_slice(&json).map_err(|error| wrong(error.to_string()))?;
        if plan.version != VERSION {
            return Err(wrong(format!("version {} instead of {VERSION}", plan.version)));
        }
        plan.folder = path.parent().unwrap_or(Path::new("")).to_owned();
        let partition_path = plan.folder.join(PARTITION_NAME);
        let bytes = fs::read(&partition_path).map_err(|source| BuildError::io(&partition_path, source))?;
        plan.partition = Partition::from_bytes(&bytes);
        if plan.partition.is_none() {
            return Err(BuildError::Damaged { path: partition_path });
        }
        Ok(plan)
    }

    /// The cells of all levels.
    pub(super) fn partition(&self) -> Result<&Partition, BuildError> {
        let missing = || BuildError::Damaged { path: self.folder.join(PARTITION_NAME) };
        self.partition.as_ref().ok_or_else(missing)
    }

    /// Number of levels of cells.
    pub fn level_count(&self) -> u8 {
        self.metadata.cell_counts.len() as u8
    }

    /// Tasks of a stage, with their numbers.
    pub fn tasks_of(&self, stage: Stage) -> impl Iterator<Item = (usize, &Task)> {
        self.tasks.iter().enumerate().filter(move |(_, task)| task.stage == stage)
    }

    /// The stages in order.
    pub fn stages(&self) -> Vec<Stage> {
        let mut stages: Vec<Stage> = self.tasks.iter().map(|task| task.stage).collect();
        stages.dedup();
        stages
    }

    /// File of triangles that a task writes, for the cells of later levels.
    pub(super) fn triangles_path(&self, task: &Task) -> PathBuf {
        match task.stage {
            Stage::Level(level) => self.folder.join(format!("level-{level}-{:08}.part", task.first)),
            _ => self.folder.join(format!("sort-{:08}.part", task.first)),
        }
    }

    /// File of steps that a task of a level writes.
    pub(super) fn steps_path(&self, level: u8, first: u64) -> PathBuf {
        self.folder.join(format!("steps-{level}-{first:08}.part"))
    }

    /// File of pages that a task writes.
    pub(super) fn pages_path(&self, level: u8, first: u64) -> PathBuf {
        self.folder.join(format!("pages-{level}-{first:08}.part"))
    }

    /// Whether a task has been run.
    pub fn is_done(&self, task: &Task) -> bool {
        match task.stage {
            Stage::Sort => self.triangles_path(task).exists(),
            Stage::Level(level) => {
                self.triangles_path(task).exists() && self.steps_path(level, task.first).exists()
            }
            Stage::Encode(level) => self.pages_path(level, task.first).exists(),
            Stage::Finish => self.is_finished(),
        }
    }

    /// Whether the result is complete.
    pub fn is_finished(&self) -> bool {
        self.folder.join("finished").exists()
    }

    pub(super) fn set_finished(&self) -> Result<(), BuildError> {
        write_whole(&self.folder.join("finished"), b"")
    }
}

/// Creates a file that disappears unless it is renamed, with the permissions of any other new file.
pub(super) fn temporary_in(folder: &Path) -> std::io::Result<tempfile::NamedTempFile> {
    let mut builder = tempfile::Builder::new();
    builder.prefix(".part-");
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    builder.tempfile_in(folder)
}

/// Writes a file beside its place and renames it.
pub(super) fn write_whole(path: &Path, bytes: &[u8]) -> Result<(), BuildError> {
    let failed = |source| BuildError::io(path, source);
    let folder = path.parent().unwrap_or(Path::new("."));
    let mut file = temporary_in(folder).map_err(failed)?;
    std::io::Write::write_all(&mut file, bytes).map_err(failed)?;
    file.persist(path).map_err(|error| failed(error.error))?;
    Ok(())
}
