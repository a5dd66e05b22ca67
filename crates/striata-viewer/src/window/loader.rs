//! Reads files and builds models on a background thread, while the window stays responsive.

use std::ops::ControlFlow;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{Receiver, Sender, channel};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::{Duration, Instant};

use striata::mesh::{IndexedMesh, weld};
use striata::{Progress, ProgressFn};

use super::args::ShownModel;
use super::mesh_subject::{MeshSubject, StoredModels};
use super::open_scene::SceneContent;
use super::subject::{Origin, Subject};
use crate::picture::has_materials;
use striata_command::failure::Failure;
use striata_command::input::Input;
use striata_command::output::Output;
use striata_command::sequence::SequencePlan;

/// Callback that wakes the window.
pub(super) type Waker = Arc<dyn Fn() + Send + Sync>;

/// A background job.
#[derive(Clone, Debug)]
pub(super) enum Task {
    /// Opens a file, and builds the model to show first if it is not shown as a scene.
    Open(PathBuf, OpenAs),
    /// Builds another model of the current mesh.
    Build(Arc<MeshSubject>, ShownModel),
}

/// How a file is opened.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct OpenAs {
    /// Whether a scene is shown as it is, rather than as one mesh.
    pub scene: bool,
    /// Model of everything that is shown as one mesh.
    pub model: ShownModel,
}

/// Result of a job: the subject with the model, or the failure to show.
pub(super) type Outcome = Result<Subject, Failure>;

/// A background job. Dropping it cancels the work and discards its result.
#[derive(Debug)]
pub(super) struct Job {
    task: Task,
    result: Receiver<Outcome>,
    progress: Arc<Mutex<JobProgress>>,
    is_canceled: Arc<AtomicBool>,
}

/// Progress of a job: its phase, and the completed fraction of the phase.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct JobProgress {
    pub phase: &'static str,
    /// 0 to 1, or none if unknown.
    pub share: Option<f32>,
}

/// Minimum time between two wake-ups for progress.
const WAKE_INTERVAL: Duration = Duration::from_millis(40);

impl Job {
    /// Starts a job on a new thread.
    pub(super) fn start(task: Task, output: Output, waker: Waker) -> Self {
        let (sender, result) = channel();
        let (progress, is_canceled) = (Arc::default(), Arc::default());
        let reporter = Reporter {
            progress: Arc::clone(&progress),
            is_canceled: Arc::clone(&is_canceled),
            waker,
            last_wake: Instant::now(),
        };
        let job = Self { task: task.clone(), result, progress, is_canceled };
        std::thread::spawn(move || work(&task, &output, reporter, &sender));
        job
    }

    /// The job's task.
    pub(super) fn task(&self) -> &Task {
        &self.task
    }

    /// Current progress.
    pub(super) fn progress(&self) -> JobProgress {
        *self.progress.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Result of the job, once it is done.
    pub(super) fn poll(&self) -> Option<Outcome> {
        match self.result.try_recv() {
            Ok(outcome) => Some(outcome),
            Err(std::sync::mpsc::TryRecvError::Empty) => None,
            // The thread has panicked, and the panic was already reported.
            Err(std::sync::mpsc::TryRecvError::Disconnected) => {
                Some(Err(Failure::internal("the loader thread has panicked")))
            }
        }
    }
}

impl Drop for Job {
    fn drop(&mut self) {
        self.is_canceled.store(true, Ordering::Relaxed);
    }
}

fn work(task: &Task, output: &Output, mut reporter: Reporter, sender: &Sender<Outcome>) {
    let outcome = match task {
        Task::Open(path, open_as) => open(path, *open_as, output, &mut reporter),
        Task::Build(subject, model) => {
            reporter.phase("models");
            subject.build(*model).map(|()| Subject::Mesh(Arc::clone(subject)))
        }
    };
    // The receiver is gone if the job was dropped.
    let _ = sender.send(outcome);
    (reporter.waker)();
}

/// Reports progress and checks for cancellation.
pub(super) struct Reporter {
    progress: Arc<Mutex<JobProgress>>,
    is_canceled: Arc<AtomicBool>,
    waker: Waker,
    last_wake: Instant,
}

impl Reporter {
    pub(super) fn phase(&mut self, phase: &'static str) {
        self.set(JobProgress { phase, share: None });
        (self.waker)();
    }

    pub(super) fn show(&mut self, progress: Progress) -> ControlFlow<()> {
        let share = (progress.total > 0).then(|| progress.done as f32 / progress.total as f32);
        self.set(JobProgress { phase: progress.phase, share });
        if self.last_wake.elapsed() > WAKE_INTERVAL {
            self.last_wake = Instant::now();
            (self.waker)();
        }
        if self.is_canceled.load(Ordering::Relaxed) {
            ControlFlow::Break(())
        } else {
            ControlFlow::Continue(())
        }
    }

    fn set(&self, progress: JobProgress) {
        *self.progress.lock().unwrap_or_else(PoisonError::into_inner) = progress;
    }
}

/// Reads a scene, or a mesh; simplifies what has no levels.
fn open(path: &Path, open_as: OpenAs, output: &Output, reporter: &mut Reporter) -> Result<Subject, Failure> {
    reporter.phase("read");
    let input = Input::open(path)?;
    let kind = input.scene_kind();
    let origin = Origin {
        name: input.file_name(),
        kind: input.kind(),
        file_bytes: input.file_bytes(),
        has_scene: kind.is_some() && !open_as.scene,
    };
    if let Some(kind) = kind.filter(|_| open_as.scene)
        && let Some(content) = SceneContent::read(&input, kind, output)?
    {
        return scene(content, origin, output, reporter);
    }
    let subject = if input.has_levels() {
        let file = input.striata()?;
        let has_materials = file.mesh().is_ok_and(|mesh| has_materials(&mesh));
        if has_materials && open_as.scene && file.has_collapses() {
            let content = SceneContent::Levels(input.received_scene(output)?.lods);
            return scene(content, origin, output, reporter);
        }
        let origin = Origin { has_scene: has_materials, ..origin };
        read_levels(&input, origin, output, reporter)?
    } else {
        let mesh = input.mesh(output)?;
        let origin = Origin { has_scene: origin.has_scene || has_materials(&mesh), ..origin };
        let mesh = if open_as.scene {
            match SceneContent::of_mesh(&input, mesh)? {
                Ok(content) => return scene(content, origin, output, reporter),
                Err(mesh) => mesh,
            }
        } else {
            mesh
        };
        simplified(&input, &mesh, origin, reporter)?
    };
    reporter.phase("models");
    let is_usable = subject.has_collapses() || !open_as.model.needs_collapses();
    subject.build(if is_usable { open_as.model } else { ShownModel::Fans })?;
    Ok(Subject::Mesh(Arc::new(subject)))
}

/// Prepares a scene.
fn scene(
    content: SceneContent,
    origin: Origin,
    output: &Output,
    reporter: &mut Reporter,
) -> Result<Subject, Failure> {
    let origin = Origin { has_scene: true, ..origin };
    Ok(Subject::Scene(Arc::new(content.into_subject(origin, output, reporter)?)))
}

/// Simplifies a mesh.
fn simplified(
    input: &Input,
    mesh: &IndexedMesh,
    origin: Origin,
    reporter: &mut Reporter,
) -> Result<MeshSubject, Failure> {
    let blame = |failure: Failure| failure.in_file(&input.name);
    reporter.phase("weld");
    let welded = weld(mesh).map_err(|error| blame(error.into()))?;
    let progress: &mut ProgressFn<'_> = &mut |progress| reporter.show(progress);
    let sequenced = SequencePlan::default().run(welded, progress).map_err(|error| blame(error.into()))?;
    Ok(MeshSubject::new(origin, sequenced.steps, StoredModels::default()))
}

/// Reads the mesh, the steps and the models of a file into memory of their own.
fn read_levels(
    input: &Input,
    origin: Origin,
    output: &Output,
    reporter: &mut Reporter,
) -> Result<MeshSubject, Failure> {
    let file = input.striata()?;
    let damaged = |error| input.damaged(&error);
    input.remark_on(&file, output)?;
    let steps = file.steps().map_err(damaged)?;
    reporter.phase("check");
    let models = StoredModels {
        strips: file.strips().transpose().map_err(damaged)?,
        lod_strips: file.lod_strips().transpose().map_err(damaged)?.map(|model| model.into_owned()),
        mts: file.mts().transpose().map_err(damaged)?.map(|model| model.into_owned()),
        fans: file.fans().transpose().map_err(damaged)?,
        patterns: file.patterns().transpose().map_err(damaged)?,
    };
    Ok(MeshSubject::new(origin, steps, models))
}
