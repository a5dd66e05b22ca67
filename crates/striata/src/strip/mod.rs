//! Triangle strips: data structures, a fast stripifier, and cost measures.
//!
//! A strip `s` of `n` indices contains `n - 2` triangles. Triangle `i` is `(s[i], s[i+1], s[i+2])` for even
//! `i`; for odd `i`, its first two corners are swapped, so that all triangles keep the same winding. A
//! repeated index creates a degenerate triangle, which draws nothing. This is how a strip changes direction
//! (a **swap**) and how two strips are joined without a restart index (a **stitch**).
//!
//! [`stripify`] creates strips for a mesh. To implement another stripifier, as the crate `striata-strip`
//! does, join and cut [`StripLinks`] and convert them to indices with [`write_strips`].
//!
//! ```
//! use striata::{mesh::shapes, strip::stripify};
//!
//! let strips = stripify(&shapes::torus(32, 16, 1.0, 0.4))?;
//! println!("{} strips; draw {:?}...", strips.strip_count(), &strips.to_restart_indices().indices[..8]);
//! # Ok::<(), striata::mesh::MeshError>(())
//! ```

mod cache_order;
mod cost;
mod greedy;
mod index_buffer;
mod links;
mod seeds;
mod strip_set;
mod write;

pub use cache_order::cache_order;
pub use cost::{CacheCost, StripCost, fifo_cache_cost, lru_cache_cost};
pub use greedy::{join_greedily, join_greedily_with_progress, stripify};
pub use index_buffer::{RESTART, StripIndices, restart_triangles_into, stitch};
pub use links::{StripLinks, Turn, next_side, prev_side};
pub use seeds::{FreeTriangles, Seeds};
pub(crate) use strip_set::check_offsets;
pub use strip_set::{StripSet, StripSetError, strip_triangles};
pub use write::{StripOrder, StripPath, write_strips};
