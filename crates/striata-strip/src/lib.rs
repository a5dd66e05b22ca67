//! Triangle strips by search: slower stripifiers that need fewer indices than one quick pass.
//!
//! [`striata::strip`] explains what strips are and what they cost, and has one quick stripifier. This crate
//! adds the others:
//!
//! * [`stripify`] makes strips with any [`Stripifier`]: the classic local algorithm, tunneling, fewest
//!   strips or fewest indices. [`stripify_with_progress`] can be cancelled. [`stripify_from`] starts from
//!   existing strips and runs until the caller's budget is spent.
//! * A [`StripOptions::cache_weight`] above 0 reorders strips for a vertex cache, or grows new strips for it.
//! * [`strip_count_bound`] proves a lower bound for the number of strips.
//! * [`LiveStrips`] follow a mesh between its levels of detail and are repaired at each step. A
//!   [`LiveStripBuffer`] is their index buffer, and says which ranges of it have changed.
//! * [`strips_in_order`] makes strips of triangles in the order of another stripifier.
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
//! A set of strips is a coloring of the dual graph: a [link](striata::strip::StripLinks) is solid if its
//! two triangles follow each other in a strip, and dashed otherwise. Every stripifier only recolors links.
//! One writer turns them into indices, so winding, parity and order are handled in one place.
//!
//! | module | algorithm |
//! | --- | --- |
//! | `stripe` | the classic greedy walk that prefers neighbors with few free neighbors; patches of quads |
//! | `tunnel` | joins strip ends greedily, then along the shortest tunnels |
//! | `fewest` | moves strip ends until they meet; proves how few strips are possible |
//! | `cheapest` | simulated annealing of single links, then joins strips whose ends share a vertex |
//! | `cache` | reorders strips, or grows new ones in rows, for few vertex cache misses |
//! | `ordered` | [`strips_in_order`] |
//! | `repair` | [`LiveStrips`] |
//! | `blocks` | [`stripify_blocks`] |
//!
//! **All costs are local.** Every strip begins at an even position of its draw call. One of the two turns
//! at its second triangle is free there, and the other costs an index. Which one is free depends only on
//! the last two triangles at that end of the strip. The cost of a link therefore follows from the triangles
//! around it: a search needs neither the length nor the parity of a strip, and its identity only to avoid
//! closing loops.

mod blocks;
mod cache;
mod cheapest;
mod entry;
mod fewest;
mod options;
mod ordered;
mod repair;
mod stripe;
mod stripifier;
mod task;
mod tunnel;

pub use blocks::{
    Block, BlockCurve, BlockOptions, BlockSource, BlockTriangle, BlocksError, BlocksReport, MeshBlocks,
    WriteStripFn, block_length, stripify_blocks, stripify_blocks_with_progress,
};
pub use entry::{StripifyError, stripify, stripify_from, stripify_with_progress};
pub use fewest::strip_count_bound;
pub use options::StripOptions;
pub use ordered::strips_in_order;
pub use repair::{LiveStripBuffer, LiveStrips, LiveStripsError, RepairGoal, RepairOptions, RepairReport};
pub use stripifier::{DEFAULT_TUNNEL_LENGTH, ParseStripifierError, StripeSwaps, Stripifier};
pub use task::SpentFn;

/// The README's example, compiled with the documentation tests.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
