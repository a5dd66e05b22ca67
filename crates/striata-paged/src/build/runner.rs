//! Runs the tasks of a plan, here and in parallel.

use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::{Mutex, mpsc};

use super::encode_task::{self, EncodeInputs};
use super::part_file::PartIndex;
use super::plan::{BuildStage, BuildTask, PagedPlan, TaskKind};
use super::{PagedBuildError, finish_task, simplify_task, sort_task};
use striata::{Cancelled, Progress, ProgressFn};

/// Callback that receives the number of finished tasks and can stop the others.
type TaskProgress<'p> = dyn FnMut(u64) -> Result<(), Cancelled> + 'p;

/// Calls `run` for every index, on several threads; the first error stops all of them.
pub(super) fn in_parallel(
    count: usize,
    threads: usize,
    progress: &mut TaskProgress<'_>,
    run: impl Fn(usize) -> Result<(), PagedBuildError> + Sync,
) -> Result<(), PagedBuildError> {
    let next = AtomicUsize::new(0);
    let is_stopped = AtomicBool::new(false);
    let failure = Mutex::new(None);
    std::thread::scope(|scope| {
        let (sender, receiver) = mpsc::channel();
        for _ in 0..threads.clamp(1, count.max(1)) {
            let sender = sender.clone();
            let (next, is_stopped, failure, run) = (&next, &is_stopped, &failure, &run);
            scope.spawn(move || {
                while !is_stopped.load(Ordering::Relaxed) {
                    let index = next.fetch_add(1, Ordering::Relaxed);
                    if index >= count {
                        break;
                    }
                    if let Err(error) = run(index) {
                        is_stopped.store(true, Ordering::Relaxed);
                        if let Ok(mut failure) = failure.lock() {
                            failure.get_or_insert(error);
                        }
                        break;
                    }
                    // After a failure, the receiver no longer exists.
                    let _ = sender.send(());
                }
            });
        }
        drop(sender);
        for (done, ()) in receiver.into_iter().enumerate() {
            if let Err(cancelled) = progress(done as u64 + 1) {
                is_stopped.store(true, Ordering::Relaxed);
                if let Ok(mut failure) = failure.lock() {
                    failure.get_or_insert(PagedBuildError::Cancelled(cancelled));
                }
            }
        }
    });
    failure.into_inner().ok().flatten().map_or(Ok(()), Err)
}

/// Runs all tasks that have not been run, on this many threads.
///
/// # Errors
/// [`PagedBuildError`] of the first task that fails. Completed tasks are kept, and a later run continues from them.
pub fn run_all(
    plan: &PagedPlan,
    threads: usize,
    progress: &mut ProgressFn<'_>,
) -> Result<(), PagedBuildError> {
    plan.stages().iter().try_for_each(|stage| run_stage(plan, stage, threads, progress))
}

/// Runs all tasks of a stage that have not been run.
///
/// # Errors
/// See [`run_all`]; also [`PagedBuildError::TaskOrder`] if an earlier stage is not complete.
pub fn run_stage(
    plan: &PagedPlan,
    stage: &BuildStage,
    threads: usize,
    progress: &mut ProgressFn<'_>,
) -> Result<(), PagedBuildError> {
    let tasks = plan.tasks.get(stage.tasks()).unwrap_or_default();
    let open: Vec<&BuildTask> = tasks.iter().filter(|task| !plan.is_done(task)).collect();
    let Some(first) = open.first() else { return Ok(()) };
    check_order(plan, stage.first_task)?;
    let inputs = StageInputs::open(plan, first.kind)?;
    let (name, before, total) = progress_of(plan, stage);
    let before = before + (tasks.len() - open.len()) as u64;
    let mut report = |done: u64| Progress { phase: name, done: before + done, total }.report(progress);
    in_parallel(open.len(), threads, &mut report, |index| inputs.run(plan, open[index]))?;
    // Data that was read while a file changed would mix both versions.
    if matches!(inputs, StageInputs::Sort(_)) { plan.check_inputs() } else { Ok(()) }
}

/// Runs one task, whether or not it has been run before. The result is the same.
///
/// # Errors
/// [`PagedBuildError::NoTask`] and [`PagedBuildError::TaskOrder`] if the task cannot be run, otherwise the reason why
/// it failed.
pub fn run_task(plan: &PagedPlan, number: usize) -> Result<(), PagedBuildError> {
    let count = plan.tasks.len();
    let task = plan.tasks.get(number).ok_or(PagedBuildError::NoTask { task: number, count })?;
    check_order(plan, number)?;
    StageInputs::open(plan, task.kind)?.run(plan, task)
}

/// Whether all stages before that of a task are complete.
fn check_order(plan: &PagedPlan, number: usize) -> Result<(), PagedBuildError> {
    let stages = plan.stages();
    let before = stages.iter().take_while(|stage| !stage.tasks().contains(&number));
    match before.flat_map(BuildStage::tasks).find(|&task| !plan.is_done(&plan.tasks[task])) {
        Some(needed) => Err(PagedBuildError::TaskOrder { task: number, needed }),
        None => Ok(()),
    }
}

/// Name of the part of a build that a stage belongs to, the number of tasks in earlier stages of this part, and of all
/// its tasks.
fn progress_of(plan: &PagedPlan, stage: &BuildStage) -> (&'static str, u64, u64) {
    let name = |name: &str| match name {
        "sort" => "sort",
        "encode" => "encode",
        "write" => "write",
        _ => "simplify",
    };
    let stages = plan.stages();
    let alike = || stages.iter().filter(|other| name(&other.name) == name(&stage.name));
    let sum = |count: usize, other: &BuildStage| count + other.task_count;
    let before = alike().take_while(|other| other.first_task < stage.first_task).fold(0, sum);
    (name(&stage.name), before as u64, alike().fold(0, sum) as u64)
}

/// Inputs that the tasks of a stage share.
enum StageInputs {
    Sort(Box<dyn striata_io::pieces::PieceSource>),
    Level(u8, PartIndex),
    Encode(EncodeInputs),
    Finish,
}

impl StageInputs {
    fn open(plan: &PagedPlan, kind: TaskKind) -> Result<Self, PagedBuildError> {
        Ok(match kind {
            TaskKind::Sort => {
                plan.check_inputs()?;
                Self::Sort(plan.input.open(&plan.options.piece_options(&plan.folder))?)
            }
            TaskKind::Level(level) => {
                let is_earlier = |task: &&BuildTask| match task.kind {
                    TaskKind::Sort => true,
                    TaskKind::Level(other) => other < level,
                    _ => false,
                };
                let parts = plan.tasks.iter().filter(is_earlier).map(|task| plan.triangles_path(task));
                Self::Level(level, PartIndex::open(parts)?)
            }
            TaskKind::Encode(_) => Self::Encode(EncodeInputs::open(plan)?),
            TaskKind::Finish => Self::Finish,
        })
    }

    fn run(&self, plan: &PagedPlan, task: &BuildTask) -> Result<(), PagedBuildError> {
        match self {
            Self::Sort(source) => sort_task::run(plan, task, source.as_ref()),
            Self::Level(level, parts) => simplify_task::run(plan, task, *level, parts),
            Self::Encode(inputs) => encode_task::run(plan, task, inputs),
            Self::Finish => {
                finish_task::run(plan)?;
                plan.set_finished()
            }
        }
    }
}
