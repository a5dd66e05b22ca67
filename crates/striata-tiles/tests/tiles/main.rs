//! Tests of tiles, in one program.

mod common;
mod neuroglancer;
mod textures;
mod tiles;
mod zarr;
