//! Triangle strips: what they are, one quick way to make them, and what they cost.
//!
//! A strip `s` of `n` indices holds `n - 2` triangles: triangle `i` is `(s[i], s[i+1], s[i+2])` for even `i`
//! and the same with its first two corners swapped for odd `i`, so a strip keeps one winding. A repeated
//! index makes a degenerate triangle that nobody draws; that is how a strip turns (a **swap**) and how two
//! strips are joined without a restart index (a **stitch**).
//!
//! [`stripify`] makes strips of a mesh. Whoever makes them in another way, as the crate `striata-strip` does, joins and
//! cuts [`StripLinks`] and has [`write_strips`] turn them into indices.
//!
//! ```
//! use striata::{mesh::shapes, strip::stripify};
//!
//! let strips = stripify(&shapes::torus(32, 16, 1.0, 0.4))?;
//! println!("{} strips; draw {:?}...", strips.strip_count(), &strips.to_restart_indices().indices[..8]);
//! # Ok::<(), striata::mesh::MeshError>(())
//! ```

mod cost;
mod greedy;
mod index_buffer;
mod links;
mod seeds;
mod strip_set;
mod write;

pub use cost::{CacheCost, StripCost, fifo_cache_cost, lru_cache_cost};
pub use greedy::{join_greedily, stripify};
pub use index_buffer::{RESTART, StripIndices, restart_triangles_into, stitch};
pub use links::{StripLinks, Turn, next_side, prev_side};
pub use seeds::{FreeTriangles, Seeds};
pub(crate) use strip_set::check_offsets;
pub use strip_set::{StripSet, StripSetError, strip_triangles};
pub use write::{StripOrder, StripPath, write_strips};
