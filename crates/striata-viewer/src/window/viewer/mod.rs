//! The viewer without its window: what is loaded, which level is requested, and when the picture must be
//! redrawn.

mod input;
#[cfg(test)]
mod tests;

use std::path::PathBuf;
use std::sync::Arc;
use std::time::Instant;

use egui::Rect;
use striata::view::Camera;
use striata_gpu::{GpuError, Look, Viewpoint};

use super::instance::{LevelRequest, ModelInstance};
use super::loader::{Job, JobProgress, Outcome, Task, Waker};
use super::orbit::Orbit;
use super::plots::{History, Sample};
use super::scene_renderer::{InspectionMode, SceneRenderer};
use super::state::{GoalKind, ViewerState};
use super::subject::Subject;
use striata_command::failure::Failure;
use striata_command::output::Output;

/// Area of the window in which the picture is drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct PictureArea {
    /// Rectangle in points.
    pub(super) rect: Rect,
    /// Size in pixels; 0 if there is no picture.
    pub(super) size: [u32; 2],
    pub(super) pixels_per_point: f32,
    pub(super) is_dark: bool,
}

/// Everything that the picture depends on, except the triangles.
#[derive(Clone, Debug, PartialEq)]
struct PictureInputs {
    viewpoint: Viewpoint,
    size: [u32; 2],
    look: Look,
    inspection_mode: InspectionMode,
}

/// Summary of a frame.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Frame {
    /// Whether the picture was redrawn.
    pub(super) is_drawn: bool,
    /// Whether the texture was replaced.
    pub(super) is_resized: bool,
    /// Whether another frame follows without input.
    pub(super) is_animated: bool,
}

/// State of the viewer.
pub(super) struct Viewer {
    pub(super) state: ViewerState,
    pub(super) orbit: Orbit,
    /// Files to choose from, and the index of the current one.
    pub(super) files: Vec<PathBuf>,
    pub(super) file: Option<usize>,
    /// The last failure, until it is dismissed.
    pub(super) failure: Option<Failure>,
    pub(super) history: History,
    pub(super) area: PictureArea,
    /// Name of the graphics adapter.
    pub(super) adapter: String,
    /// Whether the window should close.
    pub(super) quits: bool,
    subject: Option<Arc<Subject>>,
    instance: Option<ModelInstance>,
    job: Option<Job>,
    last_request: Option<LevelRequest>,
    /// Whether the triangles differ from those in the picture.
    is_new: bool,
    last_inputs: Option<PictureInputs>,
    output: Output,
    waker: Waker,
}

impl Viewer {
    /// Creates a viewer that opens the first of the files.
    pub(super) fn new(files: Vec<PathBuf>, state: ViewerState, (output, waker): (Output, Waker)) -> Self {
        let area = PictureArea { rect: Rect::NOTHING, size: [0, 0], pixels_per_point: 1.0, is_dark: true };
        let mut viewer = Self {
            state,
            orbit: Orbit::default(),
            files,
            file: None,
            failure: None,
            history: History::default(),
            area,
            adapter: String::new(),
            quits: false,
            subject: None,
            instance: None,
            job: None,
            last_request: None,
            is_new: false,
            last_inputs: None,
            output,
            waker,
        };
        if !viewer.files.is_empty() {
            viewer.choose(0);
        }
        viewer
    }

    /// The loaded subject.
    pub(super) fn subject(&self) -> Option<&Arc<Subject>> {
        self.subject.as_ref()
    }

    /// The instance of the shown model.
    pub(super) fn instance(&self) -> Option<&ModelInstance> {
        self.instance.as_ref()
    }

    /// The background task and its progress, if there is one.
    pub(super) fn work(&self) -> Option<(&Task, JobProgress)> {
        self.job.as_ref().map(|job| (job.task(), job.progress()))
    }

    /// Whether everything requested is on the screen or has failed.
    pub(super) fn is_idle(&self) -> bool {
        let is_shown =
            |instance: &ModelInstance| instance.kind() == self.state.model && !instance.is_moving();
        let is_done = self.instance.as_ref().is_some_and(is_shown) || self.failure.is_some();
        self.job.is_none() && (is_done || self.files.is_empty()) && !self.is_new
    }

    /// Opens one of the files by index.
    pub(super) fn choose(&mut self, file: usize) {
        let Some(path) = self.files.get(file).cloned() else { return };
        self.file = Some(file);
        self.failure = None;
        self.start(Task::Open(path, self.state.model));
    }

    /// Opens another file and adds it to the list.
    pub(super) fn open(&mut self, path: PathBuf) {
        let known = self.files.iter().position(|known| *known == path);
        let file = known.unwrap_or_else(|| {
            self.files.push(path);
            self.files.len() - 1
        });
        self.choose(file);
    }

    fn start(&mut self, task: Task) {
        // The previous job is dropped, which cancels it.
        self.job = Some(Job::start(task, self.output, Arc::clone(&self.waker)));
    }

    /// Shows a failure; the model shown before stays.
    pub(super) fn report_failure(&mut self, failure: Failure) {
        self.failure = Some(failure);
        if let Some(instance) = &self.instance {
            self.state.model = instance.kind();
        }
    }

    /// Takes the result of a finished job. A new subject must be uploaded before it is passed to
    /// [`set_subject`](Self::set_subject).
    pub(super) fn poll(&mut self) -> Option<Arc<Subject>> {
        let outcome: Outcome = self.job.as_ref()?.poll()?;
        let job = self.job.take()?;
        match (outcome, job.task()) {
            (Ok(subject), Task::Open(..)) => return Some(subject),
            (Ok(_), Task::Build(..)) => {}
            (Err(failure), _) => self.report_failure(failure),
        }
        None
    }

    /// Switches to another subject.
    pub(super) fn set_subject(&mut self, subject: Arc<Subject>) {
        self.state.on_new_model(subject.steps.mesh().triangle_count(), subject.has_collapses());
        self.orbit = Orbit::around(&subject.bounds, self.orbit.up());
        (self.instance, self.last_request, self.last_inputs) = (None, None, None);
        self.history.clear();
        self.subject = Some(subject);
    }

    /// Moves to the requested level, and starts building the model if it is missing.
    pub(super) fn follow(&mut self) {
        let Some(subject) = self.subject.clone() else { return };
        let kind = self.state.model;
        if self.instance.as_ref().is_none_or(|instance| instance.kind() != kind) {
            match ModelInstance::new(&subject, kind) {
                Some(instance) => (self.instance, self.last_request) = (Some(instance), None),
                None if self.job.is_none() => self.start(Task::Build(Arc::clone(&subject), kind)),
                None => {}
            }
        }
        let request = self.level_request();
        let Some(instance) = &mut self.instance else { return };
        if instance.is_moving() || self.last_request != Some(request) {
            self.is_new |= instance.follow(&subject, &request);
            self.last_request = Some(request);
        }
    }

    fn level_request(&self) -> LevelRequest {
        let is_of_view = matches!(self.state.goal, GoalKind::Pixels | GoalKind::Budget);
        let camera = if is_of_view { self.level_camera() } else { None };
        // Individual triangles are drawn at rest.
        let morphs = self.state.morphs && self.state.model.can_morph() && !self.state.needs_inspection();
        LevelRequest { goal: self.state.requested_level(), camera, morphs }
    }

    /// Camera for view-dependent levels; none if there is no picture.
    fn level_camera(&self) -> Option<Camera> {
        let (viewpoint, size) = match self.state.frozen {
            Some(frozen) => (frozen.viewpoint, frozen.size),
            None => (self.orbit.viewpoint(), self.area.size),
        };
        viewpoint.camera(size).ok()
    }

    /// Screen error of the shown level at the nearest point of the model, pixels; none if it is unbounded.
    pub(super) fn error_px(&self) -> Option<f32> {
        let (subject, achieved) = (self.subject.as_ref()?, self.instance.as_ref()?.achieved());
        let of_nearest =
            || self.level_camera().map(|camera| camera.error_px(achieved.error, &subject.sphere));
        achieved.error_px.or_else(of_nearest).filter(|pixels| pixels.is_finite())
    }

    /// Draws the picture if it differs from the last one.
    ///
    /// # Errors
    /// If a buffer or texture exceeds the device's limits.
    pub(super) fn draw(&mut self, renderer: &mut SceneRenderer, started: Instant) -> Result<Frame, GpuError> {
        let mut frame = Frame { is_animated: self.state.auto_rotates, ..Frame::default() };
        if self.area.size.contains(&0) {
            return Ok(Frame::default());
        }
        let inspection_mode = if self.state.needs_inspection() {
            InspectionMode::By(self.state.effective_colors())
        } else {
            InspectionMode::Off
        };
        let inputs = PictureInputs {
            viewpoint: self.orbit.viewpoint(),
            size: self.area.size,
            look: self.state.look(self.area.is_dark, self.area.pixels_per_point),
            inspection_mode,
        };
        frame.is_animated |= self.instance.as_ref().is_some_and(ModelInstance::is_moving);
        if !self.is_new && self.last_inputs.as_ref() == Some(&inputs) {
            return Ok(frame);
        }
        let bytes_before = renderer.uploaded_bytes();
        if let (Some(subject), Some(instance)) = (&self.subject, &mut self.instance) {
            renderer.update(subject, instance, (inspection_mode, self.is_new))?;
        }
        frame.is_resized = renderer.draw(&inputs.viewpoint, inputs.size, &inputs.look)?;
        frame.is_drawn = true;
        if let Some(instance) = &self.instance {
            self.history.push(Sample {
                frame_secs: started.elapsed().as_secs_f64(),
                level_secs: if self.is_new { instance.achieved().secs } else { 0.0 },
                triangle_count: instance.achieved().triangle_count,
                uploaded_bytes: renderer.uploaded_bytes() - bytes_before,
            });
        }
        (self.is_new, self.last_inputs) = (false, Some(inputs));
        Ok(frame)
    }
}
