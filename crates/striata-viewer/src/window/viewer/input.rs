//! Handles keys, pointers and dropped files.

use egui::Vec2;

use super::Viewer;
use crate::window::help::{Command, SHORTCUTS};
use crate::window::state::Action;
use crate::window::subject::Subject;

/// Longest step of an animation between two frames, seconds.
const MAX_STEP_SECS: f32 = 0.25;

/// Speed of auto-rotation, radians per second.
const AUTO_ROTATE_SPEED: f32 = 0.5;

impl Viewer {
    /// Executes a command.
    pub(in crate::window) fn command(&mut self, command: Command) {
        let (triangle_count, has_collapses) = match &self.subject {
            Some(subject) => (subject.triangle_count(), subject.has_collapses()),
            None => (0, true),
        };
        match command {
            Command::Apply(Action::NextModel) if self.scene().is_some() => {
                self.show_as_mesh(self.state.model)
            }
            Command::Apply(Action::StripsOrFans | Action::Flat | Action::Morphs)
                if self.scene().is_some() => {}
            Command::Apply(action) => self.state.apply(action, triangle_count, has_collapses),
            Command::Rotate(turn, rise) => self.orbit.rotate(turn, rise),
            Command::Zoom(factor) => self.orbit.zoom(factor),
            Command::Play => {
                if let Some(Subject::Scene(scene)) = &self.subject {
                    self.playback.toggle(&scene.poser);
                }
            }
            Command::Freeze => self.state.freeze(self.orbit.viewpoint(), self.area.size),
            Command::Reset => self.orbit.reset(),
            Command::Escape if self.state.shows_help => self.state.shows_help = false,
            Command::Escape if self.failure.is_some() => self.failure = None,
            Command::Escape => self.quits = true,
        }
    }

    /// Handles keys and dropped files.
    pub(in crate::window) fn handle_input(&mut self, ctx: &egui::Context) {
        let dropped = ctx.input(|input| input.raw.dropped_files.first().map(|file| file.path().to_owned()));
        if let Some(path) = dropped {
            self.open(path);
        }
        if !ctx.egui_wants_keyboard_input() {
            for shortcut in &SHORTCUTS {
                let is_plain = |input: &egui::InputState| !input.modifiers.command && !input.modifiers.alt;
                let presses = |input: &egui::InputState| input.num_presses(shortcut.key);
                // A slow frame may receive several presses.
                let count = ctx.input(|input| if is_plain(input) { presses(input) } else { 0 });
                (0..count).for_each(|_| self.command(shortcut.command));
            }
        }
        if self.state.auto_rotates {
            let secs = ctx.input(|input| input.stable_dt).min(0.1);
            self.orbit.rotate(AUTO_ROTATE_SPEED * secs, 0.0);
        }
        if let Some(Subject::Scene(scene)) = &self.subject {
            self.playback.advance(ctx.input(|input| input.stable_dt).min(MAX_STEP_SECS), &scene.poser);
        }
    }

    /// Handles the pointer over the picture.
    pub(in crate::window) fn handle_pointer(&mut self, ui: &egui::Ui, response: &egui::Response) {
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
}
