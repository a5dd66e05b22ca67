//! Triangle strips: what they are, how they are made and what they cost.
//!
//! A strip `s` of `n` indices holds `n - 2` triangles: triangle `i` is `(s[i], s[i+1], s[i+2])` for even `i`
//! and the same with its first two corners swapped for odd `i`, so a strip keeps one winding. A repeated
//! index makes a degenerate triangle that nobody draws; that is how a strip turns (a **swap**) and how two
//! strips are joined without a restart index (a **stitch**).

mod blocks;
mod cache;
mod cheapest;
mod cost;
mod fewest;
mod greedy;
mod index_buffer;
mod links;
mod repair;
mod seeds;
mod strip_set;
mod stripe;
mod stripifier;
mod tunnel;
mod write;

pub use blocks::{
    Block, BlockCurve, BlockOptions, BlockSource, BlockTriangle, BlocksError, BlocksReport, MeshBlocks,
    WriteStripFn, block_length, stripify_blocks,
};
pub use cost::{CacheCost, StripCost, fifo_cache_cost, lru_cache_cost};
pub use fewest::strip_count_bound;
pub use index_buffer::{RESTART, StripIndices, restart_triangles_into, stitch};
pub use links::StripLinks;
pub use repair::{LiveStrips, LiveStripsError, RepairGoal, RepairOptions, RepairReport};
pub(crate) use strip_set::check_offsets;
pub use strip_set::{StripSet, StripSetError, strip_triangles};
pub use stripifier::{
    DEFAULT_TUNNEL_LENGTH, ParseStripifierError, SpentFn, StripOptions, Stripifier, stripify, stripify_from,
    stripify_greedily,
};
