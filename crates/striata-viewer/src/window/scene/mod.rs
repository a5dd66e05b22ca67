//! Scenes in the window: with materials and lights, posed, at any level of detail.
//!
//! `subject` is what was read, `playback` the time of the animation, `shown` the triangles and places of a
//! frame, `resources` its buffers on the GPU, `inspection` its triangles with edges, and `panel` its part of
//! the user interface, with the tree of nodes from `tree`.

mod inspection;
mod panel;
mod playback;
mod resources;
mod shown;
mod subject;
mod tree;

pub(super) use self::panel::{animation_section, facts, materials_section, tree_section};
pub(super) use self::playback::Playback;
pub(super) use self::resources::SceneResources;
pub(super) use self::shown::{SceneRequest, ShownScene};
pub(super) use self::subject::SceneSubject;
