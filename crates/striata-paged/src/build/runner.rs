//! Runs the tasks of a plan, here and in parallel.

use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::{Mutex, mpsc};

use super::encode_task::{self, EncodeInputs};
use super::part_file::PartIndex;
use super::plan::{Plan, Stage, Task};
use super::{BuildError, finish_task, simplify_task, sort_task};
use striata::{Cancelled, Progress, ProgressFn};
use striata_io::pieces::PieceOptions;

/// Told how many tasks are done; may stop the others.
pub(super) type TaskProgress<'p> = dyn FnMut(u64) -> Result<(), Cancelled> + 'p;

/// Calls `run` for every index, on several threads; the first error stops all.
pub(super) fn in_parallel(
    count: usize,
    (threads, progress): (usize, &mut TaskProgress<'_>),
    run: impl Fn(usize) -> Result<(), BuildError> + Sync,
) -> Result<(), BuildError> {
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
                    // Nobody listens after a failure.
                    let _ = sender.send(());
                }
            });
        }
        drop(sender);
        for (done, ()) in receiver.into_iter().enumerate() {
            if let Err(cancelled) = progress(done as u64 + 1) {
                is_stopped.store(true, Ordering::Relaxed);
                if let Ok(mut failure) = failure.lock() {
                    failure.get_or_insert(BuildError::Cancelled(cancelled));
                }
            }
        }
    });
    failure.into_inner().ok().flatten().map_or(Ok(()), Err)
}

/// Runs all tasks that have not been run, on this many threads.
///
/// # Errors
/// [`BuildError`] of the first task that fails. What other tasks have completed stays, and a later run goes on.
pub fn run_all(plan: &Plan, threads: usize, progress: &mut ProgressFn<'_>) -> Result<(), BuildError> {
    plan.stages().into_iter().try_for_each(|stage| run_stage(plan, stage, (threads, progress)))
}

/// Runs all tasks of a stage that have not been run.
///
/// # Errors
/// See [`run_all`]; also [`BuildError::TaskOrder`] if an earlier stage is not complete.
pub fn run_stage(
    plan: &Plan,
    stage: Stage,
    (threads, progress): (usize, &mut ProgressFn<'_>),
) -> Result<(), BuildError> {
    let open: Vec<(usize, &Task)> = plan.tasks_of(stage).filter(|(_, task)| !plan.is_done(task)).collect();
    let Some(&(first, _)) = open.first() else { return Ok(()) };
    check_order(plan, stage, first)?;
    let inputs = StageInputs::open(plan, stage)?;
    let (phase, before, total) = phase_of(plan, stage);
    let before = before + (plan.tasks_of(stage).count() - open.len()) as u64;
    let mut report = |done: u64| Progress { phase, done: before + done, total }.report(progress);
    in_parallel(open.len(), (threads, &mut report), |index| inputs.run(plan, open[index].1))
}

/// Runs one task, whether or not it has been run before. The result is the same.
///
/// # Errors
/// [`BuildError::NoTask`] and [`BuildError::TaskOrder`] if the task cannot be run, otherwise the reason why it
/// failed.
pub fn run_task(plan: &Plan, number: usize) -> Result<(), BuildError> {
    let count = plan.tasks.len();
    let task = plan.tasks.get(number).ok_or(BuildError::NoTask { task: number, count })?;
    check_order(plan, task.stage, number)?;
    StageInputs::open(plan, task.stage)?.run(plan, task)
}

/// Whether all stages before this one are complete.
fn check_order(plan: &Plan, stage: Stage, number: usize) -> Result<(), BuildError> {
    let earlier = plan.tasks.iter().enumerate().take_while(|(_, task)| task.stage != stage);
    // Pages need the steps of all levels, but not each other.
    let is_needed =
        |task: &Task| !(matches!(stage, Stage::Encode(_)) && matches!(task.stage, Stage::Encode(_)));
    match earlier.filter(|(_, task)| is_needed(task)).find(|(_, task)| !plan.is_done(task)) {
        Some((needed, _)) => Err(BuildError::TaskOrder { task: number, needed }),
        None => Ok(()),
    }
}

/// Name of the phase that a stage belongs to, the number of its tasks in earlier stages, and of all its tasks.
fn phase_of(plan: &Plan, stage: Stage) -> (&'static str, u64, u64) {
    let name = |stage: Stage| match stage {
        Stage::Sort => "sort",
        Stage::Level(_) => "simplify",
        Stage::Encode(_) => "encode",
        Stage::Finish => "write",
    };
    let tasks = || plan.tasks.iter().filter(|task| name(task.stage) == name(stage));
    let before = tasks().take_while(|task| task.stage != stage).count();
    (name(stage), before as u64, tasks().count() as u64)
}

/// What the tasks of a stage share.
enum StageInputs {
    Sort(Box<dyn striata_io::pieces::PieceSource>),
    Level(u8, PartIndex),
    Encode(u8, EncodeInputs),
    Finish,
}

impl StageInputs {
    fn open(plan: &Plan, stage: Stage) -> Result<Self, BuildError> {
        Ok(match stage {
            Stage::Sort => Self::Sort(plan.input.open(&piece_options(plan))?),
            Stage::Level(level) => {
                let is_earlier = |task: &&Task| match task.stage {
                    Stage::Sort => true,
                    Stage::Level(other) => other < level,
                    _ => false,
                };
                let parts = plan.tasks.iter().filter(is_earlier).map(|task| plan.triangles_path(task));
                Self::Level(level, PartIndex::open(parts)?)
            }
            Stage::Encode(level) => Self::Encode(level, EncodeInputs::open(plan)?),
            Stage::Finish => Self::Finish,
        })
    }

    fn run(&self, plan: &Plan, task: &Task) -> Result<(), BuildError> {
        match self {
            Self::Sort(source) => sort_task::run(plan, task, source.as_ref()),
            Self::Level(level, parts) => simplify_task::run(plan, task, *level, parts),
            Self::Encode(level, inputs) => encode_task::run(plan, task, *level, inputs),
            Self::Finish => {
                finish_task::run(plan)?;
                plan.set_finished()
            }
        }
    }
}

/// How the input of a plan is opened.
pub(super) fn piece_options(plan: &Plan) -> PieceOptions {
    PieceOptions::default().with_scratch(plan.folder.clone()).with_z_scale(plan.options.z_scale)
}
