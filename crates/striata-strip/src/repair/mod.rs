//! Strips that follow a mesh between its levels and are repaired where it changed.
//!
//! A vertex split or a collapse changes a handful of triangles; the strips of all others need not be made anew.
//! [`LiveStrips`] keeps the dual graph of the level and the strips as its solid links, makes both follow each step,
//! and then searches tunnels around the damage, from the ends of strips that lie there \[Ste01; PS03, 3.2, 6\].
//!
//! ```text
//!   collapse: a triangle dies inside a strip      split: a triangle appears inside a strip
//!      o===t===o   ->   o=======o                    o=======o   ->   o===t===o
//! ```
//!
//! Differs: \[Ste01\] repairs in order to have few strips; a GPU pays for indices, so by default a tunnel is taken where
//! it saves indices, swaps counted, and a swap is also searched around. The strips of a level depend on the way
//! that led there, its triangles do not.
//!
//! Cost: what a step does is bounded by the triangles around it and by [`RepairOptions`], not by the mesh: 5 to 20
//! microseconds, twice that on a million triangles, which no cache holds. 57 bytes a triangle
//! of the full mesh.

mod error;
mod live_graph;
mod live_strips;
mod options;
mod scratch;
mod stars;
mod step;
mod tunnel_search;

pub use error::LiveStripsError;
pub use live_strips::LiveStrips;
pub use options::{RepairGoal, RepairOptions, RepairReport};
