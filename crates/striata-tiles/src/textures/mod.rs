//! Textures of tiles: images out of memory, and an atlas for each material of a tile.
//!
//! ```text
//!  finest surface ──> texels in use, texel size ─┐
//!  images, one at a time ────────────────────────┴──> pyramids on disk ──> charts of a tile ──> atlas
//! ```
//!
//! The texel size of a level is a sixteenth of its error, or larger if its tiles would have more than a million texels;
//! the geometric error of the level is then sixteen texels. Texels are never smaller than those of the image.
//!
//! | file | what it does |
//! | --- | --- |
//! | `tile_textures.rs` | the textures of a mesh |
//! | `material.rs` | materials and their references to textures |
//! | `coverage.rs` | the texels that triangles reach |
//! | `regions.rs` | the charts of the whole mesh, and triangles with corners in several of them |
//! | `pyramid.rs` | reduced copies of an image on disk, and how pixels are read from them |
//! | `chart.rs` | the charts of a tile, their sizes and places |
//! | `atlas.rs` | the images of a tile, and its texture coordinates |

mod atlas;
mod chart;
mod coverage;
mod material;
mod pyramid;
mod regions;
mod tile_textures;

pub(crate) use self::{
    atlas::DressedTile,
    material::without_textures,
    tile_textures::{TEXELS_PER_ERROR, TileTextures},
};
