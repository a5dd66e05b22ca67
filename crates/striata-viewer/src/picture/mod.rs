//! Draws pictures of meshes and arranges them with text into PNG files.
//!
//! A [`Shot`] describes what is visible: triangles over the vertices of a mesh, their paint, and lines. A
//! [`PictureRenderer`] draws it from a [`Camera`] with a GPU if one is available, or else with a small
//! rasterizer with the same lighting. A [`Sheet`] arranges panels and labels them. All pictures are in linear
//! light with opacity until they are encoded as bytes.
//!
//! A picture never fails for lack of a GPU: adapters are opened in order of preference, and the first one
//! on which a small triangle comes out right as a list, as strips and with edges is used. If none passes,
//! or a device is lost later, the rasterizer draws and one line reports why. Lines are triangles that face
//! the camera, so that surfaces hide them.

mod camera;
mod canvas;
mod clip;
mod distance_map;
mod frustum;
#[cfg(feature = "gpu")]
mod gpu_look;
#[cfg(feature = "gpu")]
mod gpu_renderer;
mod lit_raster;
mod lit_surface;
mod normals;
mod paint;
mod picture_renderer;
mod raster;
mod rendered_picture;
mod scene_look;
mod shading;
mod sheet;
mod shot;
mod split_sum;
mod studio;
mod text;
mod texture;
#[cfg(feature = "serve")]
mod thumbnail;
mod vector;

pub use camera::{Camera, ViewAngles};
pub use canvas::{Canvas, Rgba};
pub use distance_map::DistanceMap;
pub use frustum::Frustum;
#[cfg(feature = "gpu")]
pub use gpu_renderer::GpuRenderer;
pub use normals::{with_all_normals, with_normals};
pub use paint::{ColoredTriangles, fan_colors, fragment_colors, group_colors, strip_colors, triangle_colors};
pub use picture_renderer::PictureRenderer;
pub use rendered_picture::Drawn;
pub use scene_look::SceneLook;
pub use sheet::{ColorBar, Panel, Sheet, Theme, significant};
pub use shot::{Line, Paint, Shot, Style};
#[cfg(feature = "serve")]
pub use thumbnail::{placeholder, portrait};
