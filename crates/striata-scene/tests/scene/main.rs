//! Tests of levels of scenes, in one program.

mod deformation;
mod file;
mod flat;
mod glb_stream;
mod godot;
mod hostile;
mod levels;
mod lod_chain;
mod lod_scene;
mod ordered;
mod samples;
mod scene_view;
mod streams;
#[cfg(feature = "textures")]
mod textures;
mod vertices;
mod view;
