//! Pictures of meshes: what is on one, who draws it, and how panels with their text become a PNG.
//!
//! A [`Shot`] says what is seen: triangles over the vertices of a mesh, their paint, lines through space. An [`Artist`] draws
//! it from a [`Camera`]: the GPU where there is one, or else a small rasterizer with the same lights. A [`Sheet`] lays
//! panels out and writes beside them. All of it is in linear light with opacity, and becomes bytes at last.

mod artist;
mod camera;
mod canvas;
mod clip;
mod frustum;
#[cfg(feature = "gpu")]
mod gpu;
mod heat;
mod normals;
mod paint;
#[cfg(feature = "serve")]
mod portrait;
mod raster;
mod sheet;
mod shot;
mod text;

pub(crate) use artist::{Artist, Drawn};
pub(crate) use camera::{Angles, Camera};
pub(crate) use canvas::{Canvas, Rgba};
pub(crate) use frustum::Frustum;
#[cfg(feature = "gpu")]
pub(crate) use gpu::GpuArtist;
pub(crate) use heat::Heat;
pub(crate) use normals::with_normals;
pub(crate) use paint::{fan_colours, group_colours, strip_colours, triangle_colours};
#[cfg(feature = "serve")]
pub(crate) use portrait::{nobody, portrait};
pub(crate) use sheet::{ColourBar, Panel, Sheet, Theme, significant};
pub(crate) use shot::{Line, Paint, Shot};
