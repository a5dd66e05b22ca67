//! The viewer without its window: what is loaded, what is wanted, and when the picture has to be drawn again.

mod input;
#[cfg(test)]
mod tests;

use std::path::PathBuf;
use std::sync::Arc;
use std::time::Instant;

use egui::Rect;
use striata::view::Camera;
use striata_gpu::{GpuError, Look, Viewpoint};

use super::loader::{Job, Outcome, Stage as JobStage, Task, Waker};
use super::orbit::Orbit;
use super::plots::{History, Sample};
use super::shown::{Shown, Wish};
use super::stage::{Inspected, Stage};
use super::state::{GoalKind, ViewerState};
use super::subject::Subject;
use striata_command::failure::Failure;
use striata_command::output::Output;

/// Where the picture is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Place {
    /// Points.
    pub(super) rect: Rect,
    /// Pixels; 0 where there is no picture.
    pub(super) size: [u32; 2],
    pub(super) pixels_per_point: f32,
    pub(super) is_dark: bool,
}

/// Everything that a picture depends on apart from the triangles.
#[derive(Clone, Debug, PartialEq)]
struct Drawn {
    viewpoint: Viewpoint,
    size: [u32; 2],
    look: Look,
    inspected: Inspected,
}

/// What a frame did.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Frame {
    /// The picture differs.
    pub(super) is_drawn: bool,
    /// It is another texture.
    pub(super) is_resized: bool,
    /// There is more to come without anyone asking.
    pub(super) goes_on: bool,
}

/// The viewer.
pub(super) struct Viewer {
    pub(super) state: ViewerState,
    pub(super) orbit: Orbit,
    /// Files that can be chosen from, and the one that is.
    pub(super) files: Vec<PathBuf>,
    pub(super) file: Option<usize>,
    /// What went wrong last.
    pub(super) trouble: Option<Failure>,
    pub(super) history: History,
    pub(super) place: Place,
    /// The adapter.
    pub(super) adapter: String,
    /// Whether the window is to be closed.
    pub(super) quits: bool,
    subject: Option<Arc<Subject>>,
    shown: Option<Shown>,
    job: Option<Job>,
    last_wish: Option<Wish>,
    /// The triangles are others than in the picture.
    is_new: bool,
    drawn: Option<Drawn>,
    output: Output,
    waker: Waker,
}

impl Viewer {
    /// A viewer that opens the first of some files.
    pub(super) fn new(files: Vec<PathBuf>, state: ViewerState, (output, waker): (Output, Waker)) -> Self {
        let place = Place { rect: Rect::NOTHING, size: [0, 0], pixels_per_point: 1.0, is_dark: true };
        let mut viewer = Self {
            state,
            orbit: Orbit::default(),
            files,
            file: None,
            trouble: None,
            history: History::default(),
            place,
            adapter: String::new(),
            quits: false,
            subject: None,
            shown: None,
            job: None,
            last_wish: None,
            is_new: false,
            drawn: None,
            output,
            waker,
        };
        if !viewer.files.is_empty() {
            viewer.choose(0);
        }
        viewer
    }

    /// What is looked at.
    pub(super) fn subject(&self) -> Option<&Arc<Subject>> {
        self.subject.as_ref()
    }

    /// What is shown of it.
    pub(super) fn shown(&self) -> Option<&Shown> {
        self.shown.as_ref()
    }

    /// What is being worked on, and how far that is.
    pub(super) fn work(&self) -> Option<(&Task, JobStage)> {
        self.job.as_ref().map(|job| (job.task(), job.stage()))
    }

    /// Whether all that was asked for is on the screen, or has failed.
    pub(super) fn is_at_rest(&self) -> bool {
        let is_shown = |shown: &Shown| shown.kind() == self.state.model && !shown.is_moving();
        let has_come = self.shown.as_ref().is_some_and(is_shown) || self.trouble.is_some();
        self.job.is_none() && (has_come || self.files.is_empty()) && !self.is_new
    }

    /// Opens one of the files.
    pub(super) fn choose(&mut self, file: usize) {
        let Some(path) = self.files.get(file).cloned() else { return };
        self.file = Some(file);
        self.trouble = None;
        self.start(Task::Open(path, self.state.model));
    }

    /// Opens a file that came from elsewhere.
    pub(super) fn open(&mut self, path: PathBuf) {
        let known = self.files.iter().position(|known| *known == path);
        let file = known.unwrap_or_else(|| {
            self.files.push(path);
            self.files.len() - 1
        });
        self.choose(file);
    }

    fn start(&mut self, task: Task) {
        // The job before is dropped, and stops.
        self.job = Some(Job::start(task, self.output, Arc::clone(&self.waker)));
    }

    /// Tells of a failure; what was shown before stays.
    pub(super) fn complain(&mut self, failure: Failure) {
        self.trouble = Some(failure);
        if let Some(shown) = &self.shown {
            self.state.model = shown.kind();
        }
    }

    /// Takes what a job has come to. A new subject has to be brought to the stage before it is [met](Self::meet).
    pub(super) fn poll(&mut self) -> Option<Arc<Subject>> {
        let outcome: Outcome = self.job.as_ref()?.poll()?;
        let job = self.job.take()?;
        match (outcome, job.task()) {
            (Ok(subject), Task::Open(..)) => return Some(subject),
            (Ok(_), Task::Build(..)) => {}
            (Err(failure), _) => self.complain(failure),
        }
        None
    }

    /// Shows another subject from now on.
    pub(super) fn meet(&mut self, subject: Arc<Subject>) {
        self.state.meet(subject.steps.mesh().triangle_count(), subject.has_collapses());
        self.orbit = Orbit::around(&subject.bounds, self.orbit.up());
        (self.shown, self.last_wish, self.drawn) = (None, None, None);
        self.history.clear();
        self.subject = Some(subject);
    }

    /// Goes to the level that is wanted; asks for the model where it is not there.
    pub(super) fn follow(&mut self) {
        let Some(subject) = self.subject.clone() else { return };
        let kind = self.state.model;
        if self.shown.as_ref().is_none_or(|shown| shown.kind() != kind) {
            match Shown::new(&subject, kind) {
                Some(shown) => (self.shown, self.last_wish) = (Some(shown), None),
                None if self.job.is_none() => self.start(Task::Build(Arc::clone(&subject), kind)),
                None => {}
            }
        }
        let wish = self.wish();
        let Some(shown) = &mut self.shown else { return };
        if shown.is_moving() || self.last_wish != Some(wish) {
            self.is_new |= shown.follow(&subject, &wish);
            self.last_wish = Some(wish);
        }
    }

    fn wish(&self) -> Wish {
        let is_of_view = matches!(self.state.goal, GoalKind::Pixels | GoalKind::Budget);
        let camera = if is_of_view { self.level_camera() } else { None };
        // What is inspected stands where it belongs.
        let morphs = self.state.morphs && self.state.model.can_morph() && !self.state.inspects();
        Wish { goal: self.state.wanted(), camera, morphs }
    }

    /// The view that levels are made for; none where there is no picture.
    fn level_camera(&self) -> Option<Camera> {
        let (viewpoint, size) = match self.state.frozen {
            Some(frozen) => (frozen.viewpoint, frozen.size),
            None => (self.orbit.viewpoint(), self.place.size),
        };
        viewpoint.camera(size).ok()
    }

    /// Pixels that the error of what is shown takes where the model is nearest; none where nothing bounds them.
    pub(super) fn error_px(&self) -> Option<f32> {
        let (subject, achieved) = (self.subject.as_ref()?, self.shown.as_ref()?.achieved());
        let of_nearest =
            || self.level_camera().map(|camera| camera.error_px(achieved.error, &subject.sphere));
        achieved.error_px.or_else(of_nearest).filter(|pixels| pixels.is_finite())
    }

    /// Draws the picture if it differs from the last one.
    ///
    /// # Errors
    /// Where something does not fit on the GPU.
    pub(super) fn draw(&mut self, stage: &mut Stage, started: Instant) -> Result<Frame, GpuError> {
        let mut frame = Frame { goes_on: self.state.turns, ..Frame::default() };
        if self.place.size.contains(&0) {
            return Ok(Frame::default());
        }
        let inspected =
            if self.state.inspects() { Inspected::By(self.state.colors_shown()) } else { Inspected::No };
        let drawn = Drawn {
            viewpoint: self.orbit.viewpoint(),
            size: self.place.size,
            look: self.state.look(self.place.is_dark, self.place.pixels_per_point),
            inspected,
        };
        frame.goes_on |= self.shown.as_ref().is_some_and(Shown::is_moving);
        if !self.is_new && self.drawn.as_ref() == Some(&drawn) {
            return Ok(frame);
        }
        let bytes_before = stage.uploaded_bytes();
        if let (Some(subject), Some(shown)) = (&self.subject, &mut self.shown) {
            stage.update(subject, shown, (inspected, self.is_new))?;
        }
        frame.is_resized = stage.draw(&drawn.viewpoint, drawn.size, &drawn.look)?;
        frame.is_drawn = true;
        if let Some(shown) = &self.shown {
            self.history.push(Sample {
                frame_secs: started.elapsed().as_secs_f64(),
                level_secs: if self.is_new { shown.achieved().secs } else { 0.0 },
                triangle_count: shown.achieved().triangle_count,
                uploaded_bytes: stage.uploaded_bytes() - bytes_before,
            });
        }
        (self.is_new, self.drawn) = (false, Some(drawn));
        Ok(frame)
    }
}
