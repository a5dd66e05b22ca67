//! What keys, pointers and dropped files do to the viewer.

use egui::Vec2;

use super::Viewer;
use crate::window::help::{Command, SHORTCUTS};

/// Turn of a model that turns by itself, radians a second.
const TURN_SPEED: f32 = 0.5;

impl Viewer {
    /// Does what a key asks for.
    pub(in crate::window) fn command(&mut self, command: Command) {
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
    pub(in crate::window) fn hear(&mut self, ctx: &egui::Context) {
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
    pub(in crate::window) fn touch(&mut self, ui: &egui::Ui, response: &egui::Response) {
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
