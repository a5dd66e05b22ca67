//! Levels of detail of whole scenes.
//!
//! | module | what it does |
//! | --- | --- |
//! | `levels` | distributes a target over all meshes of a scene by one priority |
//! | `lod_scene` | a scene with a [`Lod`](striata::Lod) for each mesh |
//! | `deformation` | simplification that respects the poses of skins and morph targets |
//! | `pose` | where skins and morph targets put the vertices at a time of an animation |

mod deformation;
mod pose;

pub use deformation::Deformation;
pub use pose::{Pose, Poser};
