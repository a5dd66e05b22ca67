//! Tests that run the command in temporary folders and check what it prints and writes.

mod ball;
mod costs;
mod far_positions;
mod first_words;
mod gltf_outputs;
#[cfg(unix)]
mod guides;
mod help;
mod inputs;
mod levels;
mod ordered;
mod orders;
mod outputs;
mod paged;
mod patterns;
mod png;
mod reference_pictures;
mod refusals;
mod render;
mod render_scenes;
mod scenes;
mod seams;
#[cfg(all(unix, feature = "serve"))]
mod serve;
mod streams;
mod strip_blocks;
mod strip_levels;
mod strips;
mod tiles;
mod verbs;
#[cfg(all(unix, feature = "serve"))]
mod view;
mod workbench;

/// The command under test.
pub(crate) const COMMAND: &str = "striata";
