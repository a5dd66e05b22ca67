//! Tests of the viewer without a window: keys, pointers and files change what it shows.

mod scenes;

use std::sync::mpsc::channel;
use std::time::Duration;

use egui::{Event, Key, Modifiers, PointerButton, Pos2, RawInput, Vec2};

use super::super::args::ShownModel;
use super::super::state::Colors;
use super::super::{instance::Changes, panel};
use super::*;

/// A viewer without a window, driven by simulated events.
struct TestViewer {
    viewer: Viewer,
    ctx: egui::Context,
    woken: std::sync::mpsc::Receiver<()>,
}

impl TestViewer {
    fn new(file: &str) -> Self {
        Self::with(file, ViewerState::default())
    }

    fn with(file: impl Into<PathBuf>, state: ViewerState) -> Self {
        let (sender, woken) = channel();
        let sender = std::sync::Mutex::new(sender);
        let waker: Waker = Arc::new(move || {
            let _ = sender.lock().expect("no panic before").send(());
        });
        let viewer = Viewer::new(vec![file.into()], state, Output::quiet(), waker);
        let ctx = egui::Context::default();
        ctx.options_mut(|options| options.max_passes = std::num::NonZeroUsize::MIN);
        let mut test = Self { viewer, ctx, woken };
        test.settle();
        test
    }

    /// Runs one frame with some events.
    fn frame(&mut self, events: Vec<Event>, dropped: Vec<PathBuf>) {
        let screen = Rect::from_min_size(Pos2::ZERO, Vec2::new(1000.0, 600.0));
        let dropped_files = dropped.into_iter().map(|path| Arc::new(Dropped(path)) as _).collect();
        let input = RawInput { screen_rect: Some(screen), events, dropped_files, ..Default::default() };
        let viewer = &mut self.viewer;
        self.ctx.run_ui(input, |ui| panel::show(viewer, ui, None)).drop_without_applying_deltas();
        if let Some(subject) = self.viewer.poll() {
            self.viewer.set_subject(subject);
        }
        self.viewer.follow();
        self.viewer.is_new = false;
    }

    /// Runs frames until the viewer is idle.
    fn settle(&mut self) {
        self.frame(vec![], vec![]);
        while !self.viewer.is_idle() {
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
        let event = |pos, pressed| Event::PointerButton { pos, button, pressed, modifiers: Modifiers::NONE };
        self.frame(vec![Event::PointerMoved(from)], vec![]);
        self.frame(vec![event(from, true)], vec![]);
        self.frame(vec![Event::PointerMoved(from.lerp(to, 0.5))], vec![]);
        self.frame(vec![Event::PointerMoved(to)], vec![]);
        self.frame(vec![event(to, false)], vec![]);
    }

    fn triangle_count(&self) -> usize {
        self.viewer.achieved().expect("something is shown").triangle_count
    }

    fn instance_mut(&mut self) -> &mut ModelInstance {
        match &mut self.viewer.shown {
            Some(Shown::Mesh { instance, .. }) => instance,
            _ => panic!("a model is shown"),
        }
    }
}

#[derive(Debug)]
struct Dropped(PathBuf);

impl egui::DroppedFile for Dropped {
    fn path(&self) -> &std::path::Path {
        &self.0
    }

    fn bytes(&self) -> Result<Vec<u8>, String> {
        Err("the file is opened by its path".to_owned())
    }
}

#[test]
fn keys_change_the_level_the_model_and_the_look() {
    let mut test = TestViewer::new("shape:icosphere");
    let full = test.triangle_count();
    test.press(Key::OpenBracket);
    assert!(test.triangle_count() < full);
    test.press(Key::CloseBracket);
    assert_eq!(test.triangle_count(), full);
    for kind in [ShownModel::LiveStrips, ShownModel::Mts, ShownModel::Fans] {
        test.press(Key::M);
        test.settle();
        assert_eq!(test.viewer.instance().map(ModelInstance::kind), Some(kind), "the model was built");
        assert_eq!(test.triangle_count(), full);
    }
    test.press(Key::S);
    test.press(Key::W);
    assert!(test.viewer.state.wireframe && test.viewer.state.colors == Colors::StripsOrFans);
    test.press(Key::H);
    assert!(test.viewer.state.shows_help);
    test.press(Key::Escape);
    assert!(!test.viewer.state.shows_help && !test.viewer.quits);
    test.press(Key::Escape);
    assert!(test.viewer.quits);
}

#[test]
fn a_frozen_level_stays_while_the_camera_moves() {
    let mut test = TestViewer::new("shape:icosphere");
    test.viewer.state.set_goal(GoalKind::Pixels);
    test.settle();
    let before = test.triangle_count();
    test.press(Key::V);
    (0..12).for_each(|_| test.press(Key::Plus));
    assert_eq!(test.triangle_count(), before, "frozen");
    test.press(Key::V);
    assert_ne!(test.triangle_count(), before, "it follows again");
}

#[test]
fn pointers_rotate_pan_and_zoom_only_over_the_picture() {
    let mut test = TestViewer::new("shape:cube");
    let first = test.viewer.orbit;
    let (inside, outside) = (Pos2::new(300.0, 300.0), Pos2::new(990.0, 590.0));
    test.drag(PointerButton::Primary, inside, inside + Vec2::new(60.0, 0.0));
    let turned = test.viewer.orbit.viewpoint();
    assert_eq!(turned.look_at, first.viewpoint().look_at);
    assert_ne!(turned.eye, first.viewpoint().eye);
    test.drag(PointerButton::Secondary, inside, inside + Vec2::new(60.0, 0.0));
    assert_ne!(test.viewer.orbit.viewpoint().look_at, turned.look_at);
    let moved = test.viewer.orbit;
    test.drag(PointerButton::Primary, outside, outside - Vec2::new(0.0, 60.0));
    assert_eq!(test.viewer.orbit, moved, "the panel ignores the gesture");
    let wheel = Event::MouseWheel {
        unit: egui::MouseWheelUnit::Line,
        delta: Vec2::new(0.0, 3.0),
        phase: egui::TouchPhase::Move,
        source: egui::MouseWheelSource::Wheel,
        modifiers: Modifiers::NONE,
    };
    test.frame(vec![Event::PointerMoved(inside)], vec![]);
    test.frame(vec![wheel], vec![]);
    // Scrolling is smoothed over several frames.
    (0..120).for_each(|_| test.frame(vec![], vec![]));
    let distance = |orbit: &Orbit| {
        let view = orbit.viewpoint();
        (0..3).map(|k| (view.eye[k] - view.look_at[k]).powi(2)).sum::<f32>().sqrt()
    };
    assert!(distance(&test.viewer.orbit) < distance(&moved), "nearer");
    test.press(Key::R);
    assert_eq!(test.viewer.orbit, first);
}

#[test]
fn dropped_files_are_opened_and_failures_keep_the_old_model() {
    let mut test = TestViewer::new("shape:cube");
    let old = test.triangle_count();
    test.frame(vec![], vec!["nowhere/at-all.ply".into()]);
    test.settle();
    let failure = test.viewer.failure.as_ref().expect("the file does not exist");
    assert!(failure.message().contains("at-all.ply") && failure.hint().is_some(), "{failure:?}");
    assert_eq!(test.triangle_count(), old);
    test.frame(vec![], vec!["shape:torus".into()]);
    test.settle();
    assert!(test.viewer.failure.is_none() && test.triangle_count() > old);
    assert_eq!(test.viewer.files.len(), 3, "all can be chosen again");
}

#[test]
fn moving_the_camera_does_not_change_a_uniform_level() {
    let mut test = TestViewer::new("shape:torus");
    test.press(Key::OpenBracket);
    let instance = test.instance_mut();
    let _ = instance.take_changes();
    test.press(Key::ArrowLeft);
    test.press(Key::Plus);
    let instance = test.instance_mut();
    assert_eq!(instance.take_changes(), Changes::None);
    assert!(test.viewer.error_px().is_some_and(|pixels| pixels > 0.0));
}
