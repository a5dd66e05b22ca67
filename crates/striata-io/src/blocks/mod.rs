//! Meshes that do not fit into memory: read in blocks of triangles that lie together, written strip by strip.
//!
//! ```text
//! file --vertices--> bounds
//!      --faces-----> (key along a curve, corners) --sort through a file--> blocks, in a file
//!                                                                      --> last block of each vertex, in a file
//!      stripify_blocks(blocks) --> strips, in a file --> output, with the vertices copied from the file
//! ```
//!
//! Files in between have no name, so that they vanish with the process whatever happens. They take 36 bytes a
//! triangle and 4 a vertex while blocks are made. In memory are pages of files (8 MB each for positions and
//! for last uses), one run of the sort (6 MB) and one block; nothing grows with the mesh but 8 bytes a block.

mod output;
mod paged;
mod scratch;
mod sorted;
mod triangles;

pub use output::StripSpool;
pub use triangles::TriangleBlocks;
