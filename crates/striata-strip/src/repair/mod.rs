//! Strips that follow a mesh between its levels and are repaired wherever it changed.
//!
//! A vertex split or a collapse changes a handful of triangles; the strips of all others can stay as they
//! are. [`LiveStrips`] keeps the dual graph of the current level with the strips as its solid links,
//! updates both with each step, and then searches for tunnels around the damage, starting from nearby ends
//! of strips \[Ste01; PS03, 3.2, 6\].
//!
//! ```text
//!   collapse: a triangle dies inside a strip      split: a triangle appears inside a strip
//!      o===t===o   ->   o=======o                    o=======o   ->   o===t===o
//! ```
//!
//! Differs: \[Ste01\] repairs for few strips. A GPU pays for indices, so by default a tunnel is accepted if
//! it saves indices, swaps included, and swaps also start searches. The strips of a level depend on the
//! path that led there; its triangles do not.
//!
//! Cost: the work of a step is bounded by the triangles around it and by [`RepairOptions`], not by the
//! mesh: 5 to 20 microseconds, and twice that on a million triangles, which fit into no CPU cache. 57 bytes
//! per triangle of the full mesh.
//!
//! [`LiveStripBuffer`] keeps the strips in an index buffer, and lists the ranges of it that each move changes:
//! only these have to be sent to a GPU.

mod changed_triangles;
mod error;
mod live_graph;
mod live_strip_buffer;
mod live_strips;
mod options;
mod scratch;
mod slots;
mod stars;
mod step;
mod tunnel_search;

pub use error::LiveStripsError;
pub use live_strip_buffer::LiveStripBuffer;
pub use live_strips::LiveStrips;
pub use options::{RepairGoal, RepairOptions, RepairReport};
