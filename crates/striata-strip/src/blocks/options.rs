//! Options, report and errors of [`stripify_blocks`](super::stripify_blocks).

use striata::Cancelled;
use striata::mesh::MeshError;
use striata::strip::{RESTART, StripCost};

use crate::options::StripOptions;

/// Options of [`stripify_blocks`](super::stripify_blocks).
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct BlockOptions {
    /// Options for the strips of each block.
    pub strip: StripOptions,
    /// Largest number of triangles that may wait for later blocks; a waiting triangle takes some 30 bytes.
    /// Beyond it, strips end at the border of the block. Default 1,000,000.
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

/// Result and memory use of [`stripify_blocks`](super::stripify_blocks).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct BlocksReport {
    /// Cost of the strips.
    pub cost: StripCost,
    /// Number of blocks.
    pub block_count: u32,
    /// Number of triangles of the largest block.
    pub peak_block_triangles: usize,
    /// Largest number of triangles that were stripified together: a block and the strips that waited for it.
    pub peak_window_triangles: usize,
    /// Largest number of triangles that waited for later blocks.
    pub peak_held_triangles: usize,
    /// Number of times that a triangle was carried over to a later block.
    pub carried_count: usize,
}

/// Reason why [`stripify_blocks`](super::stripify_blocks) failed; `R` is the source's error type, `W` the
/// writer's.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum BlocksError<R, W> {
    /// A block could not be read.
    #[error("block {block}: {error}")]
    Read {
        /// Index of the block.
        block: u32,
        /// Error of the source.
        error: R,
    },
    /// A strip could not be written.
    #[error("{0}")]
    Write(W),
    /// A block's group is lower than that of the block before it.
    #[error("block {block} has group {found}, but the block before it has group {previous}")]
    GroupFalls {
        /// Index of the block.
        block: u32,
        /// Group of the block.
        found: u32,
        /// Group of the block before it.
        previous: u32,
    },
    /// A vertex has the index that is reserved for restarts.
    #[error("block {block}, triangle {triangle}: vertex index {RESTART} is reserved for restarts")]
    ReservedVertex {
        /// Index of the block.
        block: u32,
        /// Index of the triangle within the block.
        triangle: usize,
    },
    /// A block and the strips that it takes over have too many triangles or vertices.
    #[error("block {block}: {error}")]
    TooLarge {
        /// Index of the block.
        block: u32,
        /// The limit that they exceed.
        error: MeshError,
    },
    /// The progress callback cancelled.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
}

/// Callback that receives strips one after another, each with its group.
pub type WriteStripFn<'a, W> = dyn FnMut(u32, &[u32]) -> Result<(), W> + 'a;
