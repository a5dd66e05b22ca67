//! Stripifiers that search: triangle strips of a mesh with fewer indices than one quick pass finds.
//!
//! What strips are, what they cost and one quick way to make them is [`striata::strip`]. Here are the others:
//!
//! * [`stripify`] makes strips by any [`Stripifier`]: the classic local algorithm, tunnelling, fewest strips, fewest
//!   indices; [`stripify_from`] goes on from strips that there are, for as long as the caller's budget lasts;
//! * a [`StripOptions::cache_weight`] over 0 puts strips in an order that a vertex cache likes, or grows new ones for it;
//! * [`strip_count_bound`] proves how many strips there have to be;
//! * [`LiveStrips`] follow a mesh between its levels of detail and are repaired at each step;
//! * [`stripify_blocks`] makes strips of meshes that do not fit into memory.
//!
//! ```
//! use striata::mesh::shapes;
//! use striata_strip::{StripOptions, Stripifier, stripify};
//!
//! let mesh = shapes::terrain(40, 1);
//! let quick = striata::strip::stripify(&mesh)?;
//! let searched = stripify(&mesh, &StripOptions::default().with_stripifier(Stripifier::Cheapest))?;
//! assert!(searched.cost().index_count <= quick.cost().index_count);
//! # Ok::<(), striata::mesh::MeshError>(())
//! ```
//!
//! Every stripifier only joins and cuts [links](striata::strip::StripLinks); one writer turns them into indices, so
//! winding, parity and order are settled in one place.

mod blocks;
mod cache;
mod cheapest;
mod entry;
mod fewest;
mod options;
mod repair;
mod stripe;
mod stripifier;
mod task;
mod tunnel;

pub use blocks::{
    Block, BlockCurve, BlockOptions, BlockSource, BlockTriangle, BlocksError, BlocksReport, MeshBlocks,
    WriteStripFn, block_length, stripify_blocks, stripify_blocks_with_progress,
};
pub use entry::{stripify, stripify_from};
pub use fewest::strip_count_bound;
pub use options::StripOptions;
pub use repair::{LiveStrips, LiveStripsError, RepairGoal, RepairOptions, RepairReport};
pub use stripifier::{DEFAULT_TUNNEL_LENGTH, ParseStripifierError, Stripifier};
pub use task::SpentFn;

/// The readme's example, compiled with the documentation's tests.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
