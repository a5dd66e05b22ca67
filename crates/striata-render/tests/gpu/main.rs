//! Tests of drawing with wgpu.

mod crowd;
mod fans;
mod lit;
mod pictures;
mod strips;
mod support;
