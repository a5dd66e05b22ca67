//! Strips of a mesh that does not fit into memory, made block by block.
//!
//! A mesh arrives as blocks of neighboring triangles, in an order that moves through space without jumps.
//! Each block is stripified by any [`Stripifier`](super::Stripifier). Strips next to triangles of later
//! blocks are not written yet: they wait, and the block that brings those triangles stripifies them
//! together with its own, so that the border between blocks is searched like any other part of the mesh.
//! \[PS03, 6\] names the task as future work; storing with a vertex when it is last used is from \[IL05\].
//!
//! | module | content |
//! | --- | --- |
//! | `curve` | order of triangles (Hilbert's curve); a block ends at the border of a large cube |
//! | `source`, `mesh_blocks` | what a block is; blocks of a mesh in memory |
//! | `window` | a block and the strips it takes over, as a small mesh with open sides |
//! | `pending` | waiting strips, found by their open sides and written when no later block can touch them |
//! | `chain`, `joints` | strips that grow at both ends, and where strips of a block continue them |
//! | `block_stripifier` | processing of each block |
//!
//! Two kinds of strips wait. Short ones with many open sides are **loose**: the next block takes them apart
//! and stripifies their triangles again. Longer ones are **chains**: only their last two triangles enter
//! the next window, as a stub at which a strip can start. These two have vertices of their own, so that a
//! strip can leave them in one direction only; whatever continues the stub is appended to the chain, index
//! by index. Taking chains apart completely would let windows grow from block to block; cutting them at the
//! border would cost what joining saves. Every result of the stripifier is valid: a chain that no strip
//! continues is written as it is.
//!
//! ```text
//!     +---------+- - - - +
//!     |  written| waits  :  next block
//!     |  strips | strips :  takes both
//!     +---------+- - - - +
//! ```
//!
//! Time is that of the stripifier, for each triangle once and for loose triangles again. Memory is that of
//! the stripifier for one window, and the waiting strips: those along the border of the finished part,
//! which on a surface grows with the square root of the mesh, up to [`BlockOptions::held_limit`].
//! Invariants: each triangle is written once, with its winding; no strip crosses groups.

mod block_stripifier;
mod chain;
mod curve;
mod integer_map;
mod joints;
mod mesh_blocks;
mod options;
mod pending;
mod source;
mod window;

use striata::{Cancelled, Progress, ProgressFn, ignore_progress};

use block_stripifier::BlockStripifier;

pub use curve::{BlockCurve, block_length};
pub use mesh_blocks::MeshBlocks;
pub use options::{BlockOptions, BlocksError, BlocksReport, WriteStripFn};
pub use source::{Block, BlockSource, BlockTriangle};

/// Covers each triangle of a mesh by exactly one strip, with one block of it in memory at a time.
///
/// `write` receives the strips one after another, each with its group; groups never decrease. Degenerate
/// triangles (two equal corners) are left out.
///
/// ```
/// use std::convert::Infallible;
/// use striata::mesh::shapes;
/// use striata_strip::{BlockOptions, MeshBlocks, stripify_blocks};
///
/// let mesh = shapes::terrain(40, 1);
/// let mut blocks = MeshBlocks::new(&mesh, 500)?;
/// let mut indices: Vec<u32> = Vec::new();
/// let report = stripify_blocks(
///     &mut blocks,
///     &BlockOptions::default(),
///     &mut |_group, strip| {
///         indices.extend_from_slice(strip);
///         Ok::<(), Infallible>(())
///     },
/// )?;
/// assert_eq!(report.cost.triangle_count, mesh.triangle_count());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// Returns [`BlocksError`] if reading or writing fails, or if a block is invalid; strips written before
/// that stay written.
pub fn stripify_blocks<S: BlockSource, W>(
    source: &mut S,
    options: &BlockOptions,
    write: &mut WriteStripFn<'_, W>,
) -> Result<BlocksReport, BlocksError<S::Error, W>> {
    stripify_blocks_with_progress(source, options, write, &mut ignore_progress)
}

/// Makes strips like [`stripify_blocks`] and reports its progress; the callback can cancel.
///
/// # Errors
/// Returns the errors of [`stripify_blocks`], and [`BlocksError::Cancelled`] if the callback cancels.
pub fn stripify_blocks_with_progress<S: BlockSource, W>(
    source: &mut S,
    options: &BlockOptions,
    write: &mut WriteStripFn<'_, W>,
    progress: &mut ProgressFn<'_>,
) -> Result<BlocksReport, BlocksError<S::Error, W>> {
    let total = source.block_count();
    let mut stripifier = BlockStripifier::new(options, write);
    let mut block = Block::default();
    for index in 0..total {
        let now = Progress { phase: "strip", done: u64::from(index), total: u64::from(total) };
        if progress(now).is_break() {
            return Err(Cancelled.into());
        }
        source.read_block(index, &mut block).map_err(|error| BlocksError::Read { block: index, error })?;
        stripifier.add(index, &block)?;
    }
    stripifier.finish(total).map_err(BlocksError::Write)
}
