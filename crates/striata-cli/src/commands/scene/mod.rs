//! The verbs for scenes: glTF documents that keep their nodes, materials, skins and animations.
//!
//! Each verb decides by its input whether it works on a scene or on one mesh, and comes here for scenes.

mod build;
mod clusters;
mod encode;
mod facts;
mod ordered;

pub(super) use build::build;
pub(super) use encode::encode;
pub(super) use facts::SceneFacts;
pub(super) use ordered::check_order_flags;
