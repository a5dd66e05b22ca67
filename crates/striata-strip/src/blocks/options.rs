//! How blocks are stripified, what is reported of it, and what can go wrong.

use striata::Cancelled;
use striata::mesh::MeshError;
use striata::strip::{RESTART, StripCost};

use crate::options::StripOptions;

/// Options of [`stripify_blocks`](super::stripify_blocks).
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

/// What [`stripify_blocks`](super::stripify_blocks) made, and what it kept in memory for it.
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

/// Why [`stripify_blocks`](super::stripify_blocks) ended early: `R` is what reading a block says, `W` what writing a strip says.
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
