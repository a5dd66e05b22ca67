//! Files of meshes that do not fit into memory: read in blocks of neighboring triangles, written strip by
//! strip.
//!
//! ```text
//! other formats --> binary PLY, in a file
//! binary PLY --vertices--> bounds
//!            --faces-----> (key along a curve, corners) --sort through a file--> blocks, in a file
//!                                                                  and the last block of each vertex, in a file
//!      stripify_blocks(blocks) --> strips, in a file --> output, with the vertices copied from the file
//! ```
//!
//! The vertices of the output are copied from the binary PLY: attribute by attribute into a GLB, followed by
//! the indices, or row by row into a PLY whose triangles are one list of strips. Intermediate files have no
//! name, so they disappear with the process, however it ends. They take 36 bytes per triangle and 4 per
//! vertex while blocks are made; formats whose vertices have no numbers take 156 bytes per triangle before
//! that. Memory contains pages of files (8 MB each for positions and for last uses), one run of the sort (6 MB)
//! and one block; only 8 bytes per block grow with the mesh. Text, STL, OBJ, OFF and glTF are also mapped into memory,
//! from where the system removes them if it needs room.

mod binary_ply;
mod obj_triangles;
mod paged;
mod piece_triangles;
mod ply_writer;
mod scratch;
mod shared_vertices;
mod sorter;
mod strip_spool;
mod triangle_blocks;

pub use strip_spool::StripSpool;
pub use triangle_blocks::TriangleBlocks;
