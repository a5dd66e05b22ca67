//! A viewer in a window that is nowhere: keys, pointers and files change what it shows.

use std::sync::mpsc::channel;
use std::time::Duration;

use egui::{Event, Key, Modifiers, PointerButton, Pos2, RawInput, Vec2};

use super::super::args::ShownModel;
use super::super::state::Colors;
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
        let event = |pos, pressed| Event::PointerButton { pos, button, pressed, modifiers: Modifiers::NONE };
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
    assert!(bench.viewer.state.wireframe && bench.viewer.state.colors == Colors::Pieces);
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
