//! The plan of a build: its stages and tasks, and where their results are.

use std::fs;
use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};
use striata::simplify::cells::Partition;

use super::input::{InputState, check_inputs};
use super::weld::WeldMap;
use super::{BuildInput, BuildOptions, BuildPaths, PagedBuildError};
use crate::Metadata;

/// Version of the plan and of all part files.
const VERSION: u32 = 1;
/// Minimum number of tasks of a stage that has at least as many cells.
const MIN_TASKS: u64 = 16;
/// Name of the plan in its folder.
const PLAN_NAME: &str = "plan.json";
/// Name of the file of welded positions in the same folder.
const WELD_NAME: &str = "weld.bin";
/// Name of the file of the partition in the same folder.
const PARTITION_NAME: &str = "partition.bin";

/// Work of a task.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum TaskKind {
    /// Read pieces of the input and sort their triangles into cells.
    Sort,
    /// Simplify the cells of a level.
    Level(u8),
    /// Encode the pages of a level.
    Encode(u8),
    /// Write the result.
    Finish,
}

impl TaskKind {
    /// Name of its stage. Pages of all levels may be encoded at the same time.
    pub(super) fn stage(self) -> String {
        match self {
            Self::Sort => "sort".to_owned(),
            Self::Level(level) => format!("simplify level {level}"),
            Self::Encode(_) => "encode".to_owned(),
            Self::Finish => "write".to_owned(),
        }
    }
}

/// One task: it reads results of earlier stages and writes one file.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct BuildTask {
    /// Work of the task.
    pub kind: TaskKind,
    /// First piece or cell.
    pub first: u64,
    /// Number of pieces or cells.
    pub count: u64,
}

/// Tasks that may run in any order and at the same time, when all tasks of the stages before are done.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct BuildStage {
    /// Name: `sort`, `simplify level 2`, `encode`, `write`.
    pub name: String,
    /// Number of the first task.
    pub first_task: usize,
    /// Number of tasks, which are numbered consecutively.
    pub task_count: usize,
}

impl BuildStage {
    /// Numbers of the tasks.
    pub fn tasks(&self) -> std::ops::Range<usize> {
        self.first_task..self.first_task + self.task_count
    }
}

/// Input, options, metadata and tasks of a build.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct PagedPlan {
    version: u32,
    /// Input that is read.
    pub input: BuildInput,
    /// The files of the input, as they were when the plan was made.
    inputs: Vec<InputState>,
    /// Options of the build.
    pub options: BuildOptions,
    /// Metadata of the mesh, which the result contains.
    pub metadata: Metadata,
    /// Path of the result: a file, or a folder if the path ends in a separator or has no extension.
    pub output: PathBuf,
    /// All tasks, by stage.
    pub tasks: Vec<BuildTask>,
    /// Folder of the plan and of the results of tasks.
    #[serde(skip)]
    pub folder: PathBuf,
    /// Warnings about parts left out when the input was read for the plan; empty for a plan that is opened again.
    #[serde(skip)]
    pub warnings: Vec<striata_io::Warning>,
    /// Remarks on how positions are stored and welded; empty for a plan that is opened again.
    #[serde(skip)]
    pub notes: Vec<String>,
    #[serde(skip)]
    partition: Option<Partition>,
    #[serde(skip)]
    weld: WeldMap,
}

/// Facts about an input that are known after the first pass over it.
pub(super) struct Scanned {
    pub metadata: Metadata,
    pub partition: Partition,
    pub piece_count: u64,
    /// Remarks on how positions are stored and welded.
    pub notes: Vec<String>,
    /// Positions that are welded to others, if a distance was given.
    pub weld: Option<WeldMap>,
}

impl PagedPlan {
    pub(super) fn new(
        input: BuildInput,
        inputs: Vec<InputState>,
        options: BuildOptions,
        scanned: Scanned,
        paths: BuildPaths<'_>,
    ) -> Self {
        let Scanned { metadata, partition, piece_count, notes, weld } = scanned;
        let mut tasks = Vec::new();
        let mut bundle = |kind: TaskKind, count: u64, size: u64| {
            for first in (0..count).step_by(size as usize) {
                tasks.push(BuildTask { kind, first, count: size.min(count - first) });
            }
        };
        bundle(TaskKind::Sort, piece_count, options.pieces_per_task.max(1));
        // Coarse levels have few cells: if one task had all of them, the other workers would be idle.
        let cells_per_task = |cells: u64| cells.div_ceil(MIN_TASKS).clamp(1, options.cells_per_task.max(1));
        let cells = |level: usize| u64::from(partition.levels()[level].cell_count());
        let level_count = partition.levels().len();
        for level in 0..level_count {
            bundle(TaskKind::Level(level as u8), cells(level), cells_per_task(cells(level)));
        }
        bundle(TaskKind::Encode(level_count as u8), 1, 1);
        for level in (0..level_count).rev() {
            bundle(TaskKind::Encode(level as u8), cells(level), cells_per_task(cells(level)));
        }
        bundle(TaskKind::Finish, 1, 1);
        let (version, partition, warnings) = (VERSION, Some(partition), Vec::new());
        let weld = weld.unwrap_or_default();
        Self {
            version,
            input,
            inputs,
            options,
            metadata,
            output: paths.output.to_owned(),
            tasks,
            folder: paths.folder.to_owned(),
            warnings,
            notes,
            partition,
            weld,
        }
    }

    /// Writes the plan into its folder.
    pub(super) fn save(&self) -> Result<(), PagedBuildError> {
        let partition_path = self.folder.join(PARTITION_NAME);
        write_whole(&partition_path, &self.partition()?.to_bytes())?;
        if self.options.weld_distance.is_some() {
            write_whole(&self.folder.join(WELD_NAME), &self.weld.to_bytes())?;
        }
        for (index, image) in (0..).zip(&self.metadata.images).filter(|(_, image)| image.byte_count > 0) {
            write_whole(&self.image_path(index), &image.bytes)?;
        }
        let path = self.folder.join(PLAN_NAME);
        let json = serde_json::to_vec_pretty(self)
            .map_err(|error| PagedBuildError::Plan { path: path.clone(), reason: error.to_string() })?;
        write_whole(&path, &json)
    }

    /// Reads a plan from its folder or its file.
    ///
    /// # Errors
    /// [`PagedBuildError::Plan`] if it is not a plan of this version.
    pub fn open(path: &Path) -> Result<Self, PagedBuildError> {
        let path = if path.is_dir() { path.join(PLAN_NAME) } else { path.to_owned() };
        let json = fs::read(&path).map_err(|source| PagedBuildError::io(&path, source))?;
        let wrong = |reason: String| PagedBuildError::Plan { path: path.clone(), reason };
        let mut plan: Self = serde_json::from_slice(&json).map_err(|error| wrong(error.to_string()))?;
        if plan.version != VERSION {
            return Err(wrong(format!("version {} instead of {VERSION}", plan.version)));
        }
        plan.folder = path.parent().unwrap_or(Path::new("")).to_owned();
        let partition_path = plan.folder.join(PARTITION_NAME);
        let bytes =
            fs::read(&partition_path).map_err(|source| PagedBuildError::io(&partition_path, source))?;
        plan.partition = Partition::from_bytes(&bytes);
        if plan.partition.is_none() {
            return Err(PagedBuildError::Damaged { path: partition_path });
        }
        if plan.options.weld_distance.is_some() {
            let path = plan.folder.join(WELD_NAME);
            let bytes = fs::read(&path).map_err(|source| PagedBuildError::io(&path, source))?;
            plan.weld = WeldMap::from_bytes(&bytes).ok_or(PagedBuildError::Damaged { path })?;
        }
        Ok(plan)
    }

    /// Compares the files of the input with what they were when the plan was made.
    ///
    /// # Errors
    /// [`PagedBuildError::InputChanged`] with the first file that differs.
    pub fn check_inputs(&self) -> Result<(), PagedBuildError> {
        check_inputs(&self.inputs)
    }

    /// Positions that are welded to others.
    pub(super) fn weld(&self) -> &WeldMap {
        &self.weld
    }

    /// The cells of all levels.
    pub(super) fn partition(&self) -> Result<&Partition, PagedBuildError> {
        let missing = || PagedBuildError::Damaged { path: self.folder.join(PARTITION_NAME) };
        self.partition.as_ref().ok_or_else(missing)
    }

    /// Number of levels of cells.
    pub fn level_count(&self) -> u8 {
        self.metadata.cell_counts.len() as u8
    }

    /// The stages in order.
    pub fn stages(&self) -> Vec<BuildStage> {
        let mut stages: Vec<BuildStage> = Vec::new();
        for (number, task) in self.tasks.iter().enumerate() {
            let name = task.kind.stage();
            match stages.last_mut() {
                Some(last) if last.name == name => last.task_count += 1,
                _ => stages.push(BuildStage { name, first_task: number, task_count: 1 }),
            }
        }
        stages
    }

    /// File of triangles that a task writes, for the cells of later levels.
    pub(super) fn triangles_path(&self, task: &BuildTask) -> PathBuf {
        match task.kind {
            TaskKind::Level(level) => self.folder.join(format!("level-{level}-{:08}.part", task.first)),
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

    /// File of an image of the input.
    pub(super) fn image_path(&self, index: u32) -> PathBuf {
        self.folder.join(format!("image-{index:08}.part"))
    }

    /// Whether a task has been run.
    pub fn is_done(&self, task: &BuildTask) -> bool {
        match task.kind {
            TaskKind::Sort => self.triangles_path(task).exists(),
            TaskKind::Level(level) => {
                self.triangles_path(task).exists() && self.steps_path(level, task.first).exists()
            }
            TaskKind::Encode(level) => self.pages_path(level, task.first).exists(),
            TaskKind::Finish => self.is_finished(),
        }
    }

    /// Whether the result is complete.
    pub fn is_finished(&self) -> bool {
        self.folder.join("finished").exists()
    }

    pub(super) fn set_finished(&self) -> Result<(), PagedBuildError> {
        write_whole(&self.folder.join("finished"), b"")
    }
}

/// Creates a temporary file, which is removed unless it is renamed, with the permissions of an ordinary new file.
pub(super) fn temporary_in(folder: &Path) -> std::io::Result<tempfile::NamedTempFile> {
    let mut builder = tempfile::Builder::new();
    builder.prefix(".part-");
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    builder.tempfile_in(folder)
}

/// Writes a file under a temporary name in the same folder, and renames it.
pub(super) fn write_whole(path: &Path, bytes: &[u8]) -> Result<(), PagedBuildError> {
    let failed = |source| PagedBuildError::io(path, source);
    let folder = path.parent().unwrap_or(Path::new("."));
    let mut file = temporary_in(folder).map_err(failed)?;
    std::io::Write::write_all(&mut file, bytes).map_err(failed)?;
    file.persist(path).map_err(|error| failed(error.error))?;
    Ok(())
}
