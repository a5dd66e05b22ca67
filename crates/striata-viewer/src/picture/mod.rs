//! Pictures of meshes: what is on one, who draws it, and how panels with their text become a PNG.
//!
//! A [`Shot`] says what is seen: triangles over the vertices of a mesh, their paint, lines through space. An [`Artist`] draws
//! it from a [`Camera`]: the GPU where there is one, or else a small rasterizer with the same lights. A [`Sheet`] lays
//! panels out and writes beside them. All of it is in linear light with opacity, and becomes bytes at last.

mod artist;
mod camera;
mod canvas;
mod clip;
mod drawn;
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

pub use artist::Artist;
pub use camera::{Angles, Camera};
pub use canvas::{Canvas, Rgba};
pub use drawn::Drawn;
pub use frustum::Frustum;
#[cfg(feature = "gpu")]
pub use gpu::GpuArtist;
pub use heat::Heat;
pub use normals::with_normals;
pub use paint::{Painted, fan_colors, group_colors, strip_colors, triangle_colors};
#[cfg(feature = "serve")]
pub use portrait::{nobody, portrait};
pub use sheet::{ColorBar, Panel, Sheet, Theme, significant};
pub use shot::{Line, Paint, Shot, Style};
