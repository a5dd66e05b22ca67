//! What blocks are and where they come from.

/// One piece of a mesh: triangles that lie together.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Block {
    /// The triangles.
    pub triangles: Vec<BlockTriangle>,
    /// The group of the mesh that all of them belong to; may not fall from block to block.
    pub group: u32,
}

/// A triangle that knows how long its corners are needed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct BlockTriangle {
    /// Its vertices, numbered as in the whole mesh.
    pub corners: [u32; 3],
    /// For each corner the last block that has a triangle at its vertex.
    ///
    /// Too high a number costs memory and nothing else; too low a number, strips that end at a border.
    pub last_blocks: [u32; 3],
}

/// Hands out a mesh block by block.
pub trait BlockSource {
    /// Why a block cannot be read.
    type Error;

    /// Blocks of the mesh.
    fn block_count(&self) -> u32;

    /// Reads one block in place of what `block` holds.
    ///
    /// [`stripify_blocks`](super::stripify_blocks) asks for each once, in order.
    ///
    /// # Errors
    /// Where the source fails; the work ends with that.
    fn read_block(&mut self, number: u32, block: &mut Block) -> Result<(), Self::Error>;
}
