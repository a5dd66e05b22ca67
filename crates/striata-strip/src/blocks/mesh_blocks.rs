//! Blocks of a mesh in memory.

use std::convert::Infallible;
use std::ops::Range;

use striata::mesh::{IndexedMesh, MeshError};

use super::curve::{BlockCurve, block_length};
use super::source::{Block, BlockSource, BlockTriangle};

/// Mesh in memory as a source of blocks: the triangles of each group, cut into pieces along a space-filling
/// curve.
///
/// Limits the memory of the search, not of the mesh: it takes another 12 bytes per triangle and 4 per vertex.
#[derive(Clone, Debug)]
pub struct MeshBlocks<'a> {
    triangles: &'a [[u32; 3]],
    /// Triangles, group by group, along the curve.
    order: Vec<u32>,
    /// Group of each block, and its range in `order`.
    blocks: Vec<(u32, Range<usize>)>,
    /// Last block that uses each vertex.
    last_blocks: Vec<u32>,
}

impl<'a> MeshBlocks<'a> {
    /// Cuts a mesh into blocks of at most `block_triangles` triangles (at least one).
    ///
    /// # Errors
    /// Returns [`MeshError`] if the mesh is inconsistent.
    pub fn new(mesh: &'a IndexedMesh, block_triangles: usize) -> Result<Self, MeshError> {
        mesh.check()?;
        let curve = BlockCurve::new(mesh.bounds());
        let corners = |t: u32| mesh.triangles[t as usize].map(|v| mesh.positions[v as usize]);
        let mut order: Vec<u32> = Vec::with_capacity(mesh.triangle_count());
        let mut blocks = Vec::new();
        for (group, range) in mesh.groups_or_whole().iter().map(|group| group.range()).enumerate() {
            let mut keys: Vec<(u64, u32)> =
                (range.start as u32..range.end as u32).map(|t| (curve.key(corners(t)), t)).collect();
            keys.sort_unstable();
            let first = order.len();
            let mut rest = &keys[..];
            while !rest.is_empty() {
                let length = block_length(rest, |&(key, _)| key, block_triangles);
                let start = first + keys.len() - rest.len();
                blocks.push((group as u32, start..start + length));
                rest = &rest[length..];
            }
            order.extend(keys.into_iter().map(|(_, t)| t));
        }
        // Neighbors in a file are often neighbors in a row of triangles, which strips follow well.
        for (_, range) in &blocks {
            order[range.clone()].sort_unstable();
        }
        let mut last_blocks = vec![0; mesh.vertex_count()];
        for (block, (_, range)) in (0..).zip(&blocks) {
            for &v in order[range.clone()].iter().flat_map(|&t| &mesh.triangles[t as usize]) {
                last_blocks[v as usize] = block;
            }
        }
        Ok(Self { triangles: &mesh.triangles, order, blocks, last_blocks })
    }
}

impl BlockSource for MeshBlocks<'_> {
    type Error = Infallible;

    fn block_count(&self) -> u32 {
        self.blocks.len() as u32
    }

    fn read_block(&mut self, index: u32, block: &mut Block) -> Result<(), Infallible> {
        let (group, ref range) = self.blocks[index as usize];
        block.group = group;
        block.triangles.clear();
        block.triangles.extend(self.order[range.clone()].iter().map(|&t| {
            let corners = self.triangles[t as usize];
            BlockTriangle { corners, last_blocks: corners.map(|v| self.last_blocks[v as usize]) }
        }));
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use striata::mesh::shapes;

    #[test]
    fn blocks_contain_each_triangle_once_and_know_the_last_use() {
        let mesh = shapes::two_material_sphere(9, 12);
        let mut source = MeshBlocks::new(&mesh, 17).unwrap();
        let (mut block, mut found, mut group) = (Block::default(), Vec::new(), 0);
        let mut last_seen = vec![0; mesh.vertex_count()];
        let mut declared = vec![0; mesh.vertex_count()];
        for index in 0..source.block_count() {
            source.read_block(index, &mut block).unwrap();
            assert!(block.triangles.len() <= 17 && block.group >= group);
            group = block.group;
            for triangle in &block.triangles {
                found.push(triangle.corners);
                for (v, last) in triangle.corners.into_iter().zip(triangle.last_blocks) {
                    last_seen[v as usize] = index;
                    declared[v as usize] = last;
                }
            }
        }
        assert_eq!(group, 1);
        assert_eq!(last_seen, declared);
        found.sort_unstable();
        let mut expected = mesh.triangles.clone();
        expected.sort_unstable();
        assert_eq!(found, expected);
    }
}
