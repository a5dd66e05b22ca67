//! The software rasterizer, which draws the same pictures on machines without any graphics driver.
//!
//! In reading order: `view` projects and clips; `surface` finds the point that a sample shows; `texture`, `shading` and
//! `materials` shade those with materials, and `finish` all of them; `raster` draws.

mod finish;
mod materials;
mod raster;
mod shading;
mod surface;
mod texture;
mod view;

pub(crate) use texture::Texture;

use crate::camera::Camera;
use crate::canvas::Canvas;
use crate::shot::Shot;

/// Maximum number of pixels drawn at a time, before downsampling, 24 bytes each; larger pictures are
/// drawn in bands.
const BAND_PIXELS: usize = 4 << 20;

/// Draws a shot on the CPU; uncovered pixels are transparent.
pub fn rasterize(shot: &Shot<'_>, camera: &Camera, size: [usize; 2]) -> Canvas {
    let samples_per_row = view::DOWNSAMPLING * view::DOWNSAMPLING * size[0].max(1);
    let band_rows = (BAND_PIXELS / samples_per_row).max(1);
    raster::draw(shot, camera, size, band_rows)
}
