//! Files read and models built on a thread of their own, while the window stays alive.

use std::ops::ControlFlow;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{Receiver, Sender, channel};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::{Duration, Instant};

use striata::mesh::weld;
use striata::{Progress, ProgressFn};

use super::args::ShownModel;
use super::subject::{Origin, StoredModels, Subject};
use striata_command::failure::Failure;
use striata_command::input::Input;
use striata_command::output::Output;
use striata_command::sequence::{SequencePlan, Steps};

/// Lets the window know that something has come.
pub(super) type Waker = Arc<dyn Fn() + Send + Sync>;

/// What a job is for.
#[derive(Clone, Debug)]
pub(super) enum Task {
    /// A file, with the model that is to be shown first.
    Open(PathBuf, ShownModel),
    /// A model of what is shown.
    Build(Arc<Subject>, ShownModel),
}

/// What a job came to: the subject with its model, or the failure that people are told of.
pub(super) type Outcome = Result<Arc<Subject>, Failure>;

/// Work that goes on. Dropped, it stops at the next occasion, and what it made is forgotten.
#[derive(Debug)]
pub(super) struct Job {
    task: Task,
    result: Receiver<Outcome>,
    progress: Arc<Mutex<Stage>>,
    is_cancelled: Arc<AtomicBool>,
}

/// How far a job is: what is being done, and the share of that.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Stage {
    pub(super) phase: &'static str,
    /// 0 to 1; none where nobody knows.
    pub(super) share: Option<f32>,
}

/// Seldom enough to cost nothing, often enough for the eye.
const BETWEEN_WAKES: Duration = Duration::from_millis(40);

impl Job {
    /// Begins.
    pub(super) fn start(task: Task, output: Output, waker: Waker) -> Self {
        let (sender, result) = channel();
        let (progress, is_cancelled) = (Arc::default(), Arc::default());
        let reporter = Reporter {
            stage: Arc::clone(&progress),
            is_cancelled: Arc::clone(&is_cancelled),
            waker,
            last_wake: Instant::now(),
        };
        let job = Self { task: task.clone(), result, progress, is_cancelled };
        std::thread::spawn(move || work(&task, &output, reporter, &sender));
        job
    }

    /// What it is for.
    pub(super) fn task(&self) -> &Task {
        &self.task
    }

    /// How far it is.
    pub(super) fn stage(&self) -> Stage {
        *self.progress.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// What it came to, once it is done.
    pub(super) fn poll(&self) -> Option<Outcome> {
        match self.result.try_recv() {
            Ok(outcome) => Some(outcome),
            Err(std::sync::mpsc::TryRecvError::Empty) => None,
            // The thread is gone without a word: it panicked, and has said so.
            Err(std::sync::mpsc::TryRecvError::Disconnected) => {
                Some(Err(Failure::internal("the thread that loads has failed")))
            }
        }
    }
}

impl Drop for Job {
    fn drop(&mut self) {
        self.is_cancelled.store(true, Ordering::Relaxed);
    }
}

fn work(task: &Task, output: &Output, mut reporter: Reporter, sender: &Sender<Outcome>) {
    let outcome = match task {
        Task::Open(path, model) => open(path, *model, output, &mut reporter).map(Arc::new),
        Task::Build(subject, model) => {
            reporter.phase("models");
            subject.build(*model).map(|()| Arc::clone(subject))
        }
    };
    // Nobody listens any more where the job was dropped.
    let _ = sender.send(outcome);
    (reporter.waker)();
}

/// Tells how far the work is.
struct Reporter {
    stage: Arc<Mutex<Stage>>,
    is_cancelled: Arc<AtomicBool>,
    waker: Waker,
    last_wake: Instant,
}

impl Reporter {
    fn phase(&mut self, phase: &'static str) {
        self.set(Stage { phase, share: None });
        (self.waker)();
    }

    fn show(&mut self, progress: Progress) -> ControlFlow<()> {
        let share = (progress.total > 0).then(|| progress.done as f32 / progress.total as f32);
        self.set(Stage { phase: progress.phase, share });
        if self.last_wake.elapsed() > BETWEEN_WAKES {
            self.last_wake = Instant::now();
            (self.waker)();
        }
        if self.is_cancelled.load(Ordering::Relaxed) {
            ControlFlow::Break(())
        } else {
            ControlFlow::Continue(())
        }
    }

    fn set(&self, stage: Stage) {
        *self.stage.lock().unwrap_or_else(PoisonError::into_inner) = stage;
    }
}

/// Reads a file of levels, or a mesh and makes its levels.
fn open(
    path: &Path,
    model: ShownModel,
    output: &Output,
    reporter: &mut Reporter,
) -> Result<Subject, Failure> {
    reporter.phase("read");
    let input = Input::open(path)?;
    let origin = Origin { name: input.file_name(), kind: input.kind(), file_bytes: input.file_bytes() };
    let subject = if input.has_levels() {
        read_levels(&input, origin, output, reporter)?
    } else {
        let mesh = input.mesh(output)?;
        let blame = |failure: Failure| failure.in_file(&input.name);
        reporter.phase("weld");
        let welded = weld(&mesh).map_err(|error| blame(error.into()))?;
        let progress: &mut ProgressFn<'_> = &mut |progress| reporter.show(progress);
        let sequenced = SequencePlan::default().run(welded, progress).map_err(|error| blame(error.into()))?;
        Subject::new(origin, sequenced.steps, StoredModels::default())
    };
    reporter.phase("models");
    subject.build(if subject.has_collapses() { model } else { ShownModel::Patterns })?;
    Ok(subject)
}

/// Takes mesh, steps and models out of a file, each in memory of its own.
fn read_levels(
    input: &Input,
    origin: Origin,
    output: &Output,
    reporter: &mut Reporter,
) -> Result<Subject, Failure> {
    let file = input.striata()?;
    let damaged = |error| input.damaged(&error);
    input.remark_on(&file, output)?;
    let steps = if file.has_collapses() {
        Steps::Collapses(file.refinable_mesh().map_err(damaged)?)
    } else {
        Steps::Fragments(file.fragmented_mesh().map_err(damaged)?)
    };
    reporter.phase("check");
    let models = StoredModels {
        strips: file.strips().transpose().map_err(damaged)?,
        lod_strips: file.lod_strips().transpose().map_err(damaged)?.map(|model| model.into_owned()),
        mts: file.mts().transpose().map_err(damaged)?.map(|model| model.into_owned()),
        fans: file.fans().transpose().map_err(damaged)?,
        patterns: file.patterns().transpose().map_err(damaged)?,
    };
    Ok(Subject::new(origin, steps, models))
}
