//! Strips of a mesh that does not fit into memory: block by block, with the border handed on.
//!
//! A mesh comes as blocks of triangles that lie together, in an order that goes through space without jumps.
//! Each block is stripified by any [`Stripifier`](super::Stripifier). Strips that touch triangles still to
//! come are not written: they wait, and the block that brings those triangles takes them apart and makes strips of
//! their triangles and its own together, so that a border between blocks is searched like any other place.
//! \[PS03, 6\] names the task as future work; that a vertex tells when it is last used is from \[IL05\].
//!
//! ```text
//!     +---------+- - - - +
//!     |  written| waits  :  next block
//!     |  strips | strips :  takes both
//!     +---------+- - - - +
//! ```
//!
//! Time is that of the stripifier, on each triangle once and on those that wait again. Memory is that of the
//! stripifier for one block and the strips that it takes over, and what waits: strips along the border of the part that
//! is done, which on a surface grows as the square root of the mesh, up to [`BlockOptions::held_limit`].
//! Invariants: each triangle is written once, in its winding; no strip crosses a group.

mod chain;
mod curve;
mod hash;
mod held;
mod joints;
mod mesh_blocks;
mod options;
mod source;
mod window;
mod work;

use striata::{Cancelled, Progress, ProgressFn, ignore_progress};

use work::Work;

pub use curve::{BlockCurve, block_length};
pub use mesh_blocks::MeshBlocks;
pub use options::{BlockOptions, BlocksError, BlocksReport, WriteStripFn};
pub use source::{Block, BlockSource, BlockTriangle};

/// Covers each triangle of a mesh by exactly one strip, with one block of it in memory at a time.
///
/// `write` takes the strips one after another, each with its group, which never falls. Degenerate
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
/// [`BlocksError`], first of all if reading or writing fails; strips written until then stay written.
pub fn stripify_blocks<S: BlockSource, W>(
    source: &mut S,
    options: &BlockOptions,
    write: &mut WriteStripFn<'_, W>,
) -> Result<BlocksReport, BlocksError<S::Error, W>> {
    stripify_blocks_with_progress(source, options, write, &mut ignore_progress)
}

/// Does as [`stripify_blocks`] and reports its progress; the callback can cancel.
///
/// # Errors
/// As [`stripify_blocks`], and if the callback cancels.
pub fn stripify_blocks_with_progress<S: BlockSource, W>(
    source: &mut S,
    options: &BlockOptions,
    write: &mut WriteStripFn<'_, W>,
    progress: &mut ProgressFn<'_>,
) -> Result<BlocksReport, BlocksError<S::Error, W>> {
    let total = source.block_count();
    let mut work = Work::new(options, write);
    let mut block = Block::default();
    for number in 0..total {
        let now = Progress { phase: "strip", done: u64::from(number), total: u64::from(total) };
        if progress(now).is_break() {
            return Err(Cancelled.into());
        }
        source.read_block(number, &mut block).map_err(|error| BlocksError::Read { block: number, error })?;
        work.add(number, &block)?;
    }
    work.finish(total).map_err(BlocksError::Write)
}
