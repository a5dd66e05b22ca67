//! Tests of strips, in one program.

mod live_strip_buffer;
mod mts;
mod strip_blocks;
mod strip_cache;
mod strip_repair;
mod strips;
