//! The viewer without its window: what is loaded, what is wanted, and when the picture has to be drawn again.

use std::path::PathBuf;
use std::sync::Arc;
use std::time::Instant;

use egui::{Rect, Vec2};
use striata::view::Camera;
use striata_gpu::{GpuError, Look, Viewpoint};

use super::help::{Command, SHORTCUTS};
use super::loader::{Job, Outcome, Stage as JobStage, Task, Waker};
use super::orbit::Orbit;
use super::plots::{History, Sample};
use super::shown::{Shown, Wish};
use super::stage::{Inspected, Stage};
use super::state::{GoalKind, ViewerState};
use super::subject::Subject;
use striata_command::failure::Failure;
use striata_command::output::Output;

/// Turn of a model that turns by itself, radians a second.
const TURN_SPEED: f32 = 0.5;

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

/// Everything that a picture depends on beside the triangles.
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

    /// Does what a key asks for.
    pub(super) fn command(&mut self, command: Command) {
        let (triangle_count, has_collapses) = match &self.subject {
            Some(subject) => (subject.steps.mesh().triangle_count(), subject.has_collapses()),
            None => (0, true),
        };
        match command {
            Command::Do(action) => self.state.apply(action, triangle_count, has_collapses),
            Command::Rotate(turn, rise) => self.orbit.rotate(turn, rise),
            Command::Zoom(factor) => self.orbit.zoom(factor),
            Command::Freeze => self.state.freeze(self.orbit.viewpoint(), self.place.size),
            Command::Reset => self.orbit.reset(),
            Command::Escape if self.state.shows_help => self.state.shows_help = false,
            Command::Escape if self.trouble.is_some() => self.trouble = None,
            Command::Escape => self.quits = true,
        }
    }

    /// Takes keys and files that were dropped.
    pub(super) fn hear(&mut self, ctx: &egui::Context) {
        let dropped = ctx.input(|input| input.raw.dropped_files.first().map(|file| file.path().to_owned()));
        if let Some(path) = dropped {
            self.open(path);
        }
        if !ctx.egui_wants_keyboard_input() {
            for shortcut in &SHORTCUTS {
                let is_plain = |input: &egui::InputState| !input.modifiers.command && !input.modifiers.alt;
                let presses = |input: &egui::InputState| input.num_presses(shortcut.key);
                // A slow frame hears of several presses at once.
                let count = ctx.input(|input| if is_plain(input) { presses(input) } else { 0 });
                (0..count).for_each(|_| self.command(shortcut.command));
            }
        }
        if self.state.turns {
            let secs = ctx.input(|input| input.stable_dt).min(0.1);
            self.orbit.rotate(TURN_SPEED * secs, 0.0);
        }
    }

    /// Follows the pointer over the picture.
    pub(super) fn touch(&mut self, ui: &egui::Ui, response: &egui::Response) {
        let height = response.rect.height();
        let Vec2 { x, y } = response.drag_delta();
        let is_shifted = ui.input(|input| input.modifiers.shift);
        let is_primary = response.dragged_by(egui::PointerButton::Primary);
        if is_primary && !is_shifted {
            self.orbit.drag([x, y], height);
        } else if response.dragged() {
            self.orbit.pan([x, y], height);
        }
        if response.contains_pointer() {
            let (scroll, pinch) = ui.input(|input| (input.smooth_scroll_delta().y, input.zoom_delta()));
            let factor = (-0.004 * scroll).exp() / pinch;
            if factor != 1.0 {
                self.orbit.zoom(factor);
            }
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
            if self.state.inspects() { Inspected::By(self.state.colours_shown()) } else { Inspected::No };
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

#[cfg(test)]
mod tests {
    use std::sync::mpsc::channel;
    use std::time::Duration;

    use egui::{Event, Key, Modifiers, PointerButton, Pos2, RawInput};

    use super::super::args::ShownModel;
    use super::super::state::Colours;
    use super::super::{panel, shown::Changes};
    use super::*;

    /// A viewer in a window that is nowhere.
    struct Bench {
        viewer: Viewer,
        ctx: egui::Context,
        woken: std::sync::mpsc::Receiver<()>,
    }

    impl Bench {
        fn new(file: &str) -> Self {
            let (sender, woken) = channel();
            let sender = std::sync::Mutex::new(sender);
            let waker: Waker = Arc::new(move || {
                let _ = sender.lock().expect("no panic before").send(());
            });
            let viewer = Viewer::new(vec![file.into()], ViewerState::default(), (Output::quiet(), waker));
            let ctx = egui::Context::default();
            ctx.options_mut(|options| options.max_passes = std::num::NonZeroUsize::MIN);
            let mut bench = Self { viewer, ctx, woken };
            bench.rest();
            bench
        }

        /// One frame with some events.
        fn frame(&mut self, events: Vec<Event>, dropped: Vec<PathBuf>) {
            let screen = Rect::from_min_size(Pos2::ZERO, Vec2::new(1000.0, 600.0));
            let dropped_files = dropped.into_iter().map(|path| Arc::new(Dropped(path)) as _).collect();
            let input = RawInput { screen_rect: Some(screen), events, dropped_files, ..Default::default() };
            let viewer = &mut self.viewer;
            self.ctx.run_ui(input, |ui| panel::show(viewer, ui, None)).drop_without_applying_deltas();
            if let Some(subject) = self.viewer.poll() {
                self.viewer.meet(subject);
            }
            self.viewer.follow();
            self.viewer.is_new = false;
        }

        /// Frames until nothing is left to do.
        fn rest(&mut self) {
            self.frame(vec![], vec![]);
            while !self.viewer.is_at_rest() {
                self.woken.recv_timeout(Duration::from_secs(600)).expect("the work ends");
                self.frame(vec![], vec![]);
            }
            self.frame(vec![], vec![]);
        }

        fn press(&mut self, key: Key) {
            let event = |pressed| Event::Key {
                key,
                physical_key: None,
                pressed,
                repeat: false,
                modifiers: Modifiers::NONE,
            };
            self.frame(vec![event(true), event(false)], vec![]);
        }

        fn drag(&mut self, button: PointerButton, from: Pos2, to: Pos2) {
            let event =
                |pos, pressed| Event::PointerButton { pos, button, pressed, modifiers: Modifiers::NONE };
            self.frame(vec![Event::PointerMoved(from)], vec![]);
            self.frame(vec![event(from, true)], vec![]);
            self.frame(vec![Event::PointerMoved(from.lerp(to, 0.5))], vec![]);
            self.frame(vec![Event::PointerMoved(to)], vec![]);
            self.frame(vec![event(to, false)], vec![]);
        }

        fn triangle_count(&self) -> usize {
            self.viewer.shown().expect("something is shown").achieved().triangle_count
        }
    }

    #[derive(Debug)]
    struct Dropped(PathBuf);

    impl egui::DroppedFile for Dropped {
        fn path(&self) -> &std::path::Path {
            &self.0
        }

        fn bytes(&self) -> Result<Vec<u8>, String> {
            Err("it is opened by its path".to_owned())
        }
    }

    #[test]
    fn keys_change_the_level_the_model_and_the_look() {
        let mut bench = Bench::new("shape:icosphere");
        let full = bench.triangle_count();
        bench.press(Key::OpenBracket);
        assert!(bench.triangle_count() < full);
        bench.press(Key::CloseBracket);
        assert_eq!(bench.triangle_count(), full);
        for kind in [ShownModel::Mts, ShownModel::Fans] {
            bench.press(Key::M);
            bench.rest();
            assert_eq!(bench.viewer.shown().map(Shown::kind), Some(kind), "it was built meanwhile");
            assert_eq!(bench.triangle_count(), full);
        }
        bench.press(Key::S);
        bench.press(Key::W);
        assert!(bench.viewer.state.wireframe && bench.viewer.state.colours == Colours::Pieces);
        bench.press(Key::H);
        assert!(bench.viewer.state.shows_help);
        bench.press(Key::Escape);
        assert!(!bench.viewer.state.shows_help && !bench.viewer.quits);
        bench.press(Key::Escape);
        assert!(bench.viewer.quits);
    }

    #[test]
    fn a_frozen_level_stays_while_the_eye_goes_on() {
        let mut bench = Bench::new("shape:icosphere");
        bench.viewer.state.set_goal(GoalKind::Pixels, true);
        bench.rest();
        let before = bench.triangle_count();
        bench.press(Key::V);
        (0..12).for_each(|_| bench.press(Key::Plus));
        assert_eq!(bench.triangle_count(), before, "frozen");
        bench.press(Key::V);
        assert_ne!(bench.triangle_count(), before, "it follows again");
    }

    #[test]
    fn pointers_turn_move_and_zoom_the_picture_and_nothing_beside_it() {
        let mut bench = Bench::new("shape:cube");
        let first = bench.viewer.orbit;
        let (inside, beside) = (Pos2::new(300.0, 300.0), Pos2::new(990.0, 590.0));
        bench.drag(PointerButton::Primary, inside, inside + Vec2::new(60.0, 0.0));
        let turned = bench.viewer.orbit.viewpoint();
        assert_eq!(turned.look_at, first.viewpoint().look_at);
        assert_ne!(turned.eye, first.viewpoint().eye);
        bench.drag(PointerButton::Secondary, inside, inside + Vec2::new(60.0, 0.0));
        assert_ne!(bench.viewer.orbit.viewpoint().look_at, turned.look_at);
        let moved = bench.viewer.orbit;
        bench.drag(PointerButton::Primary, beside, beside - Vec2::new(0.0, 60.0));
        assert_eq!(bench.viewer.orbit, moved, "the panel is no picture");
        let wheel = Event::MouseWheel {
            unit: egui::MouseWheelUnit::Line,
            delta: Vec2::new(0.0, 3.0),
            phase: egui::TouchPhase::Move,
            source: egui::MouseWheelSource::Wheel,
            modifiers: Modifiers::NONE,
        };
        bench.frame(vec![Event::PointerMoved(inside)], vec![]);
        bench.frame(vec![wheel], vec![]);
        // The wheel runs out smoothly.
        (0..120).for_each(|_| bench.frame(vec![], vec![]));
        let distance = |orbit: &Orbit| {
            let view = orbit.viewpoint();
            (0..3).map(|k| (view.eye[k] - view.look_at[k]).powi(2)).sum::<f32>().sqrt()
        };
        assert!(distance(&bench.viewer.orbit) < distance(&moved), "nearer");
        bench.press(Key::R);
        assert_eq!(bench.viewer.orbit, first);
    }

    #[test]
    fn a_dropped_file_is_opened_and_one_that_cannot_be_leaves_the_old_model() {
        let mut bench = Bench::new("shape:cube");
        let old = bench.triangle_count();
        bench.frame(vec![], vec!["nowhere/at-all.ply".into()]);
        bench.rest();
        let trouble = bench.viewer.trouble.as_ref().expect("there is no such file");
        assert!(trouble.message().contains("at-all.ply") && trouble.hint().is_some(), "{trouble:?}");
        assert_eq!(bench.triangle_count(), old);
        bench.frame(vec![], vec!["shape:torus".into()]);
        bench.rest();
        assert!(bench.viewer.trouble.is_none() && bench.triangle_count() > old);
        assert_eq!(bench.viewer.files.len(), 3, "all can be chosen again");
    }

    #[test]
    fn a_view_that_moves_changes_no_level_that_is_the_same_everywhere() {
        let mut bench = Bench::new("shape:torus");
        bench.press(Key::OpenBracket);
        let shown = bench.viewer.shown.as_mut().expect("it is shown");
        let _ = shown.take_changes();
        bench.press(Key::ArrowLeft);
        bench.press(Key::Plus);
        let shown = bench.viewer.shown.as_mut().expect("it is shown");
        assert_eq!(shown.take_changes(), Changes::None);
        assert!(bench.viewer.error_px().is_some_and(|pixels| pixels > 0.0));
    }
}
