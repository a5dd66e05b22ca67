//! Keys: what each does, in the table that both obey and explain.

use egui::Key;

use super::state::Action;

/// A key with what it does.
#[derive(Clone, Copy, Debug)]
pub(super) struct Shortcut {
    pub(super) key: Key,
    pub(super) command: Command,
    /// As a person reads it.
    pub(super) name: &'static str,
    pub(super) does: &'static str,
}

/// What keys ask for: a change of what is shown, or of where one looks from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Command {
    /// A change of what is shown.
    Do(Action),
    /// Turn and rise, radians.
    Rotate(f32, f32),
    /// Nearer below 1.
    Zoom(f32),
    /// Keep the level of this view, or let it follow again.
    Freeze,
    /// The first look again.
    Reset,
    /// Close the help, or else the window.
    Escape,
}

/// A sixteenth of a half turn.
const TURN: f32 = std::f32::consts::PI / 16.0;

const fn shortcut(key: Key, name: &'static str, command: Command, does: &'static str) -> Shortcut {
    Shortcut { key, command, name, does }
}

/// All keys; of those with the same words only the first is explained.
pub(super) const SHORTCUTS: [Shortcut; 22] = [
    shortcut(Key::ArrowLeft, "arrows", Command::Rotate(-TURN, 0.0), ORBIT),
    shortcut(Key::ArrowRight, "arrows", Command::Rotate(TURN, 0.0), ORBIT),
    shortcut(Key::ArrowUp, "arrows", Command::Rotate(0.0, TURN), ORBIT),
    shortcut(Key::ArrowDown, "arrows", Command::Rotate(0.0, -TURN), ORBIT),
    shortcut(Key::Plus, "+ -", Command::Zoom(0.8), "nearer, farther"),
    shortcut(Key::Equals, "+ -", Command::Zoom(0.8), "nearer, farther"),
    shortcut(Key::Minus, "+ -", Command::Zoom(1.25), "nearer, farther"),
    shortcut(Key::OpenBracket, "[ ]", Command::Do(Action::Coarser), "coarser, finer"),
    shortcut(Key::CloseBracket, "[ ]", Command::Do(Action::Finer), "coarser, finer"),
    shortcut(Key::M, "M", Command::Do(Action::NextModel), "next model"),
    shortcut(Key::W, "W", Command::Do(Action::Wireframe), "wireframe"),
    shortcut(Key::S, "S", Command::Do(Action::Pieces), "strips or fans in colors"),
    shortcut(Key::F, "F", Command::Do(Action::Flat), "flat or smooth"),
    shortcut(Key::V, "V", Command::Freeze, "freeze the level, look at it from elsewhere"),
    shortcut(Key::G, "G", Command::Do(Action::Morphs), "geomorphs"),
    shortcut(Key::T, "T", Command::Do(Action::Turn), "turn by itself"),
    shortcut(Key::R, "R", Command::Reset, "the first look again"),
    shortcut(Key::P, "P", Command::Do(Action::Panel), "side panel"),
    shortcut(Key::H, "H ?", Command::Do(Action::Help), "this help"),
    shortcut(Key::Questionmark, "H ?", Command::Do(Action::Help), "this help"),
    shortcut(Key::F1, "H ?", Command::Do(Action::Help), "this help"),
    shortcut(Key::Escape, "Esc", Command::Escape, "close"),
];

const ORBIT: &str = "orbit";

/// What pointers do.
const POINTER: [[&str; 2]; 4] =
    [["drag", "orbit"], ["right drag", "pan"], ["wheel", "nearer, farther"], ["drop a file", "open it"]];

/// Shows the list of keys in the middle; whether it is still wanted.
pub(super) fn show(ctx: &egui::Context) -> bool {
    let mut is_open = true;
    let window = egui::Window::new("Keys and mouse")
        .open(&mut is_open)
        .anchor(egui::Align2::CENTER_CENTER, [0.0, 0.0])
        .collapsible(false)
        .resizable(false);
    window.show(ctx, |ui| {
        egui::Grid::new("keys").num_columns(2).spacing([24.0, 6.0]).show(ui, |ui| {
            for [name, does] in POINTER.into_iter().chain(explained()) {
                ui.strong(name);
                ui.label(does);
                ui.end_row();
            }
        });
    });
    is_open
}

/// Each key's name with what it does, once.
fn explained() -> impl Iterator<Item = [&'static str; 2]> {
    let is_first = |at: usize| at == 0 || SHORTCUTS[at - 1].name != SHORTCUTS[at].name;
    (0..SHORTCUTS.len()).filter(move |&at| is_first(at)).map(|at| [SHORTCUTS[at].name, SHORTCUTS[at].does])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_key_does_two_things_and_each_is_explained_once() {
        for (at, a) in SHORTCUTS.iter().enumerate() {
            assert!(SHORTCUTS[at + 1..].iter().all(|b| a.key != b.key), "{}", a.name);
        }
        let names: Vec<&str> = explained().map(|[name, _]| name).collect();
        for name in &names {
            assert_eq!(names.iter().filter(|other| other == &name).count(), 1, "{name}");
        }
    }
}
