//! The verbs for scenes: glTF documents that keep their nodes, materials, skins and animations.
//!
//! Each verb decides by its input whether it works on a scene or on one mesh, and comes here for scenes.

mod build;
mod convert;
mod encode;
mod facts;
mod levels;
mod view;

pub(super) use build::build;
pub(super) use convert::convert;
pub(super) use encode::encode;
pub(super) use facts::SceneFacts;
pub(super) use levels::{check_outputs, decode, extract, simplify};
pub(super) use view::scene_of_view;
