//! Keyboard shortcuts, in one table that is used for both input and help.

use egui::Key;

use super::state::Action;

/// A key and its command.
#[derive(Clone, Copy, Debug)]
pub(super) struct Shortcut {
    pub key: Key,
    pub command: Command,
    /// Name of the key in the help.
    pub name: &'static str,
    pub description: &'static str,
}

/// Command of a key: a change of the settings or of the camera.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Command {
    /// Change a setting.
    Apply(Action),
    /// Orbit by turn and rise, radians.
    Rotate(f32, f32),
    /// Multiply the distance to the target.
    Zoom(f32),
    /// Play or pause the animation.
    Play,
    /// Freeze or unfreeze the level of this view.
    Freeze,
    /// Reset the camera.
    Reset,
    /// Close the help, the error, or else the window.
    Escape,
}

/// Angle per key press, a sixteenth of a half turn.
const TURN: f32 = std::f32::consts::PI / 16.0;

const fn shortcut(key: Key, name: &'static str, command: Command, description: &'static str) -> Shortcut {
    Shortcut { key, command, name, description }
}

/// All shortcuts; of consecutive ones with the same name, only the first is listed in the help.
pub(super) const SHORTCUTS: [Shortcut; 23] = [
    shortcut(Key::ArrowLeft, "arrows", Command::Rotate(-TURN, 0.0), ORBIT),
    shortcut(Key::ArrowRight, "arrows", Command::Rotate(TURN, 0.0), ORBIT),
    shortcut(Key::ArrowUp, "arrows", Command::Rotate(0.0, TURN), ORBIT),
    shortcut(Key::ArrowDown, "arrows", Command::Rotate(0.0, -TURN), ORBIT),
    shortcut(Key::Plus, "+ -", Command::Zoom(0.8), "zoom in, zoom out"),
    shortcut(Key::Equals, "+ -", Command::Zoom(0.8), "zoom in, zoom out"),
    shortcut(Key::Minus, "+ -", Command::Zoom(1.25), "zoom in, zoom out"),
    shortcut(Key::OpenBracket, "[ ]", Command::Apply(Action::Coarser), "coarser, finer"),
    shortcut(Key::CloseBracket, "[ ]", Command::Apply(Action::Finer), "coarser, finer"),
    shortcut(Key::Space, "Space", Command::Play, "play or pause the animation"),
    shortcut(Key::M, "M", Command::Apply(Action::NextModel), "next model"),
    shortcut(Key::W, "W", Command::Apply(Action::Wireframe), "wireframe"),
    shortcut(Key::S, "S", Command::Apply(Action::StripsOrFans), "color by strip or fan"),
    shortcut(Key::F, "F", Command::Apply(Action::Flat), "flat shading"),
    shortcut(Key::V, "V", Command::Freeze, "freeze the level"),
    shortcut(Key::G, "G", Command::Apply(Action::Morphs), "geomorphs"),
    shortcut(Key::T, "T", Command::Apply(Action::Rotate), "auto-rotate"),
    shortcut(Key::R, "R", Command::Reset, "reset view"),
    shortcut(Key::P, "P", Command::Apply(Action::Panel), "side panel"),
    shortcut(Key::H, "H ?", Command::Apply(Action::Help), "this help"),
    shortcut(Key::Questionmark, "H ?", Command::Apply(Action::Help), "this help"),
    shortcut(Key::F1, "H ?", Command::Apply(Action::Help), "this help"),
    shortcut(Key::Escape, "Esc", Command::Escape, "close"),
];

/// Description shared by the arrow keys.
const ORBIT: &str = "orbit";

/// Mouse gestures, for the help.
const POINTER: [[&str; 2]; 4] =
    [["drag", "orbit"], ["right drag", "pan"], ["wheel", "zoom in, zoom out"], ["drop a file", "open"]];

/// Shows the help window, and returns whether it is still open.
pub(super) fn show(ctx: &egui::Context) -> bool {
    let mut is_open = true;
    let window = egui::Window::new("Keyboard and mouse")
        .open(&mut is_open)
        .anchor(egui::Align2::CENTER_CENTER, [0.0, 0.0])
        .collapsible(false)
        .resizable(false);
    window.show(ctx, |ui| {
        egui::Grid::new("keys").num_columns(2).spacing([24.0, 6.0]).show(ui, |ui| {
            for [name, description] in POINTER.into_iter().chain(explained()) {
                ui.strong(name);
                ui.label(description);
                ui.end_row();
            }
        });
    });
    is_open
}

/// Name and description of each shortcut, once.
fn explained() -> impl Iterator<Item = [&'static str; 2]> {
    let is_first = |at: usize| at == 0 || SHORTCUTS[at - 1].name != SHORTCUTS[at].name;
    (0..SHORTCUTS.len())
        .filter(move |&at| is_first(at))
        .map(|at| [SHORTCUTS[at].name, SHORTCUTS[at].description])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn keys_are_unique_and_each_is_explained_once() {
        for (at, a) in SHORTCUTS.iter().enumerate() {
            assert!(SHORTCUTS[at + 1..].iter().all(|b| a.key != b.key), "{}", a.name);
        }
        let names: Vec<&str> = explained().map(|[name, _]| name).collect();
        for name in &names {
            assert_eq!(names.iter().filter(|other| other == &name).count(), 1, "{name}");
        }
    }
}
