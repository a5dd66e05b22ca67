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
mod source;
mod window;
mod work;

use crate::mesh::MeshError;
use crate::strip::{RESTART, StripCost, StripOptions};
use crate::{Cancelled, Progress, ProgressFn};

pub use curve::{BlockCurve, block_length};
pub use mesh_blocks::MeshBlocks;
pub use source::{Block, BlockSource, BlockTriangle};
use work::Work;

/// Options of [`stripify_blocks`].
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct BlockOptions {
    /// How each block is stripified.
    pub strip: StripOptions,
    /// The most triangles that may wait for later blocks; a triangle that waits takes some 30 bytes. Beyond it
    /// strips end at the border. Default 1,000,000.
    pub held_limit: usize,
}

impl Default for BlockOptions {
    fn default() -> Self {
        Self { strip: StripOptions::default(), held_limit: 1_000_000 }
    }
}

impl BlockOptions {
    /// Sets [`BlockOptions::strip`].
    pub fn with_strip(mut self, strip: StripOptions) -> Self {
        self.strip = strip;
        self
    }

    /// Sets [`BlockOptions::held_limit`].
    pub fn with_held_limit(mut self, triangle_count: usize) -> Self {
        self.held_limit = triangle_count;
        self
    }
}

/// What [`stripify_blocks`] made, and what it kept in memory for it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct BlocksReport {
    /// What the strips cost.
    pub cost: StripCost,
    /// Blocks.
    pub block_count: u32,
    /// Triangles of the largest block.
    pub peak_block_triangles: usize,
    /// The most triangles that were stripified at once: a block and the strips that waited for it.
    pub peak_window_triangles: usize,
    /// The most triangles that waited at once for later blocks.
    pub peak_held_triangles: usize,
    /// How often a triangle was handed on to a later block.
    pub carried_count: usize,
}

/// Why [`stripify_blocks`] ended early: `R` is what reading a block says, `W` what writing a strip says.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum BlocksError<R, W> {
    /// A block could not be read.
    #[error("block {block}: {error}")]
    Read {
        /// The block.
        block: u32,
        /// What its source says.
        error: R,
    },
    /// A strip could not be written.
    #[error("{0}")]
    Write(W),
    /// A block's group comes before that of the block before it.
    #[error("block {block} is of group {found}, after a block of group {previous}")]
    GroupFalls {
        /// The block.
        block: u32,
        /// Its group.
        found: u32,
        /// The group of the block before it.
        previous: u32,
    },
    /// A vertex has the number of the restart index.
    #[error("block {block}, triangle {triangle}: no vertex can have the number {RESTART}")]
    ReservedVertex {
        /// The block.
        block: u32,
        /// The triangle, counted within the block.
        triangle: usize,
    },
    /// A block and what waits for it are more than can be numbered.
    #[error("block {block}: {error}")]
    TooLarge {
        /// The block.
        block: u32,
        /// How large they are.
        error: MeshError,
    },
    /// The progress callback asked to stop.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
}

/// Takes strips one after another, each with its group.
pub type WriteStripFn<'a, W> = dyn FnMut(u32, &[u32]) -> Result<(), W> + 'a;

/// Covers each triangle of a mesh by exactly one strip, with one block of it in memory at a time.
///
/// `write` takes the strips one after another, each with its group, which never falls. Degenerate
/// triangles (two equal corners) are left out.
///
/// ```
/// use std::convert::Infallible;
/// use striata::mesh::shapes;
/// use striata::strip::{BlockOptions, MeshBlocks, stripify_blocks};
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
///     &mut striata::ignore_progress,
/// )?;
/// assert_eq!(report.cost.triangle_count, mesh.triangle_count());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`BlocksError`], first of all where reading or writing fails; strips written until then stay written.
pub fn stripify_blocks<S: BlockSource, W>(
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
