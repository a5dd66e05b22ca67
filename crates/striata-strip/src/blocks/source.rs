//! Blocks of a mesh and where they come from.

/// Neighboring triangles of a mesh.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Block {
    /// Triangles of the block.
    pub triangles: Vec<BlockTriangle>,
    /// Mesh group of all these triangles; must not decrease from block to block.
    pub group: u32,
}

/// Triangle that knows how long its corners are needed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct BlockTriangle {
    /// Vertex indices in the whole mesh.
    pub corners: [u32; 3],
    /// For each corner, the last block that has a triangle at its vertex.
    ///
    /// Too high a block index only costs memory; with too low a one, strips end at a border.
    pub last_blocks: [u32; 3],
}

/// Source of a mesh as blocks.
pub trait BlockSource {
    /// Reason why a block cannot be read.
    type Error;

    /// Returns the number of blocks.
    fn block_count(&self) -> u32;

    /// Reads one block and replaces the contents of `block`.
    ///
    /// [`stripify_blocks`](super::stripify_blocks) reads each block once, in order.
    ///
    /// # Errors
    /// Returns an error if the source fails; stripification then ends with
    /// [`BlocksError::Read`](super::BlocksError::Read).
    fn read_block(&mut self, index: u32, block: &mut Block) -> Result<(), Self::Error>;
}
