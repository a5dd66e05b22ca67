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

use super::args::ShownModel;
use super::instance::{AchievedLevel, LevelRequest, ModelInstance};
use super::loader::{Job, JobProgress, OpenAs, Outcome, Task, Waker};
use super::mesh_subject::MeshSubject;
use super::orbit::{Orbit, Up};
use super::plots::{PlotHistory, Sample};
use super::scene::{Playback, SceneRequest, SceneSubject, ShownScene};
use super::scene_renderer::{InspectionMode, SceneRenderer};
use super::state::{GoalKind, ViewerState};
use super::subject::Subject;
use striata_command::args::PoseArgs;
use striata_command::failure::Failure;
use striata_command::output::Output;

/// Area of the window in which the picture is drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct PictureArea {
    /// Rectangle in points.
    pub rect: Rect,
    /// Size in pixels; 0 if there is no picture.
    pub size: [u32; 2],
    pub pixels_per_point: f32,
    pub is_dark: bool,
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
    pub is_drawn: bool,
    /// Whether the texture was replaced.
    pub is_resized: bool,
    /// Whether another frame follows without input.
    pub is_animated: bool,
}

/// Content of the picture, at the level and in the pose of the last request.
enum Shown {
    Mesh { instance: Box<ModelInstance>, request: Option<LevelRequest> },
    Scene { scene: Box<ShownScene>, request: Option<SceneRequest> },
}

/// State of the viewer.
pub(super) struct Viewer {
    pub state: ViewerState,
    pub orbit: Orbit,
    /// Files to choose from, and the index of the current one.
    pub files: Vec<PathBuf>,
    pub file: Option<usize>,
    /// The last failure, until it is dismissed.
    pub failure: Option<Failure>,
    pub history: PlotHistory,
    pub area: PictureArea,
    /// Name of the graphics adapter.
    pub adapter: String,
    /// Whether the window should close.
    pub quits: bool,
    /// Animation of the scene, if the subject is one.
    pub playback: Playback,
    /// Pose of the first subject, until it is loaded.
    pub first_pose: Option<PoseArgs>,
    subject: Option<Subject>,
    shown: Option<Shown>,
    job: Option<Job>,
    /// Whether the triangles differ from those in the picture.
    is_new: bool,
    last_inputs: Option<PictureInputs>,
    output: Output,
    waker: Waker,
}

impl Viewer {
    /// Creates a viewer that opens the first of the files.
    pub(super) fn new(files: Vec<PathBuf>, state: ViewerState, output: Output, waker: Waker) -> Self {
        let area = PictureArea { rect: Rect::NOTHING, size: [0, 0], pixels_per_point: 1.0, is_dark: true };
        let mut viewer = Self {
            state,
            orbit: Orbit::default(),
            files,
            file: None,
            failure: None,
            history: PlotHistory::default(),
            area,
            adapter: String::new(),
            quits: false,
            playback: Playback::default(),
            first_pose: None,
            subject: None,
            shown: None,
            job: None,
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
    pub(super) fn subject(&self) -> Option<&Subject> {
        self.subject.as_ref()
    }

    /// The instance of the shown model, if one mesh is shown.
    pub(super) fn instance(&self) -> Option<&ModelInstance> {
        match &self.shown {
            Some(Shown::Mesh { instance, .. }) => Some(instance),
            _ => None,
        }
    }

    /// The scene and what is shown of it, if a scene is shown.
    pub(super) fn scene(&self) -> Option<(&Arc<SceneSubject>, &ShownScene)> {
        match (&self.subject, &self.shown) {
            (Some(Subject::Scene(subject)), Some(Shown::Scene { scene, .. })) => Some((subject, scene)),
            _ => None,
        }
    }

    /// The scene and what is shown of it, for changes by the user.
    pub(super) fn scene_mut(&mut self) -> Option<(Arc<SceneSubject>, &mut ShownScene, &mut Playback)> {
        match (&self.subject, &mut self.shown) {
            (Some(Subject::Scene(subject)), Some(Shown::Scene { scene, .. })) => {
                Some((Arc::clone(subject), scene, &mut self.playback))
            }
            _ => None,
        }
    }

    /// The level of what is shown.
    pub(super) fn achieved(&self) -> Option<&AchievedLevel> {
        match self.shown.as_ref()? {
            Shown::Mesh { instance, .. } => Some(instance.achieved()),
            Shown::Scene { scene, .. } => Some(scene.achieved()),
        }
    }

    /// The background task and its progress, if there is one.
    pub(super) fn work(&self) -> Option<(&Task, JobProgress)> {
        self.job.as_ref().map(|job| (job.task(), job.progress()))
    }

    /// Whether everything requested is on the screen or has failed.
    pub(super) fn is_idle(&self) -> bool {
        let is_shown = self.shown.as_ref().is_some_and(|shown| match shown {
            Shown::Mesh { instance, .. } => instance.kind() == self.state.model && !instance.is_moving(),
            Shown::Scene { .. } => !self.playback.is_playing,
        });
        let is_done = is_shown || self.failure.is_some();
        self.job.is_none() && (is_done || self.files.is_empty()) && !self.is_new
    }

    /// Opens one of the files by index.
    pub(super) fn choose(&mut self, file: usize) {
        let Some(path) = self.files.get(file).cloned() else { return };
        self.file = Some(file);
        self.failure = None;
        let open_as = OpenAs { scene: self.state.as_scene, model: self.state.model };
        self.start(Task::Open(path, open_as));
    }

    /// Opens the current file again as a scene.
    pub(super) fn show_as_scene(&mut self) {
        self.state.as_scene = true;
        self.file.into_iter().for_each(|file| self.choose(file));
    }

    /// Opens the current file again as one mesh in a model.
    pub(super) fn show_as_mesh(&mut self, model: ShownModel) {
        (self.state.as_scene, self.state.model) = (false, model);
        self.file.into_iter().for_each(|file| self.choose(file));
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
        if let Some(instance) = self.instance() {
            self.state.model = instance.kind();
        }
    }

    /// Takes the result of a finished job. A new subject must be uploaded before it is passed to
    /// [`set_subject`](Self::set_subject).
    pub(super) fn poll(&mut self) -> Option<Subject> {
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
    pub(super) fn set_subject(&mut self, subject: Subject) {
        self.state.on_new_model(subject.triangle_count(), subject.has_collapses());
        let up = if subject.is_terrain() { Up::Z } else { self.orbit.up() };
        self.orbit = Orbit::around(&subject.bounds(), up);
        (self.shown, self.last_inputs) = (None, None);
        self.playback = Playback::default();
        if let Some(pose) = self.first_pose.take() {
            match first_playback(&pose, &subject) {
                Ok(playback) => self.playback = playback,
                Err(failure) => self.failure = Some(failure),
            }
        }
        self.history.clear();
        self.subject = Some(subject);
    }

    /// Moves to the requested level, and starts building the model if it is missing.
    pub(super) fn follow(&mut self) {
        match self.subject.clone() {
            Some(Subject::Mesh(mesh)) => self.follow_mesh(&mesh),
            Some(Subject::Scene(scene)) => self.follow_scene(&scene),
            None => {}
        }
    }

    fn follow_mesh(&mut self, subject: &Arc<MeshSubject>) {
        let kind = self.state.model;
        if self.instance().is_none_or(|instance| instance.kind() != kind) {
            match ModelInstance::new(subject, kind) {
                Some(instance) => {
                    self.shown = Some(Shown::Mesh { instance: Box::new(instance), request: None });
                }
                None if self.job.is_none() => self.start(Task::Build(Arc::clone(subject), kind)),
                None => {}
            }
        }
        let wanted = self.level_request();
        let Some(Shown::Mesh { instance, request }) = &mut self.shown else { return };
        if instance.is_moving() || *request != Some(wanted) {
            self.is_new |= instance.follow(subject, &wanted);
            *request = Some(wanted);
        }
    }

    fn follow_scene(&mut self, subject: &SceneSubject) {
        if !matches!(self.shown, Some(Shown::Scene { .. })) {
            let scene = Box::new(ShownScene::new(subject));
            self.shown = Some(Shown::Scene { scene, request: None });
        }
        let LevelRequest { goal, camera, .. } = self.level_request();
        let pose = (self.playback.animation, self.playback.time);
        let Some(Shown::Scene { scene, request }) = &mut self.shown else { return };
        let wanted = SceneRequest { goal, camera, pose, hiding: scene.hiding() };
        if *request != Some(wanted) {
            scene.follow(subject, &wanted);
            *request = Some(wanted);
            self.is_new = true;
        }
    }

    fn inspection_mode(&self) -> InspectionMode {
        let (needs_inspection, colors) = match self.subject {
            Some(Subject::Scene(_)) => (self.state.scene_needs_inspection(), self.state.colors),
            _ => (self.state.needs_inspection(), self.state.effective_colors()),
        };
        if needs_inspection { InspectionMode::By(colors) } else { InspectionMode::Off }
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
        let (subject, achieved) = (self.subject.as_ref()?, self.achieved()?);
        let of_nearest =
            || self.level_camera().map(|camera| camera.error_px(achieved.error, &subject.sphere()));
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
        let inspection_mode = self.inspection_mode();
        let inputs = PictureInputs {
            viewpoint: self.orbit.viewpoint(),
            size: self.area.size,
            look: self.state.look(self.area.is_dark, self.area.pixels_per_point),
            inspection_mode,
        };
        frame.is_animated |=
            self.instance().is_some_and(ModelInstance::is_moving) || self.playback.is_playing;
        if !self.is_new && self.last_inputs.as_ref() == Some(&inputs) {
            return Ok(frame);
        }
        let bytes_before = renderer.uploaded_bytes();
        match (&self.subject, &mut self.shown) {
            (Some(Subject::Mesh(subject)), Some(Shown::Mesh { instance, .. })) => {
                renderer.update(subject, instance, inspection_mode, self.is_new)?;
            }
            (Some(Subject::Scene(subject)), Some(Shown::Scene { scene, .. })) => {
                let mode_before = self.last_inputs.as_ref().map(|inputs| inputs.inspection_mode);
                if self.is_new || mode_before != Some(inspection_mode) {
                    renderer.update_scene(subject, scene, inspection_mode)?;
                }
            }
            _ => {}
        }
        frame.is_resized = renderer.draw(&inputs.viewpoint, inputs.size, &inputs.look)?;
        frame.is_drawn = true;
        if let Some(&AchievedLevel { secs, triangle_count, .. }) = self.achieved() {
            self.history.push(Sample {
                frame_secs: started.elapsed().as_secs_f64(),
                level_secs: if self.is_new { secs } else { 0.0 },
                triangle_count,
                uploaded_bytes: renderer.uploaded_bytes() - bytes_before,
            });
        }
        (self.is_new, self.last_inputs) = (false, Some(inputs));
        Ok(frame)
    }
}

/// Returns the animation and time that the flags ask for.
///
/// # Errors
/// If there is no such animation, or no scene.
fn first_playback(pose: &PoseArgs, subject: &Subject) -> Result<Playback, Failure> {
    let name = &subject.origin().name;
    match (subject, pose.given()) {
        (Subject::Scene(scene), _) => {
            let chosen = pose.choose(&scene.poser, name)?;
            Ok(chosen.map_or_else(Playback::default, |(animation, time)| Playback {
                animation: Some(animation),
                time: time.min(scene.poser.duration(animation)),
                is_playing: false,
            }))
        }
        (Subject::Mesh(_), None) => Ok(Playback::default()),
        (Subject::Mesh(_), Some(flag)) => {
            Err(Failure::user(format!("{flag} is for scenes, but {name} is shown as one mesh"))
                .with_hint(format!("remove {flag}")))
        }
    }
}
