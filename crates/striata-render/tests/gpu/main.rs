//! Tests of drawing with wgpu.

mod fans;
mod lit;
mod pictures;
mod strips;
mod support;
